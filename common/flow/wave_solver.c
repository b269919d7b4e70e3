/* Standing waves by theory (common/flow/waves.h) as a run. Output times and series rows fall on
 * exactly the multiples of time.every and time.sample: there are no steps. */
#include "common/flow/wave_solver.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/waves.h"
#include "common/result/record.h"
#include "common/result/result.h"

struct wave_options {
  int order;
};

static const struct param wave_params[] = {
    {.key = "order",
     .type = PARAM_INT,
     .offset = offsetof(struct wave_options, order),
     .min = 1,
     .max = 2,
     .value = "2",
     .help = "order of the theory: 1 linear, 2 with the second harmonic and the frequency of third "
             "order (Tadjbakhsh & Keller, J. Fluid Mech. 8, 1960)"},
};

/* What a series of two terms leaves out (waves.h): beyond MOST_ERROR it means nothing; beyond
 * CLEAR_ERROR the run says so, since no difference from it below that is the other solver's. */
static const double MOST_ERROR = 0.5, CLEAR_ERROR = 0.02;

static double tank_width(const struct case_file *c) {
  return c->tank.max[0] - c->tank.min[0];
}

static struct wave_standing theory(const struct case_file *c, const struct case_run *r) {
  const struct wave_options *o = r->options;
  return wave_standing_create(c->wave.amplitude, c->wave.wavelength, c->wave.depth, c->gravity,
                              c->tank.min[0], c->tank.min[1], o->order);
}

static void wave_check(const struct case_file *c, const struct case_run *r,
                       struct problems *problems) {
  if (c->wave.kind != CASE_WAVE_STANDING) {
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' with regions of water; allowed: a standing wave; "
                 "give water.wave or take another solver",
                 r->name);
    return;
  }
  struct wave_standing w = theory(c, r);
  double error = wave_standing_error(&w, c->end);
  if (error > MOST_ERROR)
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' where what theory leaves out is %.2g of the wave; "
                 "allowed: at most %g; lower water.wave.amplitude or raise water.wave.depth",
                 r->name, error, MOST_ERROR);
}

/* An instant of the theory. */
struct moment {
  const struct case_file *c;
  const struct wave_standing *w;
  double t; /* s */
};

static enum status pressure_of(void *solver, const struct case_probe *probe, double *pressure) {
  const struct moment *m = solver;
  double p[RECORD_PARTS][2], sum = 0;
  size_t parts = record_sensor(m->c, probe, p);
  for (size_t i = 0; i < parts; i++) sum += wave_standing_pressure(m->w, p[i][0], p[i][1], m->t);
  *pressure = m->c->density * sum / (double)parts;
  return OK;
}

static enum status elevation_of(void *solver, double x, double *elevation) {
  const struct moment *m = solver;
  *elevation = wave_standing_elevation(m->w, x, m->t);
  return OK;
}

static enum status write_series(const struct case_file *c, const struct wave_standing *w, double t,
                                size_t row, double start, struct result *out) {
  double width = tank_width(c);
  double kinetic = c->density * wave_standing_kinetic(w, width, t);
  double potential = c->density * wave_standing_potential_energy(w, width, t);
  struct moment moment = {c, w, t};
  struct record r = {.energy = {.time = t,
                                .kinetic = kinetic,
                                .potential = potential,
                                .total = kinetic + potential},
                     .step = {.time = t,
                              .dt = c->sample,
                              .evaluations = (double)row,
                              .wall_time = progress_wall_clock() - start,
                              .volume = width * c->wave.depth},
                     .solver = &moment,
                     .pressure = pressure_of,
                     .elevation = elevation_of};
  return record_row(out, c, &r);
}

struct surface_points {
  size_t n;
  double *x, *y, *phi, *u, *v; /* m, m^2/s, m/s, [n], owned */
  struct geo_lines line;
};

static void points_destroy(struct surface_points *s) {
  free(s->x);
  geo_lines_destroy(&s->line);
}

static enum status points_create(struct surface_points *s, const struct case_file *c,
                                 double resolution) {
  s->n = (size_t)ceil(tank_width(c) / c->H * resolution) + 1;
  double *all = malloc(5 * s->n * sizeof *all);
  CHECK(all, ERR_MEMORY, "no memory for %zu surface points", s->n);
  s->x = all;
  s->y = all + s->n;
  s->phi = all + 2 * s->n;
  s->u = all + 3 * s->n;
  s->v = all + 4 * s->n;
  return OK;
}

static enum status write_output(const struct case_file *c, const struct wave_standing *w, double t,
                                struct surface_points *s, struct result *out) {
  geo_lines_clear(&s->line);
  TRY(geo_lines_begin(&s->line, false));
  for (size_t i = 0; i < s->n; i++) {
    double f = (double)i / (double)(s->n - 1), velocity[2];
    s->x[i] = c->tank.min[0] * (1 - f) + c->tank.max[0] * f;
    s->y[i] = wave_standing_elevation(w, s->x[i], t);
    s->phi[i] = wave_standing_potential(w, s->x[i], s->y[i], t);
    wave_standing_velocity(w, s->x[i], s->y[i], t, velocity);
    s->u[i] = velocity[0];
    s->v[i] = velocity[1];
    TRY(geo_lines_add(&s->line, s->x[i], s->y[i]));
  }
  const struct result_field fields[] = {
      {"velocity", "m/s", "velocity of the water", s->u, s->v},
      {"potential", "m^2/s", "velocity potential", s->phi, NULL},
  };
  TRY(result_points(out, t, s->n, s->x, s->y, RESULT_LINE, sizeof fields / sizeof *fields, fields));
  TRY(result_surface(out, t, &s->line));
  return result_flush(out);
}

static enum status write_error(const struct case_file *c, const struct wave_standing *w,
                               struct result *out, struct progress *progress) {
  double error = wave_standing_error(w, c->end);
  if (error > CLEAR_ERROR)
    progress_say(progress,
                 "exact: this wave is steep for a theory of order %d: what it leaves out is about "
                 "%.2g %% of the wave (of its energy up to time.end, or of its elevation)",
                 w->order, 100 * error);
  return result_statistic(out, "theory_error", error, "1",
                          "estimate of what the theory leaves out, relative to the wave: its error "
                          "of energy up to the end, or the next term of its series");
}

static enum status wave_run(const struct case_file *c, const struct case_run *r, struct result *out,
                            struct progress *progress) {
  enum status status = OK;
  struct surface_points points = {0};
  struct wave_standing w = theory(c, r);
  const double slack = 1e-9 * c->sample, start = progress_wall_clock();
  ATTEMPT(points_create(&points, c, r->resolution));
  ATTEMPT(write_error(c, &w, out, progress));
  for (size_t row = 0, outputs = 0; (double)row * c->sample <= c->end + slack; row++) {
    double t = (double)row * c->sample;
    ATTEMPT(write_series(c, &w, t, row, start, out));
    for (; (double)outputs * c->every < t + c->sample - slack; outputs++) {
      double at = (double)outputs * c->every;
      if (at > c->end + slack) break;
      ATTEMPT(write_output(c, &w, at, &points, out));
    }
    progress_step(progress, row, t, c->sample, (double)(row * points.n), "point", 0);
    if (progress_stop_requested()) {
      status = status_raise(INTERRUPTED, "stopped at t = %g s", t);
      goto done;
    }
  }
done:
  points_destroy(&points);
  return status;
}

/* Measured on the standing wave of cases/, 17 to 16,000 points: 3 microseconds a point and output,
 * 0.8 ms a sample, 3 kB a point. */
static void wave_estimate(const struct case_file *c, const struct case_run *r,
                          struct solver_estimate *e) {
  e->points = ceil(r->resolution * tank_width(c) / c->H);
  e->unit = "points";
  e->bytes = 30e6 + 3000 * e->points;
  e->seconds = c->end / c->every * e->points * 3e-6 + c->end / c->sample * 0.8e-3;
}

const struct solver wave_solver = {
    .name = "exact",
    .help = "wave theory: standing waves in a rectangular tank, to second order",
    .params = wave_params,
    .n_params = sizeof wave_params / sizeof *wave_params,
    .options_size = sizeof(struct wave_options),
    .check = wave_check,
    .estimate = wave_estimate,
    .run = wave_run,
};
