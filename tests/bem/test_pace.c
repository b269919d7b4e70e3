/* A run whose surface winds up is noticed by its energy, which then changes by itself. */
#include "bem/run/pace.h"

#include "tests/test.h"

static const double STEP = 1e-5; /* sqrt(H/g) */

/* Whether steps with that growth of an energy of one, in 1/sqrt(H/g), run away. */
static bool runs_away(double step, double growth) {
  struct bem_pace p = {0};
  bool away = false;
  for (int i = 0; i < 1000; i++) away |= bem_pace_runs_away(&p, i * step, 1 + growth * i * step, 1);
  bem_pace_destroy(&p);
  return away;
}

/* Coarse films change their budget by 0.005 in unit time, surfaces that wind up by 1 to 1000. */
static void test_energy_that_changes_by_itself_is_noticed(void) {
  EXPECT(runs_away(STEP, 1));
  EXPECT(runs_away(STEP, -1));
  EXPECT(runs_away(1e-7, 1000));
  EXPECT(!runs_away(STEP, 0.05));
  EXPECT(!runs_away(STEP, -0.05));
}

/* The run then ends in a sentence, with what is known until then. */
static void test_a_million_steps_are_enough(void) {
  struct bem_pace p = {0};
  for (int i = 0; i < 999999; i++) EXPECT_OK(bem_pace_add(&p, i * STEP, STEP));
  EXPECT(!bem_pace_is_spent(&p));
  EXPECT_OK(bem_pace_add(&p, 10, STEP));
  EXPECT(bem_pace_is_spent(&p));
  bem_pace_destroy(&p);
}

/* Long steps get on, whatever their errors. */
static void test_long_steps_are_not_watched(void) {
  EXPECT(!runs_away(0.01, 1));
}

/* What a cut takes away is booked. */
static void test_a_new_start_is_measured_from_itself(void) {
  struct bem_pace p = {0};
  EXPECT(!bem_pace_runs_away(&p, 1, 1, 1));
  bem_pace_restarted(&p);
  EXPECT(!bem_pace_runs_away(&p, 1 + STEP, 1.1, 1));
  EXPECT(bem_pace_runs_away(&p, 1 + 2 * STEP, 1.2, 1));
  bem_pace_destroy(&p);
}

/* Of 500 steps, after those that the integrator takes to settle. */
static double cut_of(double (*length)(int i)) {
  struct bem_pace p = {0};
  for (int i = -60; i < 500; i++) EXPECT_OK(bem_pace_add(&p, 1, i < 0 ? 1e-6 : length(i)));
  const double cut = bem_pace_cut(&p);
  bem_pace_destroy(&p);
  return cut;
}

static double by_and_by(int i) {
  return 0.01 * pow(0.98, i);
}

static double now_and_then(int i) {
  return i % 50 == 49 ? 1e-4 : 0.01 + 1e-5 * i;
}

static void test_steps_that_shrink_by_and_by_are_not_cut_short(void) {
  EXPECT(cut_of(by_and_by) == 0);
  EXPECT(cut_of(now_and_then) == 10);
}

int main(void) {
  RUN(test_a_million_steps_are_enough);
  RUN(test_steps_that_shrink_by_and_by_are_not_cut_short);
  RUN(test_energy_that_changes_by_itself_is_noticed);
  RUN(test_long_steps_are_not_watched);
  RUN(test_a_new_start_is_measured_from_itself);
  return TEST_RESULT;
}
