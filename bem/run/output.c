#include "bem/run/output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/breaking/breaker.h"
#include "bem/start/mirror.h"
#include "bem/water/forces.h"
#include "common/base/array.h"
#include "common/base/gauge.h"
#include "common/result/record.h"
#include "common/tank/motion.h"
#include "common/tank/tank.h"

/* H: with a gap no wider than the panels' own curvature psi is wrong; 0.002 sqrt(H/g) remain then
 */
static const double CLOSEST = 0.003;
static const double NEAR = 1e-9; /* of an interval: times that count as equal */

enum status bem_output_create(struct bem_output *o, const struct bem_solve_options *options) {
  o->budget.first_energy = NAN;
  return bem_view_create(&o->view, options);
}

void bem_output_destroy(struct bem_output *o) {
  bem_view_destroy(&o->view);
  bem_sides_destroy(&o->sides);
  geo_lines_destroy(&o->line);
  bem_lattice_destroy(&o->lattice);
  free(o->field);
}

static enum status reserve(struct bem_output *o, size_t n) {
  if (n <= o->room) return OK;
  TRY(array_resize(&o->field, BEM_OUTPUT_FIELDS * n, "numbers of an output"));
  o->room = n;
  return OK;
}

void bem_output_place(const struct bem_output *o, double x, double y, double at[2]) {
  at[0] = o->c->tank.min[0] + o->c->H * x;
  at[1] = o->c->tank.min[1] + o->c->H * y;
  if (o->mirrored) at[0] = bem_mirror_x(o->c, at[0]);
}

const char *bem_output_side(const struct bem_output *o, bool right) {
  return right == o->mirrored ? "left" : "right";
}

/* The surface of water without sides in SI units, cut where it goes through the tank's. */
static enum status period_line(struct bem_output *o) {
  const struct case_file *c = o->c;
  const struct bem_surface *s = &o->view.flow.surface;
  TRY(bem_period_cut(s, s->state, &o->line));
  for (size_t i = 0; i < o->line.points; i++)
    for (int axis = 0; axis < 2; axis++)
      o->line.p[i][axis] = c->tank.min[axis] + c->H * o->line.p[i][axis];
  return OK;
}

/* The surface in SI units, without the part that has run through the right wall before it is cut.
 */
static enum status polyline(struct bem_output *o) {
  const struct case_file *c = o->c;
  const struct bem_surface *s = &o->view.flow.surface;
  const double *x = s->state, *y = x + s->n;
  geo_lines_clear(&o->line);
  if (bem_surface_is_closed(s)) return period_line(o);
  TRY(geo_lines_begin(&o->line, false));
  for (size_t k = 0; k < s->n; k++) {
    double px = x[k], py = y[k];
    bool beyond = !s->walls && px > s->tank;
    if (beyond && k > 0) {
      double a = (s->tank - x[k - 1]) / (x[k] - x[k - 1]);
      px = s->tank;
      py = y[k - 1] + a * (y[k] - y[k - 1]);
    }
    TRY(geo_lines_add(&o->line, c->tank.min[0] + c->H * px, c->tank.min[1] + c->H * py));
    if (beyond) break;
  }
  return OK;
}

/* What is seen in the mirror as the case has it, from left to right. */
static void turn_line(const struct case_file *c, struct geo_lines *l) {
  for (size_t i = 0, k = l->points; i < k--; i++) {
    const double a[2] = {bem_mirror_x(c, l->p[i][0]), l->p[i][1]},
                 b[2] = {bem_mirror_x(c, l->p[k][0]), l->p[k][1]};
    memcpy(l->p[i], b, sizeof b);
    memcpy(l->p[k], a, sizeof a);
  }
}

/* What is written of points, in SI units. */
struct shown {
  double *x, *y, *phi, *u, *v, *pressure, *volume;
};

static enum status show_begin(struct bem_output *o, size_t n, struct shown *to) {
  TRY(reserve(o, n));
  double *p = o->field;
  *to = (struct shown){p, p + n, p + 2 * n, p + 3 * n, p + 4 * n, p + 5 * n, p + 6 * n};
  return OK;
}

/* Point i: where it is, H, and its potential and velocity, H sqrt(gH) and sqrt(gH). */
static void show(const struct bem_output *o, const struct shown *to, size_t i, const double z[2],
                 double phi, const double w[2]) {
  const double velocity = sqrt(o->c->gravity * o->c->H);
  double at[2];
  bem_output_place(o, z[0], z[1], at);
  to->x[i] = at[0];
  to->y[i] = at[1];
  to->phi[i] = o->c->H * velocity * phi;
  to->u[i] = o->mirrored ? -velocity * w[0] : velocity * w[0];
  to->v[i] = velocity * w[1];
}

static enum status write_nodes(struct bem_output *o, double seconds) {
  const struct bem_flow *f = &o->view.flow;
  const size_t n = f->surface.n;
  const double *x = f->surface.state, *y = x + n, *phi = y + n;
  struct shown to;
  TRY(show_begin(o, n, &to));
  for (size_t k = 0; k < n; k++) {
    const double complex carried = bem_motion_carries(&f->motion, CMPLX(x[k], y[k]));
    show(o, &to, o->mirrored ? n - 1 - k : k, (const double[]){x[k], y[k]}, phi[k],
         (const double[]){f->u[k] - creal(carried), f->v[k] - cimag(carried)});
  }
  const struct result_field fields[] = {
      {"velocity", "m/s", "velocity of the water", to.u, to.v},
      {"potential", "m^2/s", "velocity potential", to.phi, NULL},
  };
  return result_points(o->file, seconds, n, to.x, to.y, RESULT_LINE, sizeof fields / sizeof *fields,
                       fields);
}

static enum status write_lattice(struct bem_output *o, double seconds) {
  const struct case_file *c = o->c;
  struct bem_flow *f = &o->view.flow;
  struct bem_lattice *l = &o->lattice;
  struct shown to;
  TRY(bem_pressure_solve(&o->view.pressure, f, f->surface.state));
  TRY(bem_lattice_fill(l, &o->view.pressure, f, f->surface.state, o->spacing));
  TRY(show_begin(o, l->n, &to));
  for (size_t k = 0; k < l->n; k++) {
    show(o, &to, k, (const double[]){l->x[k], l->y[k]}, l->phi[k],
         (const double[]){l->u[k], l->v[k]});
    to.pressure[k] = c->density * c->gravity * c->H * l->pressure[k];
    to.volume[k] = c->H * c->H * l->cell;
  }
  const struct result_field fields[] = {
      {"velocity", "m/s", "velocity of the water", to.u, to.v},
      {"potential", "m^2/s", "velocity potential", to.phi, NULL},
      {"pressure", "Pa", "pressure", to.pressure, NULL},
      {"volume", "m^2", "area that the point stands for", to.volume, NULL},
  };
  return result_points(o->file, seconds, l->n, to.x, to.y, RESULT_VERTICES,
                       sizeof fields / sizeof *fields, fields);
}

static enum status write_surface(struct bem_output *o, double seconds) {
  if (o->view.flow.surface.n > o->most_nodes) o->most_nodes = o->view.flow.surface.n;
  TRY(o->spacing > 0 ? write_lattice(o, seconds) : write_nodes(o, seconds));
  TRY(polyline(o));
  if (o->mirrored) turn_line(o->c, &o->line);
  TRY(result_surface(o->file, seconds, &o->line));
  return result_flush(o->file);
}

/* What cannot be found of a flow that goes on is no matter to it. */
static enum status leave_out(struct bem_output *o, enum status status) {
  if (status != ERR_SOLVER && status != ERR_DIVERGED) return status;
  if (o->left_out++ == 0)
    progress_say(
        o->progress,
        "%s: what is to be written at t = %.6g s is left out, and so may be more (statistic "
        "outputs_left_out): %s",
        o->name, o->view.flow.time * o->time_scale, status_message());
  return OK;
}

static enum status find_pressure(struct bem_output *o, const double p[2], double *pressure) {
  const struct case_file *c = o->c;
  return bem_pressure_at(&o->view.pressure, &o->view.flow, o->view.flow.surface.state,
                         (p[0] - c->tank.min[0]) / c->H, (p[1] - c->tank.min[1]) / c->H, pressure);
}

/* One of a side goes with it. */
static bool is_behind_side(const struct bem_output *o, const double p[2]) {
  const struct case_file *c = o->c;
  const double seconds = o->view.flow.time * o->time_scale;
  double now[2] = {p[0], p[1]};
  tank_point_at(&c->walls, c->motions, c->n_motions, seconds, case_near(c), now);
  return tank_hides_at(&c->walls, c->motions, c->n_motions, seconds, case_near(c), now);
}

/* NaN behind a side that moves, and where it cannot be found. */
static enum status pressure_of(void *solver, const struct case_probe *probe, double *pressure) {
  struct bem_output *o = solver;
  const struct case_file *c = o->c;
  double p[RECORD_PARTS][2], sum = 0;
  size_t parts = record_sensor(c, probe, p);
  for (size_t i = 0; i < parts; i++) {
    double part = NAN;
    if (!is_behind_side(o, p[i])) TRY(leave_out(o, find_pressure(o, p[i], &part)));
    sum += part;
  }
  *pressure = c->density * c->gravity * c->H * sum / (double)parts;
  return OK;
}

static enum status point_of(void *solver, const struct case_point *point,
                            double value[CASE_POINT_FIELDS]) {
  struct bem_output *o = solver;
  const struct case_file *c = o->c;
  const double velocity = sqrt(c->gravity * c->H);
  struct bem_place place;
  bool wet;
  TRY(bem_lattice_at(&o->lattice, &o->view.pressure, &o->view.flow, o->view.flow.surface.state,
                     CMPLX((point->x - c->tank.min[0]) / c->H, (point->y - c->tank.min[1]) / c->H),
                     &wet, &place));
  for (int k = 0; k < CASE_POINT_FIELDS; k++) value[k] = NAN;
  value[CASE_POINT_cover] = wet;
  value[CASE_POINT_x] = o->mirrored ? bem_mirror_x(c, point->x) : point->x;
  value[CASE_POINT_y] = point->y;
  if (!wet) return OK;
  value[CASE_POINT_p] = c->density * c->gravity * c->H * place.pressure;
  value[CASE_POINT_rho] = c->density;
  value[CASE_POINT_u] = velocity * (o->mirrored ? -creal(place.w) : creal(place.w));
  value[CASE_POINT_v] = -velocity * cimag(place.w);
  return OK;
}

static enum status elevation_of(void *solver, const struct case_gauge *gauge, double *elevation) {
  const struct bem_output *o = solver;
  *elevation = gauge_elevation(&o->line, gauge->x, o->c->tank.min[1]);
  return OK;
}

static enum status look_for_powers(struct bem_output *o, const struct bem_flow *f,
                                   struct bem_stepper *stepper, double time, double power[2]) {
  double found[2];
  TRY(bem_view_look(&o->view, f, stepper, time, f->motion.sides));
  TRY(bem_view_powers(&o->view, found));
  memcpy(power, found, sizeof found);
  return OK;
}

enum status bem_output_given(struct bem_output *o, const struct bem_flow *f,
                             struct bem_stepper *stepper, double time, double dt) {
  if (!f->motion.frame && !f->motion.sides) return OK;
  struct bem_budget *b = &o->budget;
  bem_budget_given(b, time, dt);
  double power[2] = {b->given.power[0][0], b->given.power[1][0]};
  for (int i = 0; i < 2; i++) {
    const double at = time - dt + BEM_GAUSS[i] * dt;
    TRY(leave_out(o, look_for_powers(o, f, stepper, at, power)));
    for (int by = 0; by < 2; by++) b->given.power[by][i] = power[by];
  }
  return OK;
}

static bool wants_pressure(const struct bem_output *o) {
  return o->c->n_probes > 0 || o->c->n_points > 0 || o->forces;
}

static enum status write_forces(struct bem_output *o, double seconds, const double momentum[2]) {
  const struct bem_flow *f = &o->view.flow;
  struct bem_forces forces;
  double value[BEM_FORCE_COUNT];
  TRY(bem_forces_find(&o->view.pressure, f, f->surface.state, momentum, &forces));
  if (o->mirrored) bem_forces_turn(&forces);
  bem_forces_in_si(o->c, &forces, value);
  return result_diagnostics(o->file, seconds, BEM_FORCE_COUNT, bem_force_columns, value);
}

/* A row of every series. */
static enum status write_row(struct bem_output *o, const struct bem_stepper *stepper,
                             double seconds, double dt) {
  const struct case_file *c = o->c;
  struct bem_flow *f = &o->view.flow;
  struct bem_totals t;
  double momentum[2];
  TRY(bem_view_totals(&o->view, &t, momentum));
  struct record r = {.energy = bem_budget_row(&o->budget, c, seconds, &t),
                     .step = {.time = seconds,
                              .dt = dt * o->time_scale,
                              .evaluations = stepper ? bem_stepper_count(stepper).evaluations : 0,
                              .wall_time = progress_wall_clock() - o->start,
                              .volume = c->H * c->H * t.volume,
                              .removed_volume = c->H * c->H * o->budget.removed_volume},
                     .solver = o,
                     .pressure = pressure_of,
                     .elevation = elevation_of,
                     .point = point_of};
  if (wants_pressure(o)) TRY(bem_pressure_solve(&o->view.pressure, f, f->surface.state));
  if (o->forces) TRY(write_forces(o, seconds, momentum));
  if (c->n_gauges > 0) TRY(polyline(o));
  if (c->n_points > 0) TRY(bem_lattice_begin(&o->lattice, f, f->surface.state));
  return record_row(o->file, c, &r);
}

bool bem_output_touches(struct bem_sides *w, const struct bem_surface *s) {
  return bem_breaker_touches(w, s, s->state, CLOSEST);
}

/* Whether a surface and a row are due, and their times, s: the same but for rounding if both are.
 */
struct due {
  bool shown, sampled;
  double output, sample;
};

/* What is due of the state that is looked at. */
static enum status put_out(struct bem_output *o, const struct due *due,
                           const struct bem_stepper *stepper, double dt) {
  if (due->shown) TRY(leave_out(o, write_surface(o, due->output)));
  TRY(bem_sides_reserve(&o->sides, &o->view.flow.surface));
  if (!due->sampled || bem_output_touches(&o->sides, &o->view.flow.surface)) return OK;
  return leave_out(o, write_row(o, stepper, due->sample, dt));
}

enum status bem_output_due(struct bem_output *o, const struct bem_flow *f,
                           struct bem_stepper *stepper, double time, double dt) {
  const struct case_file *c = o->c;
  for (;;) {
    struct due due = {.output = (double)o->next_output * c->every,
                      .sample = (double)o->next_sample * c->sample};
    const double seconds = fmin(due.output, due.sample), near = NEAR * c->sample;
    if (seconds > c->end + near || seconds > time * o->time_scale) return OK;
    due.shown = due.output - seconds < near;
    due.sampled = due.sample - seconds < near;
    o->next_output += due.shown;
    o->next_sample += due.sampled;
    const enum status seen =
        bem_view_look(&o->view, f, stepper, seconds / o->time_scale,
                      (due.sampled && wants_pressure(o)) || (due.shown && o->spacing > 0));
    TRY(stepper ? leave_out(o, seen) : seen);
    if (seen == OK) TRY(put_out(o, &due, stepper, dt));
  }
}

enum status bem_output_event(struct bem_output *o, const char *name, double time, double x,
                             double y) {
  double at[2];
  bem_output_place(o, x, y, at);
  return result_event(o->file, name, time * o->time_scale, at[0], at[1]);
}

enum status bem_output_statistics(struct bem_output *o, const struct bem_flow *f,
                                  const struct bem_stepper *stepper, double steps_cut) {
  struct bem_stepper_counts n = bem_stepper_count(stepper);
  struct bem_solve_counts s = bem_solve_count(f->solve), view = bem_solve_count(o->view.flow.solve);
  const struct {
    const char *name;
    double value;
    const char *units, *help;
  } all[] = {
      {"spilled_volume", o->c->H * o->c->H * o->spilled_volume, "m^2",
       "cut from the thin film that passed the top of the wall that the water runs to"},
      {"steps_cut", steps_cut, "1",
       "time steps more than ten times shorter than the median of the 15 before them, those just "
       "after a new start of the integrator left out"},
      {"cvode_steps", n.steps, "1", "internal steps of CVODE"},
      {"evaluations", n.evaluations, "1", "of the right-hand side by CVODE"},
      {"initialisations", n.initialisations, "1",
       "of CVODE: the first and one after every new mesh or cut"},
      {"matrix_assemblies", s.assemblies, "1", "of the boundary system, without those for outputs"},
      {"gmres_iterations", s.iterations, "1", "with these matrices, of all linear solves together"},
      {"dense_factorisations", s.dense_factorisations, "1", "of these matrices, by LAPACK"},
      {"output_assemblies", view.assemblies, "1",
       "of the boundary system, for surfaces and series"},
      {"output_gmres_iterations", view.iterations, "1", "with these, pressure included"},
      {"nodes_most", (double)o->most_nodes, "1", "of the surface at any output"},
      {"lattice_missing", (double)o->lattice.missing, "1",
       "points of the velocity_lattice inside the water that were left out at outputs, since the "
       "map "
       "of the tank was not found there"},
      {"outputs_left_out", (double)o->left_out, "1",
       "surfaces, rows of series, pressures at probes and powers that could not be found"},
      {"nodes_last", (double)f->surface.n, "1", "of the surface at the end"},
  };
  for (size_t i = 0; i < sizeof all / sizeof *all; i++)
    TRY(result_statistic(o->file, all[i].name, all[i].value, all[i].units, all[i].help));
  return OK;
}
