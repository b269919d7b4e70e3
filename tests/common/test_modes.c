/* The modes of compressible water against their equations and against numbers found otherwise. */
#include "tests/test.h"

#include "common/flow/modes.h"

/* g = H = 1, c^2 = 10, one wave of the length of the depth. */
static const struct wave_column column = {1, 3.1622776601683795, 1, 2 * M_PI};

/* Found by another program, with the digits that it gave. */
static void test_the_gravity_wave_is_the_one_found_elsewhere(void) {
  struct wave_mode m = wave_mode_gravity(&column);
  EXPECT_NEAR(m.root, 6.2331857, 5e-8);
  EXPECT_NEAR(m.omega * m.omega / (2 * M_PI), 0.99999229, 5e-9);
}

/* The root to first order in delta H, (2.59) and (2.60) as they should read:
 * nu H = a - (delta H/a) (1 - k^2)/(1 + k^2), a = (2n + 1) pi/2, k = a/(kappa H). At n = 20 it is
 * off by 8.8e-9, and by (delta H)^2 at most. */
static void test_acoustic_roots_are_those_of_the_expansion(void) {
  for (int n = 0; n <= 40; n++) {
    const struct wave_mode m = wave_mode_acoustic(&column, n);
    const double a = (2 * n + 1) * M_PI / 2, k = a / column.wavenumber;
    const double first = a - m.delta / a * (1 - k * k) / (1 + k * k);
    EXPECT_NEAR(m.root, first, m.delta * m.delta);
    if (n == 20) EXPECT_NEAR(fabs(m.root - first), 8.8e-9, 5e-11);
  }
}

/* By differences of step e: their error is e^2/12 psi'''' and rounding over e^2. */
static void expect_equations(const struct wave_mode *m) {
  const double e = 1e-3 / fmax(m->root, 1), sigma2 = pow(m->omega / m->in.sound, 2);
  const double kappa2 = m->in.wavenumber * m->in.wavenumber, H = m->in.depth;
  const double scale = fabs(wave_mode_slope(m, 0)) + fabs(wave_mode_psi(m, 0));
  for (int i = 0; i < 7; i++) {
    const double y = -H * (0.07 + 0.14 * i), psi = wave_mode_psi(m, y);
    const double up = wave_mode_psi(m, y + e), down = wave_mode_psi(m, y - e);
    const double slope = (up - down) / (2 * e), second = (up - 2 * psi + down) / (e * e);
    EXPECT_NEAR(wave_mode_slope(m, y), slope, 1e-6 * scale);
    EXPECT_NEAR(second, 2 * m->delta * slope + (kappa2 - sigma2) * psi,
                1e-5 * scale * fmax(m->root, 1));
  }
  EXPECT_NEAR(wave_mode_slope(m, -H), 0, 1e-11 * scale);
  EXPECT_NEAR(m->in.gravity * wave_mode_slope(m, 0), m->omega * m->omega * wave_mode_psi(m, 0),
              1e-10 * m->in.gravity * scale);
}

static void test_modes_satisfy_their_equations(void) {
  const struct wave_column shallow = {9.81, 31, 0.6, 1.3}, deep = {9.81, 40, 1, 60};
  const struct wave_column *const in[] = {&column, &shallow, &deep};
  for (size_t k = 0; k < 3; k++) {
    struct wave_mode m = wave_mode_gravity(in[k]);
    expect_equations(&m);
    EXPECT_NEAR(wave_mode_psi(&m, 0), 1, 1e-15);
    for (int n = 0; n < 25; n += 6) {
      m = wave_mode_acoustic(in[k], n);
      expect_equations(&m);
    }
  }
}

static void test_an_acoustic_mode_has_as_many_zeros_as_its_number(void) {
  for (int n = 0; n <= 20; n += 5) {
    const struct wave_mode m = wave_mode_acoustic(&column, n);
    int zeros = 0;
    for (int i = 0; i < 1000; i++)
      zeros += wave_mode_psi(&m, -1e-3 * i) * wave_mode_psi(&m, -1e-3 * (i + 1)) < 0;
    EXPECT(zeros == n + 1); /* and one within s/nu of the surface */
  }
}

/* Without compressibility the wave is Airy's; what is left falls like 1/c^2. */
static void test_the_gravity_wave_becomes_airys(void) {
  double off[2];
  for (int k = 0; k < 2; k++) {
    const struct wave_column in = {9.81, k ? 400 : 200, 0.7, 3};
    const struct wave_mode m = wave_mode_gravity(&in);
    off[k] = m.omega * m.omega / (9.81 * 3 * tanh(2.1)) - 1;
  }
  EXPECT(fabs(off[0]) < 1e-3 && off[0] != 0);
  EXPECT_NEAR(off[0] / off[1], 4, 0.1);
}

/* u and v are the potential's gradient and the rate of the ways; the pressure its rate. */
static void test_motions_belong_together(void) {
  const struct wave_mode modes[] = {wave_mode_gravity(&column), wave_mode_acoustic(&column, 3)};
  const double A = 1e-3, x = 0.17, y = -0.31, t = 0.0221, e = 1e-5;
  for (int k = 0; k < 2; k++) {
    const struct wave_mode *m = &modes[k];
    const struct wave_motion w = wave_mode_motion(m, A, x, y, t);
#define RATE(of, dx, dy, dt)                                                                       \
  ((wave_mode_motion(m, A, x + (dx), y + (dy), t + (dt)).of -                                      \
    wave_mode_motion(m, A, x - (dx), y - (dy), t - (dt)).of) /                                     \
   (2 * e))
    EXPECT_NEAR(w.u, RATE(potential, e, 0, 0), 1e-6 * A * m->omega);
    EXPECT_NEAR(w.v, RATE(potential, 0, e, 0), 1e-6 * A * m->omega);
    EXPECT_NEAR(w.push, -RATE(potential, 0, 0, e), 1e-6 * A * m->omega * m->omega);
    EXPECT_NEAR(w.u, RATE(xi, 0, 0, e), 1e-6 * A * m->omega);
    EXPECT_NEAR(w.v, RATE(zeta, 0, 0, e), 1e-6 * A * m->omega);
    EXPECT_NEAR(wave_mode_motion(m, A, x, 0, t).zeta, A * cos(2 * M_PI * x - m->omega * t),
                1e-9 * A);
#undef RATE
  }
}

int main(void) {
  RUN(test_the_gravity_wave_is_the_one_found_elsewhere);
  RUN(test_acoustic_roots_are_those_of_the_expansion);
  RUN(test_modes_satisfy_their_equations);
  RUN(test_an_acoustic_mode_has_as_many_zeros_as_its_number);
  RUN(test_the_gravity_wave_becomes_airys);
  RUN(test_motions_belong_together);
  return TEST_RESULT;
}
