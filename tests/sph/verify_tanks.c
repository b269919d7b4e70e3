/* Still water in tanks that are not rectangular, for 20 sqrt(H/g). */
#include "tests/test.h"

#include "sph/fluid/energy.h"
#include "tests/sph/tanks.h"

/* The largest speed from `from` sqrt(H/g) on, over sqrt(gH), and the change of the potential energy
 * against that at t = 0, where it is largest. */
struct still {
  double speed, potential;
  size_t outside;
};

static struct still keep_still(const struct still_tank *t, const char *run, double from) {
  struct case_file *c = still_tank_case(t, run);
  struct sph *s = pool_create(c);
  struct still k = {0};
  const double unit = 1 / sqrt(s->g), before = sph_energy(s).potential;
  for (int step = 1; step <= 40; step++) {
    EXPECT_OK(pool_march(s, 0.5 * step * unit));
    const double change = sph_energy(s).potential / before - 1;
    if (fabs(change) > fabs(k.potential)) k.potential = change;
    if (0.5 * step >= from) k.speed = fmax(k.speed, still_tank_speed(s) / sqrt(s->g));
    k.outside += still_tank_outside(s, t);
  }
  sph_destroy(s);
  case_destroy(c);
  return k;
}

/* Particles that start in cells which a slope has cut leave their places: the first waves of that
 * die away by 5 sqrt(H/g). Around corners of the solid water that is driven by its walls takes more
 * than 10 until it moves (layers.h). */
static void test_still_water_stays_in_tanks(void) {
  for (size_t k = 0; k < STILL_TANKS; k++) {
    const struct still o = keep_still(&still_tanks[k], "resolution: 20", 5);
    printf("     %s: speed %.4f sqrt(gH), potential energy %+.4f %%, %zu outside\n",
           still_tanks[k].name, o.speed, 100 * o.potential, o.outside);
    EXPECT(o.speed < 0.02);
    EXPECT_NEAR(o.potential, 0, 1e-3);
    EXPECT(o.outside == 0);
  }
}

int main(void) {
  RUN(test_still_water_stays_in_tanks);
  return TEST_RESULT;
}
