/* Tanks that are not rectangular: what of them this solver takes, and the surface at t = 0 there.
 */
#pragma once
#include "bem/conformal.h"
#include "bem/surface.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/solver.h"

/* The map of the tank of a case. ERR_MEMORY, ERR_SOLVER; destroy *m even then. */
enum status bem_basin_map(const struct case_file *c, struct bem_conformal **m);

/* Adds a problem for all that it does not take; *length: of the surface, m, 0 if there was one. */
void bem_basin_check(const struct case_file *c, const struct case_run *r, struct problems *problems,
                     double *length);

/* Sets the surface from wall to wall, with s->walls known, evenly along x; phi in H sqrt(gH). */
enum status bem_basin_start(const struct case_file *c, double resolution, struct bem_surface *s);
