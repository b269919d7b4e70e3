/* The forms of the equations: what each pair of sums does beside a free surface, what it conserves,
 * and which are refused together. */
#include "tests/test.h"

#include <omp.h>

#include "sph/fluid/energy.h"
#include "sph/pair/continuity.h"
#include "sph/pair/derivative.h"
#include "sph/pair/forms.h"
#include "sph/pair/viscosity.h"
#include "tests/sph/pool.h"

#define NAME(name, help) #name,
static const char *const momentums[] = {SPH_MOMENTUMS(NAME)};
static const char *const viscosities[] = {SPH_VISCOSITIES(NAME)};
static const char *const derivatives[] = {SPH_DERIVATIVES(NAME)};

static struct sph *open_water(struct case_file **c, const char *head, const char *run) {
  *c = pool_case(head, run);
  return pool_create(*c);
}

static void close_water(struct case_file *c, struct sph *s) {
  sph_destroy(s);
  case_destroy(c);
}

/* Whether the check lets the forms of a run pass. */
static bool is_allowed(const struct sph_scheme *o) {
  struct sph_scheme copy = *o;
  const struct case_run r = {.name = "r", .options = &copy};
  struct problems problems = {0};
  sph_forms_check(&r, &problems);
  const bool allowed = problems.n == 0;
  problems_destroy(&problems);
  return allowed;
}

/* The particle nearest to a point. */
static size_t nearest(const struct sph *s, double x, double y) {
  size_t best = 0;
  double least = INFINITY;
  for (size_t i = 0; i < s->f.n; i++) {
    const double d = hypot(s->f.w.x[i] - x, s->f.w.y[i] - y);
    if (d >= least) continue;
    least = d;
    best = i;
  }
  return best;
}

/* The same volumes everywhere, whatever the densities. */
static void set_masses(struct sph *s) {
  for (size_t i = 0; i < s->f.n; i++) s->f.m[i] = s->f.w.rho[i] * s->dx * s->dx;
  sph_particles_pad(&s->f);
}

/* Vertical acceleration of the rows below the surface of a half space at rest whose pressure is
 * rho0 g (depth), over g. The speed of sound is large enough for the compression to drop out. */
static void test_forms_at_a_surface_at_rest(void) {
  static const struct {
    const char *kernel;
    struct {
      const char *name;
      double a[4]; /* rows 0, 1, 2, far inside */
    } form[5];
  } kernels[] = {
      {"cubic",
       {{"neighbour", {-.2703, -.0166, .0149, .0149}},
        {"plus", {-.0480, .0777, .0149, .0149}},
        {"mass", {-.0480, .0777, .0149, .0149}},
        {"reference", {-.0480, .0777, .0149, .0149}},
        {"minus", {-.4926, -.1108, .0149, .0149}}}},
      {"gaussian",
       {{"neighbour", {-.3100, -.0648, -.0056, -.0011}},
        {"plus", {-.1195, .0994, .0169, -.0011}},
        {"mass", {-.1195, .0994, .0169, -.0011}},
        {"reference", {-.1195, .0994, .0169, -.0011}},
        {"minus", {-.5005, -.2290, -.0281, -.0011}}}},
  };
  for (size_t k = 0; k < sizeof kernels / sizeof *kernels; k++)
    for (size_t m = 0; m < 5; m++) {
      char run[300];
      snprintf(run, sizeof run,
               "resolution: 20, kernel: %s, momentum: %s, diffusion: none, alpha: 0, c0: 1e4, "
               "precision: double",
               kernels[k].kernel, kernels[k].form[m].name);
      struct case_file *c;
      struct sph *s = open_water(&c, POOL_STILL, run);
      EXPECT_OK(sph_rates(s, 0, true, true));
      for (int row = 0; row < 4; row++) {
        const double depth = ((row < 3 ? row : 9) + 0.5) * s->dx;
        const size_t i = nearest(s, 1, 1 - depth);
        /* four printed digits */
        EXPECT_NEAR(s->f.k[0].v[i] / s->g, kernels[k].form[m].a[row], 6e-5);
      }
      close_water(c, s);
    }
}

/* Thesis, eqs. (3.17) and (2.158) to (2.163), corrected: product of splines, h = dx, P = -rho g y',
 * y' the height above the plane where P = 0, and y that of the first row:
 *   a_y = -(g/2) (1 + (1 +- 1) y/h), div = (5/6) du/dx + (1/2) dv/dy, a_x = -(5/6) dP/dx / rho */
static void test_surface_row_of_the_tensor_spline(void) {
  static const struct {
    const char *name;
    double y; /* how many times y/h counts */
  } forms[] = {{"neighbour", 1}, {"plus", 2}, {"minus", 0}, {"reference", 2}};
  for (size_t m = 0; m < sizeof forms / sizeof *forms; m++)
    for (int on_row = 0; on_row < 2; on_row++) {
      char run[300];
      snprintf(run, sizeof run,
               "resolution: 16, kernel: tensor, h_over_dx: 1, momentum: %s, diffusion: none, "
               "alpha: 0, c0: 1e4, precision: double",
               forms[m].name);
      struct case_file *c;
      struct sph *s = open_water(&c, POOL_STILL, run);
      const double up = on_row ? 0 : -0.5, plane = 1 - s->dx / 2 - up * s->dx;
      const double px = 70, ux = 0.3, vy = -0.7; /* Pa/m, 1/s */
      for (size_t i = 0; i < s->f.n; i++) {
        const double x = s->f.w.x[i] - 1, y = s->f.w.y[i];
        s->f.w.rho[i] += (s->rho0 * s->g * (plane - 1) + px * x) / (s->c0 * s->c0);
        s->f.w.u[i] = ux * x;
        s->f.w.v[i] = vy * y;
      }
      set_masses(s);
      EXPECT_OK(sph_rates(s, 0, true, true));
      const size_t i = nearest(s, 1, 1);
      const double x = s->f.w.x[i] - 1; /* plus adds 2 p_i grad Gamma, which is along y */
      const double p = px * x / (s->rho0 * s->g * s->dx);
      const double sign = forms[m].y;
      /* compression: 1e-7 */
      EXPECT_NEAR(s->f.k[0].v[i] / s->g, -0.5 * (1 + sign * up) + 0.5 * sign * p, 1e-6);
      EXPECT_NEAR(s->f.k[0].u[i] * s->rho0 / px, -5. / 6, 1e-6);
      EXPECT_NEAR(-s->f.k[0].rho[i] / s->rho0, 5. / 6 * ux + 0.5 * vy, 1e-6);
      close_water(c, s);
    }
}

/* Of the energy, along the rates, W/m: by differences, so that what is compared with it shares no
 * code. */
static double power_of(struct sph *s) {
  const double step = 1e-7;
  double energy[2];
  const struct sph_state *w = &s->f.w, *k = &s->f.k[0];
  for (int side = 0; side < 2; side++) {
    const double by = side ? step : -step;
#define MOVE(q, unit, help)                                                                        \
  for (size_t i = 0; i < s->f.n; i++) w->q[i] += by * k->q[i];
    SPH_EVOLVING(MOVE)
#undef MOVE
    energy[side] = sph_energy(s).total;
#define BACK(q, unit, help)                                                                        \
  for (size_t i = 0; i < s->f.n; i++) w->q[i] -= by * k->q[i];
    SPH_EVOLVING(BACK)
#undef BACK
  }
  return (energy[1] - energy[0]) / (2 * step);
}

static double magnitude_of(const struct sph *s) {
  double sum = 0;
  for (size_t i = 0; i < s->f.n; i++)
    sum += s->f.m[i] * (fabs(s->f.w.u[i] * s->f.k[0].u[i]) + fabs(s->f.w.v[i] * s->f.k[0].v[i]));
  return sum;
}

/* Every pair of forms, in disorder, beside walls: what the energy loses is in the budget; `pairs`
 * has nothing of it where the forms are adjoint. Rounding of the energies, 1e-16 of 1e4 J over
 * 2e-7 s, is 1e-6 of the powers; the curvature of a step less. */
static void test_budget_closes_for_every_form(void) {
  size_t closed = 0, adjoint = 0;
  for (int k = 0; k < SPH_EOS_COUNT * SPH_MOMENTUM_COUNT * SPH_CONTINUITY_COUNT; k++)
    for (int d = 0; d < SPH_DERIVATIVE_COUNT; d++) {
      struct case_file *c;
      struct sph *s = open_water(&c, POOL_STILL,
                                 "resolution: 16, diffusion: molteni, alpha: 0.1, integrator: rk4, "
                                 "precision: double");
      s->scheme.eos = k % SPH_EOS_COUNT;
      s->scheme.momentum = k / SPH_EOS_COUNT % SPH_MOMENTUM_COUNT;
      s->scheme.continuity = k / SPH_EOS_COUNT / SPH_MOMENTUM_COUNT;
      s->scheme.derivative = d;
      s->scheme.viscosity = k % SPH_VISCOSITY_COUNT;
      if (is_allowed(&s->scheme)) {
        s->eos.law = (enum sph_eos)s->scheme.eos;
        sph_force_set(s, 0);
        s->adjoint = sph_forms_adjoint(&s->scheme);
        pool_shake(s, 0.3, 2, 3e3);
        EXPECT_OK(sph_rates(s, 0, true, false));
        const double out =
            s->totals.viscosity + s->totals.diffusion + s->totals.walls + s->totals.pairs;
        EXPECT_NEAR((power_of(s) + out) / magnitude_of(s), 0, 1e-6);
        EXPECT((s->totals.pairs == 0) == s->adjoint);
        EXPECT(s->totals.viscosity > 0);
        closed++;
        adjoint += s->adjoint;
      }
      close_water(c, s);
    }
  EXPECT(adjoint == 6); /* three pairs, two equations of state */
  EXPECT(closed > 30);
}

/* Rounding is left, relative to the sum of the magnitudes, as in test_rates. */
static void test_symmetric_forms_conserve_momentum(void) {
  static const int forms[] = {SPH_MOMENTUM_plus, SPH_MOMENTUM_mass};
  for (int k = 0; k < 2 * SPH_VISCOSITY_COUNT; k++) {
    char run[200];
    snprintf(run, sizeof run,
             "resolution: 20, alpha: 0.1, integrator: rk4, precision: double, eos: tait, "
             "momentum: %s, viscosity: %s, continuity: mass",
             momentums[forms[k % 2]], viscosities[k / 2]);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DROP, run);
    pool_shake(s, 0.3, 2, 3e3);
    EXPECT_OK(sph_rates(s, 0, true, true));
    double fx = 0, fy = 0, force = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      const double m = s->f.m[i], ax = s->f.k[0].u[i], ay = s->f.k[0].v[i] + s->g;
      fx += m * ax;
      fy += m * ay;
      force += m * hypot(ax, ay);
    }
    EXPECT_NEAR(fx / force, 0, 20 * 1.1e-16);
    EXPECT_NEAR(fy / force, 0, 20 * 1.1e-16);
    close_water(c, s);
  }
}

/* Thesis, eqs. (4.32) to (4.36): with the dynamic pressure rest is an exact equilibrium of any
 * kernel and any cut of it; what is left is the rounding of densities, eps rho c0^2/(rho h). */
static void test_dynamic_pressure_rests(void) {
  static const char *const runs[] = {"diffusion: none", "diffusion: molteni",
                                     "diffusion: antuono, kernel: cubic, walls: mirror"};
  for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
    char run[200];
    snprintf(run, sizeof run,
             "resolution: 16, c0: 10 sqrt(gH), eos: dynamic, momentum: reference, integrator: rk4, "
             "precision: double, %s",
             runs[k]);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_STILL, run);
    EXPECT_OK(sph_rates(s, 0, true, true));
    double most = 0;
    for (size_t i = 0; i < s->f.n; i++) most = fmax(most, hypot(s->f.k[0].u[i], s->f.k[0].v[i]));
    EXPECT_NEAR(most / s->g, 0, 20 * 1.1e-16 * s->c0 * s->c0 / (s->g * s->h));
    close_water(c, s);
  }
}

/* Thesis, eqs. (4.57) to (4.60): at rest the density that evolves is rho0, the density and the
 * pressure are hydrostatic, and a particle that falls gains pressure without divergence. */
static void test_split_density(void) {
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_STILL,
                             "resolution: 16, eos: split, momentum: reference, integrator: rk4, "
                             "precision: double");
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++) {
    const double depth = 1 - s->f.w.y[i];
    EXPECT_NEAR(s->f.w.rho[i] / s->rho0, 1, 1e-15);
    EXPECT_NEAR(s->f.p[i] / (s->rho0 * s->g * depth), 1, 1e-10);
  }
  const double fallen = eos_driving(&s->eos, s->rho0, 0.25) - eos_driving(&s->eos, s->rho0, 0.75);
  EXPECT_NEAR(fallen / (s->rho0 * s->g * 0.5), 1, 1e-12);
  close_water(c, s);
}

/* Density back from pressure, the slope c0^2 at rho0, and d e = p/rho^2 d rho, by differences of
 * fourth order: 1e-4 of rho0 makes an error of 1e-12, rounding over it one of 1e-8. */
static void test_equations_of_state(void) {
  for (int k = 0; k < SPH_EOS_COUNT; k++) {
    const struct eos e = {(enum sph_eos)k, 1000, 20, 9.81, 0.7};
    for (double rho = 900; rho < 1100; rho += 23.85) {
      const double y = 0.3, step = 0.1;
      const double driving = eos_driving(&e, rho, y), p = eos_pressure(&e, driving, y);
      EXPECT_NEAR(eos_stored(&e, driving, y) / rho, 1, 1e-12);
      EXPECT_NEAR(eos_driving_of(&e, p, y), driving, 1e-9);
      const double density = eos_density(&e, rho, y);
      const double de = (8 * (eos_energy(&e, rho + step, y) - eos_energy(&e, rho - step, y)) -
                         (eos_energy(&e, rho + 2 * step, y) - eos_energy(&e, rho - 2 * step, y))) /
                        (12 * step);
      EXPECT_NEAR(de * density * density, p, 1e-6 * e.rho0 * e.c0 * e.c0);
    }
    const double c2 = (eos_driving(&e, 1000.01, 0.7) - eos_driving(&e, 999.99, 0.7)) / 0.02;
    EXPECT_NEAR(c2 / (e.c0 * e.c0), 1, 1e-8);
    EXPECT_NEAR(eos_energy(&e, eos_stored(&e, 0, 0.7), 0.7), 0, 1e-18);
    EXPECT(eos_stored(&e, -1e9, 0.7) > 0 || eos_is_linear(e.law));
  }
}

/* On a lattice inside, sum m W is the density but for what the kernel's sum misses of one; beside
 * the surface the product of splines has 5/6 of it with h = dx, weights 2/3 and 1/6
 * (thesis, 2.5.6), and Shepard's quotient, whose volumes are 6/5 in the first row, (5/6)/(2/3 6/5 +
 * 1/6). */
static void test_summed_densities(void) {
  for (int shepard = 0; shepard < 2; shepard++) {
    char run[300];
    snprintf(run, sizeof run,
             "resolution: 16, kernel: tensor, h_over_dx: 1, momentum: mass, continuity: %s, "
             "diffusion: none, alpha: 0, c0: 1e4, walls: mirror, precision: double",
             shepard ? "shepard" : "summation");
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_STILL, run);
    EXPECT_OK(sph_rates(s, 0, true, true));
    const double first = s->f.w.rho[nearest(s, 1, 1)], inside = s->f.w.rho[nearest(s, 1, 0.5)];
    const double corner = s->f.w.rho[nearest(s, 0, 0)];
    /* compression: 1e-7 */
    const double expected = shepard ? (5. / 6) / (2. / 3 * 6 / 5 + 1. / 6) : 5. / 6;
    EXPECT_NEAR(first / s->rho0, expected, 1e-6);
    EXPECT_NEAR(inside / s->rho0, 1, 1e-6);
    EXPECT_NEAR(corner / s->rho0, 1, 1e-6);
    close_water(c, s);
  }
}

/* A linear pressure and a linear velocity, anywhere in shaken water, at its surface too. */
static void test_fits_are_exact_for_linear_fields(void) {
  for (int d = SPH_DERIVATIVE_kernel + 1; d < SPH_DERIVATIVE_COUNT; d++) {
    char run[300];
    snprintf(run, sizeof run,
             "resolution: 20, derivative: %s, momentum: reference, continuity: reference, "
             "diffusion: none, alpha: 0, precision: double",
             derivatives[d]);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DROP, run);
    pool_shake(s, 0.2, 0, 0);
    for (size_t i = 0; i < s->f.n; i++) {
      const double x = s->f.w.x[i], y = s->f.w.y[i];
      s->f.w.rho[i] = s->rho0 + (500 + 2385 * x - 7000 * y) / (s->c0 * s->c0);
      s->f.w.u[i] = 0.3 * x - 0.2 * y;
      s->f.w.v[i] = 0.9 * x + 0.4 * y;
    }
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 0, true, true));
    double force = 0, div = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      force = fmax(force, hypot(s->f.k[0].u[i] + 2.385, s->f.k[0].v[i] + s->g - 7));
      div = fmax(div, fabs(s->f.k[0].rho[i] / s->rho0 + 0.7));
    }
    EXPECT_NEAR(force, 0, 1e-9); /* densities near 1000 carry 1e-13 of rounding, c0^2/h 5e3 */
    EXPECT_NEAR(div, 0, 1e-11);
    close_water(c, s);
  }
}

/* Thesis, (4.13): on a lattice the slope of x^3 at 0 is C h^2 f_xxx = 6 C h^2, C = 1/6 with nine
 * points and 0.8137 with the 29 within 3h (S4/(6 S2)). */
static void test_error_of_the_fitted_plane_on_a_lattice(void) {
  static const struct { double radius, C; } fits[] = {{1.5, 1. / 6}, {3, 0.8137}};
  for (int k = 0; k < 2; k++) {
    char run[300];
    snprintf(run, sizeof run,
             "resolution: 20, kernel: quintic, h_over_dx: 1, derivative: mls, derivative_radius: "
             "%g, momentum: reference, continuity: reference, diffusion: none, alpha: 0, "
             "precision: double",
             fits[k].radius);
    struct case_file *c;
    struct sph *s = open_water(&c, POOL_DROP, run);
    const size_t middle = nearest(s, 1.5, 1.5);
    const double x0 = s->f.w.x[middle];
    for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = pow(s->f.w.x[i] - x0, 3);
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 0, true, true));
    const double slope = -s->f.k[0].rho[nearest(s, x0, 1.5)] / s->rho0;
    EXPECT_NEAR(slope / (6 * s->h * s->h), fits[k].C, 5e-5);
    close_water(c, s);
  }
}

/* Thesis, (3.15), corrected: of f = (a x^2 + 2 b x y + c y^2)/2 around a particle, d/dx is wrong by
 *   (a (S02 S30 - S11 S21)/2 + b (S02 S21 - S11 S12) + c (S02 S12 - S11 S03)/2) / (S20 S02 - S11^2)
 */
static void test_error_of_muellers_derivative_in_disorder(void) {
  struct case_file *c;
  struct sph *s =
      open_water(&c, POOL_DROP,
                 "resolution: 20, derivative: mueller, momentum: reference, continuity: "
                 "reference, diffusion: none, alpha: 0, precision: double");
  pool_shake(s, 0.3, 0, 0);
  EXPECT_OK(sph_neighbours_update(s));
  const double a = 1.3, b = -0.7, d = 2.1, radius = 1.5 * s->h * (1 + 1e-5);
  for (size_t at = 0; at < s->f.n; at += 37) {
    const double x0 = s->f.w.x[at], y0 = s->f.w.y[at];
    double S[4][4] = {{0}};
    for (size_t i = 0; i < s->f.n; i++) {
      const double x = s->f.w.x[i] - x0, y = s->f.w.y[i] - y0;
      s->f.w.u[i] = a * x * x / 2 + b * x * y + d * y * y / 2;
      s->f.w.v[i] = 0;
      if (x * x + y * y >= radius * radius) continue;
      for (int m = 0; m < 4; m++)
        for (int n = 0; n < 4; n++) S[m][n] += pow(x, m) * pow(y, n);
    }
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 1, true, true));
    const double det = S[2][0] * S[0][2] - S[1][1] * S[1][1];
    const double error = (a / 2 * (S[0][2] * S[3][0] - S[1][1] * S[2][1]) +
                          b * (S[0][2] * S[2][1] - S[1][1] * S[1][2]) +
                          d / 2 * (S[0][2] * S[1][2] - S[1][1] * S[0][3])) /
                         det;
    EXPECT_NEAR(-s->f.k[1].rho[at] / s->rho0, error, 1e-11);
  }
  close_water(c, s);
}

/* Places, velocities and densities after some steps, summed with weights that tell them apart. */
static double trace(const char *run, int threads) {
  omp_set_num_threads(threads);
  struct case_file *c;
  struct sph *s = open_water(&c, POOL_DAM, run);
  double sum = 0;
  for (int k = 0; k < 6; k++) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 1)));
  }
  for (size_t i = 0; i < s->f.n; i++)
    sum += (s->f.w.x[i] + 3 * s->f.w.v[i] + s->f.w.rho[i]) * (1 + 1e-3 * s->f.id[i]);
  sum += s->budget.pairs;
  omp_set_num_threads(1);
  close_water(c, s);
  return sum;
}

static void test_same_bits_with_any_number_of_threads(void) {
  static const char *const runs[] = {
      "resolution: 20, eos: tait, momentum: mass, continuity: mass, viscosity: monaghan",
      "resolution: 20, momentum: mass, continuity: shepard, diffusion: none",
      "resolution: 20, eos: split, momentum: reference",
      "resolution: 20, derivative: mls, momentum: minus",
  };
  for (size_t k = 0; k < sizeof runs / sizeof *runs; k++) {
    const double one = trace(runs[k], 1);
    EXPECT(isfinite(one));
    EXPECT(trace(runs[k], 2) == one);
    EXPECT(trace(runs[k], 3) == one);
  }
}

int main(void) {
  RUN(test_forms_at_a_surface_at_rest);
  RUN(test_surface_row_of_the_tensor_spline);
  RUN(test_budget_closes_for_every_form);
  RUN(test_symmetric_forms_conserve_momentum);
  RUN(test_dynamic_pressure_rests);
  RUN(test_split_density);
  RUN(test_equations_of_state);
  RUN(test_summed_densities);
  RUN(test_fits_are_exact_for_linear_fields);
  RUN(test_error_of_the_fitted_plane_on_a_lattice);
  RUN(test_error_of_muellers_derivative_in_disorder);
  RUN(test_same_bits_with_any_number_of_threads);
  return TEST_RESULT;
}
