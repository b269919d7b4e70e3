/* The function with the flux of walls that move. */
#include "bem/motion/flux.h"
#include "tests/test.h"

struct tank_case {
  const char *name;
  size_t n;
  double wall[8][2];
};

static const struct tank_case tanks[] = {
    {"rectangle", 4, {{0, 2}, {0, 0}, {2.385, 0}, {2.385, 2}}},
    {"wedge", 3, {{-2, 2}, {0, 0}, {2, 2}}},
    {"step", 6, {{0, 3}, {0, 0}, {1.3, 0}, {1.3, 0.45}, {3.1, 0.45}, {3.1, 2}}},
    {"beach", 4, {{0, 3}, {0, 0}, {2, 0}, {8, 2}}},
    {"bar", 8, {{0, 2}, {0, 0}, {2, 0}, {2.5, 0.6}, {3, 0.6}, {4, 0}, {5.3, 0}, {5.3, 2}}},
};
enum { TANKS = sizeof tanks / sizeof *tanks };

static const double TOP = 4;

/* At a point of a side, part of the way along it. */
static double complex at_wall(const struct bem_conformal *m, size_t side, double part,
                              double complex *zeta) {
  const double complex z = m->point[side] + part * (m->point[side + 1] - m->point[side]);
  double complex slope;
  EXPECT_OK(bem_conformal_on_wall(m, z, zeta, &slope));
  return z;
}

static void test_psi_of_a_tank_that_turns_is_that_of_its_walls(void) {
  for (int i = 0; i < TANKS; i++) {
    struct bem_rigid body[8];
    struct bem_conformal *m = NULL;
    struct bem_flux f = {0};
    double worst = 0, first = 0;
    EXPECT_OK(bem_conformal_create(tanks[i].n, tanks[i].wall, NULL, &m));
    for (size_t k = 0; k <= m->n; k++) body[k] = (struct bem_rigid){CMPLX(0.3, -0.7), 1};
    EXPECT_OK(bem_flux_set(&f, m, body, TOP));
    for (size_t side = 0; side <= m->n; side++)
      for (double part = 0.07; part < 1; part += 0.0613) {
        double complex zeta, value, slope;
        const double complex z = at_wall(m, side, part, &zeta);
        bem_flux_at(&f, zeta, &value, &slope);
        const double off = cimag(value) - bem_rigid_stream(body[0], z);
        if (side == 0 && part < 0.08) first = off;
        worst = fmax(worst, fabs(off - first));
      }
    printf("  %-9s: %zu panels, psi off by %.1e\n", tanks[i].name, f.rule.panels, worst);
    EXPECT(worst < 1e-8);
    bem_flux_destroy(&f);
    bem_conformal_destroy(m);
  }
}

/* Next to a bend phi is off by the way from it, H, to the power of pi over the angle of the water
 * there, 2/3 at least. */
static void test_at_a_bend_it_is_the_limit_along_the_sides(void) {
  const double way = 1e-3;
  for (int i = 0; i < TANKS; i++) {
    struct bem_rigid body[8];
    struct bem_conformal *m = NULL;
    struct bem_flux f = {0};
    double worst = 0;
    EXPECT_OK(bem_conformal_create(tanks[i].n, tanks[i].wall, NULL, &m));
    for (size_t k = 0; k <= m->n; k++) body[k] = (struct bem_rigid){CMPLX(0.3, -0.7), 1};
    EXPECT_OK(bem_flux_set(&f, m, body, TOP));
    for (size_t k = 0; k < m->n; k++)
      for (size_t side = k; side <= k + 1; side++) {
        const double length = cabs(m->point[side + 1] - m->point[side]);
        double complex zeta, at, beside, slope;
        at_wall(m, side, side == k ? 1 - way / length : way / length, &zeta);
        bem_flux_at(&f, zeta, &beside, &slope);
        bem_flux_at(&f, m->xi[k], &at, &slope);
        worst = fmax(worst, cabs(at - beside));
      }
    printf("  %-9s: off by %.1e\n", tanks[i].name, worst);
    EXPECT(worst < 10 * pow(way, 2. / 3));
    bem_flux_destroy(&f);
    bem_conformal_destroy(m);
  }
}

/* Near a side that moves and far from it. */
static void test_the_slope_is_the_derivative(void) {
  struct bem_conformal *m = NULL;
  struct bem_flux f = {0};
  struct bem_rigid body[8] = {{CMPLX(1, 0), 0}};
  double worst = 0;
  EXPECT_OK(bem_conformal_create(tanks[3].n, tanks[3].wall, NULL, &m));
  EXPECT_OK(bem_flux_set(&f, m, body, TOP));
  for (double part = 0.1; part < 0.9; part += 0.1) {
    double complex wall;
    at_wall(m, 0, part, &wall);
    for (double up = 0; up < 2; up += 0.1) {
      const double complex zeta = creal(wall) + up * I, way = 0.02 * (1 + I);
      double complex begin, end, slope, ignored, sum = 0;
      bem_flux_at(&f, zeta, &begin, &ignored);
      bem_flux_at(&f, zeta + way, &end, &ignored);
      for (int j = 0; j < BEM_RULE; j++) {
        bem_flux_at(&f, zeta + 0.5 * (1 + f.rule.gauss.point[j]) * way, &ignored, &slope);
        sum += 0.5 * f.rule.gauss.weight[j] * slope * way;
      }
      worst = fmax(worst, cabs(end - begin - sum));
    }
  }
  printf("  off by %.1e\n", worst);
  EXPECT(worst < 1e-9);
  bem_flux_destroy(&f);
  bem_conformal_destroy(m);
}

/* Largest error of the velocity through the sides, so far from the bends at either end of them. */
static double off_beside_bends(const struct bem_conformal *m, const struct bem_flux *f,
                               struct bem_rigid body, double way) {
  double worst = 0;
  for (size_t k = 0; k < m->n; k++)
    for (size_t side = k; side <= k + 1; side++) {
      const double length = cabs(m->point[side + 1] - m->point[side]);
      const double complex along = bem_conformal_along(m, side);
      const double complex z = m->point[side] + (side == k ? length - way : way) * along;
      double complex zeta, rise, value, slope;
      EXPECT_OK(bem_conformal_on_wall(m, z, &zeta, &rise));
      bem_flux_at(f, zeta, &value, &slope);
      worst = fmax(worst, fabs(cimag((slope * rise - conj(bem_rigid_at(body, z))) * along)));
    }
  return worst;
}

/* However near, also where a point of the formula is: a fine scan meets many. In obtuse corners q
 * is no polynomial of the variable, within 1e-6 down to 1e-4 H. */
static void test_next_to_a_bend_the_velocity_is_that_of_the_side(void) {
  for (int i = 0; i < TANKS; i++) {
    const struct bem_rigid turning = {CMPLX(0.3, -0.7), 1};
    struct bem_rigid body[8];
    struct bem_conformal *m = NULL;
    struct bem_flux f = {0};
    double worst = 0;
    EXPECT_OK(bem_conformal_create(tanks[i].n, tanks[i].wall, NULL, &m));
    for (size_t k = 0; k <= m->n; k++) body[k] = turning;
    EXPECT_OK(bem_flux_set(&f, m, body, TOP));
    for (double way = 1e-4; way < 0.2; way *= 1.05)
      worst = fmax(worst, off_beside_bends(m, &f, turning, way));
    printf("  %-9s: off by %.1e\n", tanks[i].name, worst);
    EXPECT(worst < 1e-6);
    bem_flux_destroy(&f);
    bem_conformal_destroy(m);
  }
}

int main(void) {
  RUN(test_psi_of_a_tank_that_turns_is_that_of_its_walls);
  RUN(test_at_a_bend_it_is_the_limit_along_the_sides);
  RUN(test_the_slope_is_the_derivative);
  RUN(test_next_to_a_bend_the_velocity_is_that_of_the_side);
  return TEST_RESULT;
}
