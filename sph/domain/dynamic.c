/* Dynamic boundary particles (Crespo, Gomez-Gesteira & Dalrymple, CMC 5, 2007), the walls that most
 * SPH codes have: layers of fixed particles that are water but for their places, with a density by
 * the continuity equation and a pressure by the equation of state. The lattice is that of the
 * water, in as many layers as the support is deep, the first half a spacing behind the wall
 * (layers.h): fewer layers would leave the water without neighbours, and a finer lattice pushes no
 * harder, since its volumes are smaller.
 *
 * They push when water has come nearer than it was. So water stays a spacing or two away from where
 * other walls have it, and still water hangs on no exact pressure: a familiar baseline, not a good
 * wall. As in DualSPHysics they never pull, or water would stick to them, and take no part in the
 * diffusion of the density. They start with the mean pressure of the water near them, continued
 * by its weight (Adami, Hu & Adams 2012).
 *
 * Where the forms are adjoint, the work that water does on them is their elastic energy, to the
 * error of the time steps. They see all water, that above the top of a wall, too. Water sees them
 * without slip as particles at rest; with free slip viscosity does not see them. */
#include <math.h>
#include <stdlib.h>

#include "sph/domain/layers.h"
#include "sph/domain/wall.h"
#include "sph/pair/continuity.h"
#include "sph/pair/forms.h"
#include "sph/pair/loops.h"
#include "sph/pair/rates.h"

struct dynamic {
  struct sph_layers layers;
  struct sph_lists lists;    /* water near them */
  double *m;                 /* kg/m, [n] */
  double *rho, *rho0;        /* kg m^-3, [n]: now, at the start of the step */
  double *k[SPH_MAX_STAGES]; /* rates of the stages, kg m^-3 s^-1, [n] */
  bool started;
};

static enum status dynamic_create(struct sph *s, const struct geo_lines *walls) {
  (void)walls;
  struct dynamic *d;
  TRY(sph_allocate(1, sizeof *d, &d));
  s->w.data = d;
  TRY(sph_layers_create(s, &d->layers));
  TRY(sph_wall_make_packs(s, s->w.n));
  if (s->scheme.slip == SPH_SLIP_free) /* viscosity sees nothing: all without volume */
    TRY(sph_allocate(s->w.n, sizeof *s->w.drag, &s->w.drag));
  TRY(sph_allocate(s->w.n, sizeof *d->m, &d->m));
  TRY(sph_allocate(s->w.n, sizeof *d->rho, &d->rho));
  TRY(sph_allocate(s->w.n, sizeof *d->rho0, &d->rho0));
  for (int r = 0; r < SPH_MAX_STAGES; r++) TRY(sph_allocate(s->w.n, sizeof(double), &d->k[r]));
  return OK;
}

static double lowest_density(const struct sph *s, double y) {
  return eos_stored(&s->eos, eos_driving_of(&s->eos, 0, y), y);
}

/* The mean over the water near them, by weights W V, is that at the mean place. */
static void start_cluster(struct sph *s, struct dynamic *d, size_t cluster) {
  const size_t at = cluster * SPH_LANES;
  const struct sph_near near = sph_near_of(&d->lists, cluster, s->pack);
  struct sph_targets i = {0};
  struct sph_fit_sums a = {0};
  for (size_t l = 0; l < SPH_LANES; l++) {
    const size_t k = at + l < s->w.n ? at + l : s->w.n - 1;
    i.x[l] = s->w.x[k];
    i.y[l] = s->w.y[k];
  }
  if (near.n) sph_loops_for(s, &i)->fit(s, &i, &near, &a);
  for (size_t l = 0; l < SPH_LANES && at + l < s->w.n; l++) {
    const double y = i.y[l], lowest = lowest_density(s, y);
    d->rho[at + l] = lowest;
    if (a.w[l] > 0) {
      const double scale = s->rho0 * s->c0 * s->c0;
      const double p = near.pack[near.list[0]].p + scale * a.p[l] / a.w[l];
      const double aside = s->h * a.x[l] / a.w[l], above = s->h * a.y[l] / a.w[l];
      const double rest[2] = {0, 0};
      const struct sph_vector weight =
          sph_weight(s, eos_stored(&s->eos, p, y + above), i.x[l] + aside, y + above, 0, 0, rest);
      const double here = p - (weight.x * aside + weight.y * above);
      d->rho[at + l] = larger(eos_stored(&s->eos, here, y), lowest);
    }
    d->m[at + l] = d->layers.V[at + l] * d->rho[at + l];
  }
}

static enum status dynamic_list(struct sph *s) {
  struct dynamic *d = s->w.data;
  const struct sph_sources water = sph_sources_of_water(s);
  TRY(sph_lists_build(&d->lists, s->w.n, s->w.x, s->w.y, &water, s->support + s->wall_skin));
  if (d->started) return OK;
  d->started = true;
  sph_pack_water(s);
  for (size_t c = 0; c < d->lists.n_clusters; c++) start_cluster(s, d, c);
  return OK;
}

static void dynamic_fill(struct sph *s) {
  const struct dynamic *d = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    const double y = s->w.y[k], rho = d->rho[k];
    s->w.pack[k] = (struct sph_pack){
        .x = s->w.x[k], .y = y, .p = eos_driving(&s->eos, rho, y), .V = d->m[k] / rho, .rho = rho};
    if (s->scheme.slip == SPH_SLIP_no) sph_wall_hold(s, k, 0, 0, &(struct sph_drive){0});
  }
}

static void cluster_rates(struct sph *s, struct dynamic *d, int stage, size_t cluster) {
  const size_t at = cluster * SPH_LANES;
  const struct sph_near near = sph_near_of(&d->lists, cluster, s->pack);
  const enum sph_continuity form = (enum sph_continuity)s->scheme.continuity;
  const double per_time = kernel_slope_scale((enum sph_kernel)s->scheme.kernel) * s->c0 / s->h;
  struct sph_targets i = {0};
  struct sph_rates_sums a = {0};
  for (size_t l = 0; l < SPH_LANES; l++) {
    const struct sph_pack *w = &s->w.pack[at + l < s->w.n ? at + l : s->w.n - 1];
    i.x[l] = w->x;
    i.y[l] = w->y;
    i.p[l] = w->p;
    i.rho[l] = w->rho;
  }
  if (near.n)
    sph_loops_for(s, &i)->rates(s, &(struct sph_rates_how){SPH_DIFFUSION_none, false, 1e-24}, &i,
                                &near, &a);
  for (size_t l = 0; l < SPH_LANES && at + l < s->w.n; l++) {
    const double rho = eos_density(&s->eos, i.rho[l], i.y[l]);
    d->k[stage][at + l] = -continuity_density(form, s->rho0, rho) * per_time * a.div[l];
  }
}

static void dynamic_rates(struct sph *s, int stage) {
  struct dynamic *d = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t c = 0; c < d->lists.n_clusters; c++) cluster_rates(s, d, stage, c);
}

static void dynamic_begin(struct sph *s) {
  struct dynamic *d = s->w.data;
  for (size_t k = 0; k < s->w.n; k++) d->rho0[k] = d->rho[k];
}

static void dynamic_advance(struct sph *s, const double *weights, int stages, double dt) {
  struct dynamic *d = s->w.data;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < s->w.n; k++) {
    double sum = 0;
    for (int r = 0; r < stages; r++) sum += weights[r] * d->k[r][k];
    d->rho[k] = larger(d->rho0[k] + dt * sum, lowest_density(s, s->w.y[k]));
  }
}

static uint32_t dynamic_motion(const struct sph *s, size_t k) {
  const struct dynamic *d = s->w.data;
  return d->layers.motion[k];
}

static void dynamic_destroy(struct sph *s) {
  struct dynamic *d = s->w.data;
  if (!d) return;
  sph_layers_destroy(&d->layers);
  sph_lists_destroy(&d->lists);
  free(d->m);
  free(d->rho);
  free(d->rho0);
  for (int r = 0; r < SPH_MAX_STAGES; r++) free(d->k[r]);
  free(d);
}

const struct sph_wall sph_wall_dynamic = {
    .create = dynamic_create,
    .list = dynamic_list,
    .fill = dynamic_fill,
    .rates = dynamic_rates,
    .begin = dynamic_begin,
    .advance = dynamic_advance,
    .motion = dynamic_motion,
    .destroy = dynamic_destroy,
    .layer = 2,
    .undiffused = true,
};
