/* Ends of plates that are under water. */
#pragma once
#include "common/case/case.h"

/* Refuses those without thickness, and those that are thinner than two particle spacings.
 * Next to them water flickers in and out of sight of the other side (faces.h, sight.h): still water
 * under a gate, round a plate and over a weir, H/dx = 20, reaches 0.06 sqrt(gH) within 6 sqrt(H/g)
 * at two spacings and 0.11 at one, and leaves plates of none with the speed of sound. */
void sph_tips_check(const struct case_file *c, const struct case_run *r, struct problems *problems);
