/* A gauge that looks at a strip of the surface reads what it would read off the whole of it. */
#include "sph/observe/gauge.h"

#include "common/base/gauge.h"
#include "common/cloud/surface.h"
#include "sph/domain/wall.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

enum { GAUGES = 60 };

struct count {
  size_t wet, dry,
      beside; /* readings; of the wet ones, those of which the wall's meniscus is part */
};

/* At gauges all along the tank, and on its walls. */
static void compare(const struct case_file *c, const struct sph *s, struct cloud_surface *extractor,
                    struct geo_lines *whole, struct geo_lines *part, struct count *n) {
  const struct cloud cloud = {s->f.n, s->f.w.x, s->f.w.y, NULL, s->dx, &s->tank};
  EXPECT_OK(cloud_surface_extract(extractor, &cloud, &c->walls, whole));
  for (int k = 0; k <= GAUGES; k++) {
    const double *a = s->tank.box.min, *b = s->tank.box.max;
    double x = k < GAUGES ? a[0] + (b[0] - a[0]) * k / GAUGES : b[0], strip[2];
    sph_gauge_strip(s, x, strip);
    EXPECT_OK(cloud_surface_strip(extractor, &cloud, &c->walls, strip, part));
    double right = sph_gauge(s, whole, x), read = sph_gauge(s, part, x);
    if (memcmp(&read, &right, sizeof read) && !(isnan(read) && isnan(right)))
      TEST_FAIL("t = %g s, x = %g m: %.17g on a strip, %.17g on the whole surface", s->t, x, read,
                right);
    n->wet += isfinite(right);
    n->dry += isnan(right);
    n->beside += isfinite(right) && right != gauge_elevation(whole, x, a[1]);
  }
}

static void follow(const char *walls) {
  char run[100];
  snprintf(run, sizeof run, "resolution: 16, diffusion: antuono, walls: %s", walls);
  struct case_file *c = pool_case(POOL_DAM, run);
  struct sph *s = pool_create(c);
  struct cloud_surface *extractor = NULL;
  struct geo_lines whole = {0}, part = {0};
  struct count n = {0};
  const double unit = sqrt(0.6 / c->gravity);
  EXPECT_OK(cloud_surface_create(&extractor));
  for (int k = 0; k <= 65; k++) {
    EXPECT_OK(pool_march(s, 0.1 * k * unit));
    compare(c, s, extractor, &whole, &part, &n);
  }
  printf("     walls: %s: %zu wet, %zu dry, %zu corrected\n", walls, n.wet, n.dry, n.beside);
  EXPECT(n.wet > 1000 && n.dry > 100);
  EXPECT((n.beside > 10) == (sph_walls[s->scheme.walls]->layer > 0));
  cloud_surface_destroy(extractor);
  geo_lines_destroy(&whole);
  geo_lines_destroy(&part);
  sph_destroy(s);
  case_destroy(c);
}

static void test_strips_read_the_same_bits_all_through_a_dam_break(void) {
  for (const char *const *walls = sph_wall_names; *walls; walls++) follow(*walls);
}

int main(void) {
  RUN(test_strips_read_the_same_bits_all_through_a_dam_break);
  return TEST_RESULT;
}
