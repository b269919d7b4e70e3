/* What energies are divided by, and what rest they count from. */
#include "tests/test.h"

#include "compare/data.h"
#include "tests/compare/shapes.h"

static const double density = 1000, g = 9.81, H = 0.6;

/* A run whose potential energy was `above` (J/m) over its rest at the start and is half that later.
 */
static struct result_file run_above(double rest, double above, struct result_energy energy[2]) {
  energy[0] = (struct result_energy){.time = 0, .potential = rest + above};
  energy[1] = (struct result_energy){.time = 1, .potential = rest + above / 2};
  return (struct result_file){.path = "run.h5",
                              .run = "run",
                              .H = H,
                              .g = g,
                              .density = density,
                              .spacing = 0.04 * H,
                              .rest_potential = rest,
                              .walls = shape_tank(2 * H, 3 * H),
                              .n_energy = 2,
                              .energy = energy};
}

static struct cmp_scales scales_of(double rest, double above) {
  struct result_energy energy[2];
  struct result_file f = run_above(rest, above, energy);
  struct cmp_scales s = {0};
  EXPECT_OK(cmp_scales_set(&f, &s));
  geo_lines_destroy(&f.walls);
  return s;
}

static void test_water_at_rest_is_not_divided_by(void) {
  const double scale = density * g * H * H * H, rest[] = {scale, 0, -40 * scale};
  for (int k = 0; k < 3; k++) { /* wherever the bed is */
    struct cmp_scales still = scales_of(rest[k], 1e-9 * scale), below = scales_of(rest[k], -scale);
    EXPECT(still.at_rest && below.at_rest);
    EXPECT_NEAR(still.E, scale, 1e-9 * scale);
    struct cmp_scales moving = scales_of(rest[k], 1e-3 * scale);
    EXPECT(!moving.at_rest);
    EXPECT_NEAR(moving.E, 1e-3 * scale, 1e-12 * scale);
  }
}

/* A compressible run rests higher than the reference; both start with E0 and keep half of it. */
static void test_each_run_counts_from_its_own_rest(void) {
  struct result_energy energy[2], other[2];
  struct result_file reference = run_above(50, 2, energy), run = run_above(53, 2, other);
  const struct geo_box window = {{-1, -1}, {9, 9}};
  struct cmp_scales s;
  struct cmp_data d;
  EXPECT_OK(cmp_scales_set(&reference, &s));
  EXPECT_OK(cmp_data_create(&run, &run.walls, &s, 0.1, &window, &d));
  EXPECT_NEAR(d.mechanical.value[0], 1, 1e-12);
  EXPECT_NEAR(d.potential.value[1], 0.5, 1e-12);
  cmp_data_destroy(&d);
  geo_lines_destroy(&reference.walls);
  geo_lines_destroy(&run.walls);
}

int main(void) {
  RUN(test_water_at_rest_is_not_divided_by);
  RUN(test_each_run_counts_from_its_own_rest);
  return TEST_RESULT;
}
