/* Signs: grad_i W_ij = F r_ji with F > 0 (kernel.h), so with x = r_ji, e = F V_j
 *   D rho_i/Dt = -rho_i sum (u_j - u_i).x e + delta h c0 D_i
 *   D u_i/Dt   = -(1/rho_i) sum (p_i + p_j) x e + f + alpha h c0 (rho0/rho_i) sum pi_ij x e
 * with pi_ij = (u_j - u_i).x / |x|^2: approaching particles (pi < 0) are pushed apart, and the
 * viscous power, -(1/2) alpha h c0 rho0 sum_ij V_i V_j F pi^2 |x|^2, is never positive.
 *
 * Energy, J/m: with the elastic energy of eos.h, d e = p / rho^2 d rho, water-water pairs
 * exchange kinetic and elastic energy exactly: the terms (p_i + p_j) are antisymmetric. What a wall
 * particle w takes out is the power sum_i V_i sum_w V_w (p_w u_i + p_i u_w) . grad_i W_iw. It is
 * summed from the wall pairs alone, so that the closure of the budget checks the rest. */
#include "sph/pair/rates.h"

#include <math.h>

#include "sph/domain/wall.h"
#include "sph/pair/continuity.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/eos.h"
#include "sph/pair/gradient.h"
#include "sph/pair/loop.h"
#include "sph/pair/momentum.h"
#include "sph/pair/viscosity.h"

void sph_pack_water(struct sph *s) {
  const struct sph_state *w = &s->f.w;
  const enum sph_eos eos = s->scheme.eos;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].x = w->x[i];
    s->pack[i].y = w->y[i];
    s->pack[i].u = w->u[i];
    s->pack[i].v = w->v[i];
    s->f.p[i] = s->pack[i].p = eos_pressure(eos, s->rho0, s->c0, w->rho[i]);
    s->pack[i].V = s->f.m[i] / w->rho[i];
  }
  for (size_t i = s->f.n; i % SPH_LANES; i++) s->f.p[i] = s->f.p[s->f.n - 1];
}

/* What an evaluation is asked for. */
struct evaluation {
  int stage;
  bool diffuse, bounds; /* see sph_rates */
};

/* The particles of one cluster, in lanes. */
struct lanes {
  vec x, y, u, v, p, Gx, Gy;
};

/* Sums over one kind of neighbours. */
struct sums {
  vec px, py;  /* sum momentum_pressure x e */
  vec div;     /* sum continuity_flux e */
  vec vx, vy;  /* sum viscosity_drag x e */
  vec D;       /* sum psi e */
  vec pi_most; /* max |pi| */
};

/* Added to squared distances: the particle itself gives 0/tiny. */
SPECIALISE double tiny2(const struct sph *s) {
  return 1e-24 * s->h * s->h;
}

/* d: the diffusion that these neighbours take part in. soft2: what is added to squared distances in
 * pi_most. */
SPECIALISE struct sums sum_pairs(const struct sph *s, enum sph_kernel kernel, enum sph_diffusion d,
                                 bool viscous, bool bounds, const struct lanes *i,
                                 const struct near *near, double soft2) {
  struct sums a = {0};
  const struct sph_scheme *scheme = &s->scheme;
  const struct range range = range_of(kernel, s->h);
  const double tiny = tiny2(s);
  for (size_t k = 0; k < near->n; k++) {
    const struct sph_pack *j = &near->pack[near->list[k]];
    struct pair q = pair_with(kernel, &range, near, j, i->x, i->y);
    vec approach = (j->u - i->u) * q.x + (j->v - i->v) * q.y;
    vec pressure = momentum_pressure(scheme->momentum, i->p, j->p) * q.e;
    a.px += pressure * q.x;
    a.py += pressure * q.y;
    a.div += continuity_flux(scheme->continuity, approach) * q.e;
    if (viscous) {
      vec drag = viscosity_drag(scheme->viscosity, approach / (q.r2 + tiny)) * q.e;
      a.vx += drag * q.x;
      a.vy += drag * q.y;
    }
    if (bounds && j->V > 0) { /* what has no volume is not there */
      vec soft = approach / (q.r2 + soft2);
      a.pi_most = vec_max(a.pi_most, vec_where_less(vec_abs(soft), q.r2, range.cutoff2));
    }
    if (d != SPH_DIFFUSION_none)
      a.D +=
          diffusion_psi(d, j->p - i->p, q.x, q.y, q.r2, j->Gx + i->Gx, j->Gy + i->Gy, s->h) * q.e;
  }
  return a;
}

/* Each diffusion, with and without viscosity and bounds, has a loop of its own: with less than 32
 * vector registers choices inside one loop cost 10 to 25 % of an evaluation. */
SPECIALISE struct sums sum_near(const struct sph *s, enum sph_kernel kernel, enum sph_diffusion d,
                                bool bounds, const struct lanes *i, const struct near *near,
                                double soft2) {
  const bool viscous = s->scheme.alpha > 0;
#define SUM(name, help)                                                                            \
  case SPH_DIFFUSION_##name:                                                                       \
    if (viscous && bounds)                                                                         \
      return sum_pairs(s, kernel, SPH_DIFFUSION_##name, true, true, i, near, soft2);               \
    if (viscous) return sum_pairs(s, kernel, SPH_DIFFUSION_##name, true, false, i, near, soft2);   \
    if (bounds) return sum_pairs(s, kernel, SPH_DIFFUSION_##name, false, true, i, near, soft2);    \
    return sum_pairs(s, kernel, SPH_DIFFUSION_##name, false, false, i, near, soft2);
  switch (d) { SPH_DIFFUSIONS(SUM) }
#undef SUM
  __builtin_unreachable();
}

SPECIALISE struct lanes lanes_of(const struct sph *s, size_t at) {
  const struct sph_particles *f = &s->f;
  struct lanes i = {.x = vec_load(f->w.x + at),
                    .y = vec_load(f->w.y + at),
                    .u = vec_load(f->w.u + at),
                    .v = vec_load(f->w.v + at),
                    .p = vec_load(f->p + at)};
  if (diffusion_needs_gradient(s->scheme.diffusion))
    for (size_t l = 0; l < SPH_LANES; l++) {
      size_t j = at + l < f->n ? at + l : f->n - 1;
      i.Gx[l] = s->pack[j].Gx;
      i.Gy[l] = s->pack[j].Gy;
    }
  return i;
}

SPECIALISE void cluster_rates(struct sph *s, enum sph_kernel kernel, const struct evaluation *how,
                              size_t cluster) {
  const struct sph_particles *f = &s->f;
  const struct sph_scheme *scheme = &s->scheme;
  const enum sph_diffusion d = how->diffuse ? scheme->diffusion : SPH_DIFFUSION_none;
  const size_t at = cluster * SPH_LANES;
  const double c2 = s->c0 * s->c0;
  const struct lanes i = lanes_of(s, at);
  vec rho = vec_load(f->w.rho + at), m = vec_load(f->m + at);

  struct near water = near_of(&s->water_water, cluster, s->pack);
  struct sums a = sum_near(s, kernel, d, how->bounds, &i, &water, tiny2(s)), b = {0};
  struct near walls = near_of(&s->water_wall, cluster, s->w.pack);
  /* A particle that comes through the wall meets its own image at no distance: nearer than h/100
   * that must not stop the clock. */
  const double soft2 = s->wall->moving ? 1e-4 * s->h * s->h : tiny2(s);
  struct sph_lip lip;
  if (walls.n && sph_lip_at(s, i.x, i.y, vec_load(f->over + at), &lip)) walls.lip = &lip;
  if (walls.n) b = sum_near(s, kernel, diffusion_at_walls(d), how->bounds, &i, &walls, soft2);

  const double F = kernel_slope_scale(kernel, s->h);
  const vec per_rho = 1 / rho;
  vec wall_x = -F * b.px * per_rho, wall_y = -F * b.py * per_rho, wall_div = F * b.div;
  vec drag = scheme->alpha * s->h * s->c0 * s->rho0 * F * per_rho;
  vec drag_x = drag * (a.vx + b.vx), drag_y = drag * (a.vy + b.vy);
  vec ax = wall_x - F * a.px * per_rho + drag_x;
  vec ay = wall_y - F * a.py * per_rho + drag_y - s->g;
  vec D = vec_load(f->D + at);
  if (how->diffuse) {
    D = 2 * scheme->delta * s->h * s->c0 / c2 * F * (a.D + b.D);
    vec_store(f->D + at, D);
  }

  const struct sph_state *k = &f->k[how->stage];
  vec_store(k->x + at, i.u);
  vec_store(k->y + at, i.v);
  vec_store(k->u + at, ax);
  vec_store(k->v + at, ay);
  vec_store(k->rho + at, -rho * (F * a.div + wall_div) + D);

  vec pV = i.p * m * per_rho;
  struct sph_totals *t = &s->cluster_totals[cluster];
  t->viscosity = -vec_sum(m * (i.u * drag_x + i.v * drag_y));
  t->diffusion = -vec_sum(pV * per_rho * D);
  t->walls = walls.n ? -vec_sum(m * (i.u * wall_x + i.v * wall_y) - pV * wall_div) : 0;
  if (how->bounds) {
    t->acceleration2 = vec_largest(ax * ax + ay * ay);
    t->speed = vec_largest(vec_sqrt(i.u * i.u + i.v * i.v) + s->h * vec_max(a.pi_most, b.pi_most));
  }
}

SPH_PASS(rates, cluster_rates, struct evaluation)

/* In the order of the clusters, for the same bits with any number of threads. */
static void add_totals(struct sph *s) {
  struct sph_totals t = {0};
  for (size_t c = 0; c < s->water_water.n_clusters; c++) {
    const struct sph_totals *k = &s->cluster_totals[c];
    t.viscosity += k->viscosity;
    t.diffusion += k->diffusion;
    t.walls += k->walls;
    t.acceleration2 = fmax(t.acceleration2, k->acceleration2);
    t.speed = fmax(t.speed, k->speed);
  }
  s->totals = t;
}

enum status sph_rates(struct sph *s, int stage, bool diffuse, bool bounds) {
  const struct evaluation how = {stage, diffuse, bounds};
  if (stage == 0) TRY(sph_neighbours_update(s));
  sph_pack_water(s);
  s->wall->fill(s);
  if (diffuse && diffusion_needs_gradient(s->scheme.diffusion)) {
    sph_gradient(s);
    if (s->wall->fill_gradients) s->wall->fill_gradients(s);
  }
  rates(s, s->water_water.n_clusters, &how);
  add_totals(s);
  s->evaluations++;
  return OK;
}
