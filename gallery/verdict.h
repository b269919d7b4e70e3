/* Whether an entry agrees with its document. */
#pragma once
#include "gallery/desk.h"

/* X(name, words) */
#define GALLERY_VERDICTS(X)                                                                        \
  X(agrees, "agrees")                                                                              \
  X(corrected, "agrees with the corrected formula")                                                \
  X(disagrees, "disagrees")                                                                        \
  X(none, "nothing to check")                                                                      \
  X(failed, "could not be made")                                                                   \
  X(left, "left out by --quick")
enum gallery_verdict {
#define X(name, words) GALLERY_VERDICT_##name,
  GALLERY_VERDICTS(X)
#undef X
      GALLERY_N_VERDICTS
};
extern const char *const gallery_verdict_names[], *const gallery_verdict_words[];

struct gallery_answer { /* to one check */
  double value, expected, tolerance; /* tolerance NaN: a bound */
  double low, high;                  /* what is allowed */
  double scatter;                    /* of the value, between runs that differ by rounding alone */
  bool holds, left;                  /* left: not held in --quick */
  char failure[400];                 /* why there is no value; "" */
};

/* Answers every check of the desk's entry: `answer` [e->n_checks]. A check that cannot be computed
 * is answered with its failure and does not hold. */
enum status gallery_answer_all(struct gallery_desk *desk, const struct gallery_entry *e,
                               struct gallery_answer *answer);

/* agrees: all hold. corrected: what does not hold are checks of the document alone, and the entry
 * is corrected; or all hold and the entry is corrected. disagrees: anything else. */
enum gallery_verdict gallery_verdict_of(const struct gallery_entry *e,
                                        const struct gallery_answer *answer);

/* Whether a check that does not hold says why, and one that says why does not hold; or either, when
 * the value is nearer to a limit than it scatters: else something has changed. */
bool gallery_answer_is_expected(const struct gallery_check *c, const struct gallery_answer *a);
/* Whether all are, of those that were not left out. */
bool gallery_is_expected(const struct gallery_entry *e, const struct gallery_answer *answer);
