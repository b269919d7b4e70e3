/* Good case files: what the reader makes of them. Bad ones: test_case_bad.c. */
#include "common/case/case.h"
#include "common/flow/flow.h"

#include <stdlib.h>

#include "tests/common/case_registry.h"
#include "tests/test.h"

static struct case_file *parse(const char *text) {
  struct problems problems;
  struct case_file *c = NULL;
  if (case_parse("case.yaml", text, &fake_registry, &problems, &c) != OK) {
    TEST_FAIL("%s", status_message());
    for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "  %s\n", problems.text[i]);
  }
  problems_destroy(&problems);
  return c;
}

#define TANK  "tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
#define WATER "water: {regions: [[[0, 0], [1.5, 0], [1.5, 0.75], [0, 0.75]]]}\n"
#define TIME  "time: {end: 2}\n"
#define RUNS  "runs: [{solver: sph, resolution: 10}]\n"

static void test_minimal_case_has_the_documented_defaults(void) {
  struct case_file *c = parse(TANK WATER TIME RUNS);
  if (!c) return;
  EXPECT(c->density == 1000 && c->gravity == 9.81);
  EXPECT(c->H == 0.75); /* the water's height above the bed */
  EXPECT(c->rectangular && c->flow == &flow_hydrostatic);
  EXPECT_NEAR(c->every, 0.02, 1e-15);
  EXPECT_NEAR(c->sample, 0.002, 1e-15);
  EXPECT_STR(c->title, "case");
  EXPECT(c->n_runs == 1 && c->compare.reference == 1); /* nothing to compare */
  EXPECT_STR(c->runs[0].name, "sph");
  const struct fake_sph *o = c->runs[0].options;
  EXPECT(o->diffusion == 3 && o->order == 4 && o->delta == 0.2 && o->alpha == 0.01 && o->smooth);
  EXPECT(o->note == NULL);
  EXPECT_NEAR(o->c0, 20 * sqrt(9.81 * 0.75), 1e-12);
  case_destroy(c);
}

/* Names may have 64 bytes, and a point's series are named after it. */
static void test_a_series_of_a_long_name_is_found(void) {
#define LONG "abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyzabcdefghi_64"
  struct case_file *c =
      parse(TANK WATER TIME RUNS "points: [{name: " LONG ", at: [0.5, 0.5]}]\n"
                                 "compare: {spectra: [{series: " LONG ".cover}]}\n");
  _Static_assert(sizeof LONG == CASE_LONGEST_NAME + 1, "the longest name");
  if (!c) return;
  EXPECT_STR(c->compare.spectra[0].series, LONG ".cover");
  case_destroy(c);
#undef LONG
}

/* Experiments call the front of the water so, and no point is of theirs. */
static void test_a_point_may_be_called_front(void) {
  struct case_file *c =
      parse(TANK WATER TIME RUNS "points: [{name: front, at: [0.5, 0.5]}]\n"
                                 "compare: {spectra: [{series: front.u}]}\n");
  if (!c) return;
  EXPECT_STR(c->points[0].name, "front");
  case_destroy(c);
}

/* Of several keys all combinations, the last key's values in a row; of a list its items. */
static void test_a_sweep_is_several_runs(void) {
  static const char *const names[] = {
      "a", "sph-25-none", "sph-25-antuono", "sph-50-none", "sph-50-antuono", "c1-7", "c2-8", "sph"};
  struct case_file *c = parse(
      TANK WATER TIME
      "runs:\n  - {name: a, solver: sph, resolution: 5}\n"
      "  - {solver: sph, alpha: 0.5, sweep: {resolution: [25, 50], diffusion: [none, antuono]}}\n"
      "  - {name: 'c{order}-{resolution}', solver: sph, sweep: [{order: 1, resolution: 7}, "
      "{resolution: 8, "
      "order: 2, c0: 3 m/s}]}\n"
      "  - {solver: sph, resolution: 9}\n"
      "compare: {reference: sph-50-none, tolerances: [{measure: front, max: 1, runs: [c2-8]}]}\n");
  if (!c) return;
  EXPECT(c->n_runs == 8 && c->compare.reference == 3 && c->compare.tolerances[0].runs[0] == 6);
  for (size_t i = 0; i < 8 && i < c->n_runs; i++) EXPECT_STR(c->runs[i].name, names[i]);
  const struct fake_sph *o = c->runs[4].options, *last = c->runs[6].options;
  EXPECT(o->alpha == 0.5 && o->diffusion == 3 && c->runs[4].resolution == 50);
  EXPECT(c->runs[2].resolution == 25 && c->runs[5].resolution == 7);
  EXPECT(last->order == 2 && last->c0 == 3 && last->alpha == 0.01 && c->runs[6].line == 7);
  case_destroy(c);
}

static void test_units_convert_with_the_scales(void) {
  struct case_file *c = parse("fluid: {gravity: 2.5}\nscales: {H: 40 cm}\n" TANK
                              "water: {regions: [[[0, 0], [2 H, 0], ['2H', H], [0, 1.0 H]]], "
                              "velocity: [1 sqrt(gH), -0.5 m/s]}\n"
                              "time: {end: 6 sqrt(H/g), every: 3 sqrt( H / g ), sample: 5 ms}\n"
                              "probes: [{name: P, at: [0, 2.5e1 mm], size: 20 mm}]\n" RUNS);
  if (!c) return;
  EXPECT_NEAR(c->H, 0.4, 1e-16);
  EXPECT_NEAR(c->water.p[2][0], 0.8, 1e-15);
  EXPECT_NEAR(c->end, 2.4, 1e-15); /* sqrt(0.4/2.5) = 0.4 */
  EXPECT_NEAR(c->every, 1.2, 1e-15);
  EXPECT_NEAR(c->sample, 0.005, 1e-18);
  EXPECT_NEAR(c->velocity[0], 1, 1e-15);
  EXPECT(c->velocity[1] == -0.5);
  EXPECT_NEAR(c->probes[0].y, 0.025, 1e-17);
  EXPECT_NEAR(c->probes[0].size, 0.02, 1e-17);
  case_destroy(c);
}

/* Of the comparison, not of a result: without one in the fingerprint. */
static void test_probes_may_be_averaged(void) {
#define PROBES "scales: {H: 10}\nprobes: [{name: P, at: [0, 1]}, {name: Q, at: [0, 0]}]\n"
  struct case_file *a = parse(TANK WATER TIME RUNS PROBES);
  struct case_file *b =
      parse(TANK WATER TIME RUNS PROBES
            "compare: {averages: [{probe: Q, over: 0.05 sqrt(H/g)}, {over: 0, probe: P}]}\n");
  if (a && b) {
    char of_a[33], of_b[33];
    EXPECT(a->compare.n_averages == 0 && b->compare.n_averages == 2);
    EXPECT(b->compare.averages[0].probe == 1 && b->compare.averages[1].probe == 0);
    EXPECT_NEAR(b->compare.averages[0].over, 0.05 * sqrt(10 / 9.81), 1e-15);
    EXPECT(b->compare.averages[1].over == 0);
    case_fingerprint(a, &a->runs[0], of_a);
    case_fingerprint(b, &b->runs[0], of_b);
    EXPECT_STR(of_b, of_a);
  }
  case_destroy(a);
  case_destroy(b);
}

static void test_clockwise_water_is_turned_round(void) {
  struct case_file *c =
      parse(TANK "water: {regions: [[[0, 0], [0, 1], [2, 1], [2, 0]]]}\n" TIME RUNS);
  if (!c) return;
  EXPECT_NEAR(geo_piece_area(&c->water, 0), 2, 1e-15);
  case_destroy(c);
}

static void test_rectangular_tanks_are_recognised(void) {
  static const struct {
    const char *walls;
    bool rectangular;
  } tanks[] = {
      {"[[[0, 3], [0, 0], [4, 0], [4, 3]]]", true},
      {"[[[0, 3], [0, 1.5], [0, 0], [1, 0], [4, 0], [4, 1], [4, 2]]]", true},
      {"[[[0, 3], [0, 0], [4, 0], [5, 3]]]", false},
      {"[[[0, 3], [0, 0], [2, 0.1], [4, 0], [4, 3]]]", false},
      {"[[[0, 3], [0, 0], [4, 0]]]", false},
      {"[[[0, 0], [4, 0], [4, 3], [0, 3], [0, 0]]]", false},
  };
  for (size_t i = 0; i < sizeof tanks / sizeof *tanks; i++) {
    char text[512];
    snprintf(text, sizeof text,
             "tank: {walls: %s}\nwater: {regions: [[[1, 0.5], [2, 0.5], [2, 1], [1, 1]]]}\n%s",
             tanks[i].walls, TIME RUNS);
    struct case_file *c = parse(text);
    if (c && c->rectangular != tanks[i].rectangular) TEST_FAIL("%s", tanks[i].walls);
    case_destroy(c);
  }
}

static void test_rest_potential_of_box_and_polygon_agree(void) {
  /* the same tank, once recognised as a rectangle and once, with a lid's corner, as a polygon */
  struct case_file *a = parse(TANK WATER TIME RUNS);
  struct case_file *b =
      parse("tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3], [3.9, 3]]]}\n" WATER TIME RUNS);
  if (a && b) {
    double level = 1.5 * 0.75 / 4; /* area over width */
    EXPECT(!b->rectangular);
    EXPECT_NEAR(case_water_area(a), 1.125, 1e-15);
    EXPECT_NEAR(case_rest_potential(a), 9810 * 4 * level * level / 2, 1e-9);
    EXPECT_NEAR(case_rest_potential(b), case_rest_potential(a), 1e-9); /* bisected to rounding */
  }
  case_destroy(a);
  case_destroy(b);
}

static void test_fingerprint_ignores_what_a_result_does_not_depend_on(void) {
  struct case_file *a = parse("title: one\n" TANK WATER TIME RUNS);
  struct case_file *b =
      parse("# the same water\ntime: {end: 2.0}\nruns:\n- {solver: bem, resolution: 5}\n"
            "- {name: other, alpha: 0.010, resolution: 1e1, solver: sph}\n" WATER TANK
            "compare: {reference: bem, times: [1]}\n");
  struct case_file *c = parse(TANK WATER TIME "runs: [{solver: sph, resolution: 10, alpha: 0.02}]");
  struct case_file *d = parse(TANK WATER "time: {end: 2.000000001}\n" RUNS);
  if (a && b && c && d) {
    char of_a[33], of_b[33], of_c[33], of_d[33];
    case_fingerprint(a, &a->runs[0], of_a);
    case_fingerprint(b, &b->runs[1], of_b);
    case_fingerprint(c, &c->runs[0], of_c);
    case_fingerprint(d, &d->runs[0], of_d);
    EXPECT(strlen(of_a) == 32);
    EXPECT_STR(of_b, of_a);
    EXPECT(strcmp(of_c, of_a) && strcmp(of_d, of_a) && strcmp(of_c, of_d));
  }
  case_destroy(a);
  case_destroy(b);
  case_destroy(c);
  case_destroy(d);
}

static void test_default_times_are_the_outputs_nearest_to_thirds(void) {
  static const struct {
    const char *time;
    size_t n;
    double at[3];
  } cases[] = {{"time: {end: 5, every: 0.1}\n", 3, {1.7, 3.3, 5}},
               {"time: {end: 2, every: 0.1}\n", 3, {0.7, 1.3, 2}},
               {"time: {end: 2, every: 1}\n", 2, {1, 2}},
               {"time: {end: 1, every: 1}\n", 1, {1}}};
  for (size_t k = 0; k < 4; k++) {
    char text[512];
    snprintf(text, sizeof text,
             TANK WATER "%sruns: [{solver: sph, resolution: 10}, {name: b, solver: sph, "
                        "resolution: 20}]\n",
             cases[k].time);
    struct case_file *c = parse(text);
    if (!c) continue;
    EXPECT(c->compare.n_times == cases[k].n);
    for (size_t i = 0; i < cases[k].n && i < c->compare.n_times; i++)
      EXPECT_NEAR(c->compare.times[i], cases[k].at[i], 1e-12);
    case_destroy(c);
  }
}

/* Comparable: other resolution, scheme, probes, duration, and lengths written in another unit. */
static void test_water_fingerprint_tells_what_can_be_compared(void) {
#define FLUID(g, H) "fluid: {gravity: " g "}\nscales: {H: " H "}\n"
#define BASIN       "tank: {walls: [[[0, 3], [0, 0], [3.2196, 0], [3.2196, 3]]]}\n"
#define COLUMN(y)   "water: {regions: [[[0, 0], [1.2, 0], [1.2, " y "], [0, " y "]]]}\n"
#define WAVE(a)     "water: {wave: {kind: standing, amplitude: " a ", wavelength: 6.4392, depth: 1}}\n"
  static const struct {
    const char *text;
    bool same;
  } cases[] = {
      {FLUID("9.81", "0.6") BASIN COLUMN("0.6") TIME RUNS, true},
      {FLUID("9.81", "0.6") "tank: {walls: [[[0, 5 H], [-0, 0], [5.366 H, 0], [5.366 H, 5 H]]]}\n"
                            "water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]}\n"
                            "probes: [{at: [0, 0.1], name: p}]\n"
                            "time: {end: 7}\nruns: [{solver: sph, resolution: 99, alpha: 0}]\n",
       true},
      {FLUID("9.81", "0.6") BASIN COLUMN("0.61") TIME RUNS, false},
      {FLUID("9.81", "0.61") BASIN COLUMN("0.6") TIME RUNS, false},
      {FLUID("9.82", "0.6") BASIN COLUMN("0.6") TIME RUNS, false},
      {FLUID("9.81", "0.6") BASIN WAVE("0.03") TIME RUNS, false},
      {FLUID("9.81", "0.6") BASIN WAVE("0.02") TIME RUNS, false},
  };
  char of[7][33];
  for (size_t i = 0; i < 7; i++) {
    struct case_file *c = parse(cases[i].text);
    of[i][0] = 0;
    if (c) case_water_fingerprint(c, of[i]);
    EXPECT(strlen(of[i]) == 32);
    EXPECT(cases[i].same == !strcmp(of[i], of[0]));
    case_destroy(c);
  }
  EXPECT(strcmp(of[5], of[6]));
}

int main(void) {
  RUN(test_minimal_case_has_the_documented_defaults);
  RUN(test_a_series_of_a_long_name_is_found);
  RUN(test_a_point_may_be_called_front);
  RUN(test_a_sweep_is_several_runs);
  RUN(test_units_convert_with_the_scales);
  RUN(test_probes_may_be_averaged);
  RUN(test_clockwise_water_is_turned_round);
  RUN(test_rectangular_tanks_are_recognised);
  RUN(test_rest_potential_of_box_and_polygon_agree);
  RUN(test_fingerprint_ignores_what_a_result_does_not_depend_on);
  RUN(test_default_times_are_the_outputs_nearest_to_thirds);
  RUN(test_water_fingerprint_tells_what_can_be_compared);
  return TEST_RESULT;
}
