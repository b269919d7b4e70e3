/* The charts of the report against time. */
#pragma once
#include "compare/chart.h"

enum status cmp_charts_write(const struct comparison *c, struct cmp_figures *f);
