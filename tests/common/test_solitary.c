/* The exact solitary wave against its identities and against numbers found otherwise. */
#include "tests/test.h"

#include <math.h>

#include "common/flow/crest.h"

static struct crest crest_of(double amplitude) {
  struct crest w;
  EXPECT_OK(wave_crest_create(amplitude, &w));
  return w;
}

/* A/h = 0.3 by another program, with the digits that it gave: F, and x, eta, phi, u, v. */
static void test_the_wave_is_the_one_found_elsewhere(void) {
  struct crest w = crest_of(0.3);
  const double far[] = {-14.9264050375, 0.000005663638, -0.649453168010, 0.000004978944,
                        -0.000005199533};
  EXPECT_NEAR(w.speed, 1.137523016631, 1e-11);
  EXPECT_NEAR(wave_crest_elevation(&w, far[0]), far[1], 1e-11);
  const struct crest_point p = wave_crest_at(&w, far[0], far[1]);
  EXPECT_NEAR(p.potential, far[2], 1e-10);
  EXPECT_NEAR(p.u, far[3], 1e-11);
  EXPECT_NEAR(p.v, far[4], 1e-11);
  wave_crest_destroy(&w);
}

/* Longuet-Higgins & Fenton, Proc. R. Soc. A 340 (1974): 3V = (F^2 - 1) M (after Starr 1947); and
 * the surface is one of pressure zero: (u - F)^2 + v^2 = F^2 - 2 eta. */
static void test_every_wave_has_the_identities_of_the_exact_one(void) {
  for (double a = 0.05; a < CREST_HIGHEST + 0.01; a += 0.15) {
    struct crest w = crest_of(a);
    const double f2 = w.speed * w.speed;
    printf("     A/h = %.2f: F = %.10f, 3V/((F^2 - 1) M) - 1 = %.1e, %zu modes\n", a, w.speed,
           3 * w.potential / ((f2 - 1) * w.mass) - 1, w.n);
    EXPECT_NEAR(3 * w.potential, (f2 - 1) * w.mass, 1e-10);
    EXPECT_NEAR(wave_crest_elevation(&w, 0), a, 1e-11);
    for (double x = -9; x < 9; x += 0.37) {
      const double eta = wave_crest_elevation(&w, x);
      const struct crest_point p = wave_crest_at(&w, x, eta), bed = wave_crest_at(&w, x, -1);
      EXPECT_NEAR(pow(p.u - w.speed, 2) + p.v * p.v, f2 - 2 * eta, 1e-9);
      EXPECT_NEAR(bed.v, 0, 1e-12);
    }
    wave_crest_destroy(&w);
  }
}

/* M. S. Longuet-Higgins & J. D. Fenton, Proc. R. Soc. A 340 (1974): the fastest has A/h = 0.796 and
 * F = 1.294. */
static void test_the_highest_wave_is_not_the_fastest(void) {
  struct crest less = crest_of(0.785), fastest = crest_of(0.796), more = crest_of(0.8);
  EXPECT(less.speed < fastest.speed && fastest.speed > more.speed);
  EXPECT_NEAR(fastest.speed, 1.294, 5e-4);
  wave_crest_destroy(&less);
  wave_crest_destroy(&fastest);
  wave_crest_destroy(&more);
}

int main(void) {
  RUN(test_the_wave_is_the_one_found_elsewhere);
  RUN(test_every_wave_has_the_identities_of_the_exact_one);
  RUN(test_the_highest_wave_is_not_the_fastest);
  return TEST_RESULT;
}
