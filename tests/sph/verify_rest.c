/* Water at rest whose first row lies on the surface (thesis, 2.6.5, figures 2-30 to 2-32): what p =
 * 0 on that row, a fitted derivative, and both do to the growth of disturbances. A tank with
 * periodic sides, one long, c0^2 = 40 gH, product of splines with h = dx = 0.02, the last row half
 * a spacing above the bed. The sums over pairs are (2.15) with (2.13), which are not adjoint; with
 * the first row on the surface they feel p = 0 half a spacing above it, and water is not at rest.
 *
 * Growth starts from rounding, so that instants are compared only where they are far apart. */
#include "tests/test.h"

#include "tests/sph/pool.h"

static const char tank[] =
    "title: rest\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: "
    "periodic}\nwater: {wave: {kind: pressed, strength: 1e-30, wavelength: 1, decay: 0.25, depth: "
    "0.99}}\n" POOL_TIMES;

struct growth {
  double slope; /* of ln max |du/dt| between 1e-9 and 1e-3 g, sqrt(g/H) */
  double end;   /* when an acceleration passes g, sqrt(H/g) */
};

static double largest(const struct sph *s, const double *rate) {
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) most = fmax(most, fabs(rate[i]) / s->g);
  return most;
}

/* `fitted`: whether p = 0 is kept on the first row, which starts on the surface in any case. */
static struct growth march(const char *forms, bool fitted) {
  char run[400];
  snprintf(run, sizeof run,
           "resolution: 50, kernel: tensor, h_over_dx: 1, %s, free_surface: %s, diffusion: none, "
           "alpha: 0, walls: mirror, integrator: rk4, c0: 6.324555320336759 sqrt(gH), precision: "
           "double",
           forms, fitted ? "fitted" : "level");
  struct case_file *c = pool_case(tank, run);
  struct sph *s = pool_create(c);
  const double unit = 1 / sqrt(s->g), dt = 0.5 * s->h / s->c0;
  double n = 0, t1 = 0, t2 = 0, l1 = 0, tl = 0;
  struct growth g = {.end = 12};
  while (s->t < 12 * unit) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    const double along = largest(s, s->f.k[0].u);
    if (along > 1e-9 && along < 1e-3) {
      const double t = s->t / unit, l = log(along);
      n++, t1 += t, t2 += t * t, l1 += l, tl += t * l;
    }
    if (fmax(along, largest(s, s->f.k[0].v)) > 1) {
      g.end = s->t / unit;
      break;
    }
    EXPECT_OK(sph_step(s, dt));
  }
  if (n > 2) g.slope = (n * tl - t1 * l1) / (n * t2 - t1 * t1);
  printf("     %s, %s: growth %.2f sqrt(g/H), ends at t = %.2f sqrt(H/g)\n", forms,
         fitted ? "p = 0 on the first row" : "no condition", g.slope, g.end);
  sph_destroy(s);
  case_destroy(c);
  return g;
}

/* The largest growth of linearised columns (theory/spectrum.c): 3.955 sqrt(g/H) of fits with p = 0,
 * which are at rest; 5.03 of the sums with p = 0, once their rows have settled. A fit alone imposes
 * nothing on the surface, and the column stretches. */
static void test_every_condition_delays_growth_and_none_removes_it(void) {
  static const char sums[] = "momentum: mass, continuity: absolute";
  static const char fits[] = "derivative: mls, momentum: minus";
  const struct growth none = march(sums, false), kept = march(sums, true);
  const struct growth fit = march(fits, false), both = march(fits, true);
  EXPECT(none.end < 0.5 * kept.end && none.end < 0.5 * fit.end);
  EXPECT(both.end > kept.end && both.end > fit.end && both.end < 12);
  EXPECT_NEAR(kept.slope / 5.03, 1, 0.05);
  EXPECT_NEAR(both.slope / 3.955, 1, 0.05);
  EXPECT(none.slope > 2 * kept.slope);
}

int main(void) {
  RUN(test_every_condition_delays_growth_and_none_removes_it);
  return TEST_RESULT;
}
