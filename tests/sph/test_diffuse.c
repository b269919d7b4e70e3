/* The diffusive term by itself: the bound on how fast anything decays. */
#include "tests/test.h"

#include "sph/pair/diffuse.h"
#include "sph/pair/kernel.h"
#include "tests/sph/pool.h"

static const char *const kernels[] = {
#define X(name, help) #name,
    SPH_KERNELS(X)
#undef X
};

/* The slope at q, and what Ferrari's term weighs a pair with and the lift, in the same units. */
static double slope(enum sph_kernel k, double q) {
  if (q >= kernel_support(k)) return 0;
  return kernel_slope(k, vec_of((real)q), (vec){0}, vec_of((real)(q * q)))[0];
}

static double lifted(enum sph_kernel k, double q) {
  const double c = fmax(1 - q, 0);
  return slope(k, q) * q / 2 + kernel_lift(k) * c * c * c;
}

/* The Fourier transform in the plane of a function of the distance; by the midpoint rule, whose
 * error at the largest wave number is 1e-5 of the transform at 0. */
static double transform(double (*f)(enum sph_kernel, double), enum sph_kernel k, double wave) {
  const int n = 800;
  const double d = kernel_support(k) / n;
  double sum = 0;
  for (int i = 0; i < n; i++) {
    const double q = (i + 0.5) * d;
    sum += 2 * M_PI * q * f(k, q) * j0(wave * q) * d;
  }
  return sum;
}

/* Those of waves as long as to as short as a thirtieth of h; beyond, kinks at q = 0 decide, and
 * they are those of positive functions: the lift's, 3 times its factor, is steeper than slope(0)/2.
 */
static void test_weights_are_positive_definite(void) {
  for (int n = 0; n < SPH_KERNEL_COUNT; n++) {
    const enum sph_kernel k = (enum sph_kernel)n;
    if (!kernel_is_definite(k)) continue;
    const double slope_at_0 = transform(slope, k, 0), lifted_at_0 = transform(lifted, k, 0);
    for (double wave = 0; wave < 30; wave += 0.05) {
      EXPECT(transform(slope, k, wave) > -3e-5 * slope_at_0);
      EXPECT(transform(lifted, k, wave) > -3e-5 * lifted_at_0);
    }
    EXPECT(3 * kernel_lift(k) > slope(k, 0) / 2);
  }
}

/* A block of particles in disorder, off their lattice by up to a third of a spacing. */
static struct sph *disordered(const char *run, struct case_file **c) {
  *c = pool_case(POOL_DROP, run);
  struct sph *s = pool_create(*c);
  for (size_t i = 0; i < s->f.n; i++) {
    const double n = (double)s->f.id[i];
    s->f.w.x[i] += s->dx / 3 * sin(12.9898 * n * n);
    s->f.w.y[i] += s->dx / 3 * sin(78.233 * n * n);
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_neighbours_update(s));
  return s;
}

/* The largest decay rate of density fields, by power iteration: never more than it is. */
static double largest_decay(struct sph *s, double *D) {
  double rate = 0;
  for (size_t i = 0; i < s->f.n; i++)
    s->f.w.rho[i] = s->rho0 * (1 + 1e-6 * sin(7.1 * (double)(i * i)));
  for (int k = 0; k < 300; k++) {
    double most = 0;
    sph_pack_pressure(s);
    sph_diffuse(s, D);
    for (size_t i = 0; i < s->f.n; i++) most = fmax(most, fabs(D[i]));
    double before = 0;
    for (size_t i = 0; i < s->f.n; i++) before = fmax(before, fabs(s->f.w.rho[i] - s->rho0));
    rate = most / before;
    for (size_t i = 0; i < s->f.n; i++) s->f.w.rho[i] = s->rho0 * (1 + 1e-6 * D[i] / most);
  }
  return rate;
}

/* What the exponential of the diffusion is made for, and that its price, which goes with the root
 * of the bound, is no more than a third too high. */
static void test_bound_on_decay_holds_and_is_near(void) {
  for (int n = 0; n < SPH_KERNEL_COUNT; n++)
    for (int ferrari = 0; ferrari < 2; ferrari++) {
      char run[200];
      struct case_file *c;
      snprintf(
          run, sizeof run,
          "resolution: 20, precision: double, kernel: %s, diffusion: %s, integrator: rk4-split",
          kernels[n], ferrari ? "ferrari" : "molteni");
      struct sph *s = disordered(run, &c);
      sph_pack_water(s);
      const double bound = sph_diffuse(s, s->f.k[1].rho), most = largest_decay(s, s->f.k[1].rho);
      printf("     %s, %s: %.3f of the bound\n", kernels[n], ferrari ? "ferrari" : "molteni",
             most / bound);
      EXPECT(most <= bound);
      if (kernel_is_definite((enum sph_kernel)n)) EXPECT(most > 0.75 * bound);
      sph_destroy(s);
      case_destroy(c);
    }
}

int main(void) {
  RUN(test_weights_are_positive_definite);
  RUN(test_bound_on_decay_holds_and_is_near);
  return TEST_RESULT;
}
