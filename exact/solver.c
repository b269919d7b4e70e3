/* What a flow's theory (common/flow/flow.h) says, as a run. Output times and series rows fall on
 * exactly the multiples of time.every and time.sample: there are no steps. */
#include "exact/solver.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/result/record.h"
#include "common/result/result.h"

struct options {
  int order;
};

static const struct param params[] = {
    {.key = "order",
     .type = PARAM_INT,
     .offset = offsetof(struct options, order),
     .min = 1,
     .max = 2,
     .value = "2",
     .help = "order of the theory: 1 linear, 2 with the second harmonic and the frequency of third "
             "order (Tadjbakhsh & Keller, J. Fluid Mech. 8, 1960)"},
};

/* What theory leaves out: beyond MOST_ERROR it means nothing; beyond
 * CLEAR_ERROR the run says so, since no difference from it below that is the other solver's. */
static const double MOST_ERROR = 0.5, CLEAR_ERROR = 0.02;

static double tank_width(const struct case_file *c) {
  return c->tank.max[0] - c->tank.min[0];
}

/* A theory of the case's water. */
struct theory {
  const struct case_file *c;
  const struct flow_theory *flow;
  void *of; /* what the flow's functions take; owned */
  int order;
};

static enum status theory_create(const struct case_file *c, const struct case_run *r,
                                 struct theory *w) {
  const struct options *o = r->options;
  *w = (struct theory){c, c->flow->theory, c->flow->theory->create(c, o->order), o->order};
  CHECK(w->of, ERR_MEMORY, "no memory for the theory of a wave");
  return OK;
}

/* "a standing wave": those that have a theory. */
static void name_waves(size_t n, char out[]) {
  size_t at = (size_t)snprintf(out, n, "a");
  const char *before = " ";
  for (size_t i = 0; i < flow_waves.n && at < n; i++) {
    if (!flow_waves.flow[i]->theory) continue;
    at += (size_t)snprintf(out + at, n - at, "%s%s", before, flow_wave_names[i]);
    before = " or ";
  }
  if (at < n) snprintf(out + at, n - at, " wave");
}

static void check(const struct case_file *c, const struct case_run *r, struct problems *problems) {
  struct theory w;
  if (!c->flow->theory) {
    char waves[256];
    name_waves(sizeof waves, waves);
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' with %s; allowed: %s; give water.wave or take "
                 "another solver",
                 r->name,
                 flow_is_wave(c->flow) ? "a wave that no theory follows" : "regions of water",
                 waves);
    return;
  }
  if (theory_create(c, r, &w) != OK) {
    problems->out_of_memory = true;
    return;
  }
  double error = w.flow->error(w.of, c->end);
  if (error > MOST_ERROR)
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' where what theory leaves out is %.2g of the wave; "
                 "allowed: at most %g; lower water.wave.amplitude or raise water.wave.depth",
                 r->name, error, MOST_ERROR);
  free(w.of);
}

/* An instant of the theory. */
struct moment {
  const struct theory *w;
  double t; /* s */
};

static enum status pressure_of(void *solver, const struct case_probe *probe, double *pressure) {
  const struct moment *m = solver;
  const struct theory *w = m->w;
  double p[RECORD_PARTS][2], sum = 0;
  size_t parts = record_sensor(w->c, probe, p);
  for (size_t i = 0; i < parts; i++) sum += w->flow->pressure(w->of, p[i][0], p[i][1], m->t);
  *pressure = w->c->density * sum / (double)parts;
  return OK;
}

static enum status elevation_of(void *solver, const struct case_gauge *gauge, double *elevation) {
  const struct moment *m = solver;
  *elevation = m->w->flow->elevation(m->w->of, gauge->x, m->t);
  return OK;
}

static enum status write_series(const struct theory *w, double t, size_t row, double start,
                                struct result *out) {
  const struct case_file *c = w->c;
  double kinetic = c->density * w->flow->kinetic(w->of, t);
  double potential = c->density * w->flow->potential_energy(w->of, t);
  struct moment moment = {w, t};
  struct record r = {.energy = {.time = t,
                                .kinetic = kinetic,
                                .potential = potential,
                                .total = kinetic + potential},
                     .step = {.time = t,
                              .dt = c->sample,
                              .evaluations = (double)row,
                              .wall_time = progress_wall_clock() - start,
                              .volume = case_water_area(c)},
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

static enum status write_output(const struct theory *w, double t, struct surface_points *s,
                                struct result *out) {
  const struct geo_box *tank = &w->c->tank;
  geo_lines_clear(&s->line);
  TRY(geo_lines_begin(&s->line, false));
  for (size_t i = 0; i < s->n; i++) {
    double f = (double)i / (double)(s->n - 1), velocity[2];
    s->x[i] = tank->min[0] * (1 - f) + tank->max[0] * f;
    s->y[i] = w->flow->elevation(w->of, s->x[i], t);
    s->phi[i] = w->flow->potential(w->of, s->x[i], s->y[i], t);
    w->flow->velocity(w->of, s->x[i], s->y[i], t, velocity);
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

static enum status write_error(const struct theory *w, struct result *out,
                               struct progress *progress) {
  double error = w->flow->error(w->of, w->c->end);
  if (error > CLEAR_ERROR)
    progress_say(progress,
                 "exact: this wave is steep for a theory of order %d: what it leaves out is about "
                 "%.2g %% of the wave (of its energy up to time.end, or of its elevation)",
                 w->order, 100 * error);
  return result_statistic(out, "theory_error", error, "1",
                          "estimate of what the theory leaves out, relative to the wave: its error "
                          "of energy up to the end, or the next term of its series");
}

static enum status run(const struct case_file *c, const struct case_run *r, struct result *out,
                       struct progress *progress) {
  enum status status = OK;
  struct surface_points points = {0};
  struct theory w = {0};
  const double slack = 1e-9 * c->sample, start = progress_wall_clock();
  ATTEMPT(theory_create(c, r, &w));
  ATTEMPT(points_create(&points, c, r->resolution));
  ATTEMPT(write_error(&w, out, progress));
  for (size_t row = 0, outputs = 0; (double)row * c->sample <= c->end + slack; row++) {
    double t = (double)row * c->sample;
    ATTEMPT(write_series(&w, t, row, start, out));
    for (; (double)outputs * c->every < t + c->sample - slack; outputs++) {
      double at = (double)outputs * c->every;
      if (at > c->end + slack) break;
      ATTEMPT(write_output(&w, at, &points, out));
    }
    progress_step(progress, row, t, c->sample, (double)(row * points.n), "point", 0);
    if (progress_stop_requested()) {
      status = status_raise(INTERRUPTED, "stopped at t = %g s", t);
      goto done;
    }
  }
done:
  points_destroy(&points);
  free(w.of);
  return status;
}

/* Measured on the standing wave of cases/, 17 to 16,000 points: 3 microseconds a point and output,
 * 0.8 ms a sample, 3 kB a point. */
static void estimate(const struct case_file *c, const struct case_run *r,
                     struct solver_estimate *e) {
  e->points = ceil(r->resolution * tank_width(c) / c->H);
  e->unit = "points";
  e->bytes = 30e6 + 3000 * e->points;
  e->seconds = c->end / c->every * e->points * 3e-6 + c->end / c->sample * 0.8e-3;
}

const struct solver exact_solver = {
    .name = "exact",
    .help = "wave theory: standing waves in a rectangular tank, to second order",
    .params = params,
    .n_params = sizeof params / sizeof *params,
    .options_size = sizeof(struct options),
    .check = check,
    .estimate = estimate,
    .run = run,
};
