/* A column at the right wall is the mirror image of the same column at the left one. */
#include "common/base/gauge.h"
#include "tests/bem/run.h"

static const char text[] =
    "title: column\n"
    "fluid: {density: 1000, gravity: 9.81}\n"
    "scales: {H: 0.6}\n"
    "tank:\n"
    "  walls: [[[%g, 2], [%g, -0.1], [%g, -0.1], [%g, %g]]]\n"
    "  motions: [{kind: sway, amplitude: %g, period: 2, ramp: 1}]\n"
    "water: {regions: [[[%g, -0.1], [%g, -0.1], [%g, 0.5], [%g, 0.5]]], pressure: released}\n"
    "time: {end: 1.6, every: 0.2, sample: 0.02}\n"
    "probes: [{name: P, at: [%g, 0.03], size: 0.05}, {name: bed, at: [%g, -0.1]}]\n"
    "gauges: [{name: G, x: %g}]\n"
    "runs: [{name: bem, solver: bem, resolution: 14, forces: true}]\n";

enum { LEFT = -2 };             /* x of the left wall, m */
static const double W = 3.2196; /* width of the tank, m */

/* way: 1, or -1 for the mirror image; places are counted from the wall that the column stands at.
 */
static double at(int way, double x) {
  return way > 0 ? LEFT + x : LEFT + W - x;
}

static struct result_file *column(int way) {
  char with[2000];
  const double a = at(way, way > 0 ? 0 : 1.2), b = at(way, way > 0 ? 1.2 : 0);
  snprintf(with, sizeof with, text, at(1, 0), at(1, 0), at(1, W), at(1, W), 2., way * 0.02, a, b, b,
           a, at(way, W), at(way, 0.5), at(way, 0.9));
  return run_bem(with);
}

static double mirrored(double x) {
  return 2 * LEFT + W - x;
}

static double worst(double now, double a, double b, double size) {
  const double off = isnan(a) && isnan(b) ? 0 : fabs(a - b) / size;
  return off > now ? off : now;
}

static double worst_event(const struct result_file *a, const struct result_file *b) {
  double off = 0;
  EXPECT(a->n_events == b->n_events && a->n_events >= 3);
  for (size_t i = 0; i < a->n_events && i < b->n_events; i++) {
    const struct result_event_read *p = &a->events[i], *q = &b->events[i];
    EXPECT(!strcmp(p->name, q->name));
    off = worst(off, p->time, q->time, 1);
    off = worst(off, mirrored(p->x), q->x, 1);
    off = worst(off, p->y, q->y, 1);
  }
  return off;
}

static double worst_surface(const struct result_file *a, const struct result_file *b) {
  double off = 0;
  for (size_t k = 0; k < a->n_surfaces && k < b->n_surfaces; k++) {
    const struct geo_lines *p = &a->surface[k], *q = &b->surface[k];
    EXPECT(p->points == q->points);
    for (size_t i = 0; i < p->points && p->points == q->points; i++) {
      const size_t j = q->points - 1 - i;
      off = worst(off, mirrored(p->p[i][0]), q->p[j][0], 1);
      off = worst(off, p->p[i][1], q->p[j][1], 1);
    }
  }
  return off;
}

static double worst_series(const struct result_file *a, const struct result_file *b) {
  static const char *const odd[] = {"force_x", "moment", "momentum_x"};
  double off = 0;
  EXPECT(a->n_energy == b->n_energy && a->n_diagnostics == b->n_diagnostics);
  for (size_t i = 0; i < a->n_energy; i++) {
    off = worst(off, a->energy[i].kinetic, b->energy[i].kinetic, 1e3);
    for (size_t k = 0; k < 2; k++)
      off = worst(off, a->probes[k].value[i], b->probes[k].value[i], 1e4);
    off = worst(off, a->gauges[0].value[i], b->gauges[0].value[i], 1);
  }
  for (size_t d = 0; d < a->n_diagnostics; d++)
    for (size_t k = 0; k < 3; k++)
      for (size_t i = 0; !strcmp(a->diagnostics[d].name, odd[k]) && i < a->n_energy; i++)
        off = worst(off, -a->diagnostics[d].value[i], b->diagnostics[d].value[i], 1e4);
  return off;
}

/* In a tank that sways, so that right and left matter. */
static void test_right_column_is_the_mirror_image_of_the_left_one(void) {
  struct result_file *left = column(1), *right = column(-1);
  if (left && right) {
    EXPECT(left->n_surfaces == right->n_surfaces && left->n_surfaces > 5);
    EXPECT(left->n_energy > 50 && left->n_diagnostics > 3);
    const double event = worst_event(left, right), surface = worst_surface(left, right),
                 series = worst_series(left, right);
    printf("     events off by %.1e, surfaces %.1e m, series %.1e\n", event, surface, series);
    EXPECT(event < 1e-9 && surface < 1e-9 && series < 1e-9);
    EXPECT(right->surface[0].p[0][0] < right->surface[0].p[right->surface[0].points - 1][0]);
    EXPECT(gauge_front(&right->surface[0], -0.1, 0.01) > 1); /* stands at the right wall */
  }
  result_file_destroy(left);
  result_file_destroy(right);
}

int main(void) {
  RUN(test_right_column_is_the_mirror_image_of_the_left_one);
  return TEST_RESULT;
}
