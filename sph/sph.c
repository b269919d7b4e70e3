#include "sph/sph.h"

#include <math.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/pair/kernel.h"
#include "sph/start/initial.h"
#include "sph/time/integrator.h"

/* In particle spacings. Wider lists last longer but hold more pairs: the usual skin was measured
 * best for the dam break. The widest is for ways that no sound run takes in a step, ten spacings.
 */
static const double skin_width = 0.6, widest_skin = 20;

static enum status sort_and_list(struct sph *s, const unsigned char *drop) {
  struct sph_particles *f = &s->f;
  size_t n = sph_grid_sort(&s->grid, f->n, f->w.x, f->w.y, drop, f->key, f->order);
  sph_particles_permute(f, n);
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < n; i++) {
    f->x_listed[i] = f->w.x[i];
    f->y_listed[i] = f->w.y[i];
  }
  double reach = s->support;
  TRY(sph_lists_build(&s->water_water, n, f->w.x, f->w.y, &s->grid, f->w.x, f->w.y,
                      reach + s->skin));
  TRY(s->wall->list(s));
  TRY(sph_lists_build(&s->water_wall, n, f->w.x, f->w.y, &s->w.grid, s->w.x, s->w.y,
                      reach + (s->wall->moving ? s->skin : s->skin / 2)));
  s->rebuilds++;
  return OK;
}

/* How far the water has gone since the lists were built (m), and how far in the next step, if it is
 * as long as the last. */
struct ways {
  double gone, going; /* each the longest of all */
  double both;        /* the longest sum */
};

static struct ways ways_of(const struct sph *s) {
  const struct sph_particles *f = &s->f;
  double gone = 0, fastest = 0, both = 0, dt = s->dt;
#pragma omp parallel for simd schedule(static) reduction(max : gone, fastest, both)
  for (size_t i = 0; i < f->n; i++) {
    double x = f->w.x[i] - f->x_listed[i], y = f->w.y[i] - f->y_listed[i];
    double way = sqrt(x * x + y * y);
    double speed = sqrt(f->w.u[i] * f->w.u[i] + f->w.v[i] * f->w.v[i]);
    gone = fmax(gone, way);
    fastest = fmax(fastest, speed);
    both = fmax(both, way + 1.1 * dt * speed); /* a step may be longer, and its stages faster */
  }
  return (struct ways){gone, fastest * dt, both};
}

/* Wider for water that goes far in a step; not without end, since a kicked particle may be faster
 * than the last step allows for. */
static double skin_for(const struct sph *s, const struct ways *w) {
  return fmin(fmax(skin_width * s->dx, 2.4 * w->going), widest_skin * s->dx);
}

bool sph_lists_hold(const struct sph *s) {
  return ways_of(s).gone <= s->skin / 2;
}

enum status sph_neighbours_update(struct sph *s) {
  const struct ways w = ways_of(s);
  double skin = skin_for(s, &w);
  if (w.both <= s->skin / 2 && s->skin <= 2 * skin) return OK;
  s->skin = skin;
  return sort_and_list(s, NULL);
}

enum status sph_neighbours_widen(struct sph *s) {
  s->skin = fmin(2 * fmax(s->skin, skin_width * s->dx), widest_skin * s->dx);
  return sort_and_list(s, NULL);
}

/* Water that cannot come back: below the top of the wall that it has passed over, or beyond the
 * reach of what is inside. */
static bool is_gone(const struct sph *s, size_t i) {
  const double far = s->support, x = s->f.w.x[i], y = s->f.w.y[i];
  const struct geo_box *t = &s->tank.box;
  if (x < t->min[0] - far || x > t->max[0] + far || y < t->min[1] - far) return true;
  return s->f.over[i] != 0 && y < s->tank.top[x > t->max[0]];
}

static void book_removal(struct sph *s, size_t i) {
  double volume = s->f.m[i] / s->f.w.rho[i];
  s->budget.removed += sph_energy_of(s, i);
  s->budget.removed_volume += volume;
  if (s->f.over[i] != 0) s->budget.spilled_volume += volume;
}

enum status sph_remove_outside(struct sph *s) {
  size_t n_out = 0;
  for (size_t i = 0; i < s->f.n; i++) n_out += is_gone(s, i);
  if (!n_out) return OK;
  unsigned char *drop = calloc(s->f.n, 1);
  CHECK(drop, ERR_MEMORY, "no memory for %zu particles", s->f.n);
  for (size_t i = 0; i < s->f.n; i++)
    if ((drop[i] = is_gone(s, i))) book_removal(s, i);
  enum status status = sort_and_list(s, drop);
  free(drop);
  CHECK(status != OK || s->f.n > 0, ERR_DIVERGED,
        "no water is left in the tank at t = %g s (%.3g m^2 went over the walls, %.3g m^2 through "
        "them): raise the walls, c0, alpha or delta",
        s->t, s->budget.spilled_volume, s->budget.removed_volume - s->budget.spilled_volume);
  return status;
}

enum status sph_create(const struct case_file *c, double resolution, const struct sph_scheme *o,
                       struct sph **out) {
  enum status status = OK;
  struct sph *s;
  TRY(sph_allocate(1, sizeof *s, &s));
  s->scheme = *o;
  s->scheme.delta = sph_scheme_delta(o);
  s->scheme.integrator = sph_integrator_chosen(o);
  s->rho0 = c->density;
  s->seen = (struct sph_seen){.lightest = INFINITY};
  s->c0 = o->c0;
  s->g = c->gravity;
  s->dx = c->H / resolution;
  s->h = o->h_over_dx * s->dx;
  s->support = kernel_support((enum sph_kernel)o->kernel) * s->h;
  s->skin = skin_width * s->dx;
  s->tank = tank_of(&c->walls);
  ATTEMPT(sph_initial_fill(s, c));
  ATTEMPT(sph_allocate(s->f.room, sizeof *s->pack, &s->pack));
  ATTEMPT(sph_allocate(s->f.room / SPH_LANES, sizeof *s->cluster_totals, &s->cluster_totals));
  ATTEMPT(sph_grid_create(&s->grid, &s->tank.box, s->dx));
  ATTEMPT(sph_wall_create(s, &c->walls));
  ATTEMPT(sort_and_list(s, NULL));
done:
  if (status != OK) {
    sph_destroy(s);
    s = NULL;
  }
  *out = s;
  return status;
}

void sph_destroy(struct sph *s) {
  if (!s) return;
  sph_wall_destroy(s);
  sph_particles_destroy(&s->f);
  free(s->pack);
  free(s->cluster_totals);
  sph_grid_destroy(&s->grid);
  sph_lists_destroy(&s->water_water);
  sph_lists_destroy(&s->water_wall);
  free(s);
}
