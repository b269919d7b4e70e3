/* The dam break of Buchner's tank (column 2H by H, tank 5.366H), from release to the touchdown of
 * the backward plunging jet, in units H = g = 1. Cuts of the film on the wall happen at a step, so
 * the last bits decide what the film does from then on: each resolution is run from columns whose
 * heights differ by 1e-10, as if on several processors, and all of them must lie within the error
 * bars that docs/accuracy.md states. */
#include "tests/bem/run.h"

static const char text[] =
    "title: dam break\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 4], [0, 0], [5.366, 0], [5.366, 4]]]}\n"
    "water: {regions: [[[0, 0], [2, 0], [2, %.12f], [0, %.12f]]], pressure: released}\n"
    "time: {end: 6.5, every: 0.5, sample: 0.02}\n"
    "probes: [{name: P1, at: [5.366, 0.266]}]\n"
    "runs: [{name: bem, solver: bem, resolution: %d, film: %g}]\n";

struct instants {
  double impact, overturn[3], touchdown[3]; /* t, x, y */
  double volume, energy;                    /* largest relative error with what was removed */
  double cut;                               /* of the energy that was there first */
};

static struct instants dam_break(int resolution, double film, int member) {
  char with[sizeof text + 60];
  double height = 1 + 1e-10 * member;
  snprintf(with, sizeof with, text, height, height, resolution, film);
  struct instants out = {0};
  double start = progress_wall_clock();
  struct result_file *f = run_bem(with);
  if (!f) return out;
  struct result_event_read o = run_event(f, "overturning"), t = run_event(f, "touchdown");
  out = (struct instants){.impact = run_event(f, "wall_impact").time,
                          .overturn = {o.time, o.x, o.y},
                          .touchdown = {t.time, t.x, t.y}};
  for (size_t i = 0; i < f->n_energy; i++) {
    double e = result_energy_budget(&f->energy[i]) / f->energy[0].total - 1;
    double v = (f->steps[i].volume + f->steps[i].removed_volume) / f->steps[0].volume - 1;
    out.energy = fmax(out.energy, fabs(e));
    out.volume = fmax(out.volume, fabs(v));
  }
  out.cut = f->energy[f->n_energy - 1].removed / f->energy[0].total;
  printf("  %3d nodes per H: impact %.4f; vertical tangent %.4f at (%.4f, %.4f); touchdown %.4f at "
         "(%.4f, %.4f)\n      volume %.1e, energy %.1e, removed %.2e of the volume, %.2e of the "
         "energy; %.0f CVODE "
         "steps, %.0f "
         "evaluations, %.0f initialisations, %.0f GMRES iterations, at most %.0f nodes, %.1f s\n",
         resolution, out.impact, o.time, o.x, o.y, t.time, t.x, t.y, out.volume, out.energy,
         f->steps[f->n_steps - 1].removed_volume / f->steps[0].volume, out.cut,
         run_statistic(f, "cvode_steps"), run_statistic(f, "evaluations"),
         run_statistic(f, "initialisations"), run_statistic(f, "gmres_iterations"),
         run_statistic(f, "nodes_most"), progress_wall_clock() - start);
  result_file_destroy(f);
  return out;
}

/* Error bars of docs/accuracy.md: four standard deviations of 23 members at 40 nodes per H, built
 * in four ways, so that none of the five here leaves them by chance more often than once in a few
 * thousand runs; of the tangent, of nine. */
static void expect_within_error_bars(const struct instants *i) {
  EXPECT_NEAR(i->impact, 2.3520, 3e-4);
  EXPECT_NEAR(i->overturn[0], 3.4305, 0.005);
  EXPECT_NEAR(i->overturn[1], 5.2615, 0.0008);
  EXPECT_NEAR(i->overturn[2], 0.425, 0.012);
  EXPECT_NEAR(i->touchdown[0], 6.1095, 0.002);
  EXPECT_NEAR(i->touchdown[1], 4.195, 0.006);
  EXPECT_NEAR(i->touchdown[2], 0.2242, 4e-4);
}

static void test_dam_break_converges_to_touchdown_from_every_perturbed_start(void) {
  static const struct {
    int resolution, members;
    double film;           /* H */
    double volume, energy; /* largest errors: half as much again as any of the study */
    double cut;            /* of the energy; what is asked of the finest */
  } all[] = {{40, 3, 0.005, 8e-5, 3e-4, 0.03}, {60, 2, 0.002, 1.5e-5, 4e-5, 0.007}};
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    for (int member = 0; member < all[i].members; member++) {
      struct instants now = dam_break(all[i].resolution, all[i].film, member);
      expect_within_error_bars(&now);
      EXPECT(now.volume < all[i].volume);
      EXPECT(now.energy < all[i].energy);
      EXPECT(now.cut < all[i].cut);
    }
}

int main(void) {
  RUN(test_dam_break_converges_to_touchdown_from_every_perturbed_start);
  return TEST_RESULT;
}
