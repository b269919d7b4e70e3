/* Tanks that are not rectangular: what of them this solver takes, and the surface at t = 0 there.
 */
#pragma once
#include "bem/water/shore.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/solver.h"

/* Whether the walls need a map of their own: they are no rectangle, or turn, or one of them does.
 */
bool bem_basin_is_mapped(const struct case_file *c);

/* The walls of a case. ERR_MEMORY; destroy *s even then. */
enum status bem_basin_shore(const struct case_file *c, struct bem_shore **s);

/* Adds a problem for all that it does not take; *length: of the surface, m, 0 if there was one. */
void bem_basin_check(const struct case_file *c, const struct case_run *r, struct problems *problems,
                     double *length);

/* Sets the surface of f from wall to wall, and its map; phi in H sqrt(gH). */
enum status bem_basin_start(const struct case_file *c, const struct case_run *r,
                            struct bem_shore *shore, struct bem_flow *f);
