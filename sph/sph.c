#include "sph/sph.h"

#include <math.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/flow.h"
#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/hot.h"
#include "sph/pair/forms.h"
#include "sph/pair/kernel.h"
#include "sph/start/initial.h"
#include "sph/time/integrator.h"
#include "sph/treat/treat.h"

/* In particle spacings. Wider lists last longer but hold more pairs: from 0.25 to 0.6 for the
 * water, and 0.6 to 1.5 for the walls, the dam break at H/dx = 50 takes the same within the 10 %
 * that one run differs from the next. The widest is for ways that no sound run takes in a step, ten
 * spacings.
 */
static const double usual_skin = 0.4, usual_wall_skin = 1, widest_skin = 20;

/* A step may be longer than the last, and its stages faster. */
static const double longer_step = 1.25;

/* The walls' lists hold while no water moves farther than this. */
static double wall_reserve(const struct sph *s) {
  return s->wall->moving ? s->wall_skin / 2 : s->wall_skin;
}

/* What water and walls go since the walls were listed, or up to `ahead` (s) later. */
static double way_at_walls(const struct sph *s, double ahead) {
  return sph_drift_at_walls(s, ahead) + sph_sides_way(s, s->t + ahead);
}

struct sph_sources sph_sources_of_water(const struct sph *s) {
  const struct sph_period *p = &s->period;
  const double drift = sph_drift_since_sorted(s);
  return (struct sph_sources){
      p->copies.n ? 2 : 1,
      {{&s->grid, s->f.w.x, s->f.w.y, drift, 0},
       {&p->grid, p->copies.x, p->copies.y, drift, (uint32_t)s->f.room}},
  };
}

static enum status list_walls(struct sph *s, double least) {
  const struct sph_particles *f = &s->f;
  sph_drift_list_walls(s);
  s->wall_skin = fmin(fmax(usual_wall_skin * s->dx, least), widest_skin * s->dx);
  sph_sides_list(s);
  s->drift.walls = way_at_walls(s, s->drift.ahead);
  const double wanted = (s->wall->moving ? 2.2 : 1.1) * s->drift.walls;
  if (wanted > s->wall_skin) {
    s->wall_skin = fmin(wanted, widest_skin * s->dx);
    s->drift.walls = way_at_walls(s, s->drift.ahead); /* wider lists concern more water */
  }
  if (s->sides.move) TRY(sph_wall_see(s));
  sph_period_move(s);
  TRY(s->wall->list(s));
  const struct sph_sources walls = {1, {{&s->w.grid, s->w.x, s->w.y, 0, 0}}};
  TRY(sph_lists_build(&s->water_wall, f->n, f->w.x, f->w.y, &walls, s->support + s->wall_skin));
  s->wall_rebuilds++;
  return sph_wall_look(s);
}

/* With skins of at least so much, m. */
static enum status sort_and_list(struct sph *s, const unsigned char *drop, double least,
                                 double least_wall) {
  struct sph_particles *f = &s->f;
  const enum sph_phase was = sph_enter(s, SPH_PHASE_sort);
  sph_period_wrap(s);
  size_t n = sph_grid_sort(&s->grid, f->n, f->w.x, f->w.y, drop, f->key, f->order);
  sph_particles_permute(f, n);
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < n; i++) {
    f->x_listed[i] = f->w.x[i];
    f->y_listed[i] = f->w.y[i];
  }
  sph_drift_measure(s, longer_step * s->dt);
  s->skin =
      fmin(fmax(fmax(usual_skin * s->dx, least), 1.1 * s->drift.touching), widest_skin * s->dx);
  TRY(sph_period_list(s, least));
  const struct sph_sources water = sph_sources_of_water(s);
  TRY(sph_lists_build(&s->water_water, n, f->w.x, f->w.y, &water, s->support + s->skin));
  s->rebuilds++;
  TRY(list_walls(s, least_wall));
  sph_enter(s, was);
  return OK;
}

/* A particle that leaves the straight way by this much, m, may still be listed. */
static double slack(const struct sph *s) {
  return fmin(sph_period_left(s), fmin(sph_drift_left(s) / 2, wall_reserve(s) - s->drift.walls));
}

bool sph_lists_hold(const struct sph *s, double elapsed) {
  const struct sph_particles *f = &s->f;
  if (s->stand_in) return true;
  if (elapsed > s->drift.ahead)
    return sph_drift_since_sorted(s) <= s->skin / 2 &&
           sph_drift_at_walls(s, 0) + sph_sides_way(s, s->t + elapsed) <= wall_reserve(s);
  double off2 = 0;
#pragma omp parallel for simd schedule(static) reduction(max : off2)
  for (size_t i = 0; i < f->n; i++) {
    const double x = f->w.x[i] - (f->w0.x[i] + elapsed * f->w0.u[i]);
    const double y = f->w.y[i] - (f->w0.y[i] + elapsed * f->w0.v[i]);
    off2 = larger(x * x + y * y, off2);
  }
  return sqrt(off2) <= slack(s);
}

/* Lists made for water that went farther are made anew when half as wide would do. */
static enum status update(struct sph *s) {
  sph_drift_measure(s, longer_step * s->dt);
  const double left = sph_drift_left(s);
  const bool wide = s->skin > 2 * usual_skin * s->dx && left > s->skin / 2 && !s->again;
  if (left < 0 || wide || sph_period_left(s) < 0) return sort_and_list(s, NULL, 0, 0);
  s->drift.walls = way_at_walls(s, s->drift.ahead);
  if (s->drift.walls > wall_reserve(s)) return list_walls(s, 0);
  return sph_wall_look(s);
}

enum status sph_neighbours_update(struct sph *s) {
  const enum sph_phase was = sph_enter(s, SPH_PHASE_sort);
  TRY(update(s));
  sph_enter(s, was);
  return OK;
}

enum status sph_neighbours_widen(struct sph *s) {
  s->again = true;
  return sort_and_list(s, NULL, 2 * fmax(s->skin, usual_skin * s->dx),
                       2 * fmax(s->wall_skin, usual_wall_skin * s->dx));
}

/* Water that cannot come back: below the top of the wall that it has passed over, or beyond the
 * reach of what is inside. */
static bool is_gone(const struct sph *s, size_t i) {
  const double far = s->support, x = s->f.w.x[i], y = s->f.w.y[i];
  const struct geo_box t = tank_walled(&s->tank);
  if (x < t.min[0] - far || x > t.max[0] + far || y < t.min[1] - far) return true;
  return sph_wall_has_lost(s, i);
}

static void book_removal(struct sph *s, size_t i) {
  double volume = s->f.m[i] / s->f.w.rho[i];
  s->budget.removed += sph_energy_of(s, i);
  s->budget.removed_volume += volume;
  if (s->f.over[i] != 0) s->budget.spilled_volume += volume;
}

enum status sph_remove_outside(struct sph *s) {
  size_t n_out = 0;
#pragma omp parallel for schedule(static) reduction(+ : n_out)
  for (size_t i = 0; i < s->f.n; i++) n_out += is_gone(s, i);
  if (!n_out) return OK;
  unsigned char *drop = calloc(s->f.n, 1);
  CHECK(drop, ERR_MEMORY, "no memory for %zu particles", s->f.n);
  for (size_t i = 0; i < s->f.n; i++)
    if ((drop[i] = is_gone(s, i))) book_removal(s, i);
  enum status status = sort_and_list(s, drop, 0, 0);
  free(drop);
  CHECK(status != OK || s->f.n > 0, ERR_DIVERGED,
        "no water is left in the tank at t = %g s (%.3g m^2 went over the walls, %.3g m^2 through "
        "them): raise the walls, c0, alpha or delta",
        s->t, s->budget.spilled_volume, s->budget.removed_volume - s->budget.spilled_volume);
  return status;
}

/* Of the surface, m: a wave's mean, or the top of the regions. */
static double level_at_rest(const struct case_file *c) {
  return flow_is_wave(c->flow) ? flow_level(c) : geo_lines_box(&c->water).max[1];
}

enum status sph_create(const struct case_file *c, double resolution, const struct sph_scheme *o,
                       struct sph **out) {
  enum status status = OK;
  struct sph *s;
  TRY(sph_allocate(1, sizeof *s, &s));
  s->scheme = *o;
  s->scheme.delta = sph_scheme_delta(o);
  s->scale = sph_scale_of(o);
  s->scheme.integrator = sph_integrator_chosen(o);
  s->split = sph_integrators[s->scheme.integrator]->split;
  s->rho0 = c->density;
  s->seen = (struct sph_seen){.lightest = INFINITY};
  s->c0 = o->c0;
  s->g = c->gravity;
  if (c->flow->pull) s->pull = c->flow->pull(c);
  s->eos = (struct eos){(enum sph_eos)o->eos, s->rho0, s->c0, s->g, level_at_rest(c)};
  sph_force_create(s, c);
  ATTEMPT(sph_sides_create(s, c));
  s->adjoint = sph_forms_adjoint(o);
  s->dx = c->H / resolution;
  s->h = o->h_over_dx * s->dx;
  s->support = kernel_support((enum sph_kernel)o->kernel) * s->h;
  s->skin = usual_skin * s->dx;
  s->wall_skin = usual_wall_skin * s->dx;
  s->tank = tank_of(&c->walls, c->periodic);
  ATTEMPT(sph_initial_fill(s, c));
  s->pack_room = s->f.room;
  ATTEMPT(sph_allocate(s->pack_room, sizeof *s->pack, &s->pack));
  ATTEMPT(sph_allocate(s->pack_room, sizeof *s->G, &s->G));
  ATTEMPT(sph_allocate(s->f.room / SPH_LANES, sizeof *s->cluster_totals, &s->cluster_totals));
  ATTEMPT(sph_grid_create(&s->grid, &s->tank.box, s->dx));
  ATTEMPT(sph_drift_create(&s->drift, &s->grid, s->support));
  ATTEMPT(sph_period_create(s));
  ATTEMPT(sph_wall_create(s, &c->walls));
  ATTEMPT(sort_and_list(s, NULL, 0, 0));
  ATTEMPT(sph_treat_create(s));
done:
  if (status != OK) {
    sph_destroy(s);
    s = NULL;
  }
  *out = s;
  return status;
}

void sph_tank_set(struct sph *s, double t) {
  if (s->force.n) sph_force_set(s, t);
  if (s->sides.move) sph_sides_set(s, t);
}

void sph_destroy(struct sph *s) {
  if (!s) return;
  sph_treat_destroy(s);
  free(s->fitted);
  sph_wall_destroy(s);
  sph_period_destroy(s);
  sph_particles_destroy(&s->f);
  free(s->pack);
  free(s->G);
  free(s->cluster_totals);
  sph_grid_destroy(&s->grid);
  sph_drift_destroy(&s->drift);
  sph_lists_destroy(&s->water_water);
  sph_lists_destroy(&s->water_wall);
  free(s);
}
