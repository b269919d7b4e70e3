/* hSPH (thesis, 4.2) for longer and finer than in test_hsph.c. */
#include "tests/test.h"

#include "tests/sph/hsph.h"

/* At h = 1/32: the wave is as the lattice has it, and in steps of h/c0 the budget closes. */
static void test_a_wave_lives_for_twenty_periods(void) {
  double closure;
  const struct airy_found e = airy_march(32, 20, 1, &closure);
  const struct airy_found lattice = lattice_march(32, 9.81, 20, 1);
  airy_print("20 periods, h = 1/32", &e);
  airy_print(" lattice", &lattice);
  printf("     the budget closes to %.1e of the wave's energy\n", closure);
  EXPECT_NEAR(e.amplitude, lattice.amplitude, 0.02 * lattice.amplitude);
  EXPECT_NEAR(e.lag, lattice.lag, 0.03);
  EXPECT(fabs(closure) < 1e-4);
}

static void test_the_frequency_converges_at_second_order(void) {
  double off[3], closure;
  for (int i = 0; i < 3; i++) off[i] = 1 - airy_march(16 << i, 1, 1, &closure).frequency;
  printf("     1 - w/w0 %.4f, %.4f, %.4f: order %.2f, %.2f\n", off[0], off[1], off[2],
         log2(off[0] / off[1]), log2(off[1] / off[2]));
  for (int i = 0; i < 2; i++) EXPECT_NEAR(log2(off[i] / off[i + 1]), 2, 0.15);
}

int main(void) {
  RUN(test_a_wave_lives_for_twenty_periods);
  RUN(test_the_frequency_converges_at_second_order);
  return TEST_RESULT;
}
