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

/* What theory leaves out: beyond MOST_ERROR it means nothing; beyond CLEAR_ERROR the run says so,
 * since no difference from it below that is the other solver's. */
static const double MOST_ERROR = 0.5, CLEAR_ERROR = 0.02;

static double tank_width(const struct case_file *c) {
  return c->tank.max[0] - c->tank.min[0];
}

static enum status open_theory(const struct case_file *c, const struct case_run *r,
                               struct flow_water *w) {
  const struct options *o = r->options;
  return flow_open(c, (struct flow_use){.order = o->order}, w);
}

/* " standing or airy": those of a list that have a theory. */
static void name_known(const struct flow_list *l, size_t n, char out[]) {
  size_t at = 0;
  for (size_t i = 0; i < l->n && at < n; i++)
    if (flow_has_theory(l->flow[i]))
      at += (size_t)snprintf(out + at, n - at, "%s%s", at ? " or " : " ", flow_name(l->flow[i]));
}

static const char *unknown_water(const struct flow *f) {
  return flow_is_wave(f)   ? "a wave that no theory follows"
         : flow_is_body(f) ? "a body that no theory follows"
                           : "regions of water";
}

static void check(const struct case_file *c, const struct case_run *r, struct problems *problems) {
  struct flow_water w;
  case_refuse_motions(c, r, problems);
  if (!flow_has_theory(c->flow)) {
    char waves[128], bodies[128];
    name_known(&flow_waves, sizeof waves, waves);
    name_known(&flow_bodies, sizeof bodies, bodies);
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' with %s; allowed: a%s wave, or a%s; give "
                 "water.wave or water.body, or take another solver",
                 r->name, unknown_water(c->flow), waves, bodies);
    return;
  }
  if (!c->rectangular) {
    problems_add(
        problems, case_run_line(r, "solver"),
        "runs.%s.solver: found 'exact' in a tank that is not rectangular; allowed: upright "
        "sides on a flat bed, where theory has these waves; take another solver",
        r->name);
    return;
  }
  double error = NAN;
  if (open_theory(c, r, &w) == OK)
    error = c->flow->error(&w, c->end);
  else
    problems->out_of_memory = true;
  if (error > MOST_ERROR)
    problems_add(problems, case_run_line(r, "solver"),
                 "runs.%s.solver: found 'exact' where what theory leaves out is %.2g of the wave; "
                 "allowed: at most %g; lower water.wave.amplitude or raise water.wave.depth",
                 r->name, error, MOST_ERROR);
  flow_close(&w);
}

/* An instant of the theory. */
struct moment {
  const struct flow_water *w;
  double t; /* s */
};

static enum status pressure_of(void *solver, const struct case_probe *probe, double *pressure) {
  const struct moment *m = solver;
  const struct flow_water *w = m->w;
  double p[RECORD_PARTS][2], sum = 0;
  size_t parts = record_sensor(w->c, probe, p);
  for (size_t i = 0; i < parts; i++) sum += w->c->flow->pressure(w, p[i][0], p[i][1], m->t);
  *pressure = w->c->density * sum / (double)parts;
  return OK;
}

static enum status elevation_of(void *solver, const struct case_gauge *gauge, double *elevation) {
  const struct moment *m = solver;
  const bool stands = flow_is_wave(m->w->c->flow);
  *elevation = stands ? flow_elevation(m->w, gauge->x, m->t) : NAN; /* a body is above the bed */
  return OK;
}

static enum status write_series(const struct flow_water *w, double t, size_t row, double start,
                                struct result *out) {
  const struct case_file *c = w->c;
  double kinetic = c->density * c->flow->kinetic(w, t);
  double potential = c->density * c->flow->potential_energy(w, t);
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

/* Of the surface at t = 0, m: from wall to wall, or round a body. */
static double length_of(const struct case_file *c) {
  return flow_is_wave(c->flow) ? tank_width(c) : geo_piece_length(&c->water, 0);
}

/* The first of n points is at the left wall, the last at the right one. */
static void place_on_surface(const struct flow_water *w, size_t i, size_t n, double t,
                             double p[2]) {
  const struct geo_box *tank = &w->c->tank;
  if (flow_is_body(w->c->flow)) {
    w->c->flow->rim(w, (double)i / (double)n, t, p);
    return;
  }
  double f = (double)i / (double)(n - 1);
  p[0] = tank->min[0] * (1 - f) + tank->max[0] * f;
  p[1] = flow_elevation(w, p[0], t);
}

static enum status points_create(struct surface_points *s, const struct case_file *c,
                                 double resolution) {
  s->n = (size_t)ceil(length_of(c) / c->H * resolution) + flow_is_wave(c->flow);
  double *all = malloc(5 * s->n * sizeof *all);
  CHECK(all, ERR_MEMORY, "no memory for %zu surface points", s->n);
  s->x = all;
  s->y = all + s->n;
  s->phi = all + 2 * s->n;
  s->u = all + 3 * s->n;
  s->v = all + 4 * s->n;
  return OK;
}

static enum status write_output(const struct flow_water *w, double t, struct surface_points *s,
                                struct result *out) {
  geo_lines_clear(&s->line);
  TRY(geo_lines_begin(&s->line, flow_is_body(w->c->flow)));
  for (size_t i = 0; i < s->n; i++) {
    double at[2], velocity[2];
    place_on_surface(w, i, s->n, t, at);
    s->x[i] = at[0];
    s->y[i] = at[1];
    s->phi[i] = flow_potential(w, s->x[i], s->y[i], t);
    flow_velocity(w, s->x[i], s->y[i], t, velocity);
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

static enum status write_error(const struct flow_water *w, struct result *out,
                               struct progress *progress) {
  double error = w->c->flow->error(w, w->c->end);
  if (error > CLEAR_ERROR)
    progress_say(progress,
                 "exact: this wave is steep for a theory of order %d: what it leaves out is about "
                 "%.2g %% of the wave (of its energy up to time.end, or of its elevation)",
                 w->use.order, 100 * error);
  return result_statistic(out, "theory_error", error, "1",
                          "estimate of what the theory leaves out, relative to the wave: its error "
                          "of energy up to the end, or the next term of its series");
}

static enum status run(const struct case_file *c, const struct case_run *r, struct result *out,
                       struct progress *progress) {
  enum status status = OK;
  struct surface_points points = {0};
  struct flow_water w = {0};
  const double slack = 1e-9 * c->sample, start = progress_wall_clock();
  ATTEMPT(open_theory(c, r, &w));
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
  flow_close(&w);
  return status;
}

/* Measured on the standing wave of cases/, 17 to 16,000 points: 3 microseconds a point and output,
 * 0.8 ms a sample, 3 kB a point. */
static void estimate(const struct case_file *c, const struct case_run *r,
                     struct solver_estimate *e) {
  e->points = ceil(r->resolution * length_of(c) / c->H);
  e->unit = "points";
  e->bytes = 30e6 + 3000 * e->points;
  e->seconds = c->end / c->every * e->points * 3e-6 + c->end / c->sample * 0.8e-3;
}

const struct solver exact_solver = {
    .name = "exact",
    .help = "theory, where it knows how a wave or a body of water goes on",
    .params = params,
    .n_params = sizeof params / sizeof *params,
    .options_size = sizeof(struct options),
    .check = check,
    .estimate = estimate,
    .run = run,
};
