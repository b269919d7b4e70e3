#include "gallery/verdict.h"

#include <math.h>
#include <string.h>

#define X(name, words) #name,
const char *const gallery_verdict_names[] = {GALLERY_VERDICTS(X)};
#undef X
#define X(name, words) words,
const char *const gallery_verdict_words[] = {GALLERY_VERDICTS(X)};
#undef X

static enum status answer_bound(struct gallery_desk *desk, const struct gallery_check *c,
                                struct gallery_answer *a) {
  if (c->above) TRY(gallery_desk_formula(desk, c->above, &a->low));
  if (c->below) TRY(gallery_desk_formula(desk, c->below, &a->high));
  CHECK(!c->above || isfinite(a->low), ERR_INPUT, "there is no such bound: %s", c->above);
  CHECK(!c->below || isfinite(a->high), ERR_INPUT, "there is no such bound: %s", c->below);
  a->holds = (!c->above || a->value > a->low) && (!c->below || a->value < a->high);
  return OK;
}

static enum status answer_equal(struct gallery_desk *desk, const struct gallery_check *c,
                                struct gallery_answer *a) {
  double tolerance;
  TRY(gallery_desk_formula(desk, c->equals, &a->expected));
  TRY(gallery_desk_formula(desk, c->within ? c->within : c->percent, &tolerance));
  a->tolerance = c->within ? tolerance : tolerance / 100 * fabs(a->expected);
  a->low = a->expected - a->tolerance;
  a->high = a->expected + a->tolerance;
  CHECK(isfinite(a->expected), ERR_INPUT, "there is no such number: %s", c->equals);
  CHECK(isfinite(tolerance) && tolerance >= 0, ERR_INPUT, "there is no such tolerance: %s",
        c->within ? c->within : c->percent);
  a->holds = fabs(a->value - a->expected) <= a->tolerance;
  return OK;
}

static enum status answer(struct gallery_desk *desk, const struct gallery_check *c,
                          struct gallery_answer *a) {
  TRY(gallery_desk_formula(desk, c->value, &a->value));
  TRY(c->equals ? answer_equal(desk, c, a) : answer_bound(desk, c, a));
  CHECK(isfinite(a->value), ERR_INPUT, "there is no such number: %s", c->value);
  if (c->scatter) TRY(gallery_desk_formula(desk, c->scatter, &a->scatter));
  CHECK(isfinite(a->scatter) && a->scatter >= 0, ERR_INPUT, "there is no such scatter: %s",
        c->scatter);
  return OK;
}

enum status gallery_answer_all(struct gallery_desk *desk, const struct gallery_entry *e,
                               struct gallery_answer *a) {
  for (size_t i = 0; i < e->n_checks; i++) {
    a[i] = (struct gallery_answer){
        .value = NAN, .expected = NAN, .tolerance = NAN, .low = NAN, .high = NAN};
    a[i].left = gallery_desk_is_quick(desk) && !e->checks[i].quick;
    if (a[i].left) continue;
    const enum status status = answer(desk, &e->checks[i], &a[i]);
    if (status == OK) continue;
    if (status != ERR_INPUT) return status;
    a[i].holds = false;
    if (!isfinite(a[i].value)) a[i].value = NAN;
    snprintf(a[i].failure, sizeof a[i].failure, "%s", status_message());
  }
  return OK;
}

enum gallery_verdict gallery_verdict_of(const struct gallery_entry *e,
                                        const struct gallery_answer *a) {
  bool all = true, ours = true;
  size_t held = 0;
  for (size_t i = 0; i < e->n_checks; i++) {
    if (a[i].left) continue;
    held++;
    if (*a[i].failure) return GALLERY_VERDICT_failed;
    all &= a[i].holds;
    ours &= a[i].holds || e->checks[i].of == GALLERY_ORIGIN_document;
  }
  if (!held) return e->n_checks ? GALLERY_VERDICT_left : GALLERY_VERDICT_none;
  if (!ours || (!all && !e->corrected)) return GALLERY_VERDICT_disagrees;
  return e->corrected ? GALLERY_VERDICT_corrected : GALLERY_VERDICT_agrees;
}

bool gallery_answer_is_expected(const struct gallery_check *c, const struct gallery_answer *a) {
  if (*a->failure) return false;
  if (a->holds != (c->because != NULL)) return true;
  return fabs(a->value - a->low) < a->scatter || fabs(a->value - a->high) < a->scatter;
}

bool gallery_is_expected(const struct gallery_entry *e, const struct gallery_answer *a) {
  for (size_t i = 0; i < e->n_checks; i++)
    if (!a[i].left && !gallery_answer_is_expected(&e->checks[i], &a[i])) return false;
  return true;
}
