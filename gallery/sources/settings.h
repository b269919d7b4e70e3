/* Topics of theory by words of an entry. */
#pragma once
#include "gallery/reader.h"
#include "theory/theory.h"

/* Evaluates a topic with settings as in "zeta=1,1.005 points=200"; NULL: none. The caller destroys
 * the result. ERR_INPUT. */
enum status gallery_theory(const char *topic, const char *set, struct theory_result *result);

/* The keys `topic` and `set` of the mapping `node`, called `path`: the topic, and of how many curves
 * it is then; NULL after a complaint. */
const struct theory_topic *gallery_theory_check(struct gallery_reader *r, int node,
                                                const char *path, const char *topic,
                                                const char *set, size_t *curves);
