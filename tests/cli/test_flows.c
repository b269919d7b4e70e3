/* Every solver that takes an initial state starts from the same water. */
#include <stdlib.h>
#include <unistd.h>

#include "cli/registry.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/result/result.h"
#include "tests/test.h"

/* A run of the flow's example; NULL when the solver refuses it. */
static struct case_file *case_of(const struct flow *f, const char *solver) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  char text[2000];
  snprintf(text, sizeof text,
           "%stank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]], sides: %s}\n"
           "water: {%s}\ntime: {end: 0.1, every: 0.1}\nruns: [{solver: %s, resolution: 20}]\n",
           flow_is_body(f) ? "fluid: {gravity: 0}\nscales: {H: 1, g: 1}\n" : "scales: {H: 1}\n",
           f->round ? "periodic" : "walls", f->example, solver);
  if (case_parse("flow", text, &registry, &problems, &c) != OK)
    for (size_t i = 0; i < problems.n; i++)
      EXPECT(strstr(problems.text[i], "another solver")); /* nothing else is wrong with it */
  problems_destroy(&problems);
  return c;
}

static struct result_file *run(const struct case_file *c) {
  char path[] = "/tmp/plunge-flow-XXXXXX.h5", xdmf[sizeof path + 2];
  int handle = mkstemps(path, 3);
  struct result *out = NULL;
  struct result_file *f = NULL;
  struct progress *progress = progress_create(PROGRESS_QUIET);
  progress_begin(progress, "test", c->end, 1);
  EXPECT_OK(result_create(path, c, &c->runs[0], &out));
  EXPECT_OK(c->runs[0].solver->run(c, &c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  EXPECT_OK(result_read(path, &f));
  progress_destroy(progress);
  close(handle);
  unlink(path);
  snprintf(xdmf, sizeof xdmf, "%.*s.xdmf", (int)strlen(path) - 3, path);
  unlink(xdmf);
  return f;
}

/* Potential energy over rho g of the case's outline, m^3. */
static double moment_of(const struct geo_lines *l) {
  double moment = 0;
  for (size_t k = 0; k < l->pieces; k++)
    for (size_t i = l->first[k]; i < l->first[k + 1]; i++) {
      const double *p = l->p[i], *q = l->p[i + 1 < l->first[k + 1] ? i + 1 : l->first[k]];
      moment += (p[0] * q[1] - q[0] * p[1]) * (p[1] + q[1]) / 6;
    }
  return moment;
}

/* Columns of the particles' width integrate a wave's elevation by the midpoint rule, which misses
 * width dx^2/24 times the curvature, at most twice a cosine's; regions are divided exactly. Water
 * that SPH compresses by its weight has up to g top/c0^2, c0 = 20 sqrt(gH), more mass. Small waves
 * that move a lattice change densities by less than 1e-3, to second order on the whole. */
static void expect_same_start(const struct case_file *c, const struct result_file *f) {
  double area = case_water_area(c), dx = c->H / c->runs[0].resolution, missed = 0;
  double potential = c->density * c->gravity * moment_of(&c->water), lumped = 0;
  if (flow_is_wave(c->flow)) {
    struct flow_scale s = c->flow->scale(c);
    double curvature = 2 * s.amplitude * pow(2 * M_PI / s.length, 2);
    missed = (c->tank.max[0] - c->tank.min[0]) * dx * dx / 24 * curvature;
  }
  if (!c->flow->scale && !strcmp(f->solver, "bem")) /* kinks are arcs of 0.02 H there */
    missed = (double)c->water.points * pow(0.02 * c->H, 2);
  if (c->flow->start) missed = 1e-6 * area;
  if (c->flow->pull) { /* a cell's own second moment, dx^4/6, is not in its middle's; the disc's is
                          area^2/(2 pi) */
    potential = case_rest_potential(c);
    lumped = potential * pow(dx, 2) / 6 * 2 * M_PI / area;
  }
  EXPECT(f->n_steps > 1 && f->n_energy > 1 && f->steps[0].time == 0 && f->energy[0].time == 0);
  printf("     %-12s %-6s volume, potential energy off by %.1e, %.1e of it\n", flow_name(c->flow),
         f->solver, f->steps[0].volume / area - 1, f->energy[0].potential / potential - 1);
  EXPECT_NEAR(f->steps[0].volume, area, missed + 1e-12 * area);
  EXPECT_NEAR(f->energy[0].potential, potential,
              potential * geo_lines_box(&c->water).max[1] / c->H / 400 + lumped);
}

static int run_flow(const struct flow *f) {
  int taken = 0;
  for (size_t s = 0; s < registry.n_solvers; s++) {
    struct case_file *c = case_of(f, registry.solvers[s]->name);
    if (!c) continue;
    struct result_file *r = run(c);
    if (r) expect_same_start(c, r);
    result_file_destroy(r);
    case_destroy(c);
    taken++;
  }
  return taken;
}

static void test_every_flow_runs_in_the_solvers_that_take_it(void) {
  for (size_t i = 0; i < flow_regions.n; i++) EXPECT(run_flow(flow_regions.flow[i]) >= 1);
  for (size_t i = 0; i < flow_waves.n; i++)
    EXPECT(run_flow(flow_waves.flow[i]) >= (flow_waves.flow[i]->sounds ? 1 : 2));
  for (size_t i = 0; i < flow_bodies.n; i++)
    EXPECT(run_flow(flow_bodies.flow[i]) >= 1 + flow_has_theory(flow_bodies.flow[i]));
}

/* Water that moves below a surface that hangs over, between two walls. */
static void write_curve(const double end[2]) {
  FILE *out = fopen("flows-curve.csv", "w");
  EXPECT(out != NULL);
  for (int i = 0; out && i <= 200; i++) {
    const double s = i / 200.0, x = s * end[0] + 0.22 * sin(4 * M_PI * s);
    const double y = 0.5 + s * (end[1] - 0.5) + 0.12 * sin(4 * M_PI * s);
    fprintf(out, "%.17g, %.17g, %.17g\n", x, y, 0.3 * cos(M_PI * x / end[0]) * cosh(y));
  }
  EXPECT(out && fclose(out) == 0);
}

static struct result_file *run_curve(const char *walls, const char *solver) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  FILE *out = fopen("flows-curve.yaml", "w");
  EXPECT(out != NULL);
  if (!out) return NULL;
  fprintf(out,
          "scales: {H: 0.5}\ntank: {walls: [[%s]]}\n"
          "water: {wave: {kind: curve, depth: 0.5, file: flows-curve.csv}}\n"
          "time: {end: 0.001, every: 0.001}\nruns: [{solver: %s, resolution: 40}]\n",
          walls, solver);
  EXPECT(fclose(out) == 0);
  if (case_load("flows-curve.yaml", 0, NULL, &registry, &problems, &c) != OK)
    TEST_FAIL("%s", problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  remove("flows-curve.yaml");
  struct result_file *f = c ? run(c) : NULL;
  case_destroy(c);
  return f;
}

/* The mass of particles is that of compressed water, see above; what the middles of cells miss of
 * a square of the velocity u is of the order (dx grad u)^2/6, here 1e-3 of it. */
static void test_water_below_a_curve_has_the_same_energy_in_all_solvers(void) {
  static const char *const walls[] = {"[0, 1], [0, 0], [2, 0], [2, 1]",
                                      "[0, 1], [0, 0], [1.4, 0], [2.6, 1.2]"};
  static const double end[][2] = {{2, 0.5}, {2, 0.6}};
  for (int i = 0; i < 2; i++) {
    write_curve(end[i]);
    struct result_file *bem = run_curve(walls[i], "bem"), *sph = run_curve(walls[i], "sph");
    if (bem && sph) {
      const double kinetic = sph->energy[0].kinetic / bem->energy[0].kinetic - 1,
                   potential = sph->energy[0].potential / bem->energy[0].potential - 1;
      printf("     kinetic, potential energy of SPH over those of BEM: %+.1e, %+.1e\n", kinetic,
             potential);
      EXPECT_NEAR(kinetic, 0, 1.3 / 400);
      EXPECT_NEAR(potential, 0, 1.3 / 400);
    }
    result_file_destroy(bem);
    result_file_destroy(sph);
  }
  remove("flows-curve.csv");
}

int main(void) {
  RUN(test_every_flow_runs_in_the_solvers_that_take_it);
  RUN(test_water_below_a_curve_has_the_same_energy_in_all_solvers);
  return TEST_RESULT;
}
