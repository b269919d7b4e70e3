/* The pair loops. A cluster of SPH_LANES particles i stands in the lanes of vector registers and
 * meets the neighbours j of its list one at a time; each i sums over its own j and writes only
 * itself, so the bits do not depend on the number of threads.
 *
 * Signs: grad_i W_ij = F r_ji with F > 0 (kernel.h), so with x = r_ji, e = F V_j
 *   D rho_i/Dt = -rho_i sum (u_j - u_i).x e + delta h c0 D_i
 *   D u_i/Dt   = -(1/rho_i) sum (p_i + p_j) x e + f + alpha h c0 (rho0/rho_i) sum pi_ij x e
 * with pi_ij = (u_j - u_i).x / |x|^2: approaching particles (pi < 0) are pushed apart, and the
 * viscous power, -(1/2) alpha h c0 rho0 sum_ij V_i V_j F pi^2 |x|^2, is never positive.
 *
 * Energy, J/m: with the elastic energy of energy.h, d e = p / rho^2 d rho, water-water pairs
 * exchange kinetic and elastic energy exactly: the terms (p_i + p_j) are antisymmetric. What a wall
 * particle w takes out is the power sum_i V_i sum_w V_w (p_w u_i + p_i u_w) . grad_i W_iw. It is
 * summed from the wall pairs alone, so that the closure of the budget checks the rest. */
#include "sph/pair/rates.h"

#include <math.h>

#include "sph/domain/wall.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/gradient.h"
#include "sph/pair/kernel.h"

void sph_pack_water(struct sph *s) {
  const struct sph_state *w = &s->f.w;
  double c2 = s->c0 * s->c0;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].x = w->x[i];
    s->pack[i].y = w->y[i];
    s->pack[i].u = w->u[i];
    s->pack[i].v = w->v[i];
    s->pack[i].p = c2 * (w->rho[i] - s->rho0);
    s->pack[i].V = s->f.m[i] / w->rho[i];
  }
}

/* The particles of one cluster, in lanes. */
struct lanes {
  vec x, y, u, v, p, Gx, Gy;
};

/* Sums over one kind of neighbours. */
struct sums {
  vec px, py;  /* sum (p_i + p_j) x e */
  vec div;     /* sum (u_j - u_i).x e */
  vec vx, vy;  /* sum pi x e */
  vec D;       /* sum psi e */
  vec pi_most; /* max |pi| */
};

/* Added to squared distances: the particle itself gives 0/tiny. */
SPECIALISE double tiny2(const struct sph *s) {
  return 1e-24 * s->h * s->h;
}

/* soft2: what is added to squared distances in pi_most. lip: NULL, or what hides neighbours. */
SPECIALISE struct sums sum_pairs(const struct sph *s, enum sph_kernel kernel, enum sph_diffusion d,
                                 bool viscous, bool bounds, const struct lanes *i, size_t n,
                                 const uint32_t *list, const struct sph_pack *pack, double soft2,
                                 const struct sph_lip *lip) {
  struct sums a = {0};
  const double per_h2 = 1 / (s->h * s->h);
  const vec cutoff2 = (vec){0} + kernel_cutoff2(s->h);
  const double tiny = tiny2(s), far2 = kernel_cutoff2(s->h);
  for (size_t k = 0; k < n; k++) {
    const struct sph_pack *j = &pack[list[k]];
    vec x = j->x - i->x, y = j->y - i->y;
    vec r2 = x * x + y * y;
    if (lip) r2 = sph_lip_hide(lip, j->x, j->y, r2, far2);
    vec e = vec_where_less(kernel_slope(kernel, r2 * per_h2) * j->V, r2, cutoff2);
    vec approach = (j->u - i->u) * x + (j->v - i->v) * y;
    vec pressure = (j->p + i->p) * e;
    a.px += pressure * x;
    a.py += pressure * y;
    a.div += approach * e;
    if (viscous || bounds) {
      vec pi = approach / (r2 + tiny);
      if (bounds) {
        vec soft = approach / (r2 + soft2);
        a.pi_most = vec_max(a.pi_most, vec_where_less(vec_abs(soft), r2, cutoff2));
      }
      if (viscous) {
        vec drag = pi * e;
        a.vx += drag * x;
        a.vy += drag * y;
      }
    }
    if (d != SPH_DIFFUSION_none)
      a.D += diffusion_psi(d, j->p - i->p, x, y, r2, j->Gx + i->Gx, j->Gy + i->Gy, s->h) * e;
  }
  return a;
}

SPECIALISE void cluster_rates(struct sph *s, enum sph_kernel kernel, enum sph_diffusion d,
                              bool viscous, bool bounds, int stage, bool diffuse, size_t cluster) {
  const struct sph_particles *f = &s->f;
  const size_t at = cluster * SPH_LANES;
  const double c2 = s->c0 * s->c0;
  vec rho = vec_load(f->w.rho + at), m = vec_load(f->m + at);
  struct lanes i = {.x = vec_load(f->w.x + at),
                    .y = vec_load(f->w.y + at),
                    .u = vec_load(f->w.u + at),
                    .v = vec_load(f->w.v + at),
                    .p = c2 * (rho - s->rho0)};
  if (diffusion_needs_gradient(d))
    for (size_t l = 0; l < SPH_LANES; l++) {
      size_t j = at + l < f->n ? at + l : f->n - 1;
      i.Gx[l] = s->pack[j].Gx;
      i.Gy[l] = s->pack[j].Gy;
    }

  size_t n;
  const uint32_t *list = sph_lists_of(&s->water_water, cluster, &n);
  struct sums a = sum_pairs(s, kernel, d, viscous, bounds, &i, n, list, s->pack, tiny2(s), NULL);
  struct sums b = {0};
  list = sph_lists_of(&s->water_wall, cluster, &n);
  /* A particle that comes through the wall meets its own image at no distance: nearer than h/100
   * that must not stop the clock. */
  const double soft2 = s->wall->moving ? 1e-4 * s->h * s->h : tiny2(s);
  struct sph_lip lip;
  bool at_lip = n && sph_lip_at(s, i.x, i.y, vec_load(f->over + at), &lip);
  if (n)
    b = sum_pairs(s, kernel, diffusion_at_walls(d), viscous, bounds, &i, n, list, s->w.pack, soft2,
                  at_lip ? &lip : NULL);

  const double F = kernel_slope_scale(kernel, s->h);
  const vec per_rho = 1 / rho;
  vec wall_x = -F * b.px * per_rho, wall_y = -F * b.py * per_rho, wall_div = F * b.div;
  vec drag = s->o.alpha * s->h * s->c0 * s->rho0 * F * per_rho;
  vec drag_x = drag * (a.vx + b.vx), drag_y = drag * (a.vy + b.vy);
  vec ax = wall_x - F * a.px * per_rho + drag_x;
  vec ay = wall_y - F * a.py * per_rho + drag_y - s->g;
  vec D = vec_load(f->D + at);
  if (diffuse) {
    D = 2 * s->o.delta * s->h * s->c0 / c2 * F * (a.D + b.D);
    vec_store(f->D + at, D);
  }

  const struct sph_state *k = &f->k[stage];
  vec_store(k->x + at, i.u);
  vec_store(k->y + at, i.v);
  vec_store(k->u + at, ax);
  vec_store(k->v + at, ay);
  vec_store(k->rho + at, -rho * (F * a.div + wall_div) + D);

  vec pV = i.p * m * per_rho;
  struct sph_totals *t = &s->cluster_totals[cluster];
  t->viscosity = -vec_sum(m * (i.u * drag_x + i.v * drag_y));
  t->diffusion = -vec_sum(pV * per_rho * D);
  t->walls = n ? -vec_sum(m * (i.u * wall_x + i.v * wall_y) - pV * wall_div) : 0;
  if (bounds) {
    t->acceleration2 = vec_largest(ax * ax + ay * ay);
    t->speed = vec_largest(vec_sqrt(i.u * i.u + i.v * i.v) + s->h * vec_max(a.pi_most, b.pi_most));
  }
}

/* One loop over the clusters for each combination of what meets inside it. */
#define LOOP(name, kernel, diffusion, viscous, bounds)                                             \
  static void name(struct sph *s, int stage, bool diffuse) {                                       \
    _Pragma("omp parallel for schedule(dynamic, 16)") for (size_t c = 0;                           \
                                                           c < s->water_water.n_clusters; c++)     \
        cluster_rates(s, kernel, diffusion, viscous, bounds, stage, diffuse, c);                   \
  }
#define X(d, delta, strength, frozen, help, k)                                                     \
  LOOP(rates_##k##_##d, SPH_KERNEL_##k, SPH_DIFFUSION_##d, false, false)                           \
  LOOP(rates_##k##_##d##_bounds, SPH_KERNEL_##k, SPH_DIFFUSION_##d, false, true)                   \
  LOOP(rates_##k##_##d##_viscous, SPH_KERNEL_##k, SPH_DIFFUSION_##d, true, false)                  \
  LOOP(rates_##k##_##d##_viscous_bounds, SPH_KERNEL_##k, SPH_DIFFUSION_##d, true, true)
#define EACH(k) SPH_DIFFUSIONS(X, k)
SPH_KERNELS(EACH)
#undef X
#undef EACH

static void (*const loops[SPH_N_KERNELS][SPH_N_DIFFUSIONS][2][2])(struct sph *, int, bool) = {
#define X(d, delta, strength, frozen, help, k)                                                     \
  {{rates_##k##_##d, rates_##k##_##d##_bounds},                                                    \
   {rates_##k##_##d##_viscous, rates_##k##_##d##_viscous_bounds}},
#define EACH(k) {SPH_DIFFUSIONS(X, k)},
    SPH_KERNELS(EACH)
#undef X
#undef EACH
};

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
  int d = diffuse ? s->o.diffusion : SPH_DIFFUSION_none;
  TRY(sph_neighbours_update(s));
  sph_pack_water(s);
  s->wall->fill(s);
  if (diffusion_needs_gradient(d)) {
    sph_gradient(s);
    if (s->wall->fill_gradients) s->wall->fill_gradients(s);
  }
  loops[s->o.kernel][d][s->o.alpha > 0][bounds](s, stage, diffuse);
  add_totals(s);
  s->evaluations++;
  return OK;
}
