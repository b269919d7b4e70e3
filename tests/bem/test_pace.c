/* A run whose surface winds up is noticed by its energy, which then changes by itself. */
#include "bem/pace.h"

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

int main(void) {
  RUN(test_energy_that_changes_by_itself_is_noticed);
  RUN(test_long_steps_are_not_watched);
  RUN(test_a_new_start_is_measured_from_itself);
  return TEST_RESULT;
}
