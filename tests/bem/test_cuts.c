/* What is cut from a jet, and what is left of it. Water is on the right of the way along the nodes.
 */
#include "bem/cuts.h"
#include "tests/test.h"

enum { N = 241 };

static const double WIDE = 2;

/* Level water of depth 0.5 in a tank 2 long, with a spike in the middle that is 0.4 high, `thick`
 * wide at its foot and a tenth of that near its round end; above it a bulb if there is one. */
static void put(struct bem_surface *s, double thick, double bulb) {
  EXPECT_OK(bem_surface_reserve(s, N));
  double *x = s->state, *y = x + N, *phi = y + N;
  for (int k = 0; k < N; k++) {
    const int side = k < N / 2 ? k : N - 1 - k; /* from either wall to the end of the spike */
    const double t = side < 60 ? 0 : (double)(side - 60) / 60;
    const double wide = thick * (1 - 0.9 * t) + bulb * exp(-100 * (t - 0.8) * (t - 0.8));
    const double half = 0.5 * wide * sqrt(1 - t * t * t * t * t * t * t * t);
    const double at = side < 60 ? (1 - 0.5 * thick) * side / 60. : 1 - half;
    x[k] = k < N / 2 ? at : WIDE - at;
    y[k] = 0.5 + 0.4 * t;
    phi[k] = 0.3 * x[k];
  }
  x[N / 2] = 1;
}

static void flow_open_box(struct bem_flow *f) {
  *f = (struct bem_flow){.mesh.resolution = 200};
  f->surface = (struct bem_surface){.right = BEM_END_WALL,
                                    .tank = WIDE,
                                    .length = WIDE,
                                    .depth = 0.5,
                                    .volume = 1,
                                    .film = 0.005};
}

static void test_a_sheet_is_cut_where_it_is_thick_enough(void) {
  struct bem_flow f;
  struct bem_sides w = {0};
  struct bem_piece p;
  flow_open_box(&f);
  put(&f.surface, 0.04, 0);
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-10, 0}, &f.solve));
  EXPECT_OK(bem_flow_reserve(&f, N));
  EXPECT_OK(bem_flow_solve(&f, f.surface.state, 0));
  EXPECT_OK(bem_sides_reserve(&w, &f.surface));
  bem_sides_set(&w, &f.surface, f.surface.state);
  EXPECT(bem_cuts_find_sheet(&w, &f.surface, 1, &p));
  const double wide = f.surface.state[p.last] - f.surface.state[p.first];
  printf("  cut %.4f thick at (%.3f, %.3f)\n", wide, p.x, p.y);
  EXPECT(wide > 0.005 && wide < 0.03);
  EXPECT_NEAR(p.x, 1, 1e-3);
  const double before = bem_surface_totals(&f.surface, f.psi).volume;
  EXPECT_OK(bem_cuts_sheet(&f, &p));
  double most = 0;
  for (size_t k = 0; k < f.surface.n; k++) {
    most = fmax(most, f.surface.state[f.surface.n + k]);
    EXPECT_NEAR(f.surface.state[2 * f.surface.n + k], 0.3 * f.surface.state[k], 0.01);
  }
  EXPECT_NEAR(most, p.y + 1.0 * wide, 0.3 * wide); /* the round end is as long as it is wide */
  EXPECT_OK(bem_flow_reserve(&f, f.surface.n));
  const double lost = before - bem_surface_totals(&f.surface, f.psi).volume;
  EXPECT(lost > 0 && lost < 0.4 * wide);
  EXPECT_OK(bem_sides_reserve(&w, &f.surface));
  bem_sides_set(&w, &f.surface, f.surface.state);
  EXPECT(!bem_cuts_find_sheet(&w, &f.surface, 1, &p));
  bem_sides_destroy(&w);
  bem_flow_destroy(&f);
}

/* Bends the spike to the right, round a circle, so that its end is `gap` above the level. */
static void bend(struct bem_surface *s, double gap) {
  const double radius = 0.12, whole = M_PI - asin(gap / radius);
  double *x = s->state, *y = x + N;
  for (int k = 60; k < N - 60; k++) {
    const double angle = whole * (y[k] - 0.5) / 0.4, off = radius - (x[k] - 1);
    x[k] = 1 + radius - off * cos(angle);
    y[k] = 0.5 + off * sin(angle);
  }
}

static void test_a_tip_that_is_about_to_land_is_not_cut(void) {
  for (int near = 0; near < 2; near++) {
    struct bem_flow f;
    struct bem_sides w = {0};
    struct bem_piece p;
    flow_open_box(&f);
    put(&f.surface, 0.04, 0);
    bend(&f.surface, near ? 0.008 : 0.04);
    EXPECT_OK(bem_sides_reserve(&w, &f.surface));
    bem_sides_set(&w, &f.surface, f.surface.state);
    EXPECT(bem_cuts_find_sheet(&w, &f.surface, 1, &p) == !near);
    EXPECT(bem_cuts_find_sheet(&w, &f.surface, 2, &p)); /* where the run does not get on */
    bem_sides_destroy(&w);
    bem_flow_destroy(&f);
  }
}

static void test_water_that_is_thick_enough_is_not_cut(void) {
  struct bem_flow f;
  struct bem_sides w = {0};
  struct bem_piece p;
  flow_open_box(&f);
  put(&f.surface, 0.3, 0);
  EXPECT_OK(bem_sides_reserve(&w, &f.surface));
  bem_sides_set(&w, &f.surface, f.surface.state);
  EXPECT(!bem_cuts_find_sheet(&w, &f.surface, 1, &p));
  EXPECT(!bem_cuts_find_loop(&w, &f.surface, &p));
  bem_sides_destroy(&w);
  bem_flow_destroy(&f);
}

/* The neck below a bulb has gone through itself. */
static void test_a_drop_that_has_come_off_goes(void) {
  struct bem_flow f;
  struct bem_sides w = {0};
  struct bem_piece p;
  flow_open_box(&f);
  put(&f.surface, 0.04, 0.05);
  double *x = f.surface.state;
  for (int k = 84; k < 88; k++) {
    x[k] = 1.002;
    x[N - 1 - k] = 0.998;
  }
  EXPECT_OK(bem_sides_reserve(&w, &f.surface));
  bem_sides_set(&w, &f.surface, f.surface.state);
  EXPECT(bem_cuts_find_loop(&w, &f.surface, &p));
  EXPECT(p.first >= 82 && p.first < 88 && p.last > N - 90);
  EXPECT_OK(bem_flow_reserve(&f, N));
  EXPECT_OK(bem_cuts_loop(&f, &p));
  double most = 0;
  for (size_t k = 0; k < f.surface.n; k++) most = fmax(most, f.surface.state[f.surface.n + k]);
  EXPECT(most < 0.5 + 0.4 * 28 / 60.);
  bem_sides_destroy(&w);
  bem_flow_destroy(&f);
}

int main(void) {
  RUN(test_a_sheet_is_cut_where_it_is_thick_enough);
  RUN(test_a_tip_that_is_about_to_land_is_not_cut);
  RUN(test_water_that_is_thick_enough_is_not_cut);
  RUN(test_a_drop_that_has_come_off_goes);
  return TEST_RESULT;
}
