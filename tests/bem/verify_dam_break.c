/* The dam break of Buchner's tank (column 2H by H, tank 5.366H) at three resolutions, from release
 * to the touchdown of the backward plunging jet, in units H = g = 1. */
#include "tests/bem/run.h"

static const char text[] =
    "title: dam break\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 4], [0, 0], [5.366, 0], [5.366, 4]]]}\n"
    "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: released}\n"
    "time: {end: 6.5, every: 0.5, sample: 0.01}\n"
    "probes: [{name: P1, at: [5.366, 0.266]}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d}]\n";

struct instants {
  double impact, overturn[3], touchdown[3]; /* t, x, y */
  double volume, energy;                    /* largest relative error with what was removed */
};

static struct instants dam_break(int resolution) {
  char with[sizeof text + 20];
  snprintf(with, sizeof with, text, resolution);
  struct instants out = {0};
  double start = progress_wall_clock();
  struct result_file *f = run_bem(with);
  if (!f) return out;
  struct result_event_read o = run_event(f, "overturning"), t = run_event(f, "touchdown");
  out = (struct instants){.impact = run_event(f, "wall_impact").time,
                          .overturn = {o.time, o.x, o.y},
                          .touchdown = {t.time, t.x, t.y}};
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = (f->energy[i].total + f->energy[i].removed) / f->energy[0].total - 1;
    double v = (f->steps[i].volume + f->steps[i].removed_volume) / f->steps[0].volume - 1;
    out.energy = fmax(out.energy, fabs(e));
    out.volume = fmax(out.volume, fabs(v));
  }
  printf("  %3d nodes per H: impact %.4f; vertical tangent %.4f at (%.4f, %.4f); touchdown %.4f at "
         "(%.4f, %.4f)\n      volume %.1e, energy %.1e, removed %.2e of the volume; %.0f CVODE "
         "steps, %.0f "
         "evaluations, %.0f initialisations, %.0f GMRES iterations, at most %.0f nodes, %.1f s\n",
         resolution, out.impact, o.time, o.x, o.y, t.time, t.x, t.y, out.volume, out.energy,
         f->steps[f->n_steps - 1].removed_volume / f->steps[0].volume,
         run_statistic(f, "cvode_steps"), run_statistic(f, "evaluations"),
         run_statistic(f, "initialisations"), run_statistic(f, "gmres_iterations"),
         run_statistic(f, "nodes_most"), progress_wall_clock() - start);
  result_file_destroy(f);
  return out;
}

/* The spread of the three is the error bar that the documentation states. */
static void test_dam_break_converges_to_touchdown(void) {
  const int resolution[3] = {40, 60, 90};
  struct instants all[3];
  for (int i = 0; i < 3; i++) {
    all[i] = dam_break(resolution[i]);
    EXPECT_NEAR(all[i].impact, 2.352, 1e-3);
    EXPECT(all[i].volume < 1e-4);
    EXPECT(all[i].energy < 3e-4);
  }
  for (int i = 0; i < 2; i++) {
    EXPECT_NEAR(all[i].impact, all[2].impact, 5e-4);
    EXPECT_NEAR(all[i].overturn[0], all[2].overturn[0], 5e-3);
    EXPECT_NEAR(all[i].overturn[1], all[2].overturn[1], 5e-3);
    EXPECT_NEAR(all[i].overturn[2], all[2].overturn[2], 6e-3); /* flat in y: measured 5.2e-3 */
    EXPECT_NEAR(all[i].touchdown[0], all[2].touchdown[0], 5e-3);
    EXPECT_NEAR(all[i].touchdown[1], all[2].touchdown[1], 5e-3);
    EXPECT_NEAR(all[i].touchdown[2], all[2].touchdown[2], 5e-3);
  }
}

int main(void) {
  RUN(test_dam_break_converges_to_touchdown);
  return TEST_RESULT;
}
