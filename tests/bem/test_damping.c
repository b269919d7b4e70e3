/* What filter and smoothing do to the water. */
#include "bem/water/damping.h"

#include <math.h>
#include <string.h>

#include "tests/test.h"

/* A wave with a sawtooth on it, from wall to wall, or up to a thin tip on the bed. */
static enum status make_rough(struct bem_flow *f, bool thin) {
  enum { LAST = 60 };
  struct bem_surface *s = &f->surface;
  *s = (struct bem_surface){.right = thin ? BEM_END_BED : BEM_END_WALL,
                            .tip = thin ? BEM_TOE : 0,
                            .tank = 3,
                            .length = thin ? 6 : 3,
                            .depth = 1};
  TRY(bem_surface_reserve(s, LAST + 1));
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  for (size_t k = 0; k < s->n; k++) {
    const double a = (double)k / LAST, off = k % 2 ? 1e-3 * a * (1 - a) : 0;
    x[k] = 3 * a + (thin ? off : 0);
    y[k] = thin ? 1 - a * a + off : 1 + 0.08 * cos(6.3 * a) + off;
    phi[k] = 0.3 * sin(5.1 * a) - off;
  }
  return bem_flow_reserve(f, s->n);
}

static double volume_after(const struct bem_flow *f, double time) {
  struct bem_surface moved = {0};
  const struct bem_surface *s = &f->surface;
  EXPECT_OK(bem_surface_follow(&moved, s, s->n));
  for (size_t k = 0; k < 3 * s->n; k++) moved.state[k] = s->state[k] + time * f->damping[k];
  const double volume = bem_surface_totals(&moved, f->psi).volume;
  bem_surface_destroy(&moved);
  return volume;
}

static double largest(const double *a, size_t n) {
  double most = 0;
  for (size_t k = 0; k < n; k++) most = fmax(most, fabs(a[k]));
  return most;
}

/* The volume is quadratic in the nodes' places: central differences give its rate exactly. */
static void test_damping_moves_nodes_and_keeps_the_volume(void) {
  for (int thin = 0; thin < 2; thin++) {
    struct bem_flow f = {.mesh.resolution = 20, .filter = 30, .smoothing = 30, .level = 1};
    EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-12, 2000}, &f.solve));
    EXPECT_OK(make_rough(&f, thin));
    const size_t n = f.surface.n;
    double rate[3 * n];
    EXPECT_OK(bem_flow_rates(&f, 0, f.surface.state, rate));
    EXPECT(largest(f.damping + n, n) > 1e-3);
    EXPECT_NEAR(volume_after(&f, 1) - volume_after(&f, -1), 0, 1e-14);
    bem_flow_destroy(&f);
  }
}

int main(void) {
  RUN(test_damping_moves_nodes_and_keeps_the_volume);
  return TEST_RESULT;
}
