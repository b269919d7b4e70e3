/* Compiled twice: for floats (with SPH_SINGLE) and for doubles. */
#include "sph/pair/loops.h"

#include "sph/pair/continuity.h"
#include "sph/pair/loop.h"
#include "sph/pair/momentum.h"
#include "sph/pair/viscosity.h"

/* The rates ---------------------------------------------------------------------------------- */

struct rates {
  vec px, py, div, vx, vy, D, pi_most;
};

struct rates_choice {
  enum sph_kernel kernel;
  enum sph_momentum momentum;
  enum sph_continuity continuity;
  enum sph_viscosity viscosity;
  enum sph_diffusion diffusion;
  bool viscous, bounds;
  real soft2;
};

SPECIALISE void add_rates(const struct rates_choice o, const struct targets *i,
                          const struct turn *block, const struct turn_gradients *G, size_t n,
                          struct rates *sums) {
  struct rates a = *sums;
  const vec cutoff2 = vec_of(kernel_cutoff2(o.kernel)), zero = {0};
  const vec ri = i->rho + (real)1;
  for (const struct turn *j = block; j < block + n; j++) {
    const struct pair q = pair_with(o.kernel, j, i, cutoff2);
    const struct gradient_of_pair g = gradient_of(o.kernel, &q, j, cutoff2);
    const vec e = g.e, pj = vec_sources(j->p), rj = vec_sources(j->rho) + (real)1;
    const vec u = vec_sources(j->u) - i->u, v = vec_sources(j->v) - i->v;
    const vec approach = u * q.x + v * q.y;
    const vec flow = flow_along(o.kernel, &g, u, v, approach);
    const vec own = flow_along(o.kernel, &g, i->own_u, i->own_v, i->own_u * q.x + i->own_v * q.y);
    add_along(o.kernel, &q, &g, momentum_pressure(o.momentum, i->p, pj, ri, rj), &a.px, &a.py);
    a.div += continuity_flux(o.continuity, flow, own, ri, rj);
    if (o.viscous) {
      const vec drag = viscosity_drag(o.viscosity, approach, q.q2, ri, rj) * e;
      a.vx += drag * q.x;
      a.vy += drag * q.y;
    }
    if (o.bounds) { /* what has no volume is not there */
      vec pi = vec_where_less(vec_abs(approach) / (q.q2 + o.soft2), q.reach2, cutoff2);
      a.pi_most = vec_max(a.pi_most, vec_where_less(pi, zero, vec_sources(j->V)));
    }
    if (o.diffusion != SPH_DIFFUSION_none) {
      vec Gx = zero, Gy = zero;
      if (diffusion_needs_gradient(o.diffusion)) {
        Gx = vec_sources(G[j - block].x) + i->Gx;
        Gy = vec_sources(G[j - block].y) + i->Gy;
      }
      a.D += diffusion_psi(o.diffusion, pj - i->p, q.x, q.y, q.q2, Gx, Gy) * e;
    }
  }
  *sums = a;
}

/* With the paper's forms each kernel and diffusion, with and without viscosity and bounds, has a
 * loop of its own, and a function of its own around it: what else a function does takes registers
 * from its loop. Other forms are chosen inside one loop, with which whole runs of the paper's take
 * a tenth (without diffusion) to a quarter (Antuono) longer. */
typedef void add_rates_function(real soft2, const struct targets *i, const struct turn *block,
                                const struct turn_gradients *G, size_t n, struct rates *sums);

#define OWN(kernel_, diffusion_, viscous_, bounds_)                                                \
  __attribute__((noinline)) static void add_##kernel_##_##diffusion_##_##viscous_##bounds_(        \
      real soft2, const struct targets *i, const struct turn *block,                               \
      const struct turn_gradients *G, size_t n, struct rates *sums) {                              \
    const struct rates_choice o = {.kernel = SPH_KERNEL_##kernel_,                                 \
                                   .momentum = SPH_MOMENTUM_plus,                                  \
                                   .continuity = SPH_CONTINUITY_divergence,                        \
                                   .viscosity = SPH_VISCOSITY_artificial,                          \
                                   .diffusion = SPH_DIFFUSION_##diffusion_,                        \
                                   .viscous = viscous_,                                            \
                                   .bounds = bounds_,                                              \
                                   .soft2 = soft2};                                                \
    add_rates(o, i, block, G, n, sums);                                                            \
  }
#define OWN_OF_DIFFUSION(d, help, k) OWN(k, d, 0, 0) OWN(k, d, 0, 1) OWN(k, d, 1, 0) OWN(k, d, 1, 1)
#define OWN_OF_KERNEL(k, help)       SPH_DIFFUSIONS(OWN_OF_DIFFUSION, k)
SPH_KERNELS(OWN_OF_KERNEL)

/* By kernel, diffusion, viscosity and bounds. */
#define ROW_OF_DIFFUSION(d, help, k)                                                               \
  [SPH_DIFFUSION_##                                                                                \
      d] = {{add_##k##_##d##_00, add_##k##_##d##_01}, {add_##k##_##d##_10, add_##k##_##d##_11}},
#define ROW_OF_KERNEL(k, help) [SPH_KERNEL_##k] = {SPH_DIFFUSIONS(ROW_OF_DIFFUSION, k)},
static add_rates_function *const own_loop[SPH_KERNEL_COUNT][SPH_DIFFUSION_COUNT][2][2] = {
    SPH_KERNELS(ROW_OF_KERNEL)};
#undef OWN
#undef OWN_OF_DIFFUSION
#undef OWN_OF_KERNEL
#undef ROW_OF_DIFFUSION
#undef ROW_OF_KERNEL

SPECIALISE void choose_rates(struct rates_choice o, const struct targets *i,
                             const struct turn *block, const struct turn_gradients *G, size_t n,
                             struct rates *sums) {
  if (o.momentum == SPH_MOMENTUM_plus && o.continuity == SPH_CONTINUITY_divergence &&
      o.viscosity == SPH_VISCOSITY_artificial) {
    own_loop[o.kernel][o.diffusion][o.viscous][o.bounds](o.soft2, i, block, G, n, sums);
    return;
  }
  o.bounds = true;
  add_rates(o, i, block, G, n, sums);
}

SPECIALISE void sum_rates(enum sph_kernel kernel, const struct sph *s,
                          const struct sph_rates_how *how, const struct sph_targets *of,
                          const struct sph_near *near, struct sph_rates_sums *sums) {
  const struct frame f = frame_of(s, of->x[0], of->y[0], of->u[0], of->v[0], 0);
  const struct rates_choice o = {.kernel = kernel,
                                 .momentum = (enum sph_momentum)s->scheme.momentum,
                                 .continuity = (enum sph_continuity)s->scheme.continuity,
                                 .viscosity = (enum sph_viscosity)s->scheme.viscosity,
                                 .diffusion = how->diffusion,
                                 .viscous = s->scheme.alpha > 0,
                                 .bounds = how->bounds,
                                 .soft2 = (real)how->soft2};
  const double gradient = s->h * f.unit[P];
  struct targets i[SPH_PARTS] = {0};
  struct rates a[SPH_PARTS] = {0};
  for (int part = 0; part < SPH_PARTS; part++) {
    set_places(&i[part], of, &f, part);
    set_blind(&i[part], near, part);
    i[part].u = spread(of->u, part, f.origin[U], f.unit[U]);
    i[part].v = spread(of->v, part, f.origin[V], f.unit[V]);
    i[part].own_u = spread(of->u, part, 0, f.unit[U]);
    i[part].own_v = spread(of->v, part, 0, f.unit[V]);
    i[part].p = spread(of->p, part, f.origin[P], f.unit[P]);
    i[part].rho = spread(of->rho, part, f.origin[RHO], f.unit[RHO]);
    i[part].Gx = spread(of->Gx, part, 0, gradient);
    i[part].Gy = spread(of->Gy, part, 0, gradient);
  }
  struct turn block[BLOCK / SPH_SOURCES];
  struct turn_gradients G[BLOCK / SPH_SOURCES];
  for (size_t from = 0; from < near->n; from += BLOCK) {
    const size_t n = gather(&f, near, from, block);
    if (diffusion_needs_gradient(o.diffusion)) gather_gradients(gradient, near, from, G);
    for (int part = 0; part < SPH_PARTS; part++) choose_rates(o, &i[part], block, G, n, &a[part]);
  }
  for (int part = 0; part < SPH_PARTS; part++) {
    collect(sums->px, part, a[part].px);
    collect(sums->py, part, a[part].py);
    collect(sums->div, part, a[part].div);
    collect(sums->vx, part, a[part].vx);
    collect(sums->vy, part, a[part].vy);
    collect(sums->D, part, a[part].D);
    collect_most(sums->pi_most, part, a[part].pi_most);
  }
}

/* The gradient ------------------------------------------------------------------------------- */

struct gradient {
  vec xx, xy, yy, x, y;
};

SPECIALISE void add_gradient(enum sph_kernel kernel, const struct targets *i,
                             const struct turn *block, size_t n, struct gradient *sums) {
  struct gradient a = *sums;
  const vec cutoff2 = vec_of(kernel_cutoff2(kernel));
  for (const struct turn *j = block; j < block + n; j++) {
    const struct pair q = pair_with(kernel, j, i, cutoff2);
    const vec e = slope_of(kernel, &q, j, cutoff2);
    const vec ex = e * q.x, ey = e * q.y, dp = vec_sources(j->p) - i->p;
    a.xx += ex * q.x;
    a.xy += ex * q.y;
    a.yy += ey * q.y;
    a.x += dp * ex;
    a.y += dp * ey;
  }
  *sums = a;
}

SPECIALISE void sum_gradient(enum sph_kernel kernel, const struct sph *s,
                             const struct sph_targets *of, const struct sph_near *near,
                             struct sph_gradient_sums *sums) {
  const struct frame f = frame_of(s, of->x[0], of->y[0], 0, 0, of->p[0]);
  struct targets i[SPH_PARTS] = {0};
  struct gradient a[SPH_PARTS] = {0};
  for (int part = 0; part < SPH_PARTS; part++) {
    set_places(&i[part], of, &f, part);
    set_blind(&i[part], near, part);
    i[part].p = spread(of->p, part, f.origin[P], f.unit[P]);
  }
  struct turn block[BLOCK / SPH_SOURCES];
  for (size_t from = 0; from < near->n; from += BLOCK) {
    const size_t n = gather(&f, near, from, block);
    for (int part = 0; part < SPH_PARTS; part++) add_gradient(kernel, &i[part], block, n, &a[part]);
  }
  for (int part = 0; part < SPH_PARTS; part++) {
    collect(sums->xx, part, a[part].xx);
    collect(sums->xy, part, a[part].xy);
    collect(sums->yy, part, a[part].yy);
    collect(sums->x, part, a[part].x);
    collect(sums->y, part, a[part].y);
  }
}

/* The diffusion by itself -------------------------------------------------------------------- */

struct diffusion {
  vec D, weight;
};

SPECIALISE void add_diffusion(enum sph_kernel kernel, enum sph_diffusion d, const struct targets *i,
                              const struct turn *block, size_t n, struct diffusion *sums) {
  struct diffusion a = *sums;
  const vec cutoff2 = vec_of(kernel_cutoff2(kernel)), zero = {0};
  for (const struct turn *j = block; j < block + n; j++) {
    const struct pair q = pair_with(kernel, j, i, cutoff2);
    const vec e = slope_of(kernel, &q, j, cutoff2), dp = vec_sources(j->p) - i->p;
    a.D += diffusion_psi(d, dp, q.x, q.y, q.q2, zero, zero) * e;
    const vec weight = diffusion_weight(d, kernel, kernel_slope(kernel, q.x, q.y, q.q2), q.q2);
    a.weight += vec_where_less(weight * vec_sources(j->V), q.reach2, cutoff2);
  }
  *sums = a;
}

SPECIALISE void choose_diffusion(enum sph_kernel kernel, enum sph_diffusion d,
                                 const struct targets *i, const struct turn *block, size_t n,
                                 struct diffusion *sums) {
#define CASE(name, help)                                                                           \
  case SPH_DIFFUSION_##name:                                                                       \
    add_diffusion(kernel, SPH_DIFFUSION_##name, i, block, n, sums);                                \
    break;
  switch (d) { SPH_DIFFUSIONS(CASE) }
#undef CASE
}

SPECIALISE void sum_diffusion(enum sph_kernel kernel, const struct sph *s,
                              const struct sph_targets *of, const struct sph_near *near,
                              struct sph_diffusion_sums *sums) {
  const struct frame f = frame_of(s, of->x[0], of->y[0], 0, 0, of->p[0]);
  struct targets i[SPH_PARTS] = {0};
  struct diffusion a[SPH_PARTS] = {0};
  for (int part = 0; part < SPH_PARTS; part++) {
    set_places(&i[part], of, &f, part);
    set_blind(&i[part], near, part);
    i[part].p = spread(of->p, part, f.origin[P], f.unit[P]);
  }
  struct turn block[BLOCK / SPH_SOURCES];
  for (size_t from = 0; from < near->n; from += BLOCK) {
    const size_t n = gather(&f, near, from, block);
    for (int part = 0; part < SPH_PARTS; part++)
      choose_diffusion(kernel, (enum sph_diffusion)s->scheme.diffusion, &i[part], block, n,
                       &a[part]);
  }
  for (int part = 0; part < SPH_PARTS; part++) {
    collect(sums->D, part, a[part].D);
    collect(sums->weight, part, a[part].weight);
  }
}

/* The fit of a plane -------------------------------------------------------------------------- */

struct fit {
  vec w, x, y, xx, xy, yy, p, px, py, u, ux, uy, v, vx, vy, speed2;
};

enum weight { VALUE, SLOPE, HAT };

/* A hat counts what the target sees and has a volume; `radius2` is its square. */
SPECIALISE vec weight_in_fit(enum weight weight, enum sph_kernel kernel, const struct turn *j,
                             const struct targets *i, vec radius2) {
  const vec cutoff2 = vec_of(kernel_cutoff2(kernel)), one = vec_of(1), zero = {0};
  const struct pair q = pair_with(kernel, j, i, cutoff2);
  switch (weight) {
  case VALUE:
    return value_of(kernel, &q, j, cutoff2);
  case SLOPE:
    return slope_of(kernel, &q, j, cutoff2);
  case HAT:
    break;
  }
  vec far2 = q.q2;
  if (i->blind) far2 = hide(i, j, q.q2, radius2);
  return vec_where_less(vec_where_less(one, far2, radius2), zero, vec_sources(j->V));
}

SPECIALISE void add_fit(enum weight weight, enum sph_kernel kernel, const struct targets *i,
                        vec radius2, const struct turn *block, size_t n, struct fit *sums) {
  struct fit a = *sums;
  for (const struct turn *j = block; j < block + n; j++) {
    const vec x = vec_sources(j->x) - i->x, y = vec_sources(j->y) - i->y;
    const vec w = weight_in_fit(weight, kernel, j, i, radius2);
    const vec wx = w * x, wy = w * y;
    const vec p = vec_sources(j->p), u = vec_sources(j->u), v = vec_sources(j->v);
    a.w += w;
    a.x += wx;
    a.y += wy;
    a.xx += wx * x;
    a.xy += wx * y;
    a.yy += wy * y;
    a.p += w * p;
    a.px += wx * p;
    a.py += wy * p;
    a.u += w * u;
    a.ux += wx * u;
    a.uy += wy * u;
    a.v += w * v;
    a.vx += wx * v;
    a.vy += wy * v;
    a.speed2 += w * (u * u + v * v);
  }
  *sums = a;
}

SPECIALISE void sum_fit(enum weight weight, enum sph_kernel kernel, const struct sph *s,
                        const struct sph_targets *of, const struct sph_near *near,
                        struct sph_fit_sums *sums) {
  const struct sph_pack zero = {0}, *first = near->n ? &near->pack[near->list[0]] : &zero;
  const struct frame f = frame_of(s, of->x[0], of->y[0], first->u, first->v, first->p);
  /* a lattice may have neighbours on the edge, which count */
  const double radius = s->scheme.derivative_radius * (1 + 1e-5);
  const vec radius2 = vec_of((real)(radius * radius));
  struct targets i[SPH_PARTS] = {0};
  struct fit a[SPH_PARTS] = {0};
  for (int part = 0; part < SPH_PARTS; part++) {
    set_places(&i[part], of, &f, part);
    set_blind(&i[part], near, part);
  }
  struct turn block[BLOCK / SPH_SOURCES];
  for (size_t from = 0; from < near->n; from += BLOCK) {
    const size_t n = gather(&f, near, from, block);
    for (int part = 0; part < SPH_PARTS; part++)
      add_fit(weight, kernel, &i[part], radius2, block, n, &a[part]);
  }
  for (int part = 0; part < SPH_PARTS; part++) {
#define SUM(q) collect(sums->q, part, a[part].q);
    SUM(w)
    SUM(x)
    SUM(y)
    SUM(xx)
    SUM(xy) SUM(yy) SUM(p) SUM(px) SUM(py) SUM(u) SUM(ux) SUM(uy) SUM(v) SUM(vx) SUM(vy) SUM(speed2)
#undef SUM
  }
}

/* One of each for every kernel ------------------------------------------------------------------
 */

#define LOOPS(k, help)                                                                             \
  static void rates_##k(const struct sph *s, const struct sph_rates_how *how,                      \
                        const struct sph_targets *i, const struct sph_near *near,                  \
                        struct sph_rates_sums *sums) {                                             \
    sum_rates(SPH_KERNEL_##k, s, how, i, near, sums);                                              \
  }                                                                                                \
  static void gradient_##k(const struct sph *s, const struct sph_targets *i,                       \
                           const struct sph_near *near, struct sph_gradient_sums *sums) {          \
    sum_gradient(SPH_KERNEL_##k, s, i, near, sums);                                                \
  }                                                                                                \
  static void diffusion_##k(const struct sph *s, const struct sph_targets *i,                      \
                            const struct sph_near *near, struct sph_diffusion_sums *sums) {        \
    sum_diffusion(SPH_KERNEL_##k, s, i, near, sums);                                               \
  }                                                                                                \
  static void fit_##k(const struct sph *s, const struct sph_targets *i,                            \
                      const struct sph_near *near, struct sph_fit_sums *sums) {                    \
    sum_fit(VALUE, SPH_KERNEL_##k, s, i, near, sums);                                              \
  }                                                                                                \
  static void slope_fit_##k(const struct sph *s, const struct sph_targets *i,                      \
                            const struct sph_near *near, struct sph_fit_sums *sums) {              \
    sum_fit(SLOPE, SPH_KERNEL_##k, s, i, near, sums);                                              \
  }                                                                                                \
  static void hat_fit_##k(const struct sph *s, const struct sph_targets *i,                        \
                          const struct sph_near *near, struct sph_fit_sums *sums) {                \
    sum_fit(HAT, SPH_KERNEL_##k, s, i, near, sums);                                                \
  }
SPH_KERNELS(LOOPS)

#ifdef SPH_SINGLE
const struct sph_loops sph_loops_single[SPH_KERNEL_COUNT] = {
#else
const struct sph_loops sph_loops_double[SPH_KERNEL_COUNT] = {
#endif
#define ROW(k, help) {rates_##k, gradient_##k, diffusion_##k, fit_##k, slope_fit_##k, hat_fit_##k},
    SPH_KERNELS(ROW)
#undef ROW
};
