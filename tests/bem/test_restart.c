/* Water that moves, from a file, in a tank that is not rectangular: the potential on the surface or
 * the velocity there. */
#include "tests/bem/run.h"

static const double A = 1e-3;

static void write_surface(const char *path, bool velocities) {
  FILE *out = fopen(path, "w");
  EXPECT(out != NULL);
  for (int i = -40; out && i <= 40; i++) {
    const double x = 0.05 * i;
    fprintf(out, velocities ? "%.17g, 0, %.17g, %.17g\n" : "%.17g, 0, %.17g\n", x,
            velocities ? A : A * x, A * x);
  }
  EXPECT(out && fclose(out) == 0);
}

static struct result_file *run_from_file(bool velocities) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  write_surface("plunge-restart.csv", velocities);
  FILE *out = fopen("plunge-restart.yaml", "w");
  EXPECT(out != NULL);
  if (!out) return NULL;
  fputs("fluid: {density: 1, gravity: 1}\n"
        "scales: {H: 1}\n"
        "tank: {walls: [[[-2, 2], [0, 0], [2, 2]]]}\n"
        "water: {wave: {kind: file, depth: 1, file: plunge-restart.csv}}\n"
        "time: {end: 4, every: 4, sample: 0.05}\n"
        "gauges: [{name: side, x: 0.8}]\n"
        "runs: [{name: bem, solver: bem, resolution: 20}]\n",
        out);
  EXPECT(fclose(out) == 0);
  if (case_load("plunge-restart.yaml", 0, NULL, &run_registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  remove("plunge-restart.yaml");
  remove("plunge-restart.csv");
  return c ? run_bem_case(c) : NULL;
}

/* phi = A x y sin(pi/2 + t) in a wedge of 90 degrees (test_basin.c), level at t = 0: the surface
 * tilts as A x sin t, up to terms of the order A^2. */
static void test_water_goes_on_from_the_potential_or_the_velocity_on_its_surface(void) {
  for (int velocities = 0; velocities < 2; velocities++) {
    struct result_file *f = run_from_file(velocities);
    if (!f) return;
    double worst = 0;
    for (size_t i = 0; i < f->gauges[0].n; i++) {
      const double theory = 1 + A * 0.8 * sin(f->gauges[0].t[i]);
      worst = fmax(worst, fabs(f->gauges[0].value[i] - theory));
    }
    printf("  from %s: off by %.1e of A\n", velocities ? "velocities" : "a potential", worst / A);
    EXPECT(f->gauges[0].n == 81);
    EXPECT(worst < 2 * A * A);
    result_file_destroy(f);
  }
}

int main(void) {
  RUN(test_water_goes_on_from_the_potential_or_the_velocity_on_its_surface);
  return TEST_RESULT;
}
