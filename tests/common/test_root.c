#include "common/base/root.h"

#include "tests/test.h"

static double cubic(double x, const void *with) {
  return x * x * x - *(const double *)with;
}

static void test_root_is_the_last_bit(void) {
  double two = 2, eight = 8;
  double root = root_between(cubic, &two, 0, 7);
  EXPECT(cubic(root, &two) * cubic(nextafter(root, 7), &two) <= 0);
  EXPECT(root_between(cubic, &eight, 2, 7) == 2);
  EXPECT(root_between(cubic, &eight, 0, 2) == 2);
  EXPECT(isnan(root_between(cubic, &eight, 3, 7)));
}

int main(void) {
  RUN(test_root_is_the_last_bit);
  return TEST_RESULT;
}
