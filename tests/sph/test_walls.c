/* How images go on below the bed, and what holds water at walls without slip. */
#include "tests/test.h"

#include <math.h>
#include <omp.h>

#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/theory/lattice.h"
#include "tests/sph/pool.h"

#define LAYER                                                                                      \
  "title: layer\nscales: {H: 1}\nfluid: {gravity: %g}\n"                                           \
  "tank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: periodic}\n"                           \
  "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]}\n" POOL_TIMES

enum { ROWS = 3 };

/* Row of a particle above the bed. */
static int row_of(const struct sph *s, size_t i) {
  return (int)floor(s->f.w.y[i] / s->dx);
}

/* Vertical accelerations of the lowest rows over g, with gravity. */
static void accelerations(struct sph *s, double row[ROWS]) {
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++)
    if (row_of(s, i) < ROWS) row[row_of(s, i)] = s->f.k[0].v[i] / s->g;
}

static struct sph *layer(const char *run, double gravity, struct case_file **c) {
  char head[600];
  snprintf(head, sizeof head, LAYER, gravity);
  *c = pool_case(head, run);
  return pool_create(*c);
}

static void rest_at(const char *walls, const char *kernel, double row[ROWS]) {
  char run[300];
  struct case_file *c;
  snprintf(run, sizeof run,
           "resolution: 24, kernel: %s, walls: %s, diffusion: none, c0: 1000, precision: double",
           kernel, walls);
  struct sph *s = layer(run, 9.81, &c);
  accelerations(s, row);
  sph_destroy(s);
  case_destroy(c);
}

/* What row n lacks of the push of the images when they have the pressure of the water, over g: the
 * images at the depth d below the bed miss 2 d rho g. */
static double missing_push(const struct sph_lattice *l, int n) {
  double sum = 0;
  for (size_t k = 0; k < l->n; k++) {
    const double depth = -(l->near[k].j + n + 0.5) / l->h_over_dx;
    if (depth > 0) sum += 2 * depth * l->near[k].gy;
  }
  return sum;
}

/* Still water: with continued weight the rows at the bed have the residual of the inner ones, which
 * is sum x dW/dx V - 1 (gallery of lattice sums: 0.0149 g up with the radial spline at h = 4/3 dx,
 * 0.0011 g down with the Gaussian); plain images let them fall, by 0.56 g and 0.62 g in the lowest
 * row. What is left is the compression by weight, gH/c0^2 = 1e-5. */
static void test_still_water_at_the_bed_has_the_residual_of_the_lattice(void) {
  static const struct {
    const char *name;
    enum sph_kernel kernel;
    double inner;
  } of[] = {{"cubic", SPH_KERNEL_cubic, 0.0149}, {"gaussian", SPH_KERNEL_gaussian, -0.0011}};
  for (int k = 0; k < 2; k++) {
    struct sph_lattice l;
    double plain[ROWS], linear[ROWS], exponential[ROWS], ghost[ROWS];
    sph_lattice_of(of[k].kernel, 4. / 3, &l);
    const double inner = sph_lattice_gradient_moment(&l, 1, 0, SPH_LATTICE_REACH) - 1;
    rest_at("mirror-plain", of[k].name, plain);
    rest_at("mirror", of[k].name, linear);
    rest_at("mirror-exponential", of[k].name, exponential);
    rest_at("ghost", of[k].name, ghost);
    printf("     %s: inner %.4f, mirror %.4f, plain %.4f %.4f %.4f\n", of[k].name, inner, linear[0],
           plain[0], plain[1], plain[2]);
    for (int n = 0; n < ROWS; n++) {
      EXPECT_NEAR(linear[n], inner, 2e-5);
      EXPECT_NEAR(inner, of[k].inner, 5.1e-5);
      EXPECT_NEAR(linear[n], exponential[n], 1e-5);
      EXPECT_NEAR(linear[n], ghost[n], 1e-5);
      EXPECT_NEAR(plain[n] - linear[n], missing_push(&l, n), 1e-5);
    }
  }
}

/* Slow sound, c0^2 = 10 gH, and densities that rise as exp(-g y/c0^2): every row is the same but
 * for a factor, so that its residual is that of all others, to rounding, where the images go on so;
 * linearly they lack (2 d g/c0^2)^2/2 of it, and with the weight of rho0 the share 1 - rho0/rho of
 * what plain images lack. */
static void test_slow_sound_rests_on_exponential_images(void) {
  static const char *const walls[] = {"mirror-exponential", "mirror", "mirror-reference"};
  struct sph_lattice l;
  sph_lattice_of(SPH_KERNEL_cubic, 4. / 3, &l);
  for (int k = 0; k < 3; k++) {
    char run[300];
    double row[ROWS];
    struct case_file *c;
    snprintf(run, sizeof run,
             "resolution: 24, kernel: cubic, walls: %s, diffusion: none, alpha: 0, "
             "c0: %.17g, precision: double",
             walls[k], sqrt(10 * 9.81));
    struct sph *s = layer(run, 9.81, &c);
    for (size_t i = 0; i < s->f.n; i++) {
      const double V = s->f.m[i] / s->f.w.rho[i];
      s->f.w.rho[i] = s->rho0 * exp(s->g * (1 - s->f.w.y[i]) / (s->c0 * s->c0));
      s->f.m[i] = s->f.w.rho[i] * V;
    }
    sph_particles_pad(&s->f);
    accelerations(s, row);
    printf("     %s: rows differ by %.1e g\n", walls[k], row[0] - row[ROWS - 1]);
    if (k == 0)
      for (int n = 1; n < ROWS; n++) EXPECT_NEAR(row[n], row[0], 1e-12);
    else if (k == 1)
      EXPECT(fabs(row[0] - row[ROWS - 1]) > 1e-5);
    else
      EXPECT_NEAR((row[0] - row[ROWS - 1]) / (missing_push(&l, 0) * (1 - exp(-0.1))), 1, 0.05);
    sph_destroy(s);
    case_destroy(c);
  }
}

/* Tait's law, whatever the gradient of the water: dp/dy = -rho g by a small step. */
static void test_water_at_rest_goes_on_by_its_equation_of_state(void) {
  static const enum sph_eos law[] = {SPH_EOS_linear, SPH_EOS_tait};
  for (int k = 0; k < 2; k++) {
    const struct eos e = {law[k], 1000, 12, 9.81, 0};
    for (double p = -2e3; p < 3e4; p += 2385) {
      const double d = 1e-4, above = eos_driving_below(&e, p, -d),
                   below = eos_driving_below(&e, p, d);
      EXPECT_NEAR((below - above) / (2 * d), eos_stored(&e, p, 0) * e.g, 1e-4);
      EXPECT_NEAR(eos_driving_below(&e, below, -d), p, 1e-9);
      EXPECT_NEAR(eos_driving_below(&e, eos_driving_below(&e, p, 0.3), 0.2),
                  eos_driving_below(&e, p, 0.5), 1e-8);
    }
  }
}

/* Without slip, d/dt of the energy and the powers still cancel to rounding, in any disorder; and
 * the friction is in the viscosity's, so that walls take what they take with slip. */
static void close_budget_at(const char *walls) {
  double by_walls[2], by_viscosity[2];
  for (int k = 0; k < 2; k++) {
    char run[300];
    snprintf(run, sizeof run,
             "resolution: 16, alpha: 0.1, walls: %s, slip: %s, diffusion: none, precision: double",
             walls, k ? "no" : "free");
    struct case_file *c = pool_case(POOL_STILL, run);
    struct sph *s = pool_create(c);
    for (size_t i = 0; i < s->f.n; i++) { /* no random numbers: the same for both */
      s->f.w.u[i] += 1.5 + sin(7 * s->f.w.y[i] + 3 * s->f.w.x[i]);
      s->f.w.v[i] += cos(9 * s->f.w.x[i] * s->f.w.y[i]);
      s->f.w.x[i] += 0.2 * s->dx * sin(31 * s->f.w.y[i] + 17 * s->f.w.x[i]);
    }
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 0, true, false));
    double power = 0, magnitude = 0;
    for (size_t i = 0; i < s->f.n; i++) {
      const double m = s->f.m[i], rho = s->f.w.rho[i];
      const double kinetic = m * (s->f.w.u[i] * s->f.k[0].u[i] + s->f.w.v[i] * s->f.k[0].v[i]);
      const double elastic = m * pool_p(s, i) / (rho * rho) * s->f.k[0].rho[i];
      power += kinetic + elastic + m * s->g * s->f.k[0].y[i];
      magnitude += fabs(kinetic) + fabs(elastic);
    }
    by_walls[k] = s->totals.walls;
    by_viscosity[k] = s->totals.viscosity;
    EXPECT_NEAR((power + s->totals.walls + s->totals.viscosity) / magnitude, 0, 1e-13);
    sph_destroy(s);
    case_destroy(c);
  }
  EXPECT(by_walls[1] == by_walls[0]);
  EXPECT(by_viscosity[1] > 1.1 * by_viscosity[0]);
}

static void test_friction_is_viscosity_and_closes_the_budget(void) {
  for (size_t k = 0; sph_wall_names[k]; k++) close_budget_at(sph_wall_names[k]);
}

/* Of shear on the lattice, over alpha h c0: 1/8 in the continuum. */
static double lattice_viscosity(void) {
  const double wave = 0.01;
  struct sph_lattice l;
  struct sph_symbols a;
  sph_lattice_of(SPH_KERNEL_gaussian, 4. / 3, &l);
  sph_lattice_symbols(&l, SPH_DIFFUSION_none, wave, 0, &a);
  return a.yy / (wave * wave);
}

/* Stokes' first problem: water that moves along the bed as one at t = 0, almost without gravity, is
 * held there and u = U erf(y/2 sqrt(nu t)). U is far too small to move particles. Returns the
 * largest error over U when 2 sqrt(nu t) is a quarter of the depth. */
static double stokes_error(const char *walls, int resolution) {
  char run[300];
  snprintf(run, sizeof run,
           "resolution: %d, alpha: 0.5, c0: 10, walls: %s, slip: no, diffusion: none, "
           "integrator: rk4, precision: double",
           resolution, walls);
  struct case_file *c;
  struct sph *s = layer(run, 1e-9, &c);
  const double U = 1e-6, nu = lattice_viscosity() * s->scheme.alpha * s->h * s->c0, width = 0.25;
  for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = U;
  sph_particles_pad(&s->f);
  EXPECT_OK(pool_march(s, width * width / (4 * nu)));
  double worst = 0;
  for (size_t i = 0; i < s->f.n; i++)
    if (s->f.w.y[i] < 0.7) worst = fmax(worst, fabs(s->f.w.u[i] / U - erf(s->f.w.y[i] / width)));
  sph_destroy(s);
  case_destroy(c);
  return worst;
}

/* Second order: what the kernel adds to nu u'' is a multiple of h^2 u'''', and u'''' is odd as u
 * is, so that images continue it. Fits of a plane are of second order, too. Particles at rest hold
 * the water half a spacing or so behind the wall: first order. */
static void test_water_is_held_at_the_bed_as_stokes_has_it(void) {
  printf("     nu = %.5f alpha h c0 on the lattice\n", lattice_viscosity());
  EXPECT_NEAR(8 * lattice_viscosity(), 1, 0.07); /* less by what the kernel is cut by */
  for (size_t k = 0; sph_wall_names[k]; k++) {
    const double coarse = stokes_error(sph_wall_names[k], 24);
    const double fine = stokes_error(sph_wall_names[k], 48);
    printf("     %s: off by %.2e and %.2e U, order %.2f\n", sph_wall_names[k], coarse, fine,
           log2(coarse / fine));
    EXPECT(fine < (pool_reflects(sph_wall_names[k]) ? 0.01 : 0.1));
    EXPECT_NEAR(log2(coarse / fine), pool_reflects(sph_wall_names[k]) ? 2 : 1, 0.3);
  }
}

/* As the boundary of free slip has it. */
static void test_water_slides_freely_otherwise(void) {
  struct case_file *c;
  struct sph *s = layer("resolution: 20, alpha: 1, walls: mirror, precision: double", 9.81, &c);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = 0.3;
  sph_particles_pad(&s->f);
  EXPECT(!s->w.drag);
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++) EXPECT_NEAR(s->f.k[0].u[i], 0, 1e-10);
  sph_destroy(s);
  case_destroy(c);
}

/* Elastic energy of wall particles whose density evolves, J/m. */
static double wall_energy(const struct sph *s) {
  double sum = 0;
  for (size_t k = 0; k < s->w.n; k++) {
    const struct sph_pack *w = &s->w.pack[k];
    sum += w->V * w->rho * eos_energy(&s->eos, w->rho, w->y);
  }
  return sum;
}

/* Water that falls on dynamic particles, everywhere under pressure: what it does work on is all
 * that they have, whatever integrator takes both on; what is left is the error of its steps. */
static void test_dynamic_walls_keep_the_work_done_on_them(void) {
  static const char *const how[] = {"rk4, dt: 4e-4", "rk4, dt: 2e-4", "stoermer-verlet, dt: 2e-4"};
  double off[3];
  for (int k = 0; k < 3; k++) {
    char run[300];
    snprintf(run, sizeof run,
             "resolution: 16, alpha: 0, walls: dynamic, diffusion: none, precision: double, "
             "integrator: %s",
             how[k]);
    struct case_file *c = pool_case(POOL_STILL, run);
    struct sph *s = pool_create(c);
    EXPECT_OK(sph_rates(s, 0, true, true));
    const double water = sph_energy(s).total, walls = wall_energy(s);
    for (size_t i = 0; i < s->f.n; i++) s->f.w.v[i] = -0.3 * s->f.w.y[i];
    sph_particles_pad(&s->f);
    const double kinetic = sph_energy(s).total - water;
    EXPECT_OK(pool_march(s, 0.02));
    EXPECT_OK(sph_rates(s, 0, true, true));
    off[k] = (wall_energy(s) - walls - s->budget.walls) / kinetic;
    printf("     %s: walls took %.4f of the motion, but for %.1e\n", how[k],
           s->budget.walls / kinetic, off[k]);
    EXPECT(s->budget.walls > 0.01 * kinetic);
    sph_destroy(s);
    case_destroy(c);
  }
  EXPECT_NEAR(off[0], 0, 1e-5); /* pairs come within the cut, where the kernel jumps by 1e-4 */
  EXPECT_NEAR(off[1], 0, 1e-6);
  EXPECT_NEAR(off[2], 0, 1e-3);
}

static double *march_with(int threads, const char *walls, size_t *n) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 15, alpha: 0.1, walls: %s, slip: no", walls);
  struct case_file *c = pool_case(POOL_DAM, run);
  omp_set_num_threads(threads);
  struct sph *s = pool_create(c);
  EXPECT_OK(pool_march(s, 0.15));
  double *u = malloc(s->f.n * sizeof *u);
  *n = s->f.n;
  for (size_t i = 0; i < s->f.n; i++) u[i] = s->f.w.u[i];
  sph_destroy(s);
  case_destroy(c);
  return u;
}

static void test_bits_without_slip_do_not_depend_on_threads(void) {
  const int most = omp_get_max_threads();
  for (size_t k = 0; sph_wall_names[k]; k++) {
    size_t n[2];
    double *a = march_with(1, sph_wall_names[k], &n[0]);
    double *b = march_with(3, sph_wall_names[k], &n[1]);
    EXPECT(n[0] == n[1] && memcmp(a, b, n[0] * sizeof *a) == 0);
    free(a);
    free(b);
  }
  omp_set_num_threads(most);
}

int main(void) {
  RUN(test_still_water_at_the_bed_has_the_residual_of_the_lattice);
  RUN(test_slow_sound_rests_on_exponential_images);
  RUN(test_water_at_rest_goes_on_by_its_equation_of_state);
  RUN(test_friction_is_viscosity_and_closes_the_budget);
  RUN(test_water_is_held_at_the_bed_as_stokes_has_it);
  RUN(test_water_slides_freely_otherwise);
  RUN(test_dynamic_walls_keep_the_work_done_on_them);
  RUN(test_bits_without_slip_do_not_depend_on_threads);
  return TEST_RESULT;
}
