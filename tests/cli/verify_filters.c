/* What filters make of the pressure of an impact that nothing damps (thesis, section 3.2.1 and
 * table 3.2): the dam break of its section 4.3 by mSPH without smoothing. */
#include "compare/filters.h"
#include "compare/spectrum.h"
#include "tests/cli/run_text.h"

static const double H = 0.6, h = 0.025, c0 = 26.457513;

/* Probes every 1.25 cm up the wall, 40 h of it around P (0.266 H). */
static struct result_file *dam_break(void) {
  char text[4000];
  int n = snprintf(text, sizeof text,
                   "scales: {H: 0.6}\n"
                   "tank: {walls: [[[0, 4 H], [0, 0], [5.366 H, 0], [5.366 H, 4 H]]]}\n"
                   "water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]]}\n"
                   "time: {end: 1.3 s, every: 0.65 s, sample: 0.1 ms}\n"
                   "runs: [{solver: sph, resolution: 32, kernel: cubic, c0: %.8g, walls: mirror, "
                   "diffusion: none, alpha: 0, integrator: rk4, dt: 0.7559 ms, momentum: "
                   "reference}]\nprobes:\n",
                   c0);
  for (int k = -10; k <= 10; k++)
    n += snprintf(text + n, sizeof text - (size_t)n, "  - {name: P%d, at: [5.366 H, %.6g]}\n",
                  k + 10, 0.266 * H + 0.0125 * k);
  return run_text(text);
}

/* From 0.7 s on, Pa. */
static double deviation(size_t n, const double *t, const double *p) {
  double sum = 0, squares = 0, rows = 0;
  for (size_t i = 0; i < n; i++) {
    if (t[i] < 0.7) continue;
    rows++;
    sum += p[i];
    squares += p[i] * p[i];
  }
  return sqrt(squares / rows - sum * sum / (rows * rows));
}

/* Each probe takes part in the mean over a length by its weight. */
static void wall_mean(const struct result_file *f, double length, double *out) {
  struct cmp_series probe[32] = {0};
  double weight[32];
  for (size_t k = 0; k < f->n_probes; k++) {
    probe[k].x = f->probes[k].x;
    probe[k].y = f->probes[k].y;
  }
  size_t places;
  EXPECT_OK(cmp_wall_weights(&f->walls, f->n_probes, probe, 10, length, weight, &places));
  for (size_t i = 0; i < f->probes[10].n; i++) {
    out[i] = 0;
    for (size_t k = 0; k < f->n_probes; k++) out[i] += weight[k] * f->probes[k].value[i];
  }
}

/* The order of the table: the temporal filter is effective, the more so the longer the period, and
 * so is the mean over the wall; which of the two takes more at ten h is told and not held: the run
 * is chaotic. */
static void test_filters_have_the_order_of_the_table(void) {
  struct result_file *f = dam_break();
  const struct result_series *p = &f->probes[10];
  const struct cmp_signal raw = {p->n, p->t, p->value};
  double *out = calloc(p->n, sizeof *out), low[2], wall[2];
  const double before = deviation(p->n, p->t, p->value);
  for (int k = 0; k < 2; k++) {
    const double alpha = k ? 10 : 5;
    EXPECT_OK(cmp_signal_low_pass(&raw, 2 * alpha * h / c0, out));
    low[k] = deviation(p->n, p->t, out);
    wall_mean(f, alpha * h, out);
    wall[k] = deviation(p->n, p->t, out);
  }
  printf("     std of the pressure from 0.7 s on, kPa: raw %.2f; low pass at pi c0/5h %.2f, at pi "
         "c0/10h "
         "%.2f; mean over 5h %.2f, over 10h %.2f\n",
         before / 1e3, low[0] / 1e3, low[1] / 1e3, wall[0] / 1e3, wall[1] / 1e3);
  EXPECT(before > 1.2 * low[0] && low[0] > low[1]);
  EXPECT(before > wall[0] && wall[0] > wall[1]);
  free(out);
  result_file_destroy(f);
}

int main(void) {
  RUN(test_filters_have_the_order_of_the_table);
  return TEST_RESULT;
}
