/* The water of a case at t = 0, solved for without a run; and two waters that several tests are of.
 */
#pragma once
#include "bem/start/basin.h"
#include "bem/start/start.h"
#include "bem/water/pressure.h"
#include "bem/water/shore.h"
#include "tests/bem/run.h"

/* A released column; a steady wave round a tank. What else the case has is to follow. */
#define WATER_COLUMN                                                                               \
  "title: column\n"                                                                                \
  "fluid: {density: 1, gravity: 1}\n"                                                              \
  "scales: {H: 1}\n"                                                                               \
  "tank: {walls: [[[0, 3], [0, 0], [5.366, 0], [5.366, 3]]]}\n"                                    \
  "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: released}\n"
#define WATER_WAVE                                                                                 \
  "scales: {H: 1}\n"                                                                               \
  "tank: {walls: [[[-1, 3], [-1, -0.7], [4, -0.7], [4, 3]]], sides: periodic}\n"                   \
  "water: {wave: {kind: stream, height: 0.3, wavelength: 5, depth: 0.9}}\n"

struct water {
  struct case_file *c;
  struct bem_shore *shore; /* of a tank that is not rectangular */
  struct bem_flow f;
  struct bem_pressure p;
};

/* Takes the case over; false when it was refused. dense: see struct bem_solve_options. */
static inline bool water_start(struct water *w, struct case_file *c, size_t dense) {
  *w = (struct water){.c = c};
  EXPECT(c);
  if (!c) return false;
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-12, dense}, &w->f.solve));
  if (bem_basin_is_mapped(c)) EXPECT_OK(bem_basin_shore(c, &w->shore));
  EXPECT_OK(bem_start_surface(c, &c->runs[0], w->shore, &w->f));
  EXPECT_OK(bem_flow_reserve(&w->f, w->f.surface.n));
  return true;
}

/* psi, velocities and pressure of what its surface is now. */
static inline void water_solve(struct water *w) {
  EXPECT_OK(bem_flow_solve(&w->f, w->f.surface.state, 1));
  EXPECT_OK(bem_pressure_solve(&w->p, &w->f, w->f.surface.state));
}

static inline void water_end(struct water *w) {
  bem_pressure_destroy(&w->p);
  bem_flow_destroy(&w->f);
  bem_shore_destroy(w->shore);
  case_destroy(w->c);
}
