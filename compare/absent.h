/* What a result does not have, so that it is not compared. */
#pragma once
#include "compare/comparison.h"

/* Names of what a run or the reference lacks: the datasets that every result of plunge
 * has, and the sensors that another of the results has. At most CMP_MOST_ABSENT; how many. */
enum { CMP_MOST_ABSENT = 6 };
size_t cmp_absent_find(const struct comparison *c, const struct cmp_run *run,
                       const char *what[CMP_MOST_ABSENT]);
