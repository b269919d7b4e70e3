/* Tanks whose sides are none: what leaves through one comes in through the other. */
#include "tests/test.h"

#include <omp.h>

#include "common/cloud/surface.h"
#include "sph/domain/wall.h"
#include "sph/observe/gauge.h"
#include "tests/sph/pool.h"

#define TANK "scales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]], sides: periodic}\n"
/* Standing on the bed, and far above it: a slab that goes on for ever and falls free. */
#define LAYER TANK "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n" POOL_TIMES
#define SLAB  TANK "water: {regions: [[[0, 0.8], [2, 0.8], [2, 1.5], [0, 1.5]]]}\n" POOL_TIMES

static const double L = 2;

static double shifted(double x, double by) {
  return x + by < L ? x + by : x + by - L;
}

/* A wave of no symmetry, of length L/2 and less, everywhere in the water. */
static void add_wave(struct sph *s, double from) {
  for (size_t i = 0; i < s->f.n; i++) {
    const double k = 2 * M_PI / L, x = s->f.w.x[i] - from, y = s->f.w.y[i];
    s->f.w.u[i] += 0.3 * sin(k * x + y) + 0.1 * cos(3 * k * x);
    s->f.w.v[i] += 0.2 * cos(2 * k * x + 3 * y) * y;
    s->f.w.rho[i] *= 1 + 2e-4 * cos(k * x - 2 * y);
  }
  sph_particles_pad(&s->f);
}

/* The particles by their numbers, since sorting is another one's. */
static size_t *places_of(const struct sph *s) {
  size_t *place = calloc(s->f.n, sizeof *place);
  for (size_t i = 0; i < s->f.n; i++) place[s->f.id[i]] = i;
  return place;
}

/* Every pair within the support is listed once, whichever way round the tank. */
static void test_lists_hold_every_pair_round_the_seam(void) {
  struct case_file *c = pool_case(LAYER, "resolution: 23");
  struct sph *s = pool_create(c);
  pool_shake(s, 3, 0, 0);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.x[i] += 0.6; /* and some round it */
  EXPECT_OK(sph_neighbours_update(s));
  size_t missing = 0, pairs = 0, round = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    size_t n;
    const uint32_t *list = sph_lists_of(&s->water_water, i / SPH_LANES, &n);
    EXPECT(s->f.w.x[i] >= 0 && s->f.w.x[i] < L);
    for (size_t j = 0; j < s->f.n; j++) {
      const double way = s->f.w.x[j] - s->f.w.x[i], x = way - L * nearbyint(way / L);
      if (hypot(x, s->f.w.y[j] - s->f.w.y[i]) >= s->support) continue;
      int times = 0;
      for (size_t k = 0; k < n; k++)
        times += sph_period_particle(s, list[k]) == j && (list[k] == j) == (x == way);
      missing += times != 1;
      round += x != way;
      pairs++;
    }
  }
  EXPECT(pairs > 20 * s->f.n && round > pairs / 50);
  EXPECT(missing == 0);
  sph_destroy(s);
  case_destroy(c);
}

/* The same wave half a tank farther: the same to rounding, which grows with the steps. */
static void expect_translated(const char *head, const char *run) {
  struct case_file *c = pool_case(head, run);
  struct sph *s[2] = {pool_create(c), pool_create(c)};
  double most = 0, speed = 0;
  for (int k = 0; k < 2; k++) {
    for (size_t i = 0; i < s[k]->f.n; i++) s[k]->f.w.x[i] = shifted(s[k]->f.w.x[i], k * L / 2);
    add_wave(s[k], k * L / 2);
    EXPECT_OK(pool_march(s[k], 0.06));
  }
  EXPECT(s[0]->steps > 10 && s[0]->steps == s[1]->steps);
  size_t *place[2] = {places_of(s[0]), places_of(s[1])};
  for (size_t n = 0; n < s[0]->f.n; n++) {
    const struct sph_state *a = &s[0]->f.w, *b = &s[1]->f.w;
    const size_t i = place[0][n], j = place[1][n];
    const double way = b->x[j] - a->x[i] - L / 2;
    most = fmax(most, fabs(way - L * round(way / L)) / s[0]->dx);
    most = fmax(most, fabs(a->y[i] - b->y[j]) / s[0]->dx);
    most = fmax(most, hypot(a->u[i] - b->u[j], a->v[i] - b->v[j]));
    most = fmax(most, fabs(a->rho[i] - b->rho[j]));
    speed = fmax(speed, fabs(a->u[i]));
  }
  EXPECT(speed > 0.1);
  EXPECT_NEAR(most, 0, 1e-9); /* of 0.3 m/s, 1000 kg/m^3 and a spacing */
  for (int k = 0; k < 2; k++) {
    free(place[k]);
    sph_destroy(s[k]);
  }
  case_destroy(c);
}

static void test_a_wave_is_the_same_anywhere(void) {
  expect_translated(LAYER, "resolution: 20, precision: double");
  expect_translated(LAYER, "resolution: 20, precision: double, walls: mirror");
  expect_translated(SLAB, "resolution: 20, precision: double, diffusion: molteni");
}

static void test_treatments_know_no_sides(void) {
  static const char *const treatments[] = {
#define X(name, ...) #name,
      SPH_TREATMENTS(X)
#undef X
  };
  for (size_t k = 0; k < sizeof treatments / sizeof *treatments; k++) {
    char run[200];
    snprintf(run, sizeof run, "resolution: 10, precision: double, %s: 3", treatments[k]);
    expect_translated(LAYER, run);
  }
}

static void sum_momentum(const struct sph *s, double p[2]) {
  p[0] = p[1] = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    p[0] += s->f.m[i] * s->f.w.u[i];
    p[1] += s->f.m[i] * s->f.w.v[i];
  }
}

/* Sound that runs round the tank: no wall takes momentum, gravity gives what is its own. */
static void test_sound_keeps_its_momentum(void) {
  struct case_file *c = pool_case(SLAB, "resolution: 20, precision: double, alpha: 0.1");
  struct sph *s = pool_create(c);
  double before[2], after[2], mass = 0, size = 0;
  pool_shake(s, 0.2, 0, 0);
  add_wave(s, 0);
  sum_momentum(s, before);
  EXPECT_OK(pool_march(s, 0.06));
  sum_momentum(s, after);
  for (size_t i = 0; i < s->f.n; i++) {
    mass += s->f.m[i];
    size += s->f.m[i] * hypot(s->f.w.u[i], s->f.w.v[i]);
  }
  EXPECT(s->steps > 20 && s->w.n > 0);
  EXPECT_NEAR(after[0], before[0], 1e-13 * size * (double)s->steps);
  EXPECT_NEAR(after[1], before[1] - mass * s->g * s->t, 1e-13 * size * (double)s->steps);
  sph_destroy(s);
  case_destroy(c);
}

/* More than once round the tank with nothing else to do. */
static void test_uniform_water_stays_so(void) {
  struct case_file *c = pool_case(SLAB, "resolution: 20, precision: double, c0: 40");
  struct sph *s = pool_create(c);
  const double U = 8, end = 0.55;
  double *x = calloc(s->f.n, sizeof *x), off = 0;
  pool_set_gravity(s, 0);
  for (size_t i = 0; i < s->f.n; i++) {
    x[s->f.id[i]] = s->f.w.x[i];
    s->f.w.u[i] = U;
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(pool_march(s, end));
  for (size_t i = 0; i < s->f.n; i++) {
    const double way = s->f.w.x[i] - x[s->f.id[i]] - U * s->t;
    off = fmax(off, fabs(way - L * round(way / L)));
    off = fmax(off, fabs(s->f.w.u[i] - U) + fabs(s->f.w.v[i]) + fabs(s->f.w.rho[i] - 1000) / 1e3);
  }
  EXPECT_NEAR(off, 0, 1e-10);
  EXPECT(s->rebuilds > 20); /* that they have gone far is why */
  free(x);
  sph_destroy(s);
  case_destroy(c);
}

/* Water at rest on the bed stays as still as between walls of ghosts. */
static void test_still_water_knows_no_sides(void) {
  struct case_file *c = pool_case(LAYER, "resolution: 20, precision: double");
  struct sph *s = pool_create(c);
  double speed = 0, sideways = 0;
  EXPECT_OK(pool_march(s, 0.05));
  for (size_t i = 0; i < s->f.n; i++) {
    speed = fmax(speed, hypot(s->f.w.u[i], s->f.w.v[i]));
    sideways = fmax(sideways, fabs(s->f.w.u[i]));
  }
  EXPECT(speed > 1e-6 && speed < 0.02);
  EXPECT_NEAR(sideways, 0, 1e-11); /* every column is like every other */
  sph_destroy(s);
  case_destroy(c);
}

/* The surface goes from side to side at the level of the water; and where the water has gone half
 * round, it has gone with it. */
static void test_surfaces_and_gauges_go_on_round_the_seam(void) {
  struct case_file *c = pool_case(LAYER, "resolution: 20");
  struct sph *s = pool_create(c);
  struct cloud_surface *extractor;
  struct geo_lines line = {0}, outline = {0};
  EXPECT_OK(cloud_surface_create(&extractor));
  EXPECT_OK(tank_outline(&s->tank, &c->walls, &outline));
  double elevation[2];
  for (int k = 0; k < 2; k++) {
    for (size_t i = 0; i < s->f.n; i++) {
      s->f.w.x[i] = shifted(s->f.w.x[i], k * 0.9);
      if (k == 0) s->f.w.y[i] *= 1 + 0.1 * cos(M_PI * s->f.w.x[i]);
    }
    const struct cloud cloud = {s->f.n, s->f.w.x, s->f.w.y, NULL, s->dx, &s->tank};
    EXPECT_OK(cloud_surface_extract(extractor, &cloud, &outline, &line));
    EXPECT(line.pieces == 1 && !line.closed[0]);
    const double *first = line.p[0], *last = line.p[line.points - 1];
    EXPECT(first[0] == 0 && last[0] == L);
    EXPECT_NEAR(first[1], last[1], 1e-12);
    EXPECT_NEAR(first[1], 1 + 0.1 * cos(M_PI * 0.9 * k), 0.01);
    elevation[k] = sph_gauge(s, &line, k * 0.9); /* of the crest, on the seam and off it */
  }
  EXPECT_NEAR(elevation[0], elevation[1], 1e-4);
  geo_lines_destroy(&line);
  geo_lines_destroy(&outline);
  cloud_surface_destroy(extractor);
  sph_destroy(s);
  case_destroy(c);
}

/* To the last bit, seam or not. */
static void test_threads_do_not_matter(void) {
  struct case_file *c = pool_case(LAYER, "resolution: 20, walls: mirror");
  double *x = NULL;
  for (int threads = 1; threads <= 3; threads++) {
    omp_set_num_threads(threads);
    struct sph *s = pool_create(c);
    pool_shake(s, 0, 0, 0);
    add_wave(s, 0.3);
    EXPECT_OK(pool_march(s, 0.02));
    if (!x) x = calloc(3 * s->f.n, sizeof *x);
    for (size_t i = 0; i < s->f.n; i++) {
      double *at = x + 3 * s->f.id[i];
      const double now[3] = {s->f.w.x[i], s->f.w.v[i], s->f.w.rho[i]};
      EXPECT(threads == 1 || !memcmp(at, now, sizeof now));
      memcpy(at, now, sizeof now);
    }
    sph_destroy(s);
  }
  omp_set_num_threads(1);
  free(x);
  case_destroy(c);
}

int main(void) {
  RUN(test_lists_hold_every_pair_round_the_seam);
  RUN(test_a_wave_is_the_same_anywhere);
  RUN(test_treatments_know_no_sides);
  RUN(test_sound_keeps_its_momentum);
  RUN(test_uniform_water_stays_so);
  RUN(test_still_water_knows_no_sides);
  RUN(test_surfaces_and_gauges_go_on_round_the_seam);
  RUN(test_threads_do_not_matter);
  return TEST_RESULT;
}
