/* What is cut from a jet, and what is left of it. Water is on the right of the way along the nodes.
 */
#include "bem/breaking/contact.h"
#include "bem/breaking/cuts.h"
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

/* Level water with a film up the right wall, which is 0.05 thick at its foot and 0.002 from a
 * height of 1 to one of 1.5; or mirrored. phi is the same on both sides. */
static void put_film(struct bem_surface *s, bool right) {
  EXPECT_OK(bem_surface_reserve(s, N));
  double *x = s->state, *y = x + N, *phi = y + N;
  for (int k = 0; k < N; k++) {
    const int at = right ? k : N - 1 - k;
    const double t = k < 100 ? 0 : (double)(k - 100) / (N - 101), up = fmin(2 * t, 1);
    const double thick = 0.05 * (1 - up) * (1 - up) + 0.002;
    const double from = k < 100 ? (WIDE - 0.052) * k / 100. : k == N - 1 ? WIDE : WIDE - thick;
    x[at] = right ? from : WIDE - from;
    y[at] = 0.5 + t;
    phi[at] = y[at] * y[at];
  }
}

static void cut_film(struct bem_flow *f, bool right) {
  flow_open_box(f);
  put_film(&f->surface, right);
  EXPECT_OK(bem_solve_create(&(struct bem_solve_options){1e-12, 0}, &f->solve));
  EXPECT_OK(bem_flow_reserve(f, N));
  EXPECT_OK(bem_flow_solve(f, f->surface.state, 0));
  EXPECT(bem_contact_film_is_thin(&f->surface, right, 1));
  EXPECT(!bem_contact_film_is_thin(&f->surface, !right, 1));
  EXPECT(!bem_contact_film_is_thin(&f->surface, right, 0.3));
  EXPECT_OK(bem_contact_cut_film(f, right, 1));
  EXPECT(!bem_contact_film_is_thin(&f->surface, right, 1));
}

/* The cap ends eight thicknesses above the place where the film is 0.005 thick, at about 0.9. */
static void test_films_on_either_wall_are_cut_alike(void) {
  struct bem_flow left, right;
  cut_film(&right, true);
  cut_film(&left, false);
  const size_t n = right.surface.n;
  const double *x = right.surface.state, *y = x + n, *phi = y + n;
  EXPECT(x[n - 1] == WIDE && y[n - 1] > 0.85 && y[n - 1] < 0.95);
  EXPECT(left.surface.n == n && left.surface.state[0] == 0);
  for (size_t k = 0; k < n && left.surface.n == n; k++) {
    const double *mirrored = left.surface.state + n - 1 - k;
    EXPECT_NEAR(WIDE - mirrored[0], x[k], 1e-9);
    EXPECT_NEAR(mirrored[n], y[k], 1e-9);
    EXPECT_NEAR(mirrored[2 * n], phi[k], 1e-9);
  }
  bem_flow_destroy(&left);
  bem_flow_destroy(&right);
}

/* The edge itself has no thickness. */
static void test_level_water_has_no_film(void) {
  struct bem_flow f;
  flow_open_box(&f);
  EXPECT_OK(bem_surface_reserve(&f.surface, 5));
  for (int k = 0; k < 5; k++) {
    f.surface.state[k] = WIDE * k / 4;
    f.surface.state[5 + k] = 0.5;
  }
  for (int right = 0; right < 2; right++) EXPECT(!bem_contact_film_is_thin(&f.surface, right, 1));
  bem_flow_destroy(&f);
}

/* Of a step, with the edge on its riser and a jet that has gone over its shelf. */
static void test_a_jet_behind_a_riser_is_no_film_on_it(void) {
  struct bem_flow f;
  struct bem_conformal *walls = NULL;
  const double step[][2] = {{0, 2}, {0, 0}, {2, 0}, {2, 0.5}, {4, 0.5}, {4, 2}};
  const double corner[][2] = {{0, 0.4}, {1.7, 0.4}, {1.8, 0.7}, {2.6, 0.7}, {1.9, 0.6}, {2, 0.4}};
  enum { PARTS = sizeof corner / sizeof *corner - 1, EACH = (N - 1) / PARTS };
  flow_open_box(&f);
  EXPECT_OK(bem_surface_reserve(&f.surface, N));
  for (int k = 0; k < N; k++) {
    const int part = k < N - 1 ? k / EACH : PARTS - 1;
    const double t = (double)(k - part * EACH) / EACH;
    for (int axis = 0; axis < 2; axis++)
      f.surface.state[axis * N + k] = (1 - t) * corner[part][axis] + t * corner[part + 1][axis];
  }
  EXPECT_OK(bem_conformal_create(6, step, NULL, &walls));
  f.surface.walls = walls;
  f.surface.side[1] = 2;
  for (int right = 0; right < 2; right++) EXPECT(!bem_contact_film_is_thin(&f.surface, right, 1));
  bem_conformal_destroy(walls);
  bem_flow_destroy(&f);
}

/* A sheet, `thick`, up the rising face of a bar and over its crest, with its edge and `past` nodes
 * before that on the falling face. What lies before the crest is behind that face. */
static void put_over_bar(struct bem_flow *f, struct bem_conformal *walls, double thick, int past) {
  const double complex crest = walls->point[3], way = bem_conformal_along(walls, 3);
  const double complex rise = bem_conformal_along(walls, 2), off = I * rise;
  const double panel = 0.008;
  struct bem_surface *s = &f->surface;
  flow_open_box(f);
  EXPECT_OK(bem_surface_reserve(s, N));
  s->walls = walls;
  s->side[1] = 3;
  for (int k = 0; k < N; k++) {
    const int behind = N - 1 - past - k; /* panels before the crest */
    const double down = panel * (1 - behind), thin = thick * (N - 1 - k) / (past + 1);
    const double complex z = behind > 0 ? crest + thick * off - panel * behind * rise
                                        : crest + down * way + thin * I * way;
    s->state[k] = creal(z);
    s->state[N + k] = cimag(z);
    s->state[2 * N + k] = 0;
  }
}

/* What is counted as a tongue can be cut so that its edge is on the wall that the surface holds. */
static void test_water_that_comes_over_a_crest_is_no_tongue_behind_it(void) {
  const double bar[][2] = {{0, 2}, {0, 0}, {2, 0}, {4, 1}, {6, 0}, {8, 0}, {8, 2}};
  struct bem_conformal *walls = NULL;
  EXPECT_OK(bem_conformal_create(7, bar, NULL, &walls));
  for (int thin = 0; thin < 2; thin++) {
    struct bem_flow f;
    put_over_bar(&f, walls, thin ? 1e-4 : 0.05, 3);
    const size_t count = bem_contact_tongue(&f.surface, true);
    EXPECT(thin ? count > 0 && count <= 3 : count == 0);
    if (count > 0) {
      EXPECT_OK(bem_contact_cut_tongue(&f, true));
      const size_t n = f.surface.n;
      const double x = f.surface.state[n - 1], y = f.surface.state[2 * n - 1];
      EXPECT(x >= 4 && x < 4.05);
      EXPECT_NEAR(y, 1 - (x - 4) / 2, 1e-12);
    }
    bem_flow_destroy(&f);
  }
  bem_conformal_destroy(walls);
}

static void test_water_on_a_slope_is_no_film(void) {
  struct bem_flow f;
  struct bem_conformal *walls = NULL;
  const double gentle[][2] = {{0, 2}, {0, 0}, {2, 0}, {42, 2}};
  flow_open_box(&f);
  EXPECT_OK(bem_surface_reserve(&f.surface, N));
  for (int k = 0; k < N; k++) {
    f.surface.state[k] = 12. * k / (N - 1);
    f.surface.state[N + k] = 0.5;
  }
  EXPECT_OK(bem_conformal_create(4, gentle, NULL, &walls));
  f.surface.walls = walls;
  f.surface.side[1] = 2;
  EXPECT(!bem_contact_film_is_thin(&f.surface, true, 1));
  bem_conformal_destroy(walls);
  bem_flow_destroy(&f);
}

int main(void) {
  RUN(test_a_sheet_is_cut_where_it_is_thick_enough);
  RUN(test_a_tip_that_is_about_to_land_is_not_cut);
  RUN(test_water_that_is_thick_enough_is_not_cut);
  RUN(test_a_drop_that_has_come_off_goes);
  RUN(test_films_on_either_wall_are_cut_alike);
  RUN(test_level_water_has_no_film);
  RUN(test_water_on_a_slope_is_no_film);
  RUN(test_a_jet_behind_a_riser_is_no_film_on_it);
  RUN(test_water_that_comes_over_a_crest_is_no_tongue_behind_it);
  return TEST_RESULT;
}
