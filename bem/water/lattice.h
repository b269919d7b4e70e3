/* Velocity and pressure at places of the tank that are inside the water: at one, or at all points
 * of a rectangular lattice. */
#pragma once
#include "bem/water/inside.h"
#include "common/base/geometry.h"

struct bem_lattice {
  size_t n, room;
  size_t missing;         /* points inside the water that the map was not found at, of all fills */
  double *x, *y;          /* H, [room], owned, with those that follow */
  double *phi, *pressure; /* H sqrt(gH), rho g H */
  double *u, *v;          /* sqrt(gH) */
  double cell;            /* area that each point stands for, H^2 */
  struct bem_inside inside; /* scratch */
  struct geo_lines outline; /* scratch: of the water, H */
  struct geo_cut cut;       /* scratch */
};

/* Of the state that was solved last, see bem_inside_begin. The points are the middles of cells that
 * divide the tank's width, and heights above y = 0, evenly by about `spacing` (H). ERR_MEMORY. */
enum status bem_lattice_fill(struct bem_lattice *l, const struct bem_pressure *p,
                             const struct bem_flow *f, const double *state, double spacing);
void bem_lattice_destroy(struct bem_lattice *l);

/* Before bem_lattice_at, of the state that was solved last: see bem_inside_begin. */
enum status bem_lattice_begin(struct bem_lattice *l, const struct bem_flow *f, const double *state);

/* At any place of the tank, its walls included. *found: it is in the water, whose surface is seen
 * as straight from node to node, and no bend of the walls. ERR_MEMORY. */
enum status bem_lattice_at(struct bem_lattice *l, const struct bem_pressure *p,
                           const struct bem_flow *f, const double *state, double complex z,
                           bool *found, struct bem_place *out);
