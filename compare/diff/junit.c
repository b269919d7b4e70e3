#include <stdlib.h>

#include "compare/diff/write.h"
#include "compare/markup.h"

static void testcase(struct markup *m, const struct cmp_diff_run *run, const char *name) {
  cmp_markup_open(m, "testcase", NULL);
  cmp_markup_attribute(m, "classname", run->name);
  cmp_markup_attribute(m, "name", name);
}

static void outcome(struct markup *m, const char *tag, const char *type, const char *message) {
  cmp_markup_open(m, tag, NULL);
  cmp_markup_attribute(m, "message", message);
  if (type) cmp_markup_attribute(m, "type", type);
  cmp_markup_close(m);
}

static void quantity(struct markup *m, const struct cmp_diff_run *run,
                     const struct result_quantity *q) {
  testcase(m, run, q->name);
  if (q->ignored) outcome(m, "skipped", NULL, "ignored by a tolerance");
  if (q->differs) {
    char *says = result_quantity_say(run->d, q);
    outcome(m, "failure", "difference", says ? says : "differs");
    free(says);
  }
  cmp_markup_close(m);
}

/* A file that is only on one side is one case of its own. */
static void suite(struct markup *m, const struct cmp_diff_run *run) {
  const bool alone = run->outcome == CMP_DIFF_ONLY_A || run->outcome == CMP_DIFF_ONLY_B;
  cmp_markup_open(m, "testsuite", NULL);
  cmp_markup_attribute(m, "name", run->name);
  cmp_markup_number(m, "tests", run->d ? run->d->n : 1);
  cmp_markup_number(m, "failures", run->d ? run->d->n_differ : alone);
  cmp_markup_number(m, "errors", run->trouble != NULL);
  cmp_markup_number(m, "skipped", run->d ? run->d->n_ignored : 0);
  for (size_t i = 0; run->d && i < run->d->n; i++) quantity(m, run, &run->d->quantity[i]);
  if (!run->d) {
    testcase(m, run, "file");
    if (alone)
      outcome(m, "failure", "missing", cmp_diff_word(run->outcome));
    else
      outcome(m, "error", "unreadable", run->trouble);
    cmp_markup_close(m);
  }
  cmp_markup_close(m);
}

enum status cmp_diff_junit(const struct cmp_diff *d, FILE *out) {
  struct markup *m = cmp_markup_create(out, true);
  CHECK(m, ERR_MEMORY, "no memory for a report");
  cmp_markup_open(m, "testsuites", NULL);
  cmp_markup_attribute(m, "name", "plunge diff");
  for (size_t i = 0; i < d->n; i++) suite(m, &d->run[i]);
  const bool good = cmp_markup_finish(m);
  cmp_markup_destroy(m);
  CHECK(good, ERR_IO, "cannot write the JUnit report");
  return OK;
}
