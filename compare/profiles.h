/* Measured surfaces at an instant, beside those of the runs. */
#pragma once
#include "compare/comparison.h"

/* Whether profile k of the reference's file is of a comparison time. */
bool cmp_profile_is_at(const struct comparison *c, size_t k, size_t time);

/* Mean distance, in H, of the points of profile k within the window from the run's surface at that
 * time. */
struct cmp_value cmp_profile_distance(const struct comparison *c, const struct cmp_run *run,
                                      size_t k, size_t time);
