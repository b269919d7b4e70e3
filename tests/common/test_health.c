/* Which runs are sound, doubtful or failed, and why. */
#include "common/result/health.h"

#include "tests/common/result_sample.h"
#include "tests/test.h"

static const double E0 = 700, VOLUME = 2; /* J/m above rest, m^2 */

/* A run whose k-th measure has this value, and all others are zero. */
static void watch_make(struct health_watch *w, size_t k, double value) {
  double of[HEALTH_N] = {0};
  if (k < HEALTH_N) of[k] = value;
  struct result_energy e = {.kinetic = 0, .potential = 900, .internal = 1};
  struct result_step s = {.volume = VOLUME};
  health_watch_begin(w, 200, 1000);
  health_watch_energy(w, &e);
  health_watch_step(w, &s);
  e.time = s.time = 1;
  e.kinetic = of[HEALTH_energy_gained] * E0;
  e.term[RESULT_TERMS - 1] = of[HEALTH_budget] * E0 - e.kinetic;
  e.potential -= of[HEALTH_budget] > 0 ? 2 * of[HEALTH_budget] * E0 : 0; /* lost, not gained */
  s.removed_volume = (of[HEALTH_spilled] + of[HEALTH_lost] + of[HEALTH_cut_away]) * VOLUME;
  s.volume = VOLUME - s.removed_volume - of[HEALTH_volume_change] * VOLUME;
  health_watch_energy(w, &e);
  health_watch_step(w, &s);
  health_watch_statistic(w, "largest_mach", of[HEALTH_mach]);
  health_watch_statistic(w, "lowest_density", 1 - of[HEALTH_density_change] / 2);
  health_watch_statistic(w, "highest_density", 1 + of[HEALTH_density_change]);
  health_watch_statistic(w, "spilled_volume", of[HEALTH_spilled] * VOLUME);
  health_watch_statistic(w, "lost_volume", of[HEALTH_lost] * VOLUME);
  health_watch_statistic(w, "steps", 1000);
  health_watch_statistic(w, "steps_cut", of[HEALTH_steps_cut] * 1000);
  if (of[HEALTH_theory_error] > 0) /* of a theory only */
    health_watch_statistic(w, "theory_error", of[HEALTH_theory_error]);
}

static struct health judged(size_t k, double value) {
  struct health_watch w;
  struct health h;
  watch_make(&w, k, value);
  health_judge(&w, "", &h);
  return h;
}

static void test_nothing_wrong_is_sound(void) {
  struct health h = judged(HEALTH_N, 0);
  EXPECT(h.verdict == HEALTH_SOUND);
  EXPECT_STR(h.reasons, "");
  EXPECT_STR(h.missing, "");
  for (size_t k = 0; k < HEALTH_N; k++) EXPECT(h.value[k] == 0 || k == HEALTH_theory_error);
}

/* One measure after another just below and above its limits; its words say so, and no other's. */
static void test_each_measure_has_its_limits(void) {
  for (size_t k = 0; k < HEALTH_N; k++) {
    const struct health_measure *m = &health_measures[k];
    struct health below = judged(k, 0.99 * m->doubtful), above = judged(k, 1.01 * m->doubtful);
    if (below.verdict != HEALTH_SOUND || above.verdict != HEALTH_DOUBTFUL)
      TEST_FAIL("%s: %s below its limit, %s above it: %s", m->name, health_verdicts[below.verdict],
                health_verdicts[above.verdict], above.reasons);
    EXPECT(!strncmp(above.reasons, m->before, strlen(m->before)) && !strchr(above.reasons, ';'));
    EXPECT_NEAR(above.value[k], 1.01 * m->doubtful, 1e-12);
    if (m->failed == HEALTH_NO_LIMIT) continue;
    EXPECT(judged(k, 0.99 * m->failed).verdict == HEALTH_DOUBTFUL);
    EXPECT(judged(k, 1.01 * m->failed).verdict == HEALTH_FAILED);
  }
}

/* The speed of sound that is too small, and the run without dissipation, as they were found. */
static void test_words_are_plain(void) {
  EXPECT_STR(judged(HEALTH_mach, 4.06).reasons,
             "speeds reach 4.06 of the speed of sound (failed beyond 1)");
  EXPECT_STR(judged(HEALTH_budget, 17.45).reasons,
             "the budget of energy is off by 17.4 E0 (failed beyond 0.1 E0)");
  EXPECT_STR(judged(HEALTH_spilled, 0.02).reasons,
             "over the walls spilled 2 % of the water (doubtful beyond 0.1 %)");
}

/* The shipped standing wave: its theory leaves out 1.1 %, in its energies too, where 2 % are
 * allowed; it is not doubtful for the one and sound for the other. */
static void test_energy_of_a_theory_is_judged_as_its_error(void) {
  struct health_watch w;
  struct health h;
  watch_make(&w, HEALTH_energy_gained, 0.0113);
  health_watch_statistic(&w, "theory_error", 0.0112);
  health_judge(&w, "", &h);
  EXPECT(h.verdict == HEALTH_SOUND && strstr(h.facts, "energy gained 0.0113 E0"));
  watch_make(&w, HEALTH_budget, 0.03);
  health_watch_statistic(&w, "theory_error", 0.0112);
  health_judge(&w, "", &h);
  EXPECT_STR(h.reasons, "the budget of energy is off by 0.03 E0 (doubtful beyond 0.02 E0)");
}

/* Water that a moving tank has set in motion has gained nothing by itself, and is at fault only for
 * what it has beyond that. */
static void test_what_a_moving_tank_gives_is_not_gained(void) {
  struct health_watch w;
  struct health h;
  const struct result_energy given = {
      .time = 2, .potential = 900, .internal = 1, .kinetic = 0.3 * E0, .term = {0, -0.29 * E0}};
  for (int outside = 0; outside < 2; outside++) {
    watch_make(&w, HEALTH_N, 0);
    w.outside[1] = outside;
    health_watch_energy(&w, &given);
    health_judge(&w, "", &h);
    EXPECT_NEAR(h.value[HEALTH_energy_gained], outside ? 0.01 : 0.3, 1e-12);
    EXPECT_NEAR(h.value[HEALTH_budget], 0.01, 1e-12);
  }
}

static void test_what_is_no_number_fails(void) {
  struct health_watch w;
  struct health h;
  watch_make(&w, HEALTH_N, 0);
  health_watch_energy(&w, &(struct result_energy){.time = 2, .kinetic = NAN});
  health_judge(&w, "", &h);
  EXPECT(h.verdict == HEALTH_FAILED && strstr(h.reasons, "not all numbers"));
  watch_make(&w, HEALTH_mach, INFINITY);
  health_judge(&w, "", &h);
  EXPECT(h.verdict == HEALTH_FAILED && strstr(h.reasons, "speeds reach inf"));
}

/* A wave from rest has little energy to divide by, still water none. */
static void test_water_at_rest_is_measured_by_its_column(void) {
  bool at_rest;
  struct result_energy e = {.potential = 5e8};
  EXPECT(health_energy_scale(&e, 5e8 - 1, 1000, &at_rest) == 1000 && at_rest);
  EXPECT(health_energy_scale(&e, 5e8 - 1000, 1000, &at_rest) == 1000 && !at_rest);
  EXPECT(health_energy_scale(NULL, 200, 1000, &at_rest) == 1000 && at_rest);
}

/* A file of before: judged by its series, and it says what it cannot tell; water that does not
 * yield has neither sound nor another density to tell. */
static void test_older_file_is_judged_by_what_it_has(void) {
  struct result_energy e[] = {{.potential = 900}, {.time = 1, .potential = 900 - 0.2 * E0}};
  struct result_step s[] = {{.volume = VOLUME}, {.time = 1, .volume = VOLUME}};
  struct result_file f = {.health = "", .ended = "", .complete = true, .rest_potential = 200};
  struct health h;
  f.H = f.g = f.density = 1;
  f.n_energy = f.n_steps = 2;
  f.energy = e;
  f.steps = s;
  health_of_file(&f, &h);
  EXPECT(h.verdict == HEALTH_FAILED);          /* a fifth of the energy has gone nowhere */
  EXPECT_STR(h.missing, "spilled, steps cut"); /* nor particles to slip through a wall */
  EXPECT(health_since(&f, HEALTH_DOUBTFUL) == 1);
  struct result_statistic_read theory = {"theory_error", "", 0.001};
  f.n_statistics = 1;
  f.statistics = &theory;
  health_of_file(&f, &h);
  EXPECT_STR(h.missing, "");
  f.n_statistics = 0;
  e[1].term[0] = 0.2 * E0;
  e[1].internal = 1e-3;
  health_of_file(&f, &h);
  EXPECT(h.verdict == HEALTH_SOUND);
  EXPECT_STR(h.missing, "Mach, density, spilled, lost, steps cut");
  EXPECT(health_since(&f, HEALTH_DOUBTFUL) == INFINITY);
}

/* Writes a run that ended this way and reads it back. */
static struct result_file *written(const char *ended, const char *broke_off, bool finish,
                                   struct health *h) {
  char path[128];
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  snprintf(path, sizeof path, "%s/health.h5", sample_folder());
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  if (w) {
    EXPECT_OK(result_energy(w, &(struct result_energy){.potential = 5e4}));
    EXPECT_OK(result_step(w, &(struct result_step){.volume = 0.72}));
    EXPECT_OK(result_statistic(w, "largest_mach", 0.125, "1", "a fact"));
    if (*ended) EXPECT_OK(result_ended(w, ended));
    EXPECT_OK(result_health(w, broke_off, h));
    if (finish) EXPECT_OK(result_finish(w));
  }
  result_destroy(w);
  sample_case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  return f;
}

/* A failure stays one when the file is judged again; a stop is none, nor an end on purpose. */
static void test_file_keeps_its_verdict(void) {
  static const struct {
    const char *ended, *broke_off;
    bool finish;
    enum health_verdict verdict;
  } runs[] = {{"", "", true, HEALTH_SOUND},
              {"at t = 1 s: torn", "at t = 1 s: torn", false, HEALTH_FAILED},
              {"stopped at t = 1 s", "", false, HEALTH_SOUND},
              {"the jet touched down", "", true, HEALTH_SOUND}};
  for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
    struct health h, again;
    struct result_file *f = written(runs[k].ended, runs[k].broke_off, runs[k].finish, &h);
    if (!f) continue;
    health_of_file(f, &again);
    EXPECT(h.verdict == runs[k].verdict && again.verdict == h.verdict);
    EXPECT_STR(f->health, health_verdicts[h.verdict]);
    EXPECT_STR(again.reasons, h.reasons);
    EXPECT(again.value[HEALTH_mach] == 0.125);
    result_file_destroy(f);
  }
}

int main(void) {
  RUN(test_nothing_wrong_is_sound);
  RUN(test_each_measure_has_its_limits);
  RUN(test_words_are_plain);
  RUN(test_energy_of_a_theory_is_judged_as_its_error);
  RUN(test_what_a_moving_tank_gives_is_not_gained);
  RUN(test_what_is_no_number_fails);
  RUN(test_water_at_rest_is_measured_by_its_column);
  RUN(test_older_file_is_judged_by_what_it_has);
  RUN(test_file_keeps_its_verdict);
  sample_folder_remove();
  return TEST_RESULT;
}
