/* The figures of an entry. */
#pragma once
#include <jansson.h>

#include "compare/figure.h"
#include "gallery/desk.h"

/* Makes those of the desk's entry, in `f`, which is for this entry alone, and puts them in place.
 * *figures: what the entry's JSON has of them (docs/gallery-entries.md). One that cannot be made
 * says why there, and does not take the others with it. INTERRUPTED when the user asks to stop. */
enum status gallery_figures_make(struct gallery_desk *desk, const struct gallery_entry *e,
                                 struct cmp_figures *f, json_t **figures);
