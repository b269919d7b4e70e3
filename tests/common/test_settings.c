/* The settings of a comparison out of the case that a result file carries: whatever else is in it
 * may be of another program or version. */
#include "common/case/case.h"

#include "tests/common/case_registry.h"
#include "tests/test.h"

static const double times[] = {0, 0.5, 1};
static const char *const runs[] = {"theirs"}, *const probes[] = {"P"};
static const struct case_frame frame = {.H = 2,
                                        .g = 8,
                                        .tank = {{0, 0}, {4, 3}},
                                        .n_times = 3,
                                        .times = times,
                                        .runs = {1, runs},
                                        .probes = {1, probes}};

static struct case_file *parse(const char *text, struct problems *problems) {
  struct case_file *c = NULL;
  enum status status = case_parse_settings("old.h5", text, &frame, &fake_registry, problems, &c);
  EXPECT((status == OK) == (c != NULL));
  return c;
}

/* Keys, sections, solvers and kinds of water that nobody here knows. */
#define STRANGE                                                                                    \
  "tank: {shape: round}\nwater: {wave: {kind: rogue}}\nfoam: yes\ntime: {end: 1, every: 0.5}\n"    \
  "probes: [{name: Q, depth: 3}]\n"                                                                \
  "runs: [{solver: lattice-gas, cells: 3}, {name: theirs, solver: volume-of-fluid}]\n"

static void test_only_the_comparison_is_read(void) {
  struct problems problems;
  struct case_file *c = parse(
      STRANGE "compare:\n  reference: theirs\n  times: [1 sqrt(H/g)]\n"
              "  tolerances: [{measure: front, max: 0.1, runs: [lattice-gas]}]\n"
              "  averages: [{probe: Q, over: 0.1}]\n  experiments: [{file: gone, target: P}]\n",
      &problems);
  EXPECT(problems.n == 0);
  problems_destroy(&problems);
  if (!c) return;
  EXPECT(c->n_runs == 2 && !strcmp(c->runs[0].name, "theirs") && c->compare.reference == 0);
  EXPECT(c->compare.n_times == 1);
  EXPECT_NEAR(c->compare.times[0], 0.5, 1e-15);
  EXPECT(c->compare.n_tolerances == 1 && c->compare.tolerances[0].runs[0] == 1);
  EXPECT(c->n_probes == 2 && c->compare.averages[0].probe == 1);
  EXPECT(c->compare.n_experiments == 0 && c->end == 1);
  case_destroy(c);
}

static void test_times_that_are_not_given_are_those_of_the_run(void) {
  struct problems problems;
  struct case_file *c = parse(STRANGE, &problems);
  problems_destroy(&problems);
  if (!c) return;
  EXPECT(c->compare.n_times == 2 && c->compare.times[0] == 0.5 && c->compare.times[1] == 1);
  case_destroy(c);
}

static void test_a_result_without_a_case_asks_nothing(void) {
  struct problems problems;
  struct case_file *c = parse("", &problems);
  problems_destroy(&problems);
  if (!c) return;
  EXPECT(c->compare.n_times == 0 && c->compare.n_tolerances == 0 && c->n_runs == 1);
  EXPECT(isinf(c->compare.window.max[0]));
  case_destroy(c);
}

/* What moves the sides is known if this version can move them; nothing else of the tank is. */
static void test_sides_move_as_the_case_says(void) {
  static const struct {
    const char *motions;
    size_t n;
    double x; /* of the left side's top a quarter of a period after t = 0 */
  } tries[] = {
      {"{kind: piston, side: left, amplitude: 0.1 H, period: 1 sqrt(H/g), ramp: 0}", 1, 0.2},
      {"{kind: flap, side: left, amplitude: 0.1, period: 0.5, ramp: 0}", 1, 3 * sin(0.1)},
      {"{kind: piston, side: left, file: gone.csv}", 1, 0},
      {"{kind: dance, side: left}", 0, 0},
      {"{kind: flap, side: left, amplitude: 0.1, period: 0.5, hinge: 9}", 0, 0},
  };
  double p[][2] = {{0, 3}, {0, 0}, {4, 0}, {4, 3}}, then[4][2];
  size_t first[] = {0, 4};
  unsigned char closed[] = {0};
  const struct geo_lines walls = {1, 4, first, closed, p, 0, 0};
  struct case_frame moving = frame;
  moving.walls = &walls;
  for (size_t i = 0; i < sizeof tries / sizeof *tries; i++) {
    char text[256];
    struct problems problems;
    struct case_file *c = NULL;
    snprintf(text, sizeof text, "tank: {shape: round, motions: [%s]}\n", tries[i].motions);
    EXPECT(!case_parse_settings("old.h5", text, &moving, &fake_registry, &problems, &c));
    problems_destroy(&problems);
    if (!c) continue;
    EXPECT(c->n_motions == tries[i].n);
    tank_vertices_at(&walls, c->motions, c->n_motions, 0.125, then, NULL, NULL);
    EXPECT_NEAR(then[0][0], tries[i].x, 1e-12);
    case_destroy(c);
  }
}

static void test_what_is_wrong_is_said(void) {
  static const struct {
    const char *text, *problem;
  } wrong[] = {
      {STRANGE "compare: {times: [0.7], colour: red}\n",
       "old.h5:7: compare.colour: found an unknown key; allowed: reference, times, window"},
      {STRANGE "compare: {tolerances: [{measure: front, max: 1, runs: [sea]}]}\n",
       "old.h5:7: compare.tolerances[0].runs[0]: found 'sea'; allowed: one of the runs theirs, "
       "lattice-gas"},
      {STRANGE "compare: {reference: sea}\n",
       "old.h5:7: compare.reference: found 'sea'; allowed: one of the runs theirs, lattice-gas"},
      {"{", "old.h5:2: found broken YAML"},
      {"- a\n", NULL},
  };
  for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
    struct problems problems;
    struct case_file *c = parse(wrong[i].text, &problems);
    EXPECT((c == NULL) == (wrong[i].problem != NULL));
    if (wrong[i].problem && problems.n &&
        strncmp(problems.text[0], wrong[i].problem, strlen(wrong[i].problem)) != 0)
      TEST_FAIL("%s", problems.text[0]);
    problems_destroy(&problems);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_only_the_comparison_is_read);
  RUN(test_times_that_are_not_given_are_those_of_the_run);
  RUN(test_a_result_without_a_case_asks_nothing);
  RUN(test_sides_move_as_the_case_says);
  RUN(test_what_is_wrong_is_said);
  return TEST_RESULT;
}
