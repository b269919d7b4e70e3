/* The pressure at the instant the water is let go, as a head p/(rho0 g) in metres.
 *
 * The first acceleration of incompressible water in a force f and with gradients of its velocity u,
 * -grad p/rho + f, has the divergence d_i u_j d_j u_i: laplace p = rho (div f - d_i u_j d_j u_i),
 * with p = 0 on every free surface, dp/dx = 0 on the side walls and dp/dy = -rho g on the bed. At
 * uniform velocity under gravity the right side is 0, and water that falls free has no pressure. */
#pragma once
#include "common/tank/tank.h"

/* In a column of width L and height H that stands at a wall, x from that wall and y from the bed:
 * H - y minus a Fourier series that makes the other side free of pressure. */
double release_head(double x, double y, double L, double H);

/* Any water in such a tank, by finite volumes on a lattice of about `spacing`: five-point stencils
 * with the distance of the surface where it comes between two nodes (Gibou, Fedkiw, Cheng & Kang,
 * J. Comput. Phys. 176, 2002: symmetric, and of second order in p where p is smooth), factorised by
 * CHOLMOD. */
struct release;

/* What makes the pressure: the weight of the water on the bed, g over that of the head, and
 * -laplace p/(rho0 g), 1/m, everywhere the same. */
struct release_drive {
  double weight, source;
};

/* `near`: regions within this distance (m) are one body. ERR_MEMORY, ERR_SOLVER. */
enum status release_create(const struct geo_lines *water, const struct tank *tank, double spacing,
                           double near, const struct release_drive *drive, struct release **out);
void release_destroy(struct release *r); /* NULL is fine */
double release_at(const struct release *r, double x, double y);
