/* Plane sound in water without end: a box that is periodic both ways, on whose lattice of particles
 * the linear equations of a wave exp(i k x) can be summed.
 *
 * With e = F V (rates.c) and sums over the neighbours (x, y) of a particle,
 *     s = sum x sin(kx) e,  w = sum (1 - cos kx) x^2/r^2 e,  L = sum x^2 e,
 *     d = 2 sum (1 - cos kx) e - s^2/L     (Antuono's; without the last term Molteni's)
 * (by a fit to the neighbours within 1.5 h with s = sum x sin(kx)/sum x^2)
 * they are rho' = -i s rho0 u - delta h c0 d rho, u' = -i s c0^2/rho0 rho - alpha h c0 w u. */
#include "tests/test.h"

#include <complex.h>

#include "sph/pair/derivative.h"
#include "tests/sph/pool.h"

enum { STEPS = 400 };

struct wave {
  double k, h, c0, alpha, delta;
  bool corrected, fitted;
};

/* F of the renormalised Gaussian: 2 exp(-q^2)/(pi h^4 (1 - 10 exp(-9))), q < 3. */
static double slope(double h, double r2) {
  const double q2 = r2 / (h * h);
  return q2 < 9 ? 2 * exp(-q2) / (M_PI * pow(h, 4) * (1 - 10 * exp(-9))) : 0;
}

/* The rate of the wave, 1/s: the root with a positive frequency. */
static complex double lattice_rate(const struct wave *w, double dx) {
  double s = 0, v = 0, L = 0, d = 0, hat_s = 0, hat = 0;
  for (int i = -8; i <= 8; i++)
    for (int j = -8; j <= 8; j++) {
      const double x = i * dx, y = j * dx, r2 = x * x + y * y, e = slope(w->h, r2) * dx * dx;
      if (r2 == 0) continue;
      if (r2 < 1.5001 * 1.5001 * w->h * w->h) {
        hat_s += x * sin(w->k * x);
        hat += x * x;
      }
      s += x * sin(w->k * x) * e;
      v += (1 - cos(w->k * x)) * x * x / r2 * e;
      L += x * x * e;
      d += 2 * (1 - cos(w->k * x)) * e;
    }
  if (w->corrected) d -= s * s / L;
  if (w->fitted) s = hat_s / hat;
  const double a = w->delta * w->h * w->c0 * d, b = w->alpha * w->h * w->c0 * v;
  return -(a + b) / 2 + csqrt(pow((a - b) / 2, 2) - pow(w->c0 * s, 2));
}

/* P, eqs. (18) to (20), with B of the diffusion that there is, 3/8 for Antuono's, whose gradient is
 * smoothed itself, in place of 1/8; and with the viscosity of two dimensions: 2 nu grad div u + nu
 * lap u is 3 nu, nu = alpha h c0/8, where P's one dimension has alpha h c0/6. */
static complex double paper_rate(const struct wave *w) {
  const double mu = w->k * w->h, B = w->corrected ? 3. / 8 : 0;
  const double viscous = 3 * w->alpha / 8, diffusive = B * w->delta * mu * mu;
  const double F = 1 - mu * mu / 4 * pow(viscous - diffusive, 2);
  const double b = -mu / 2 * (viscous + diffusive);
  return w->k * w->c0 * (b + I * sqrt(F));
}

/* Of what decays and swings as its two roots do: A(n+1) = p A(n) + q A(n-1), by least squares. */
static complex double rate_of(const double *a, size_t n, double dt) {
  double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
  for (size_t i = 1; i + 1 < n; i++) {
    aa += a[i] * a[i];
    ab += a[i] * a[i - 1];
    bb += a[i - 1] * a[i - 1];
    ac += a[i] * a[i + 1];
    bc += a[i - 1] * a[i + 1];
  }
  const double det = aa * bb - ab * ab;
  const double p = (ac * bb - bc * ab) / det, q = (aa * bc - ab * ac) / det;
  return clog(p / 2 + csqrt(p * p / 4 + q)) / dt;
}

/* `waves` of them in 40 spacings. */
static complex double measured_rate(int waves, const char *run, struct wave *w, double *dx) {
  char options[300];
  snprintf(options, sizeof options,
           "resolution: 10, precision: double, integrator: rk4, cfl_acoustic: 0.4, c0: 7, %s", run);
  struct case_file *c = pool_case(
      "fluid: {gravity: 0}\nscales: {H: 1, g: 1}\n"
      "tank: {walls: [[[0, 1.6], [0, 0], [4, 0], [4, 1.6]]], sides: periodic, bed: periodic}\n"
      "water: {regions: [[[0, 0], [4, 0], [4, 1.6], [0, 1.6]]]}\n" POOL_TIMES,
      options);
  struct sph *s = pool_create(c);
  static double amplitude[STEPS];
  size_t n = 0;
  *w = (struct wave){2 * M_PI * waves / 4,
                     s->h,
                     s->c0,
                     s->scheme.alpha,
                     s->scheme.delta,
                     s->scheme.diffusion == SPH_DIFFUSION_antuono,
                     s->scheme.derivative == SPH_DERIVATIVE_mls};
  if (s->scheme.diffusion == SPH_DIFFUSION_none) w->delta = 0;
  *dx = s->dx;
  for (size_t i = 0; i < s->f.n; i++) s->f.w.rho[i] *= 1 + 1e-6 * cos(w->k * s->f.w.x[i]);
  sph_particles_pad(&s->f);
  double dt = 0;
  const double periods = 3 * 2 * M_PI / (w->k * s->c0);
  while (n < STEPS && s->t < periods) {
    double sum = 0;
    for (size_t i = 0; i < s->f.n; i++)
      sum += (s->f.w.rho[i] / s->rho0 - 1) * cos(w->k * s->f.w.x[i]);
    amplitude[n++] = sum / (double)s->f.n;
    EXPECT_OK(sph_rates(s, 0, true, true));
    if (dt == 0) dt = sph_timestep(s, 1e9);
    EXPECT_OK(sph_step(s, dt));
  }
  EXPECT(s->w.n == 0 && n > 12);
  sph_destroy(s);
  case_destroy(c);
  return rate_of(amplitude, n, dt);
}

static const struct {
  const char *run;
  int waves;
} tried[] = {
    {"diffusion: none, alpha: 0", 1},
    {"diffusion: none, alpha: 0", 6},
    {"diffusion: none, alpha: 0.2", 1},
    {"diffusion: none, alpha: 0.2", 4},
    {"diffusion: antuono, alpha: 0", 4},
    {"diffusion: antuono, alpha: 0.05", 1},
    {"diffusion: antuono, alpha: 0.05", 7},
    {"diffusion: molteni, delta: 0.1, alpha: 0", 3},
    {"diffusion: none, alpha: 0, derivative: mls, momentum: minus", 6},
};

static void test_sound_runs_and_decays_as_the_lattice_says(void) {
  for (size_t k = 0; k < sizeof tried / sizeof *tried; k++) {
    struct wave w;
    double dx;
    const complex double found = measured_rate(tried[k].waves, tried[k].run, &w, &dx);
    const complex double law = lattice_rate(&w, dx), paper = paper_rate(&w);
    const double mu = w.k * w.h, speed = w.k * w.c0;
    printf("     kh = %.3f, %-42s frequency %.4f (lattice %.4f, paper %.4f), decay %.5f (%.5f, "
           "%.5f) kc0\n",
           mu, tried[k].run, cimag(found) / speed, cimag(law) / speed, cimag(paper) / speed,
           -creal(found) / speed, -creal(law) / speed, -creal(paper) / speed);
    /* RK4 with c0 dt = 0.2 h: what it does itself is 2e-5 of k c0 at most */
    EXPECT_NEAR(cimag(found), cimag(law), 2e-3 * cimag(law));
    EXPECT_NEAR(creal(found), creal(law), 5e-3 * fabs(creal(law)) + 3e-5 * speed);
    /* long waves, where kernels are points: 1 - s/k = (kh)^2/4 of the Gaussian */
    if (mu > 0.25) continue;
    EXPECT_NEAR(cimag(found), cimag(paper), 0.02 * cimag(paper));
    EXPECT_NEAR(creal(found), creal(paper), 0.02 * fabs(creal(paper)) + 1e-5 * speed);
  }
}

int main(void) {
  RUN(test_sound_runs_and_decays_as_the_lattice_says);
  return TEST_RESULT;
}
