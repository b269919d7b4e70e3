/* The solver against what is known: the released column, an acoustic and a standing gravity wave.
 */
#include "tests/test.h"

#include "common/flow/waves.h"
#include "sph/fluid/energy.h"
#include "sph/observe/probe.h"
#include "tests/sph/pool.h"

#define COLUMN                                                                                     \
  "title: released column\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]]}\n"    \
  "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: released}\n" POOL_TIMES

/* Plane fitted to the vertical acceleration of the particles within 0.1 H of the wall and between 4
 * dx and 4 dx + 0.1 H below the surface, taken at the corner. Nearer than 3h = 4 dx the pressure
 * force of P is consistent in the mean only (P eq. (3)): rows alternate by some percent of g. */
static double corner_acceleration(const struct sph *s) {
  double A[3][4] = {{0}};
  for (size_t i = 0; i < s->f.n; i++) {
    double x = s->f.w.x[i], depth = 1 - s->f.w.y[i];
    if (x > 0.1 || depth < 4 * s->dx || depth > 4 * s->dx + 0.1) continue;
    double row[4] = {1, x, depth, s->f.k[0].v[i]};
    for (int k = 0; k < 3; k++)
      for (int l = 0; l < 4; l++) A[k][l] += row[k] * row[l];
  }
  for (int k = 0; k < 3; k++)
    for (int r = 0; r < 3; r++) {
      double f = r == k ? 0 : A[r][k] / A[k][k];
      for (int l = 0; l < 4; l++) A[r][l] -= f * A[k][l];
    }
  return A[0][3] / A[0][0];
}

/* Potential flow at t = 0+ (the Fourier series of initial.h): p(0,0) = 0.930060 rho g H, the top
 * left corner accelerates by -0.109770 g, and kinetic energy grows as 0.270415 rho g^2 H^2 t^2.
 * Asked: within 3 % at H/dx = 100. */
static void test_released_column_starts_like_potential_flow(void) {
  struct case_file *c = pool_case(COLUMN, "resolution: 100, diffusion: antuono, alpha: 0.01");
  struct sph *s = pool_create(c);
  EXPECT_OK(sph_rates(s, 0, true, true));
  struct case_probe corner = {.x = 0, .y = 0};
  double p;
  EXPECT_OK(sph_probe(s, &corner, &c->walls, &p));
  p /= s->rho0 * s->g;
  double a = corner_acceleration(s) / s->g;
  double t = 0.1 / sqrt(s->g);
  EXPECT_OK(pool_march(s, t));
  double growth = sph_energy(s).kinetic / (s->rho0 * s->g * s->g * t * t);
  printf("     p(0,0) %.6f, corner %.6f g, kinetic energy %.6f (at t sqrt(g/H) = 0.1)\n", p, a,
         growth);
  EXPECT_NEAR(p / 0.930060, 1, 0.03);
  EXPECT_NEAR(a / -0.109770, 1, 0.03);
  EXPECT_NEAR(growth / 0.270415, 1, 0.03);
  sph_destroy(s);
  case_destroy(c);
}

/* The slowest sound between bed and surface of a nearly weightless tank: v = V sin(pi y/2H)
 * cos(omega t) with omega = c0 pi/2H, which viscosity damps at the rate (1/2) (3 nu) (pi/2H)^2, nu
 * = alpha h c0/8 (P eqs. (14), (20), (28)). Returns the time of the n-th zero of the velocity's
 * mode; *amplitude is that of the mode at its last extreme over the first. */
static double sound(double resolution, double alpha, double *amplitude) {
  const int zeros = 6;
  char run[200];
  snprintf(run, sizeof run, "resolution: %g, diffusion: none, c0: 1, alpha: %g, integrator: rk4",
           resolution, alpha);
  struct case_file *c = pool_case(
      "title: sound\nfluid: {gravity: 1e-5}\nscales: {H: 1}\n"
      "tank: {walls: [[[0, 1.5], [0, 0], [1, 0], [1, 1.5]]]}\n"
      "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES,
      run);
  struct sph *s = pool_create(c);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.v[i] = 1e-3 * sin(M_PI / 2 * s->f.w.y[i]);
  double now = 1, first = 0, last = 0, before, at = 0, extreme = 0, start = 0;
  for (int n = 0; n < zeros;) {
    if (pool_march(s, s->t + 0.01) != OK) exit(1);
    before = now;
    now = 0;
    for (size_t i = 0; i < s->f.n; i++)
      now += s->f.m[i] * s->f.w.v[i] * sin(M_PI / 2 * s->f.w.y[i]) / (0.5e-3 * s->rho0);
    if (start == 0) start = now;
    extreme = fmax(extreme, fabs(now));
    if ((now > 0) != (before > 0)) {
      at = s->t - 0.01 * now / (now - before);
      if (n == 1) first = extreme;
      last = extreme;
      extreme = 0;
      n++;
    }
  }
  *amplitude = last / first; /* extremes zeros - 2 half periods apart */
  sph_destroy(s);
  case_destroy(c);
  return at / (zeros - 0.5); /* half a period */
}

static void test_sound_has_its_speed_and_its_damping(void) {
  double amplitude, half[2];
  for (int k = 0; k < 2; k++) {
    half[k] = sound(16 << k, 0, &amplitude);
    printf("     H/dx = %d: half period of sound %.5f, exact 2\n", 16 << k, half[k]);
  }
  /* The surface of a particle fluid is smeared over h: first order. */
  EXPECT_NEAR(half[1] / 2, 1, 0.02);
  EXPECT(fabs(half[1] - 2) < 0.65 * fabs(half[0] - 2));
  const double alpha = 0.5, h = 4. / 3 / 32, k = M_PI / 2;
  double undamped;
  sound(32, 0, &undamped);
  sound(32, alpha, &amplitude);
  double rate = -log(amplitude / undamped) / (4 * half[1]);
  double expected = 0.5 * 3 * (alpha * h / 8) * k * k;
  printf("     damping rate %.5f, theory %.5f\n", rate, expected);
  EXPECT_NEAR(rate / expected, 1, 0.1);
}

/* The lowest standing wave of a tank as wide as deep: omega^2 = g k tanh(k d) with the shift of
 * third order (waves.h), from the zeros of the horizontal momentum's mode over two periods. */
static double standing_wave(double resolution) {
  char run[200];
  snprintf(run, sizeof run, "resolution: %g, diffusion: antuono, alpha: 0.01", resolution);
  struct case_file *c = pool_case(
      "title: standing wave\nscales: {H: 1}\ntank: {walls: [[[0, 1.5], [0, 0], [1, 0], [1, "
      "1.5]]]}\n"
      "water: {wave: {kind: standing, amplitude: 0.03, wavelength: 2, depth: 1}}\n" POOL_TIMES,
      run);
  struct sph *s = pool_create(c);
  struct wave_standing w = wave_standing_create(0.03, 2, 1, s->g, 0, 0, 2);
  double step = 0.01 * M_PI / w.omega, now = 0, before, at = 0;
  for (int n = 0; n < 4;) {
    if (pool_march(s, s->t + step) != OK) exit(1);
    before = now;
    now = 0;
    for (size_t i = 0; i < s->f.n; i++) now += s->f.m[i] * s->f.w.u[i] * sin(M_PI * s->f.w.x[i]);
    if (before != 0 && (now > 0) != (before > 0)) {
      at = s->t - step * now / (now - before);
      n++;
    }
  }
  sph_destroy(s);
  case_destroy(c);
  double omega = 4 * M_PI / at;
  printf("     H/dx = %g: omega / exact %.5f\n", resolution, omega / w.omega);
  return omega / w.omega;
}

static void test_standing_wave_has_its_frequency(void) {
  double coarse = standing_wave(16), fine = standing_wave(32);
  EXPECT_NEAR(fine, 1, 0.01);
  EXPECT(fabs(fine - 1) < 0.75 * fabs(coarse - 1));
}

int main(void) {
  RUN(test_released_column_starts_like_potential_flow);
  RUN(test_sound_has_its_speed_and_its_damping);
  RUN(test_standing_wave_has_its_frequency);
  return TEST_RESULT;
}
