/* Acoustic modes n = 10, 20, 40 by their spectra, as the thesis' figures 2-15, 2-17 and 2-18 have
 * them. */
#include "tests/cli/acoustic.h"

static void test_peaks_follow_the_lattice(void) {
  static const int number[] = {10, 20, 40};
  for (int k = 0; k < 3; k++) acoustic_expect(number[k], 100, 0.6, 0.015);
}

int main(void) {
  RUN(test_peaks_follow_the_lattice);
  return TEST_RESULT;
}
