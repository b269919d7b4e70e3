/* What a run will take. */
#pragma once
#include "common/case/case.h"

void sph_estimate(const struct case_file *c, const struct case_run *r, struct solver_estimate *e);
