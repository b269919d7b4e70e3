/* Log-log figures of errors over the spacing, and over what they cost. */
#pragma once
#include "compare/convergence/convergence.h"
#include "compare/figure.h"

enum status cmp_convergence_draw(const struct comparison *c, const struct cmp_convergence *v,
                                 struct cmp_figures *f);
