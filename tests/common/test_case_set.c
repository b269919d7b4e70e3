/* Overrides: --set PATH=VALUE. */
#include <stdlib.h>

#include "common/case/case.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

static const char base[] = "# comments go\n"
                           "title: Overridden\n"
                           "scales: {H: 0.5}\n"
                           "tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
                           "water: {regions: [&column [[0, 0], [1, 0], [1, 1], [0, 1]]]}\n"
                           "time: {end: 2, every: 0.5}\n"
                           "runs:\n"
                           "  - &one {name: fine, solver: sph, resolution: 40, alpha: 0.01}\n"
                           "  - {name: fine.2, solver: sph, resolution: 40}\n"
                           "  - {solver: bem, resolution: 30}\n"
                           "compare:\n"
                           "  tolerances: [{measure: front, max: 0.1}]\n";

/* Loads `base` with overrides; NULL and the messages in `said` when it is refused. */
static struct case_file *load(size_t n, const char *const *set, char *said, size_t size) {
  struct problems problems;
  struct case_file *c = NULL;
  char path[] = "case-set-XXXXXX";
  int file = mkstemp(path);
  FILE *out = file < 0 ? NULL : fdopen(file, "w");
  said[0] = 0;
  if (!out) return NULL;
  fputs(base, out);
  fclose(out);
  case_load(path, n, set, &fake_registry, &problems, &c);
  for (size_t i = 0, at = 0; i < problems.n && at < size; i++)
    at += (size_t)snprintf(said + at, size - at, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  remove(path);
  return c;
}

static void test_overrides_reach_every_kind_of_place(void) {
  const char *set[] = {"runs.fine.alpha=0.02",
                       "runs.fine.2.resolution=80",
                       "runs.bem.resolution=60",
                       "time.end=4 sqrt(H/g)",
                       "time.every=1 sqrt(H/g)",
                       "fluid.density=998",
                       "compare.reference=bem",
                       "compare.tolerances[0].max=0.2",
                       "compare.times=[2 sqrt(H/g), 3 sqrt(H/g)]",
                       "title=A title: with # signs"};
  char said[4096];
  struct case_file *c = load(sizeof set / sizeof *set, set, said, sizeof said);
  if (!c) {
    TEST_FAIL("%s", said);
    return;
  }
  const struct fake_sph *fine = c->runs[0].options, *fine2 = c->runs[1].options;
  EXPECT(fine->alpha == 0.02 && fine2->alpha == 0.01);
  EXPECT(c->runs[0].resolution == 40 && c->runs[1].resolution == 80 && c->runs[2].resolution == 60);
  EXPECT_NEAR(c->end, 4 * sqrt(0.5 / 9.81), 1e-15);
  EXPECT(c->density == 998 && c->gravity == 9.81);
  EXPECT(c->compare.reference == 2 && c->compare.n_times == 2);
  EXPECT(c->compare.tolerances[0].max == 0.2);
  EXPECT_STR(c->title, "A title: with # signs");

  /* the text that goes into result files is the case as run */
  struct problems problems;
  struct case_file *again = NULL;
  EXPECT_OK(case_parse("result", c->text, &fake_registry, &problems, &again));
  problems_destroy(&problems);
  for (size_t i = 0; again && i < c->n_runs; i++) {
    char of_c[33], of_again[33];
    case_fingerprint(c, &c->runs[i], of_c);
    case_fingerprint(again, &again->runs[i], of_again);
    EXPECT_STR(of_again, of_c);
  }
  if (again) EXPECT_STR(again->title, c->title);
  case_destroy(again);
  case_destroy(c);
}

static void test_without_overrides_the_text_is_the_file(void) {
  char said[1024];
  struct case_file *c = load(0, NULL, said, sizeof said);
  if (c) EXPECT_STR(c->text, base);
  case_destroy(c);
}

static void test_an_override_does_not_leak_through_aliases(void) {
  struct problems problems;
  struct case_file *c = NULL;
  const char text[] = "tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
                      "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]}\n"
                      "time: {end: 2}\n"
                      "compare: {tolerances: [&t {measure: front, max: 0.1}, *t]}\n"
                      "runs: [{solver: sph, resolution: 9}, {solver: bem, resolution: 9}]\n";
  const char *set[] = {"compare.tolerances[1].max=0.3"};
  char path[] = "case-set-XXXXXX";
  int file = mkstemp(path);
  FILE *out = file < 0 ? NULL : fdopen(file, "w");
  if (!out) return;
  fputs(text, out);
  fclose(out);
  EXPECT_OK(case_load(path, 1, set, &fake_registry, &problems, &c));
  if (c) EXPECT(c->compare.tolerances[0].max == 0.1 && c->compare.tolerances[1].max == 0.3);
  problems_destroy(&problems);
  case_destroy(c);
  remove(path);
}

static void test_bad_overrides_get_exact_messages(void) {
  static const struct {
    const char *set, *message;
  } cases[] = {
      {"runs.nope.alpha=1",
       "--set runs.nope.alpha=1: found no item 'nope' in the list; allowed: fine, "
       "fine.2, [2]; correct the path\n"},
      {"runs[7].alpha=1", "--set runs[7].alpha=1: found no item '[7]' in the list; allowed: fine, "
                          "fine.2, [2]; correct the path\n"},
      {"runs.fine.alhpa=1",
       "--set runs.fine.alhpa=1: runs.fine.alhpa: found an unknown key; allowed: "
       "name, solver, resolution, sweep, diffusion, order, delta, alpha, c0, smooth, "
       "note; did you mean 'alpha'?\n"},
      {"runs.fine.alpha=2",
       "--set runs.fine.alpha=2: runs.fine.alpha: found '2'; allowed: a number "
       "from 0 to 1\n"},
      {"runs.fine.alpha=",
       "--set runs.fine.alpha=: runs.fine.alpha: found nothing; allowed: a number "
       "from 0 to 1\n"},
      {"runs.fine=x",
       "--set runs.fine=x: runs[0]: found 'x'; allowed: a mapping with the keys name, "
       "solver, resolution, sweep\n"},
      {"time.end.x=1",
       "--set time.end.x=1: found '2'; allowed: a path to a key of a section or of a "
       "run; the path goes on behind a value: correct it\n"},
      {"time.every=3",
       "--set time.every=3: time.every: found 3 s; allowed: at most time.end, 2 s; make "
       "it smaller\n"},
      {"tiem.end=3",
       "--set tiem.end=3: tiem: found an unknown key; allowed: title, fluid, scales, "
       "tank, water, time, probes, gauges, points, runs, compare; did you mean 'time'?\n"},
      {"alpha", "--set alpha: found no 'PATH=VALUE'; allowed: runs.NAME.KEY=VALUE or "
                "SECTION.KEY=VALUE\n"},
      {"=1",
       "--set =1: found no 'PATH=VALUE'; allowed: runs.NAME.KEY=VALUE or SECTION.KEY=VALUE\n"},
      {"time..end=1",
       "--set time..end=1: found an empty word in the path; allowed: words joined by "
       "'.'; correct the path\n"},
      {"compare.times=[1, ", "--set compare.times=[1, : found a value that is not YAML; allowed: a "
                             "number, a word, a text or a list; correct the brackets or quotes\n"},
      {"compare.times=[0.7]",
       "--set compare.times=[0.7]: compare.times[0]: found 0.7 s; allowed: a "
       "multiple of time.every, 0.5 s; the nearest is 0.5 s\n"},
      {"compare.reference=exact",
       "--set compare.reference=exact: compare.reference: found 'exact'; "
       "allowed: one of the runs fine, fine.2, bem\n"},
      {"fluid.density=-1\n",
       "--set fluid.density=-1\\x0a: fluid.density: found '-1\\x0a'; allowed: a "
       "density above 0 and up to 1000000 in kg/m^3\n"},
  };
  for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
    char said[4096];
    struct case_file *c = load(1, &cases[i].set, said, sizeof said);
    if (c) TEST_FAIL("%s is accepted", cases[i].set);
    EXPECT_STR(said, cases[i].message);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_overrides_reach_every_kind_of_place);
  RUN(test_without_overrides_the_text_is_the_file);
  RUN(test_an_override_does_not_leak_through_aliases);
  RUN(test_bad_overrides_get_exact_messages);
  return TEST_RESULT;
}
