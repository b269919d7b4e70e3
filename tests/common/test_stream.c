/* Exact steady periodic waves against their identities and against numbers found otherwise. */
#include "tests/test.h"

#include <math.h>

#include "common/flow/crest.h"

static struct crest wave_of(double height, double length) {
  struct crest w;
  EXPECT_OK(wave_crest_create_periodic(height, length, &w));
  return w;
}

/* H/d = 0.2, T sqrt(g/d) = 3 by another program, Fenton's method with 20 terms, with the four
 * digits that it gave; its surface at some of its places. */
static void test_the_wave_is_the_one_found_elsewhere(void) {
  const double length = 1.6526, digit = 0.6e-4;
  struct crest w = wave_of(0.2, length);
  const double surface[][2] = {{0, 1.1246},      {0.0212, 1.1233}, {0.1071, 1.0972},
                               {0.2591, 1.0340}, {0.4773, 0.9656}, {0.7615, 0.9260}};
  EXPECT_NEAR(w.speed, 0.5509, digit);
  EXPECT_NEAR(length / w.speed, 3, 3e-4); /* of the digits of both */
  EXPECT_NEAR(w.kinetic / length, 0.0023, digit);
  EXPECT_NEAR(w.potential / length, 0.0022, digit);
  for (size_t i = 0; i < sizeof surface / sizeof *surface; i++)
    EXPECT_NEAR(1 + wave_crest_elevation(&w, surface[i][0]), surface[i][1], digit);
  wave_crest_destroy(&w);
}

/* Heights up to the highest that are taken, of waves from very short to very long ones: 2T = cI
 * (Longuet-Higgins, Proc. R. Soc. A 342, 1975), the height and length that were asked for,
 * and a surface of one pressure. */
static void test_every_wave_has_the_identities_of_the_exact_one(void) {
  const double lengths[] = {1 / 6.0, 1.3, 6.2, 14, 50};
  const double parts[] = {0.01, 0.5, 0.9, CREST_STEEPEST};
  for (size_t i = 0; i < sizeof lengths / sizeof *lengths; i++)
    for (size_t j = 0; j < sizeof parts / sizeof *parts; j++) {
      const double length = lengths[i], height = parts[j] * wave_crest_limit(length);
      struct crest w = wave_of(height, length);
      double worst = 0, moved = 0;
      for (double x = -0.7 * length; x < 0.7 * length; x += 0.0371 * length) {
        const double eta = wave_crest_elevation(&w, x);
        worst = fmax(worst, fabs(wave_crest_at(&w, x, eta).head));
        moved = fmax(moved, fabs(wave_crest_at(&w, x, -1).v));
      }
      printf("     lambda/h = %6.3f, H = %.5f h: c = %.10f sqrt(gh), cI/2T - 1 = %.1e, p = %.1e, "
             "%zu modes\n",
             length, height, w.speed, w.speed * w.impulse / (2 * w.kinetic) - 1, worst, w.n);
      EXPECT_NEAR(w.speed * w.impulse, 2 * w.kinetic, 1e-9 * w.kinetic);
      EXPECT_NEAR(wave_crest_elevation(&w, 0) - wave_crest_elevation(&w, length / 2), height,
                  1e-11 * height);
      EXPECT_NEAR(2 * w.x[w.points], length, 1e-11 * length);
      EXPECT_NEAR(worst, 0, 1e-10 * height);
      EXPECT_NEAR(moved, 0, 1e-13);
      wave_crest_destroy(&w);
    }
}

/* Inside, from bed to crest, velocity is the potential's gradient, by central differences over e.
 */
static void test_the_steepest_wave_is_a_potential_flow(void) {
  const double e = 1e-5;
  struct crest w = wave_of(CREST_STEEPEST * wave_crest_limit(7), 7);
  for (double x = -0.3; x < 4; x += 0.0593)
    for (double part = 0; part < 0.99; part += 0.0571) {
      const double y = -1 + part * (1 + wave_crest_elevation(&w, x));
      const struct crest_point p = wave_crest_at(&w, x, y), east = wave_crest_at(&w, x + e, y),
                               west = wave_crest_at(&w, x - e, y);
      const struct crest_point up = wave_crest_at(&w, x, y + e), down = wave_crest_at(&w, x, y - e);
      EXPECT_NEAR((east.potential - west.potential) / (2 * e), p.u, 1e-6);
      EXPECT_NEAR((up.potential - down.potential) / (2 * e), p.v, 1e-6);
      EXPECT(p.head > 0);
    }
  wave_crest_destroy(&w);
}

/* dE = c dI from one wave to the next of the same length (the same, 1975); by central differences
 * over 2e of the height, whose error is of the order e^2. */
static void test_energy_grows_with_speed_times_impulse(void) {
  for (double height = 0.1; height < 0.55; height += 0.2) {
    const double e = 1e-3;
    struct crest low = wave_of(height - e, 6.2), high = wave_of(height + e, 6.2),
                 w = wave_of(height, 6.2);
    const double energy = high.kinetic + high.potential - low.kinetic - low.potential;
    EXPECT_NEAR(energy, w.speed * (high.impulse - low.impulse), 1e-5 * energy);
    wave_crest_destroy(&low);
    wave_crest_destroy(&high);
    wave_crest_destroy(&w);
  }
}

/* c^2 k/g = 1 + e^2 + e^4/2 + e^6/4 - ..., e = kH/2, in deep water (Stokes 1880 to the fourth
 * power, Wilton 1914 beyond): what follows is of order e^8. */
static void test_low_waves_are_those_of_stokes_series(void) {
  const double length = 1 / 6.0, k = 2 * M_PI / length, e = 0.05;
  struct crest w = wave_of(2 * e / k, length);
  EXPECT_NEAR(w.speed * w.speed * k, 1 + e * e + pow(e, 4) / 2 + pow(e, 6) / 4, pow(e, 8));
  wave_crest_destroy(&w);
}

/* In deep water the fastest wave has H/lambda = 0.1387 and is 1.0929 as fast as a low one (L. W.
 * Schwartz, J. Fluid Mech. 62, 1974); the highest has 0.1411. */
static void test_the_fastest_deep_wave_is_schwartz(void) {
  const double length = 1 / 6.0, low = sqrt(length / (2 * M_PI));
  struct crest less = wave_of(0.1365 * length, length), more = wave_of(0.1382 * length, length);
  printf("     c/c0 = %.5f at H/lambda = 0.1365, %.5f at 0.1382\n", less.speed / low,
         more.speed / low);
  EXPECT(less.speed < more.speed);
  EXPECT_NEAR(more.speed / low, 1.0929, 1e-4);
  EXPECT_NEAR(wave_crest_limit(length) / length, 0.1411, 4e-4); /* of a fit */
  wave_crest_destroy(&less);
  wave_crest_destroy(&more);
}

int main(void) {
  RUN(test_the_wave_is_the_one_found_elsewhere);
  RUN(test_every_wave_has_the_identities_of_the_exact_one);
  RUN(test_the_steepest_wave_is_a_potential_flow);
  RUN(test_energy_grows_with_speed_times_impulse);
  RUN(test_low_waves_are_those_of_stokes_series);
  RUN(test_the_fastest_deep_wave_is_schwartz);
  return TEST_RESULT;
}
