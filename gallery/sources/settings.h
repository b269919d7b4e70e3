/* Topics of theory by words of an entry. */
#pragma once
#include "theory/theory.h"

/* Evaluates a topic with settings as in "zeta=1,1.005 points=200"; NULL: none. The caller destroys
 * the result. ERR_INPUT. */
enum status gallery_theory(const char *topic, const char *set, struct theory_result *result);
