#include "sph/observe/output.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/progress.h"
#include "common/cloud/surface.h"
#include "common/result/record.h"
#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/observe/diagnose.h"
#include "sph/observe/gauge.h"
#include "sph/observe/point.h"
#include "sph/observe/probe.h"
#include "sph/observe/rest.h"
#include "sph/pair/eos.h"
#include "sph/pair/rates.h"

struct sph_output {
  const struct case_file *c;
  struct result *result;
  struct cloud_surface *extractor;
  struct geo_lines outline; /* of the tank */
  struct geo_lines surface;
  struct sph_gauges *gauges;
  double started;                    /* wall clock, s */
  size_t n_every, n_sample;          /* multiples written so far */
  double budget0, available, budget; /* J/m */
  bool diagnose, due;                /* the rates of a sample, of an output, are still to come */
  bool *dry;                         /* [faces], its wall_impact is still to come; owned */
  uint32_t *followed; /* [points], ids of the particles of those that follow; owned */
  size_t room;
  double *x, *y, *u, *v, *rho, *p, *m, *V; /* [room], in the order of the particles' ids */
  double *ax, *ay;                         /* the same; NULL: not wanted */
  uint32_t *place;                         /* [room] */
};

/* The particle that is nearest to the water's side of a face, and how far. */
static size_t foremost(const struct sph *s, const struct face *f, double *way) {
  size_t at = 0;
  *way = INFINITY;
  for (size_t i = 0; i < s->f.n; i++) {
    const double d = face_way(f, s->f.w.x[i], s->f.w.y[i]);
    if (d >= *way || d < -s->dx) continue;
    *way = d;
    at = i;
  }
  return at;
}

/* How far the foremost particle, a disc of diameter dx, is from a face. */
static double gap(const struct sph *s, const struct face *f) {
  double way;
  foremost(s, f, &way);
  return way - s->dx / 2;
}

/* Whether any water touches a face that has been dry; then it is worth to look which. */
static bool any_touches(const struct sph_output *o, const struct sph *s) {
  bool any = false;
#pragma omp parallel for schedule(static) reduction(| : any)
  for (size_t i = 0; i < s->f.n; i++) {
    size_t n;
    const uint32_t *near = sph_sight_faces(&s->sight, s->f.w.x[i], s->f.w.y[i], &n);
    for (size_t k = 0; k < n; k++)
      any |= o->dry[near[k]] &&
             face_way(&s->faces.face[near[k]], s->f.w.x[i], s->f.w.y[i]) <= s->dx / 2;
  }
  return any;
}

enum status sph_output_create(const struct case_file *c, const struct sph *s, struct result *result,
                              struct sph_output **out) {
  enum status status = OK;
  struct sph_output *o;
  TRY(sph_allocate(1, sizeof *o, &o));
  o->c = c;
  o->result = result;
  o->started = progress_wall_clock();
  o->room = s->f.n;
  ATTEMPT(sph_allocate(s->faces.n, sizeof *o->dry, &o->dry));
  for (size_t k = 0; k < s->faces.n; k++)
    o->dry[k] = !s->tank.periodic[0] && gap(s, &s->faces.face[k]) > 1.5 * s->dx;
  ATTEMPT(sph_allocate(c->n_points, sizeof *o->followed, &o->followed));
  for (size_t k = 0; k < c->n_points; k++)
    if (c->points[k].follow) o->followed[k] = sph_point_nearest(s, &c->points[k]);
  struct result_energy e = sph_energy(s);
  o->budget = o->budget0 = result_energy_budget(&e);
  double rest;
  ATTEMPT(sph_rest_find(c, s, &rest));
  o->available = e.kinetic + e.potential - rest;
  ATTEMPT(result_rest(result, rest));
  ATTEMPT(tank_outline(&s->tank, &c->walls, &o->outline));
  ATTEMPT(cloud_surface_create(&o->extractor));
  ATTEMPT(sph_gauges_create(c, s, &o->gauges));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->x));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->y));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->u));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->v));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->rho));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->p));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->m));
  ATTEMPT(sph_allocate(o->room, sizeof(double), &o->V));
  if (s->scheme.accelerations) {
    ATTEMPT(sph_allocate(o->room, sizeof(double), &o->ax));
    ATTEMPT(sph_allocate(o->room, sizeof(double), &o->ay));
  }
  ATTEMPT(sph_allocate(o->room, sizeof *o->place, &o->place));
done:
  if (status != OK) {
    sph_output_destroy(o);
    o = NULL;
  }
  *out = o;
  return status;
}

void sph_output_destroy(struct sph_output *o) {
  if (!o) return;
  cloud_surface_destroy(o->extractor);
  geo_lines_destroy(&o->outline);
  geo_lines_destroy(&o->surface);
  sph_gauges_destroy(o->gauges);
  free(o->dry);
  free(o->followed);
  free(o->x);
  free(o->y);
  free(o->u);
  free(o->v);
  free(o->rho);
  free(o->p);
  free(o->m);
  free(o->V);
  free(o->ax);
  free(o->ay);
  free(o->place);
  free(o);
}

/* The particles by id: an array's element is the same particle at every output, as long as none has
 * been taken out. */
static size_t sort_by_id(struct sph_output *o, const struct sph *s) {
  const struct sph_particles *f = &s->f;
  for (size_t i = 0; i < o->room; i++) o->place[i] = UINT32_MAX;
  for (size_t i = 0; i < f->n; i++) o->place[f->id[i]] = (uint32_t)i;
  size_t n = 0;
  for (size_t k = 0; k < o->room; k++)
    if (o->place[k] != UINT32_MAX) o->place[n++] = o->place[k];
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < n; k++) {
    size_t i = o->place[k];
    o->x[k] = tank_wrap(&s->tank, 0, f->w.x[i]);
    o->y[k] = tank_wrap(&s->tank, 1, f->w.y[i]);
    o->u[k] = f->w.u[i];
    o->v[k] = f->w.v[i];
    const double y = f->w.y[i], stored = f->w.rho[i];
    o->rho[k] = eos_density(&s->eos, stored, y);
    o->p[k] = eos_pressure(&s->eos, eos_driving(&s->eos, stored, y), y);
    o->m[k] = f->m[i];
    o->V[k] = f->m[i] / f->w.rho[i];
  }
  return n;
}

/* Where the particles are, by id; infinitely far for those taken out. */
static struct cloud cloud_of(struct sph_output *o, const struct sph *s) {
  if (s->f.n < o->room)
    for (size_t k = 0; k < o->room; k++) o->x[k] = o->y[k] = INFINITY;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    o->x[s->f.id[i]] = tank_wrap(&s->tank, 0, s->f.w.x[i]);
    o->y[s->f.id[i]] = tank_wrap(&s->tank, 1, s->f.w.y[i]);
  }
  return (struct cloud){o->room, o->x, o->y, NULL, s->dx, &s->tank};
}

/* After sort_by_id; `known`: the rates are those of the state. */
static void take_accelerations(struct sph_output *o, const struct sph *s, size_t n, bool known) {
  for (size_t k = 0; o->ax && k < n; k++) {
    o->ax[k] = known ? s->f.k[0].u[o->place[k]] : NAN;
    o->ay[k] = known ? s->f.k[0].v[o->place[k]] : NAN;
  }
}

static enum status write_state(struct sph_output *o, const struct sph *s, bool rates) {
  size_t n = sort_by_id(o, s);
  take_accelerations(o, s, n, rates);
  const struct result_field fields[] = {
      {"pressure", "Pa", "pressure, by the equation of state", o->p, NULL},
      {"density", "kg/m^3", "density", o->rho, NULL},
      {"mass", "kg/m", "mass, which it keeps", o->m, NULL},
      {"volume", "m^2", "mass over the density that evolves", o->V, NULL},
      {"velocity", "m/s", "velocity", o->u, o->v},
      {"acceleration", "m/s^2", "rate of the velocity", o->ax, o->ay}};
  const size_t n_fields = sizeof fields / sizeof *fields - (o->ax ? 0 : 1);
  TRY(result_points(o->result, s->t, n, o->x, o->y, RESULT_VERTICES, n_fields, fields));
  const struct cloud cloud = cloud_of(o, s);
  TRY(cloud_surface_extract(o->extractor, &cloud, sph_sides_walls(s, &o->outline), &o->surface));
  TRY(result_surface(o->result, s->t, &o->surface));
  return result_flush(o->result);
}

/* The water, for the record. */
struct moment {
  const struct sph_output *o;
  const struct sph *s;
};

static enum status pressure_of(void *solver, const struct case_probe *probe, double *pressure) {
  const struct moment *m = solver;
  struct case_probe now = *probe;
  double at[2] = {probe->x, probe->y};
  sph_sides_carry(m->s, at);
  now.x = at[0];
  now.y = at[1];
  return sph_probe(m->s, &now, sph_sides_walls(m->s, &m->o->c->walls), pressure);
}

static enum status elevation_of(void *solver, const struct case_gauge *gauge, double *elevation) {
  const struct moment *m = solver;
  *elevation = sph_gauges_elevation(m->o->gauges, (size_t)(gauge - m->o->c->gauges));
  return OK;
}

static enum status write_series(struct sph_output *o, struct sph *s, double dt) {
  struct moment moment = {o, s};
  struct record r = {.energy = sph_energy(s),
                     .step = {.time = s->t,
                              .dt = dt,
                              .evaluations = (double)s->evaluations,
                              .wall_time = progress_wall_clock() - o->started,
                              .volume = sph_volume(s),
                              .removed_volume = s->budget.removed_volume},
                     .solver = &moment,
                     .pressure = pressure_of,
                     .elevation = elevation_of};
  o->budget = result_energy_budget(&r.energy);
  if (o->c->n_probes) sph_pack_pressure_of_probes(s);
  if (o->c->n_gauges) {
    const struct cloud cloud = cloud_of(o, s);
    TRY(sph_gauges_measure(o->gauges, s, &cloud));
  }
  return record_row(o->result, o->c, &r);
}

/* The instant at which the foremost particle touches a face, from its velocity now. */
static enum status write_impact(struct sph_output *o, const struct sph *s, size_t face) {
  const struct face *f = &s->faces.face[face];
  double way;
  const size_t i = foremost(s, f, &way);
  const double open = way - s->dx / 2;
  if (open > 0) return OK;
  o->dry[face] = false;
  const struct sph_drive d = sph_wall_drive(s, 2 * (uint32_t)face, s->f.w.x[i], s->f.w.y[i], 0, 0);
  const double speed = f->t[1] * (s->f.w.u[i] - d.V[0]) - f->t[0] * (s->f.w.v[i] - d.V[1]);
  const double ago = speed > 0 ? -open / speed : 0;
  const double along = fmin(fmax(face_along(f, s->f.w.x[i], s->f.w.y[i]), 0), f->length);
  return result_event(o->result, "wall_impact", s->t - ago, f->a[0] + along * f->t[0],
                      f->a[1] + along * f->t[1]);
}

static enum status write_impacts(struct sph_output *o, const struct sph *s) {
  if (!any_touches(o, s)) return OK;
  for (size_t k = 0; k < s->faces.n; k++)
    if (o->dry[k]) TRY(write_impact(o, s, k));
  return OK;
}

enum status sph_output_step(struct sph_output *o, struct sph *s, double dt) {
  const struct case_file *c = o->c;
  const double late = 1e-9 * c->every;
  TRY(write_impacts(o, s));
  if (s->t >= (double)o->n_sample * c->sample - late) {
    TRY(write_series(o, s, dt));
    o->diagnose = true;
    o->n_sample = (size_t)floor((s->t + late) / c->sample) + 1;
  }
  if (s->t >= (double)o->n_every * c->every - late || s->t >= c->end - late) {
    if (o->ax)
      o->due = true;
    else
      TRY(write_state(o, s, false));
    o->n_every++;
  }
  return OK;
}

static enum status write_points(const struct sph_output *o, const struct sph *s) {
  double value[CASE_POINT_FIELDS];
  for (size_t k = 0; k < o->c->n_points; k++) {
    const struct case_point *point = &o->c->points[k];
    if (s->steps % (size_t)point->every) continue;
    if (point->follow)
      sph_point_follow(s, o->followed[k], value);
    else
      sph_point(s, point, value);
    TRY(result_point(o->result, k, s->t, value));
  }
  return OK;
}

enum status sph_output_rates(struct sph_output *o, struct sph *s) {
  TRY(write_points(o, s));
  if (o->due) TRY(write_state(o, s, true));
  o->due = false;
  if (!o->diagnose) return OK;
  o->diagnose = false;
  return sph_diagnose_write(s, o->c, o->result);
}

enum status sph_output_finish(struct sph_output *o, struct sph *s) {
  if (!o->due) return OK;
  TRY(sph_rates(s, 0, true, true));
  o->due = false;
  return write_state(o, s, true);
}

double sph_output_next(const struct sph_output *o) {
  double next = (double)o->n_every * o->c->every;
  return next < o->c->end - 1e-9 * o->c->every ? next : o->c->end;
}

enum status sph_output_last(struct sph_output *o, struct sph *s) {
  return write_state(o, s, false);
}

double sph_output_drift(const struct sph_output *o) {
  bool at_rest = !(o->available > 1e-6 * fabs(o->budget0)); /* its rounding would be the scale */
  return (o->budget - o->budget0) / (at_rest ? fabs(o->budget0) : o->available);
}
