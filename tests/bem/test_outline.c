/* Water that is no column: wet beds and sloping faces, from their outline. */
#include "bem/start/mirror.h"
#include "bem/start/outline.h"
#include "bem/start/start.h"
#include "bem/water/pressure.h"
#include "common/base/gauge.h"
#include "common/flow/release.h"
#include "common/tank/tank.h"
#include "tests/bem/water.h"

static const char text[] = "title: outline\n"
                           "fluid: {density: 1, gravity: 1}\n"
                           "scales: {H: 1}\n"
                           "tank: {walls: [[[0, 3], [0, 0], [7, 0], [7, 3]]]}\n"
                           "water: {regions: [%s], pressure: released%s}\n"
                           "time: {end: %g, every: 0.1, sample: 0.05}\n"
                           "runs: [{name: bem, solver: bem, resolution: %d, rounding: %g}]\n";

static const char one_polygon[] = "[[0, 0], [7, 0], [7, 0.25], [2.385, 0.25], [2.385, 1], [0, 1]]";
static const char two_regions[] =
    "[[0, 0], [2.385, 0], [2.385, 1], [0, 1]], [[2.385, 0], [7, 0], [7, 0.25], [2.385, 0.25]]";
static const char mirrored[] = "[[7, 0], [0, 0], [0, 0.25], [4.615, 0.25], [4.615, 1], [7, 1]]";

static struct case_file *case_of(const char *water, double end, int resolution, double rounding) {
  static char with[2000];
  snprintf(with, sizeof with, text, water, "", end, resolution, rounding);
  return run_case(with);
}

static void test_joined_regions_have_the_outline_of_one_polygon(void) {
  const char *const waters[] = {one_polygon, two_regions};
  static const double is[][2] = {{0, 1}, {2.385, 1}, {2.385, 0.25}, {7, 0.25}};
  for (int i = 0; i < 2; i++) {
    struct case_file *c = case_of(waters[i], 1, 20, 0.02);
    struct bem_outline o = {0};
    const char *problem = "none found";
    if (c) EXPECT_OK(bem_outline_find(c, &o, &problem));
    EXPECT(!problem && o.chain.points == 4 && !o.toe[0] && !o.toe[1]);
    for (size_t k = 0; o.chain.points == 4 && k < 4; k++)
      EXPECT(o.chain.p[k][0] == is[k][0] && o.chain.p[k][1] == is[k][1]);
    bem_outline_destroy(&o);
    case_destroy(c);
  }
}

static void test_ends_on_a_dry_bed_are_toes(void) {
  static const struct {
    const char *water;
    bool left, right;
  } waters[] = {{"[[0, 0], [2, 0], [1.6, 1], [0, 1]]", false, true},
                {"[[0, 0], [4, 0], [0, 1]]", false, true},
                {"[[0, 0], [4, 0], [0, 0.07]]", false, true}, /* however flat */
                {"[[7, 0], [7, 1], [5.5, 0.8], [5, 0]]", true, false}};
  for (size_t i = 0; i < sizeof waters / sizeof *waters; i++) {
    struct case_file *c = case_of(waters[i].water, 1, 20, 0.02);
    struct bem_outline o = {0};
    const char *problem = "none found";
    if (c) EXPECT_OK(bem_outline_find(c, &o, &problem));
    EXPECT(!problem && o.toe[0] == waters[i].left && o.toe[1] == waters[i].right);
    bem_outline_destroy(&o);
    case_destroy(c);
  }
}

/* An arc of radius R takes (1 - pi/4) R^2 off a corner and adds it to a notch; the nodes'
 * polynomials are of fourth order on the arcs. */
static void test_rounding_keeps_the_volume_of_one_corner_and_one_notch(void) {
  const double R = 0.05, area = 2.385 + 0.25 * 4.615;
  struct case_file *c = case_of(one_polygon, 1, 20, R);
  struct bem_flow f = {0};
  EXPECT(c);
  if (!c) return;
  EXPECT_OK(bem_start_surface(c, &c->runs[0], NULL, &f));
  double *psi = calloc(f.surface.n, sizeof *psi);
  const double volume = bem_surface_totals(&f.surface, psi).volume;
  printf("     %zu nodes, volume off by %.1e\n", f.surface.n, volume - area);
  EXPECT_NEAR(volume, area, 0.02 * R * R);
  free(psi);
  bem_flow_destroy(&f);
  case_destroy(c);
}

/* The pressure at the instant of release, by boundary elements and by CHOLMOD's finite volumes. */
static double pressure_of(double rounding, double x) {
  struct water w;
  double is = NAN;
  if (!water_start(&w, case_of(one_polygon, 1, 30, rounding), 0)) return NAN;
  water_solve(&w);
  EXPECT_OK(bem_pressure_at(&w.p, &w.f, w.f.surface.state, x, 0, &is));
  water_end(&w);
  return is;
}

static double pressure_by_elements(double spacing, double x) {
  struct case_file *c = case_of(one_polygon, 1, 30, 0.02);
  struct release *r = NULL;
  double is = NAN;
  EXPECT(c);
  if (!c) return NAN;
  const struct release_drive weight = {.weight = {0, -1}};
  EXPECT_OK(release_create(&c->water, &c->walls, spacing, case_near(c), &weight, &r));
  is = release_at(r, x, 0);
  release_destroy(r);
  case_destroy(c);
  return is;
}

/* At the notch the pressure behaves as r^(2/3): a change of the shape there by the length e changes
 * it everywhere else in proportion to e^(4/3). */
static void test_released_pressure_of_a_wet_bed_is_that_of_finite_elements(void) {
  static const double at[] = {0.3, 2.2, 2.6, 4};
  for (size_t i = 0; i < sizeof at / sizeof *at; i++) {
    const double wide = pressure_of(0.04, at[i]), narrow = pressure_of(0.01, at[i]);
    const double elements = pressure_by_elements(0.01, at[i]);
    const double bem = narrow + (narrow - wide) / (pow(4, 4. / 3) - 1);
    printf("     x = %g: rounded by 0.04 %.5f, 0.01 %.5f, 0 %.5f; elements %.5f\n", at[i], wide,
           narrow, bem, elements);
    EXPECT_NEAR(bem, elements, fmax(0.2 * fabs(narrow - bem), 2e-5));
  }
}

static struct result_file *wet(const char *water, int resolution) {
  static char with[2000];
  snprintf(with, sizeof with, text, water, "", 0.4, resolution, 0.08);
  return run_bem(with);
}

/* How far the budget of energy is open at the end. */
static double open_budget(const struct result_file *f) {
  return fabs(result_energy_budget(&f->energy[f->n_energy - 1]) - result_energy_budget(f->energy));
}

/* A jet rises where column and bed meet (Stansby, Chegini & Barnes 1998). Its energy converges, and
 * no end of the surface is special: the mirror image is as far off as the steps' tolerance, 1e-6.
 */
static void test_wet_bed_throws_a_jet_whose_energy_converges(void) {
  struct result_file *coarse = wet(two_regions, 14), *fine = wet(two_regions, 28),
                     *turned = wet(mirrored, 28);
  if (coarse && fine && turned) {
    const struct geo_lines *surface = &fine->surface[fine->n_surfaces - 1],
                           *mirror = &turned->surface[turned->n_surfaces - 1];
    const double motion = fine->energy->total - fine->rest_potential;
    const double jet = gauge_elevation(surface, 2.65, 0);
    printf("     budget open by %.1e and %.1e of the energy of motion, jet up to %.3f\n",
           open_budget(coarse) / motion, open_budget(fine) / motion, jet);
    EXPECT(open_budget(fine) < 1e-4 * motion && open_budget(fine) < open_budget(coarse) / 4);
    EXPECT(gauge_elevation(fine->surface, 2.65, 0) < 0.2501 && jet > 0.27);
    EXPECT_NEAR(gauge_elevation(mirror, 7 - 2.65, 0), jet, 1e-5);
    EXPECT_NEAR(turned->energy[4].kinetic, fine->energy[4].kinetic, 1e-6);
  }
  result_file_destroy(coarse);
  result_file_destroy(fine);
  result_file_destroy(turned);
}

/* A velocity of all water is a potential that is linear, which walls take the momentum of. */
static void test_water_that_moves_as_one_starts_with_its_potential(void) {
  char with[2000];
  snprintf(with, sizeof with, text, one_polygon, ", velocity: [0.3, -0.1]", 1., 20, 0.02);
  struct case_file *c = run_case(with);
  struct bem_flow f = {0};
  EXPECT(c);
  if (!c) return;
  EXPECT_OK(bem_start_surface(c, &c->runs[0], NULL, &f));
  const double *x = f.surface.state, *y = x + f.surface.n, *phi = y + f.surface.n;
  for (size_t k = 0; k < f.surface.n; k++) EXPECT_NEAR(phi[k], 0.3 * x[k] - 0.1 * y[k], 1e-14);
  bem_flow_destroy(&f);
  case_destroy(c);
}

/* The front of a wedge moves at once as the shallow-water equations say: by g slope t^2 / 2. */
static void test_front_of_a_flat_lens_runs_on(void) {
  static char with[2000];
  const double slope = 0.07 / 4, end = 1;
  snprintf(with, sizeof with, text, "[[0, 0], [4, 0], [0, 0.07]]", "", end, 30, 0.02);
  struct result_file *f = run_bem(with);
  if (f) {
    const double way = gauge_front(&f->surface[f->n_surfaces - 1], 0, 1e-9) - 4;
    printf("     front by %.5f H, %.5f of a rigid slope\n", way, slope * end * end / 2);
    EXPECT_NEAR(way, slope * end * end / 2, 0.1 * BEM_TOE / 30) /* of a panel there */;
  }
  result_file_destroy(f);
}

/* Regions that all have the same velocity of their own, seen in the mirror too. */
static void test_regions_of_one_velocity_are_water_that_moves_as_one(void) {
  static const char *const waters[] = {
      "{points: [[0, 0], [2, 0], [2, 1], [0, 1]], velocity: [0.3, -0.1]}, "
      "{points: [[2, 0], [7, 0], [7, 0.25], [2, 0.25]], velocity: [0.3, -0.1]}",
      "{points: [[5, 0], [7, 0], [7, 1], [5, 1]], velocity: [-0.3, -0.1]}"};
  for (int i = 0; i < 2; i++) {
    struct case_file *c = case_of(waters[i], 1, 20, 0.02);
    struct bem_mirror seen = {0};
    struct bem_flow f = {0};
    EXPECT(c);
    if (!c) continue;
    EXPECT_OK(bem_mirror_create(c, &seen));
    EXPECT(seen.turned == (i == 1));
    EXPECT_OK(bem_start_surface(&seen.c, &c->runs[0], NULL, &f));
    const double *x = f.surface.state, *y = x + f.surface.n, *phi = y + f.surface.n;
    for (size_t k = 0; k < f.surface.n; k++) EXPECT_NEAR(phi[k], 0.3 * x[k] - 0.1 * y[k], 1e-14);
    bem_flow_destroy(&f);
    bem_mirror_destroy(&seen);
    case_destroy(c);
  }
}

int main(void) {
  RUN(test_joined_regions_have_the_outline_of_one_polygon);
  RUN(test_ends_on_a_dry_bed_are_toes);
  RUN(test_rounding_keeps_the_volume_of_one_corner_and_one_notch);
  RUN(test_released_pressure_of_a_wet_bed_is_that_of_finite_elements);
  RUN(test_wet_bed_throws_a_jet_whose_energy_converges);
  RUN(test_water_that_moves_as_one_starts_with_its_potential);
  RUN(test_regions_of_one_velocity_are_water_that_moves_as_one);
  RUN(test_front_of_a_flat_lens_runs_on);
  return TEST_RESULT;
}
