/* Pictures at the comparison times: particles coloured by pressure under the reference's free
 * surface, a panel for every run; and the plunging jet close up. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

enum status cmp_overlays_write(const struct comparison *c, struct cmp_figures *f);
