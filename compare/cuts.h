/* Water that a solver took out of the computation because it could not follow it: what has a place
 * in the curves of its energy. */
#pragma once
#include "compare/comparison.h"

/* Whether so much energy went with water between rows i - 1 and i of the energies that it shows. */
bool cmp_cut_shows(const struct cmp_data *d, size_t i);

/* Whether any run, or the reference, lost energy so. */
bool cmp_cuts_any(const struct comparison *c);

/* Appends to a caption what the marks are, and what went in all from each run that is picked and
 * the reference. Nothing where no mark is. */
void cmp_cuts_say(const struct comparison *c, char *out, size_t room);
