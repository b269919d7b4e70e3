/* Charts of many numbers of a run against time, a panel for each: what its solver says of its
 * noise, and where its energy goes. */
#pragma once
#include "compare/chart.h"

enum status cmp_stacks_write(const struct comparison *c, struct cmp_figures *f);
