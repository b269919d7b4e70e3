#include "exact/solver.h"

#include <stdlib.h>
#include <unistd.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/waves.h"
#include "common/result/result.h"
#include "tests/test.h"

static const struct solver *const solvers[] = {&exact_solver};
static const struct registry registry = {.solvers = solvers, .n_solvers = 1};

static const char good[] =
    "tank: {walls: [[[0, 2], [0, 0], [2.5, 0], [2.5, 2]]]}\n"
    "water: {wave: {kind: standing, amplitude: 0.02, wavelength: 1, depth: 0.7}}\n"
    "time: {end: 1.03, every: 0.25, sample: 0.04}\n"
    "probes: [{name: P, at: [0, 0.3]}, {name: Q, at: [2.5, 0.69], size: 0.1}]\n"
    "gauges: [{name: G, x: 1.1}]\n"
    "runs: [{solver: exact, resolution: 20, order: 2}]\n";

static void test_run_writes_the_theory_at_the_multiples_of_the_output_times(void) {
  char folder[] = "/tmp/plunge-wave-XXXXXX", path[64];
  EXPECT(mkdtemp(folder));
  snprintf(path, sizeof path, "%s/run.h5", folder);
  struct problems problems = {0};
  struct case_file *c = NULL;
  struct result *out = NULL;
  struct result_file *f = NULL;
  struct progress *progress = progress_create(PROGRESS_QUIET);
  EXPECT_OK(case_parse("case.yaml", good, &registry, &problems, &c));
  if (!c) return;
  EXPECT_OK(result_create(path, c, &c->runs[0], &out));
  EXPECT_OK(exact_solver.run(c, &c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  EXPECT_OK(result_read(path, &f));
  if (!f) return;
  struct wave_standing w = wave_standing_create(0.02, 1, 0.7, c->gravity, 0, 0, 2);

  EXPECT(f->n_surfaces == 5 && f->n_energy == 26 && f->n_outputs == 5);
  for (size_t k = 0; k < f->n_surfaces; k++) {
    const struct geo_lines *l = &f->surface[k];
    EXPECT_NEAR(f->surface_time[k], 0.25 * (double)k, 1e-15);
    EXPECT(l->pieces == 1 && !l->closed[0]);
    EXPECT(l->p[0][0] == 0 && l->p[l->points - 1][0] == 2.5);
    EXPECT(l->points >= 2.5 / (0.7 / 20));
    for (size_t i = 0; i < l->points; i++)
      EXPECT_NEAR(l->p[i][1], wave_standing_elevation(&w, l->p[i][0], 0.25 * (double)k), 1e-15);
  }
  for (size_t i = 0; i < f->n_energy; i++) {
    double t = 0.04 * (double)i;
    EXPECT_NEAR(f->energy[i].time, t, 1e-15);
    EXPECT_NEAR(f->gauges[0].value[i], wave_standing_elevation(&w, 1.1, t), 1e-15);
    EXPECT_NEAR(f->probes[0].value[i], 1000 * wave_standing_pressure(&w, 0, 0.3, t), 1e-9);
    /* the mean of a sensor that is half in the air, whose pressure is nearly hydrostatic: within
     * the 2 cm of wave and a seventh of it */
    double wet = wave_standing_elevation(&w, 2.5, t) - 0.64;
    EXPECT_NEAR(f->probes[1].value[i], 9810 * wet * wet / 2 / 0.1, 9810 * 0.02 * 0.4);
  }
  /* the theory's energy varies by the fourth order, (ka)^2 = 0.016 of what the wave holds */
  double above = f->energy[0].total - f->rest_potential;
  for (size_t i = 0; i < f->n_energy; i++)
    EXPECT_NEAR(f->energy[i].total, f->energy[0].total, 0.02 * above);
  EXPECT(f->n_statistics == 1);
  EXPECT_STR(f->statistics[0].name, "theory_error");
  EXPECT_NEAR(f->statistics[0].value, wave_standing_error(&w, 1.03), 1e-15);
  result_file_destroy(f);
  case_destroy(c);
  progress_destroy(progress);
  unlink(path);
  snprintf(path, sizeof path, "%s/run.xdmf", folder);
  unlink(path);
  EXPECT(rmdir(folder) == 0);
}

/* Replaces the first occurrence of `was` in the good case. */
static void expect_problem(const char *was, const char *is, const char *message) {
  char text[2048];
  const char *at = strstr(good, was);
  EXPECT(at);
  if (!at) return;
  snprintf(text, sizeof text, "%.*s%s%s", (int)(at - good), good, is, at + strlen(was));
  struct problems problems = {0};
  struct case_file *c = NULL;
  EXPECT(case_parse("case.yaml", text, &registry, &problems, &c) == ERR_INPUT);
  bool found = false;
  for (size_t i = 0; i < problems.n; i++) found |= strstr(problems.text[i], message) != NULL;
  if (!found)
    TEST_FAIL("no problem says '%s', but %s", message, problems.n ? problems.text[0] : "none");
  problems_destroy(&problems);
  case_destroy(c);
}

static void test_other_cases_are_refused_with_the_reason(void) {
  expect_problem("wave: {kind: standing, amplitude: 0.02, wavelength: 1, depth: 0.7}",
                 "regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]",
                 "found 'exact' with regions of water");
  expect_problem("depth: 0.7", "depth: 0.06", "what theory leaves out is");
  /* (k a) = 0.6: steeper than theory has a meaning for, not yet breaking */
  expect_problem("amplitude: 0.02", "amplitude: 0.099", "allowed: at most 0.5; lower");
}

int main(void) {
  RUN(test_run_writes_the_theory_at_the_multiples_of_the_output_times);
  RUN(test_other_cases_are_refused_with_the_reason);
  return TEST_RESULT;
}
