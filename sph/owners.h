/* Keys of a scheme that do something only beside another, their owner. */
#pragma once
#include "common/case/case.h"

/* Refuses those that a run gives itself where their owner is off: they would do nothing. What a
 * named scheme sets is let be. */
void sph_owners_check(const struct case_run *r, struct problems *problems);
