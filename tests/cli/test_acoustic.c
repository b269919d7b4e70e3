/* The period of an acoustic mode, from the case file to the peak of a spectrum. */
#include "tests/cli/acoustic.h"

/* 6.7 % below the continuum: that it is the lattice's is certain. */
static void test_peaks_follow_the_lattice(void) {
  acoustic_expect(10, 50, 0.6, 0.015);
}

int main(void) {
  RUN(test_peaks_follow_the_lattice);
  return TEST_RESULT;
}
