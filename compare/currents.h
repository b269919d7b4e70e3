/* How the water moves at the comparison times: pictures of the reference and the runs whose points
 * fill their water, coloured by speed, with arrows. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

/* None where the points of the reference do not fill its water. */
enum status cmp_currents_write(const struct comparison *c, struct cmp_figures *f);
