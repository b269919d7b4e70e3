/* The pressure at the instant the water is let go, as a head p/(rho0 g) in metres.
 *
 * The first acceleration of incompressible water in a force f and with gradients of its velocity u,
 * -grad p/rho + f, has the divergence d_i u_j d_j u_i: laplace p = rho (div f - d_i u_j d_j u_i),
 * with p = 0 on every free surface and dp/dn = rho f_n on the walls. At uniform velocity under
 * gravity the right side is 0, and water that falls free has no pressure. */
#pragma once
#include "common/base/geometry.h"

/* In a column of width L and height H that stands at a wall, x from that wall and y from the bed:
 * H - y minus a Fourier series that makes the other side free of pressure. */
double release_head(double x, double y, double L, double H);

/* Any water between any walls, by finite elements: parabolas on triangles that fit walls and
 * surfaces (release_mesh.h), so that what is linear or of second order is exact and the rest of
 * third order where it is smooth; the matrix is symmetric and positive definite and is factorised
 * by CHOLMOD. Water that is mirrored or turned with walls and weight gets the same, to rounding. */
struct release;

/* What makes the pressure: the weight of the water on walls, over rho0 times the g of the head, and
 * -laplace p/(rho0 g), 1/m, everywhere the same. */
struct release_drive {
  double weight[2], source;
};

/* Nodes are about `spacing` apart; regions within `near` (m) are one body. ERR_INPUT: water that no
 * surface bounds; ERR_MEMORY, ERR_SOLVER. */
enum status release_create(const struct geo_lines *water, const struct geo_lines *walls,
                           double spacing, double near, const struct release_drive *drive,
                           struct release **out);
void release_destroy(struct release *r); /* NULL is fine */

/* What release_create takes of one processor, s. Measured on columns at a wall, H/dx = 80 to 620:
 * 0.07, 0.43, 2.7 s for 6,400, 25,600 and 102,400 nodes, 28 s on a busy machine for 384,400. */
double release_seconds(const struct geo_lines *water, double spacing);

/* At a point of the water; beside it, that of the nearest triangle there. */
double release_at(const struct release *r, double x, double y);
