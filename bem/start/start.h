/* From the case to the surface at t = 0, and what this solver cannot start from. */
#pragma once
#include "bem/water/shore.h"
#include "common/case/case.h"

void bem_start_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems);

/* Nodes per H that give regions of water the least of its mean depth that is worth following; 0:
 * there are enough anyway. Bursts of spray follow a jet of water that is not resolved. */
double bem_start_shallowest(const struct case_file *c);

/* Where a run has fewer. */
void bem_start_warn(const struct case_file *c, const struct case_run *r, struct problems *warnings);

/* Whether the surface of regions begins with arcs in the place of kinks. */
bool bem_start_is_rounded(const struct case_file *c);

/* Sets f->surface, f->mesh.resolution and f->level. */
enum status bem_start_surface(const struct case_file *c, const struct case_run *r,
                              struct bem_shore *shore, struct bem_flow *f);
