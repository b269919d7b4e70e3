/* Splines, and the nodes that regridding puts on them. */
#include "bem/shape/mesh.h"

#include <math.h>

#include "bem/shape/spline.h"
#include "tests/test.h"

/* Not-a-knot splines reproduce every cubic, whatever the spacing. */
static void test_splines_through_cubics_are_these_cubics(void) {
  enum { MOST = 9 };
  for (size_t n = 4; n <= MOST; n++) {
    double s[MOST], f[2][MOST], second[2 * MOST], scratch[3 * MOST];
    for (size_t k = 0; k < n; k++) {
      double t = s[k] = (double)k + 0.385 * sin(2.2 * (double)k);
      f[0][k] = 0.7 - 1.3 * t + 0.45 * t * t - 0.11 * t * t * t;
      f[1][k] = 2.385 * t * t - 0.3;
    }
    EXPECT_OK(bem_spline_fit(n, s, 2, (const double *const[]){f[0], f[1]}, second, scratch));
    for (size_t k = 0; k < n; k++) {
      EXPECT_NEAR(second[k], 0.9 - 0.66 * s[k], 1e-11);
      EXPECT_NEAR(second[n + k], 4.77, 1e-11);
    }
    size_t from = 0;
    for (double t = s[0]; t <= s[n - 1]; t += 0.237)
      EXPECT_NEAR(bem_spline_value(n, s, f[0], second, t, &from),
                  0.7 - 1.3 * t + 0.45 * t * t - 0.11 * t * t * t, 1e-11);
  }
}

static double height(double x) {
  return 1 + 0.08 * cos(2.1 * x);
}

static double potential(double x) {
  return 0.3 * sin(1.7 * x);
}

/* A wave from x = 0 to 3 and, with a side, a straight line from there down to the bed. */
static enum status make_wave(struct bem_surface *s, size_t top, size_t side) {
  *s = (struct bem_surface){.right = side ? BEM_END_BED : BEM_END_WALL, .tank = 3, .length = 3};
  TRY(bem_surface_reserve(s, top + side + 1));
  s->corner = side ? top : 0;
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  for (size_t k = 0; k < s->n; k++) {
    x[k] = k < top ? 3 * (double)k / (double)top : 3;
    y[k] = k <= top ? height(x[k]) : height(3) * (double)(top + side - k) / (double)side;
    phi[k] = k <= top ? potential(x[k]) : potential(3);
  }
  return OK;
}

/* Largest distance of the new nodes of the wave, with so many old ones per H, from the curve. */
static double misplacement(size_t per_h, size_t side) {
  struct bem_surface s;
  struct bem_mesh m = {.resolution = (double)per_h};
  double worst = 0;
  EXPECT_OK(make_wave(&s, 3 * per_h, side));
  double end[2][2] = {{0, height(0)}, {3, side ? 0 : height(3)}};
  EXPECT_OK(bem_mesh_regrid(&m, &s));
  const double *x = s.state, *y = x + s.n, *phi = y + s.n;
  EXPECT(x[0] == end[0][0] && y[0] == end[0][1]);
  EXPECT(x[s.n - 1] == end[1][0] && y[s.n - 1] == end[1][1]);
  if (side) EXPECT(x[s.corner] == 3 && y[s.corner] == height(3));
  for (size_t k = 0; k <= (side ? s.corner : s.n - 1); k++)
    worst = fmax(worst, fmax(fabs(y[k] - height(x[k])), fabs(phi[k] - potential(x[k]))));
  EXPECT(!bem_mesh_is_poor(&m, &s));
  bem_mesh_destroy(&m);
  bem_surface_destroy(&s);
  return worst;
}

static void test_new_nodes_lie_on_the_old_curve_to_fourth_order(void) {
  for (size_t side = 0; side <= 16; side += 16) {
    double coarse = misplacement(24, side), fine = misplacement(48, side);
    EXPECT(coarse > 1e-12);
    EXPECT(log2(coarse / fine) > 3.5);
  }
}

/* A node moves towards the side that has more than its share of the nodes. */
static void test_a_mesh_without_motion_of_the_water_drifts_to_equal_shares(void) {
  struct bem_surface s;
  struct bem_mesh m = {.resolution = 24};
  enum { TOP = 72 };
  double still[TOP + 1] = {0}, tx[TOP + 1], ty[TOP + 1], q[TOP + 1];
  EXPECT_OK(make_wave(&s, TOP, 0));
  EXPECT_OK(bem_mesh_reserve(&m, s.n));
  bem_mesh_velocity(&m, &s, s.state, still, still, tx, ty, q);
  EXPECT(q[0] == 0 && q[TOP] == 0);
  for (size_t k = 0; k < s.n; k++) EXPECT_NEAR(tx[k] * tx[k] + ty[k] * ty[k], 1, 1e-14);
  for (size_t k = 1; k < TOP; k++) {
    double left = 0, whole = 0;
    for (size_t j = 0; j < TOP; j++) {
      if (j < k) left += m.work.share[j];
      whole += m.work.share[j];
    }
    double lack = whole * (double)k / TOP - left;
    EXPECT(fabs(lack) < 1e-9 || lack * q[k] > 0);
  }
  bem_mesh_destroy(&m);
  bem_surface_destroy(&s);
}

int main(void) {
  RUN(test_splines_through_cubics_are_these_cubics);
  RUN(test_new_nodes_lie_on_the_old_curve_to_fourth_order);
  RUN(test_a_mesh_without_motion_of_the_water_drifts_to_equal_shares);
  return TEST_RESULT;
}
