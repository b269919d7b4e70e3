/* Water that moves, from a file, in a tank that is not rectangular: the potential on the surface or
 * the velocity there. */
#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/flow/line.h"
#include "tests/bem/run.h"
#include "tests/common/result_water.h"

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

/* ---- a wave that breaks ---- */

static const char BREAKING[] =
    "fluid: {density: 1000, gravity: 9.81}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 2], [0, 0], [5.6, 0], [5.6, 2]]], sides: periodic}\n"
    "water: {wave: {%s}}\n"
    "time: {end: %.17g, every: %.17g}\n"
    "runs: [{name: bem, solver: bem, resolution: %d}]\n";

static const double UNIT = 0.31927542840705044; /* sqrt(H/g), s */
enum { BEFORE = 11, END = 12 };                 /* outputs: upright at 10.9 */

static struct result_file *run_wave(const char *wave, int outputs, int resolution, run_look *look) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  const double every = 0.25 * UNIT;
  FILE *out = fopen("plunge-breaker.yaml", "w");
  EXPECT(out != NULL);
  if (!out) return NULL;
  fprintf(out, BREAKING, wave, outputs * every, every, resolution);
  EXPECT(fclose(out) == 0);
  if (case_load("plunge-breaker.yaml", 0, NULL, &run_registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  remove("plunge-breaker.yaml");
  return c ? run_bem_and(c, look, NULL) : NULL;
}

/* The nodes of a period, from the first on, wherever it is. */
static void write_curve(const char *path, void *unused) {
  (void)unused;
  struct result_water at;
  EXPECT_OK(water_read(path, "potential", false, BEFORE, &at));
  FILE *out = fopen("plunge-breaker.csv", "w");
  EXPECT(out && at.n);
  for (size_t k = 0; out && k < at.n; k++)
    fprintf(out, "%.17g, %.17g, %.17g\n", at.p[k][0], at.p[k][1], at.value[0][k]);
  EXPECT(out && fclose(out) == 0);
  result_water_free(&at);
}

/* Splines through the points of a surface, as chords of a fiftieth of their distances. */
static enum status refine(const struct geo_lines *from, struct geo_lines *to) {
  const size_t n = from->points;
  double *x, *way;
  struct flow_line line;
  size_t ways;
  TRY(array_create(&x, 2 * n, "a surface"));
  for (size_t i = 0; i < n; i++) {
    x[i] = from->p[i][0];
    x[n + i] = from->p[i][1];
  }
  TRY(flow_line_create(&(struct flow_rows){n, x, x + n, NULL, NULL}, false, &line));
  TRY(flow_line_sample(&line, 0, 1e-3, &ways, &way));
  TRY(geo_lines_begin(to, false));
  for (size_t i = 0; i < ways; i++) {
    const struct flow_line_point at = flow_line_at(&line, way[i]);
    TRY(geo_lines_add(to, at.p[0], at.p[1]));
  }
  flow_line_destroy(&line);
  free(way);
  free(x);
  return OK;
}

/* Mean and largest distance of the points of a surface from another. */
static void find_distance(const struct geo_lines *a, const struct geo_lines *b, double d[2]) {
  struct geo_lines fine = {0};
  d[0] = d[1] = 0;
  EXPECT_OK(refine(b, &fine));
  for (size_t i = 0; i < a->points; i++) {
    double nearest[2];
    size_t piece;
    const double here = geo_lines_distance(&fine, a->p[i][0], a->p[i][1], nearest, &piece);
    d[0] += here / (double)a->points;
    d[1] = fmax(d[1], here);
  }
  geo_lines_destroy(&fine);
}

static void restart(int resolution, double d[2]) {
  struct result_file *whole = run_wave("kind: airy, amplitude: 0.38, wavelength: 5.6, depth: 1",
                                       END, resolution, write_curve);
  struct result_file *part =
      run_wave("kind: curve, depth: 1, file: plunge-breaker.csv", END - BEFORE, resolution, NULL);
  remove("plunge-breaker.csv");
  d[0] = d[1] = INFINITY;
  if (whole && part && whole->n_surfaces == END + 1 && part->n_surfaces == END - BEFORE + 1)
    find_distance(&part->surface[END - BEFORE], &whole->surface[END], d);
  else
    TEST_FAIL("a run has not come to its end");
  result_file_destroy(whole);
  result_file_destroy(part);
}

/* It goes on as the run did from whose nodes it starts: on splines through them. */
static void test_breaking_wave_goes_on_from_its_own_surface(void) {
  double coarse[2], fine[2];
  restart(20, coarse);
  restart(40, fine);
  printf("  mean %.1e, %.1e, largest %.1e, %.1e H\n", coarse[0], fine[0], coarse[1], fine[1]);
  EXPECT(coarse[0] < 1e-4 && coarse[1] < 1e-3);   /* H */
  EXPECT(fine[0] > 0 && fine[0] < coarse[0] / 8); /* of fourth order: 16 */
}

int main(void) {
  RUN(test_water_goes_on_from_the_potential_or_the_velocity_on_its_surface);
  RUN(test_breaking_wave_goes_on_from_its_own_surface);
  return TEST_RESULT;
}
