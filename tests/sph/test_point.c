/* The water at points, by sums that are known. */
#include "sph/observe/point.h"

#include "tests/sph/pool.h"
#include "tests/test.h"

static struct case_point at(double x, double y) {
  return (struct case_point){.x = x, .y = y, .every = 1};
}

/* Means of linear fields over a lattice are their values in the middle of a cell, by symmetry. */
static void test_inside_a_lattice_means_are_values(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, alpha: 0, precision: double");
  struct sph *s = pool_create(c);
  double value[CASE_POINT_FIELDS];
  for (size_t i = 0; i < s->f.n; i++) {
    const double x = s->f.w.x[i] - 1.5, y = s->f.w.y[i] - 1.5;
    s->f.w.rho[i] = s->rho0;
    s->f.w.u[i] = 2 + x - 3 * y;
    s->f.w.v[i] = 1 + 4 * x + 5 * y;
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++) { /* whatever they would be */
    s->f.w.rho[i] = s->rho0 * 1.01;
    s->f.k[0].u[i] = 6 * s->f.w.x[i];
    s->f.k[0].v[i] = -s->g;
  }
  const struct case_point point = at(1.55, 1.4);
  sph_point(s, &point, value);
  EXPECT_NEAR(value[CASE_POINT_rho], s->rho0 * 1.01, 1e-9);
  EXPECT_NEAR(value[CASE_POINT_p], 0.01 * s->rho0 * s->c0 * s->c0, 1e-6);
  EXPECT_NEAR(value[CASE_POINT_u], 2 + 0.05 + 0.3, 1e-12);
  EXPECT_NEAR(value[CASE_POINT_v], 1 + 0.2 - 0.5, 1e-12);
  EXPECT_NEAR(value[CASE_POINT_a_x], 6 * 1.55, 1e-12);
  EXPECT_NEAR(value[CASE_POINT_a_y], -s->g, 1e-12);
  EXPECT_NEAR(value[CASE_POINT_cover], 1 / 1.01, 1e-3); /* the lattice's own sum is 1 to 1e-4 */
  sph_destroy(s);
  case_destroy(c);
}

/* At the middle of an edge half of the neighbours are there, at a corner a quarter; beyond, none.
 */
static void test_cover_tells_edges(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20, alpha: 0");
  struct sph *s = pool_create(c);
  double value[CASE_POINT_FIELDS];
  EXPECT_OK(sph_rates(s, 0, true, true));
  static const double where[][3] = {{1.5, 2, 0.5}, {2, 2, 0.25}};
  for (int k = 0; k < 2; k++) {
    const struct case_point point = at(where[k][0], where[k][1]);
    sph_point(s, &point, value);
    EXPECT_NEAR(value[CASE_POINT_cover], where[k][2], 2e-3); /* compressed by its own weight */
    EXPECT(isfinite(value[CASE_POINT_p]));
  }
  const struct case_point beyond = at(2.1, 2.1), far = at(0.1, 0.1);
  sph_point(s, &beyond, value);
  EXPECT(value[CASE_POINT_cover] > 0 && value[CASE_POINT_cover] < 0.1);
  EXPECT(isnan(value[CASE_POINT_p]) && isnan(value[CASE_POINT_a_y]));
  sph_point(s, &far, value);
  EXPECT(value[CASE_POINT_cover] == 0 && isnan(value[CASE_POINT_u]));
  sph_destroy(s);
  case_destroy(c);
}

/* With the neighbours beyond a periodic side, of a kernel that is a product. */
static void test_periodic_sides_are_none(void) {
  struct case_file *c = pool_case(
      "title: wave\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: "
      "periodic}\nwater: {wave: {kind: airy, amplitude: 0.001, wavelength: 1, depth: "
      "1}}\n" POOL_TIMES,
      "resolution: 20, kernel: tensor, h_over_dx: 1, walls: mirror");
  struct sph *s = pool_create(c);
  double left[CASE_POINT_FIELDS], right[CASE_POINT_FIELDS];
  EXPECT_OK(sph_rates(s, 0, true, true));
  const struct case_point ends[] = {at(0, 0.5), at(1, 0.5)};
  sph_point(s, &ends[0], left);
  sph_point(s, &ends[1], right);
  EXPECT_NEAR(left[CASE_POINT_cover], 1, 0.01);
  for (int k = 0; k <= CASE_POINT_cover; k++)
    EXPECT_NEAR(left[k], right[k], 1e-12 * fmax(1, fabs(left[k])));
  sph_destroy(s);
  case_destroy(c);
}

/* The nearest, also beyond a periodic side, and the same one wherever it goes and however particles
 * are sorted: by its mass, which no other has. */
static void test_a_particle_is_followed(void) {
  struct case_file *c = pool_case(
      "title: wave\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: "
      "periodic}\nwater: {wave: {kind: airy, amplitude: 0.05, wavelength: 1, depth: "
      "1}}\n" POOL_TIMES,
      "resolution: 20, kernel: tensor, h_over_dx: 1, walls: mirror, momentum: mass, continuity: "
      "mass");
  struct sph *s = pool_create(c);
  double value[CASE_POINT_FIELDS];
  EXPECT_OK(sph_rates(s, 0, true, true));
  size_t of = 0;
  for (size_t i = 0; i < s->f.n; i++)
    if (s->f.id[i] == 238) of = i;
  struct case_point place = at(s->f.w.x[of] + 1e-3, s->f.w.y[of] - 1e-3);
  EXPECT(sph_point_nearest(s, &place) == 238);
  place.x += 1;
  EXPECT(sph_point_nearest(s, &place) == 238);
  const double mass = s->f.m[of] *= 1 + 1e-9;
  const double began = s->f.w.x[of];
  for (int step = 0; step < 50; step++) {
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, 0.5 * s->h / s->c0));
  }
  EXPECT_OK(sph_rates(s, 0, true, true));
  for (size_t i = 0; i < s->f.n; i++)
    if (s->f.m[i] == mass) of = i;
  sph_point_follow(s, 238, value);
  EXPECT(fabs(s->f.w.x[of] - began) > 1e-3);
  EXPECT(value[CASE_POINT_x] == s->f.w.x[of] && value[CASE_POINT_y] == s->f.w.y[of]);
  EXPECT(value[CASE_POINT_u] == s->f.w.u[of] && value[CASE_POINT_v] == s->f.w.v[of]);
  EXPECT(value[CASE_POINT_a_x] == s->f.k[0].u[of] && value[CASE_POINT_a_y] == s->f.k[0].v[of]);
  EXPECT(value[CASE_POINT_rho] == s->f.w.rho[of]);
  EXPECT_NEAR(value[CASE_POINT_cover], 1, 0.05);
  sph_point_follow(s, (uint32_t)s->f.n, value); /* one that has gone */
  for (int k = 0; k < CASE_POINT_FIELDS; k++) EXPECT(isnan(value[k]));
  sph_destroy(s);
  case_destroy(c);
}

int main(void) {
  RUN(test_inside_a_lattice_means_are_values);
  RUN(test_cover_tells_edges);
  RUN(test_periodic_sides_are_none);
  RUN(test_a_particle_is_followed);
  return TEST_RESULT;
}
