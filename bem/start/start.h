/* From the case to the surface at t = 0, and what this solver cannot start from. */
#pragma once
#include "bem/water/shore.h"
#include "common/case/case.h"

void bem_start_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems);

/* Whether the surface of regions begins with arcs in the place of kinks. */
bool bem_start_is_rounded(const struct case_file *c);

/* Sets f->surface, f->mesh.resolution and f->level. */
enum status bem_start_surface(const struct case_file *c, const struct case_run *r,
                              struct bem_shore *shore, struct bem_flow *f);
