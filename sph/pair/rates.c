/* Signs: grad_i W_ij = F r_ji with F > 0 (kernel.h), so with x = r_ji, e = F V_j
 *   D rho_i/Dt = -rho_i sum (u_j - u_i).x e + delta h c0 D_i
 *   D u_i/Dt   = -(1/rho_i) sum (p_i + p_j) x e + f + alpha h c0 (rho0/rho_i) sum pi_ij x e
 * with pi_ij = (u_j - u_i).x / |x|^2: approaching particles (pi < 0) are pushed apart, and the
 * viscous power, -(1/2) alpha h c0 rho0 sum_ij V_i V_j F pi^2 |x|^2, is never positive.
 *
 * Energy, J/m: with the elastic energy of eos.h, d e = p / rho^2 d rho, water-water pairs
 * exchange kinetic and elastic energy exactly: the terms (p_i + p_j) are antisymmetric. So do the
 * other pairs of forms that are adjoint (forms.h); what the rest make or take is the power of the
 * pressure forces and the rate of the elastic energy, `pairs` of the budget. What a wall
 * particle w takes out is the power sum_i V_i sum_w V_w (p_w u_i + p_i u_w) . grad_i W_iw. It is
 * summed from the wall pairs alone, so that the closure of the budget checks the rest. Of walls
 * that move (sides.h) the power of their forces with their velocity is the sides'. */
#include "sph/pair/rates.h"

#include <math.h>

#include "sph/domain/fitted.h"
#include "sph/domain/wall.h"
#include "sph/fluid/clusters.h"
#include "sph/fluid/energy.h"
#include "sph/pair/continuity.h"
#include "sph/pair/density.h"
#include "sph/pair/derivative.h"
#include "sph/pair/gradient.h"
#include "sph/pair/loops.h"
#include "sph/pair/momentum.h"
#include "sph/treat/treat.h"

static void pad_pressure(struct sph_particles *f) {
  for (size_t i = f->n; i % SPH_LANES; i++) f->p[i] = f->p[f->n - 1];
}

void sph_pack_water(struct sph *s) {
  if (s->stand_in) return;
  const struct sph_state *w = &s->f.w;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].x = w->x[i];
    s->pack[i].y = w->y[i];
    s->pack[i].u = w->u[i];
    s->pack[i].v = w->v[i];
    s->f.p[i] = s->pack[i].p = eos_driving(&s->eos, w->rho[i], w->y[i]);
    s->pack[i].V = s->f.m[i] / w->rho[i];
    s->pack[i].rho = w->rho[i];
  }
  sph_period_fill(s);
  pad_pressure(&s->f);
}

void sph_pack_pressure(struct sph *s) {
  if (s->stand_in) return;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++)
    s->f.p[i] = s->pack[i].p = eos_driving(&s->eos, s->f.w.rho[i], s->f.w.y[i]);
  sph_period_fill(s);
  pad_pressure(&s->f);
}

void sph_pack_pressure_of_probes(struct sph *s) {
  sph_pack_water(s);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++)
    s->pack[i].p = eos_pressure(&s->eos, s->pack[i].p, s->pack[i].y);
  sph_period_fill(s);
}

struct sph_targets sph_targets_of(const struct sph *s, size_t cluster) {
  const struct sph_particles *f = &s->f;
  const size_t at = cluster * SPH_LANES;
  struct sph_targets i;
  for (size_t l = 0; l < SPH_LANES; l++) {
    i.x[l] = f->w.x[at + l];
    i.y[l] = f->w.y[at + l];
    i.u[l] = f->w.u[at + l];
    i.v[l] = f->w.v[at + l];
    i.p[l] = f->p[at + l];
    i.rho[l] = f->w.rho[at + l];
    i.Gx[l] = s->G[at + l].x;
    i.Gy[l] = s->G[at + l].y;
  }
  return i;
}

struct sph_near sph_near_walls(const struct sph *s, size_t cluster) {
  struct sph_near walls = sph_near_of(&s->water_wall, cluster, s->w.pack);
  walls.G = s->w.G;
  return walls;
}

/* What an evaluation is asked for. */
struct evaluation {
  int stage;
  bool diffuse, bounds; /* see sph_rates */
};

/* What water and walls do to a cluster's particles, per second: acceleration (m/s^2), divergence of
 * the velocity, diffusion (kg m^-3 s^-1). */
struct effects {
  double wall_x[SPH_LANES], wall_y[SPH_LANES], wall_div[SPH_LANES];
  double pushed[SPH_LANES], dragged[SPH_LANES]; /* by V of walls, m^2 s^-3 */
  double water_x[SPH_LANES], water_y[SPH_LANES], water_div[SPH_LANES];
  double drag_x[SPH_LANES], drag_y[SPH_LANES];
  double ax[SPH_LANES], ay[SPH_LANES], div[SPH_LANES], D[SPH_LANES];
};

/* From the sums over water (a) and walls (b), whose units are h, c0 and rho0 (loops.h). */
static void effects_of(const struct sph *s, const double *rho, const struct sph_rates_sums *a,
                       const struct sph_rates_sums *b, struct effects *e) {
  const struct sph_scheme *o = &s->scheme;
  const double F = kernel_slope_scale((enum sph_kernel)o->kernel), per_time = F * s->c0 / s->h;
  const double force = per_time * s->c0 * s->rho0, drag = o->alpha * force;
  const double diffusion = 2 * o->delta * per_time * s->rho0;
  for (int l = 0; l < SPH_LANES; l++) {
    const double per_rho = 1 / rho[l];
    e->wall_x[l] = -force * b->px[l] * per_rho;
    e->wall_y[l] = -force * b->py[l] * per_rho;
    e->wall_div[l] = per_time * b->div[l];
    e->drag_x[l] = drag * (a->vx[l] + b->vx[l]) * per_rho;
    e->drag_y[l] = drag * (a->vy[l] + b->vy[l]) * per_rho;
    e->water_x[l] = -force * a->px[l] * per_rho;
    e->water_y[l] = -force * a->py[l] * per_rho;
    e->water_div[l] = per_time * a->div[l];
    e->D[l] = diffusion * (a->D[l] + b->D[l]);
  }
}

/* Pressure and divergence by a fit instead, which does not tell walls from water. */
static void fit_effects(const struct sph *s, const struct sph_targets *i,
                        const struct sph_near *water, const struct sph_near *walls,
                        struct effects *e) {
  const struct sph_slopes g = sph_slopes_of(s, i, water, walls);
  for (int l = 0; l < SPH_LANES; l++) {
    const double rho = momentum_density((enum sph_momentum)s->scheme.momentum, s->rho0, i->rho[l]);
    e->wall_x[l] = e->wall_y[l] = e->wall_div[l] = 0;
    e->water_x[l] = -g.px[l] / rho;
    e->water_y[l] = -g.py[l] / rho;
    e->water_div[l] = g.div[l];
  }
}

static void add_effects(const struct sph *s, struct effects *e) {
  const double *f = s->force.drive;
  for (int l = 0; l < SPH_LANES; l++) {
    e->ax[l] = e->wall_x[l] + e->water_x[l] + e->drag_x[l] + f[0];
    e->ay[l] = e->wall_y[l] + e->water_y[l] + e->drag_y[l] + f[1];
    e->div[l] = e->water_div[l] + e->wall_div[l];
  }
}

static void add_pull(const struct flow_pull *p, const struct sph_targets *i, struct effects *e) {
  for (int l = 0; l < SPH_LANES; l++) {
    e->ax[l] -= p->rate * p->rate * (i->x[l] - p->x);
    e->ay[l] -= p->rate * p->rate * (i->y[l] - p->y);
  }
}

/* What a tank that turns adds; and the power, W/m, that its motion takes. */
static void add_frame(const struct sph *s, size_t at, const struct sph_targets *i,
                      struct effects *e, double *power) {
  *power = 0;
  for (size_t l = 0; l < SPH_LANES; l++) {
    double turn[2], f[2];
    sph_force_turn(&s->force, i->x[l], i->y[l], i->u[l], i->v[l], turn);
    sph_force_excess(&s->force, i->x[l], i->y[l], i->u[l], i->v[l], f);
    e->ax[l] += turn[0];
    e->ay[l] += turn[1];
    *power -= s->f.m[at + l] * (i->u[l] * f[0] + i->v[l] * f[1]);
  }
}

/* The elastic energy of particles of mass m, the stored density and its rate: d(m e) = elastic
 * d rho_stored + lift dy. */
struct stiffness {
  double rho[SPH_LANES]; /* that multiplies the divergence in the continuity equation, kg m^-3 */
  double elastic[SPH_LANES]; /* J m^-1 per kg m^-3 */
  double lift[SPH_LANES];    /* N m^-1 */
  double pV[SPH_LANES];      /* J m^-1 s^-1 per 1/s of divergence */
};

/* The usual case by itself, for speed. */
static void find_stiffness(const struct sph *s, size_t at, struct stiffness *k) {
  const enum sph_continuity c = (enum sph_continuity)s->scheme.continuity;
  for (size_t l = 0; l < SPH_LANES; l++) {
    k->rho[l] = s->f.w.rho[at + l];
    k->pV[l] = s->f.p[at + l] * s->f.m[at + l] / k->rho[l];
    k->elastic[l] = k->pV[l] / k->rho[l];
    k->lift[l] = 0;
  }
  if (eos_is_plain(s->eos.law) && !continuity_is_of_reference(c)) return;
  for (size_t l = 0; l < SPH_LANES; l++) {
    const double y = s->f.w.y[at + l], rho = eos_density(&s->eos, s->f.w.rho[at + l], y);
    const double pV = eos_pressure(&s->eos, s->f.p[at + l], y) * s->f.m[at + l] / rho;
    k->rho[l] = continuity_density(c, s->rho0, rho);
    k->pV[l] = pV * (k->rho[l] / rho);
    k->elastic[l] = pV / rho;
    k->lift[l] = s->f.m[at + l] * eos_lift(&s->eos, s->f.p[at + l], s->f.w.rho[at + l], y);
  }
}

/* Powers that leave the water, and what bounds the step. */
static struct sph_totals totals_of(const struct sph *s, size_t at, const struct stiffness *k,
                                   const struct effects *e, const struct sph_rates_sums *a,
                                   const struct sph_rates_sums *b) {
  const struct sph_state *w = &s->f.w;
  struct sph_totals t = {0};
  const double unbalanced = s->g - eos_gravity(&s->eos);
  double acceleration2 = 0, speed = 0;
  for (size_t l = 0; l < SPH_LANES; l++) {
    const double m = s->f.m[at + l], u = w->u[at + l], v = w->v[at + l];
    t.viscosity -= m * (u * e->drag_x[l] + v * e->drag_y[l] - e->dragged[l]);
    t.diffusion -= k->elastic[l] * e->D[l];
    t.walls -= m * (u * e->wall_x[l] + v * e->wall_y[l] - e->pushed[l]) - k->pV[l] * e->wall_div[l];
    t.sides -= m * (e->pushed[l] + e->dragged[l]);
    t.pairs -= m * (u * e->water_x[l] + v * (e->water_y[l] + unbalanced)) + k->lift[l] * v -
               k->pV[l] * e->water_div[l];
    acceleration2 = larger(e->ax[l] * e->ax[l] + e->ay[l] * e->ay[l], acceleration2);
    speed = larger(sqrt(u * u + v * v) + s->c0 * larger(a->pi_most[l], b->pi_most[l]), speed);
  }
  if (s->adjoint) t.pairs = 0; /* but for rounding */
  t.acceleration2 = acceleration2;
  t.speed = speed;
  return t;
}

/* Where walls have no slip, viscosity has sums of its own. */
static void sum_walls(const struct sph *s, const struct evaluation *how, enum sph_diffusion d,
                      const struct sph_targets *i, const struct sph_near *walls,
                      struct sph_rates_sums *b) {
  const struct sph_loops *loops = sph_loops_for(s, i);
  /* A particle that comes through the wall meets its own image at no distance: nearer than h/100
   * that must not stop the clock. */
  const double soft2 = s->wall->moving ? 1e-4 : 1e-24;
  const enum sph_diffusion at_walls =
      s->wall->undiffused ? SPH_DIFFUSION_none : diffusion_at_walls(d);
  loops->rates(s, &(struct sph_rates_how){at_walls, how->bounds, soft2}, i, walls, b);
  if (!s->w.drag) return;
  struct sph_near held = *walls;
  struct sph_rates_sums a;
  held.pack = s->w.drag;
  loops->rates(s, &(struct sph_rates_how){SPH_DIFFUSION_none, how->bounds, soft2}, i, &held, &a);
  for (int l = 0; l < SPH_LANES; l++) {
    b->vx[l] = a.vx[l];
    b->vy[l] = a.vy[l];
    b->pi_most[l] = larger(a.pi_most[l], b->pi_most[l]);
  }
}

static bool any_part(const struct sph_near *walls, const struct sph_pack *part) {
  for (size_t k = 0; k < walls->n; k++)
    if (part[walls->list[k]].V != 0) return true;
  return false;
}

void sph_rates_push(const struct sph *s, const struct sph_targets *i, const struct sph_near *walls,
                    const struct sph_pack *pressing, const struct sph_pack *holding,
                    struct sph_push *p) {
  const struct sph_scheme *o = &s->scheme;
  const double per_time = kernel_slope_scale((enum sph_kernel)o->kernel) * s->c0 / s->h;
  const double force = per_time * s->c0 * s->rho0, drag = o->alpha * force;
  const struct sph_rates_how how = {SPH_DIFFUSION_none, false, s->wall->moving ? 1e-4 : 1e-24};
  struct sph_near near = *walls;
  struct sph_rates_sums a, b;
  near.pack = pressing;
  sph_loops_for(s, i)->rates(s, &how, i, &near, &a);
  b = a;
  if (holding != pressing) {
    near.pack = holding;
    sph_loops_for(s, i)->rates(s, &how, i, &near, &b);
  }
  for (int l = 0; l < SPH_LANES; l++) {
    p->x[l] = -force * a.px[l] / i->rho[l];
    p->y[l] = -force * a.py[l] / i->rho[l];
    p->drag_x[l] = drag * b.vx[l] / i->rho[l];
    p->drag_y[l] = drag * b.vy[l] / i->rho[l];
  }
}

/* Of sums with volumes times V along an axis. */
static void push_along(const struct sph *s, int axis, const struct sph_targets *i,
                       const struct sph_near *walls, struct effects *e) {
  const struct sph_pack *pressing = s->w.part[0][axis];
  struct sph_push p;
  if (!any_part(walls, pressing)) return;
  sph_rates_push(s, i, walls, pressing, s->w.drag ? s->w.part[1][axis] : pressing, &p);
  for (int l = 0; l < SPH_LANES; l++) {
    e->pushed[l] += (axis ? p.y : p.x)[l];
    e->dragged[l] += (axis ? p.drag_y : p.drag_x)[l];
  }
}

/* The solver refuses fits, which do not tell walls from water, where sides move. */
static void push_sides(const struct sph *s, const struct sph_targets *i,
                       const struct sph_near *walls, struct effects *e) {
  for (int l = 0; l < SPH_LANES; l++) e->pushed[l] = e->dragged[l] = 0;
  if (!s->w.V || !walls->n) return;
  for (int axis = 0; axis < 2; axis++) push_along(s, axis, i, walls, e);
}

static void cluster_rates(struct sph *s, size_t cluster, const void *wanted) {
  const struct evaluation *how = wanted;
  const enum sph_diffusion d =
      how->diffuse ? (enum sph_diffusion)s->scheme.diffusion : SPH_DIFFUSION_none;
  const size_t at = cluster * SPH_LANES;
  const struct sph_targets i = sph_targets_of(s, cluster);
  const struct sph_loops *loops = sph_loops_for(s, &i);
  struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  water.G = s->G;
  struct sph_rates_sums a, b = {0};
  loops->rates(s, &(struct sph_rates_how){d, how->bounds, 1e-24}, &i, &water, &a);
  const struct sph_near walls = sph_near_walls(s, cluster);
  if (walls.n) sum_walls(s, how, d, &i, &walls, &b);

  struct effects e;
  effects_of(s, s->f.w.rho + at, &a, &b, &e);
  if (derivative_is_fit((enum sph_derivative)s->scheme.derivative))
    fit_effects(s, &i, &water, &walls, &e);
  push_sides(s, &i, &walls, &e);
  add_effects(s, &e);
  if (s->pull.rate > 0) add_pull(&s->pull, &i, &e);
  double frame = 0;
  if (s->force.shakes) add_frame(s, at, &i, &e, &frame);
  struct stiffness stiff;
  find_stiffness(s, at, &stiff);
  const struct sph_state *k = &s->f.k[how->stage];
  for (size_t l = 0; l < SPH_LANES; l++) {
    if (!how->diffuse) e.D[l] = s->f.D[at + l];
    s->f.D[at + l] = e.D[l];
    k->x[at + l] = i.u[l];
    k->y[at + l] = i.v[l];
    k->u[at + l] = e.ax[l];
    k->v[at + l] = e.ay[l];
    k->rho[at + l] = e.D[l] - stiff.rho[l] * e.div[l];
  }
  sph_fitted_rates(s, how->stage, cluster);
  s->cluster_totals[cluster] = totals_of(s, at, &stiff, &e, &a, &b);
  s->cluster_totals[cluster].frame = frame;
  sph_treat_rates(s, how->stage, cluster, &s->cluster_totals[cluster]);
}

/* In the order of the clusters, for the same bits with any number of threads. */
static void add_totals(struct sph *s) {
  struct sph_totals t = {0};
  for (size_t c = 0; c < s->water_water.n_clusters; c++) {
    const struct sph_totals *k = &s->cluster_totals[c];
#define X(name, ...) t.name += k->name;
    SPH_POWERS(X)
#undef X
    t.acceleration2 = larger(k->acceleration2, t.acceleration2);
    t.speed = larger(k->speed, t.speed);
  }
  t.speed = larger(s->sides.speed, t.speed);
  s->totals = t;
}

/* What the density jumps by at the start of a step, from where its rate has brought it, is the
 * budget's, too. */
static void sum_densities(struct sph *s, int stage) {
  const double before = stage == 0 ? sph_energy(s).total : 0;
  sph_density_sum(s);
  sph_particles_pad(&s->f);
  if (stage == 0) s->budget.pairs += before - sph_energy(s).total;
  sph_pack_water(s);
  sph_wall_fill(s);
}

enum status sph_rates(struct sph *s, int stage, bool diffuse, bool bounds) {
  const struct evaluation how = {stage, diffuse && !s->split, bounds};
  if (s->stand_in) {
    s->stand_in->rates(s, stage, how.diffuse);
    return OK;
  }
  const enum sph_phase was = sph_enter(s, SPH_PHASE_rates);
  if (stage == 0) {
    sph_tank_set(s, s->t);
    TRY(sph_neighbours_update(s));
  }
  sph_pack_water(s);
  sph_wall_fill(s);
  if (continuity_sums((enum sph_continuity)s->scheme.continuity)) sum_densities(s, stage);
  if (how.diffuse && diffusion_needs_gradient(s->scheme.diffusion)) {
    sph_gradient(s);
    if (s->wall->fill_gradients) s->wall->fill_gradients(s);
  }
  sph_each_cluster(s, cluster_rates, &how);
  sph_wall_rates(s, stage);
  add_totals(s);
  s->evaluations++;
  sph_enter(s, was);
  return OK;
}
