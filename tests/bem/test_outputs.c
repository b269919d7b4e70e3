/* What is written does not touch the run: the same bits of every event and of every count of work,
 * whatever is asked for, and rows at exactly the times that were asked for. */
#include "bem/run/output.h"
#include "bem/start/start.h"
#include "tests/bem/run.h"

static const char text[] =
    "title: dam break\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 4], [0, 0], [5.366, 0], [5.366, 4]]]}\n"
    "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: released}\n"
    "time: {end: 7, %s}\n"
    "%s"
    "runs: [{name: bem, solver: bem, resolution: %d%s}]\n";

static const char probes[] = "probes: [{name: P1, at: [5.366, 0.266]}, {name: low, at: [1, 0]}]\n"
                             "gauges: [{name: G1, x: 1}, {name: G2, x: 4}]\n"
                             "points: [{name: A, at: [1, 0.5]}, {name: B, at: [4, 0.1]}]\n";

static struct result_file *dam_break(const char *times, const char *series, int resolution,
                                     const char *more) {
  char with[sizeof text + sizeof probes + 120];
  snprintf(with, sizeof with, text, times, series, resolution, more);
  return run_bem(with);
}

static void expect_same_run(const struct result_file *a, const struct result_file *b) {
  static const char *const events[] = {"wall_impact", "overturning", "touchdown"};
  static const char *const counts[] = {"cvode_steps", "evaluations", "matrix_assemblies",
                                       "gmres_iterations", "nodes_last"};
  for (size_t i = 0; i < sizeof events / sizeof *events; i++) {
    struct result_event_read p = run_event(a, events[i]), q = run_event(b, events[i]);
    EXPECT(p.time == q.time && p.x == q.x && p.y == q.y);
  }
  for (size_t i = 0; i < sizeof counts / sizeof *counts; i++)
    EXPECT(run_statistic(a, counts[i]) == run_statistic(b, counts[i]));
}

/* Rows and surfaces of the same instant are the same bits. */
static void expect_same_series(const struct result_file *a, const struct result_file *b) {
  size_t common = 0;
  EXPECT(a->n_points == b->n_points);
  for (size_t i = 0, k = 0; i < a->n_energy && k < b->n_energy;) {
    if (fabs(a->energy[i].time - b->energy[k].time) > 1e-9) {
      a->energy[i].time < b->energy[k].time ? i++ : k++;
      continue;
    }
    EXPECT(!memcmp(&a->energy[i].kinetic, &b->energy[k].kinetic, 5 * sizeof(double)));
    EXPECT(a->energy[i].term[0] == b->energy[k].term[0]);
    EXPECT(a->steps[i].volume == b->steps[k].volume);
    for (size_t p = 0; p < a->n_probes && p < b->n_probes; p++)
      EXPECT(a->probes[p].value[i] == b->probes[p].value[k]);
    for (size_t g = 0; g < a->n_gauges && g < b->n_gauges; g++)
      EXPECT(!memcmp(&a->gauges[g].value[i], &b->gauges[g].value[k],
                     sizeof(double))); /* or NaN: dry */
    for (size_t p = 0; p < a->n_points && p < b->n_points; p++)
      for (int v = 0; v < CASE_POINT_FIELDS; v++)
        EXPECT(!memcmp(&a->points[p].value[v][i], &b->points[p].value[v][k], sizeof(double)));
    common++, i++, k++;
  }
  EXPECT(common > 10);
}

static void expect_rows_at_multiples_of_sample(const struct result_file *f, double every,
                                               double sample) {
  double touchdown = run_event(f, "touchdown").time;
  size_t rows = (size_t)(touchdown / sample) + 1;
  size_t at = 0;
  EXPECT(f->n_energy <= rows && f->n_energy + 3 >= rows); /* none while a gap is nearly closed */
  EXPECT(f->n_steps == f->n_energy && f->probes[0].n == f->n_energy);
  EXPECT(f->n_points == 2 && f->points[1].n == f->n_energy);
  for (size_t i = 0; i < f->n_energy; i++, at++) {
    for (; at < rows && f->energy[i].time > (double)at * sample;) at++;
    const double time = (double)at * sample;
    EXPECT(f->energy[i].time == time && f->steps[i].time == time && f->probes[0].t[i] == time &&
           f->gauges[0].t[i] == time);
  }
  EXPECT(f->n_surfaces == (size_t)(touchdown / every) + 1);
}

/* 12 nodes per H are solved by dense factorisation, 16 by GMRES from the last psi. */
static void test_events_are_the_same_bits_whatever_is_written(void) {
  for (int resolution = 12; resolution <= 16; resolution += 4) {
    struct result_file *plain = dam_break("every: 7, sample: 7", "", resolution, "");
    struct result_file *fine = dam_break("every: 0.5, sample: 0.03", probes, resolution, "");
    if (plain && fine) {
      expect_same_run(plain, fine);
      expect_rows_at_multiples_of_sample(fine, 0.5, 0.03);
    }
    struct result_file *often =
        dam_break("every: 0.511, sample: 0.015", probes, resolution, ", velocity_lattice: 0.05");
    if (plain && often) expect_same_run(plain, often);
    if (fine && often) expect_same_series(fine, often); /* every second row */
    result_file_destroy(often);
    result_file_destroy(plain);
    result_file_destroy(fine);
  }
}

/* The coarser run is another one, whose results are seen in no bit but of the errors. */
static void test_a_run_with_error_bars_is_the_same_bits(void) {
  static const char times[] = "every: 0.5, sample: 0.05";
  struct result_file *plain = dam_break(times, probes, 15, "");
  struct result_file *held = dam_break(times, probes, 15, ", error_bars: true");
  if (plain && held) {
    expect_same_run(plain, held);
    expect_same_series(plain, held);
    EXPECT(plain->n_energy == held->n_energy && plain->n_surfaces == held->n_surfaces);
    EXPECT(!plain->n_energy_errors && held->n_energy_errors == held->n_energy);
  }
  result_file_destroy(plain);
  result_file_destroy(held);
}

static const char standing[] = "title: standing wave\n"
                               "fluid: {density: 1, gravity: 1}\n"
                               "scales: {H: 1}\n"
                               "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"
                               "water: {wave: {kind: standing, amplitude: 0.01, depth: 1, "
                               "wavelength: 4}}\n"
                               "time: {end: 1.5, every: 1, sample: 0.4}\n"
                               "runs: [{name: bem, solver: bem, resolution: 8}]\n";

static void never(void *data, double time, const double *state, double *root) {
  (void)data, (void)time, (void)state;
  *root = 1;
}

/* From t = 1 on, which CVODE knows nothing before. */
static void write_late(const struct case_file *c, struct bem_flow *f, struct bem_output *o) {
  static const struct bem_roots none = {.n = 1, .find = never};
  struct bem_stepper *stepper = NULL;
  const int *found;
  double time = 1, dt;
  EXPECT_OK(bem_start_surface(c, &c->runs[0], NULL, f));
  EXPECT_OK(bem_stepper_create(f, 1e-6, &none, NULL, &stepper));
  EXPECT_OK(bem_stepper_restart(stepper, time));
  EXPECT_OK(bem_output_due(o, f, stepper, 0.9, 0.1));
  EXPECT(o->left_out == 3);
  while (time < c->end) {
    EXPECT_OK(bem_stepper_step(stepper, &time, &dt, &found));
    EXPECT_OK(bem_output_due(o, f, stepper, time, dt));
  }
  EXPECT(o->left_out == 3);
  EXPECT(bem_stepper_count(stepper).initialisations == 1);
  bem_stepper_destroy(stepper);
}

/* A surface and a row of the same instant, and two rows, are missing; what is due later is there.
 */
static void test_what_cannot_be_found_is_left_out_and_nothing_else(void) {
  const char path[] = "/tmp/plunge-left-out.h5";
  struct case_file *c = run_case(standing);
  struct progress *progress = progress_create(PROGRESS_QUIET);
  struct bem_output o = {.c = c, .name = "bem", .progress = progress, .time_scale = 1};
  struct bem_flow f = {0};
  struct result_file *read = NULL;
  const struct bem_solve_options options = {1e-8, 0};
  EXPECT_OK(result_create(path, c, &c->runs[0], &o.file));
  EXPECT_OK(bem_solve_create(&options, &f.solve));
  EXPECT_OK(bem_output_create(&o, &options));
  write_late(c, &f, &o);
  EXPECT_OK(result_finish(o.file));
  EXPECT_OK(result_read(path, &read));
  if (read) {
    EXPECT(read->n_surfaces == 1 && read->surface_time[0] == 1);
    EXPECT(read->n_energy == 1 && read->energy[0].time == 3 * 0.4);
  }
  result_file_destroy(read);
  bem_output_destroy(&o);
  result_destroy(o.file);
  bem_flow_destroy(&f);
  progress_destroy(progress);
  case_destroy(c);
  unlink(path);
  unlink("/tmp/plunge-left-out.xdmf");
}

int main(void) {
  RUN(test_what_cannot_be_found_is_left_out_and_nothing_else);
  RUN(test_events_are_the_same_bits_whatever_is_written);
  RUN(test_a_run_with_error_bars_is_the_same_bits);
  return TEST_RESULT;
}
