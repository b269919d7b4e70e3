/* What every pair loop is made of: the sources of a list, turned into numbers counted from a
 * cluster in units of h, c0 and rho0, and its targets, in registers. For files that are compiled
 * twice: for floats (with SPH_SINGLE) and for doubles. */
#pragma once
#include "sph/pair/loops.h"
#include "sph/pair/vec.h"

/* As many sources as the loops take at a time, side by side. */
struct turn {
  real x[SPH_SOURCES], y[SPH_SOURCES], u[SPH_SOURCES], v[SPH_SOURCES];
  real p[SPH_SOURCES], V[SPH_SOURCES], rho[SPH_SOURCES];
  real hidden[SPH_SOURCES]; /* the lanes that do not see it, as bits: the pack's `spare` */
} __attribute__((aligned(32)));

/* Their gradients, and one of them. */
struct turn_gradients {
  real x[SPH_SOURCES], y[SPH_SOURCES];
};
typedef double two __attribute__((vector_size(2 * sizeof(double)), may_alias));
typedef real real_two __attribute__((vector_size(2 * sizeof(real)), may_alias));

/* A struct sph_pack, a register at a time; and the same as real numbers. */
enum { PIECE = SPH_VEC_BYTES > 32 ? SPH_VEC_BYTES : 32, IN_PIECE = PIECE / (int)sizeof(double) };
typedef double piece __attribute__((vector_size(PIECE), may_alias));
typedef real real_piece __attribute__((vector_size(IN_PIECE * sizeof(real)), may_alias));
enum { PACKED = sizeof(struct sph_pack) / sizeof(double) };
_Static_assert(sizeof(struct turn) == PACKED * SPH_SOURCES * sizeof(real), "a turn is packs");

/* Where the numbers of a cluster are counted from, and in what: as a struct sph_pack. Densities are
 * counted from rho0. */
enum { X, Y, U, V, P, VOLUME, RHO, SPARE };
struct frame {
  double origin[PACKED], unit[PACKED];
} __attribute__((aligned(64)));

static inline struct frame frame_of(const struct sph *s, double x, double y, double u, double v,
                                    double p) {
  const double h = 1 / s->h, c = 1 / s->c0, pressure = c * c / s->rho0;
  return (struct frame){{x, y, u, v, p, 0, s->rho0, 0},
                        {h, h, c, c, pressure, h * h, 1 / s->rho0, 0}};
}

/* Sources that are in flight between memory and registers: some KB, in the nearest cache. */
enum { BLOCK = 64 };

SPECIALISE void convert(const struct frame *f, const struct sph_near *near, size_t k, real *out) {
  if (k < near->n_ahead) __builtin_prefetch(&near->pack[near->ahead[k]]);
  const piece *a = (const piece *)&near->pack[near->list[k]];
  const piece *origin = (const piece *)f->origin, *unit = (const piece *)f->unit;
  for (int q = 0; q < PACKED / IN_PIECE; q++)
    ((real_piece *)out)[q] = __builtin_convertvector((a[q] - origin[q]) * unit[q], real_piece);
}

/* Who does not see them, where the list says so. */
SPECIALISE void gather_hidden(const struct sph_near *near, size_t from,
                              struct turn block[BLOCK / SPH_SOURCES]) {
  const size_t n = near->n - from < BLOCK ? near->n - from : BLOCK;
  for (size_t k = 0; near->hidden && k < n; k++)
    block[k / SPH_SOURCES].hidden[k % SPH_SOURCES] = (real)near->hidden[from + k];
}

/* The sources from `from` on, as many as there is room for; returns the turns. A source that misses
 * in the last has no volume. */
SPECIALISE size_t gather(const struct frame *of, const struct sph_near *near, size_t from,
                         struct turn block[BLOCK / SPH_SOURCES]) {
  const struct frame f = *of;
  const size_t n = near->n - from < BLOCK ? near->n - from : BLOCK;
  if (SPH_SOURCES == 1) {
    for (size_t k = 0; k < n; k++) convert(&f, near, from + k, block[k].x);
    gather_hidden(near, from, block);
    return n;
  }
  for (size_t k = 0; k < n; k += SPH_SOURCES) {
    real source[2][PACKED] __attribute__((aligned(64)));
    convert(&f, near, from + k, source[0]);
    convert(&f, near, from + (k + 1 < n ? k + 1 : k), source[1]);
    vec_interleave(source[0], source[1], block[k / SPH_SOURCES].x);
  }
  if (n % SPH_SOURCES) block[n / SPH_SOURCES].V[SPH_SOURCES - 1] = 0;
  gather_hidden(near, from, block);
  return (n + SPH_SOURCES - 1) / SPH_SOURCES;
}

/* The gradients of the same sources. */
SPECIALISE void gather_gradients(double unit, const struct sph_near *near, size_t from,
                                 struct turn_gradients block[BLOCK / SPH_SOURCES]) {
  const size_t n = near->n - from < BLOCK ? near->n - from : BLOCK;
  for (size_t k = 0; k < n; k++) {
    if (from + k < near->n_ahead) __builtin_prefetch(&near->G[near->ahead[from + k]]);
    const two *G = (const two *)&near->G[near->list[from + k]];
    const real_two g = __builtin_convertvector(*G * unit, real_two);
    block[k / SPH_SOURCES].x[k % SPH_SOURCES] = g[0];
    block[k / SPH_SOURCES].y[k % SPH_SOURCES] = g[1];
  }
  if (n % SPH_SOURCES) /* no volume makes nothing of it if it is a number */
    block[n / SPH_SOURCES].x[SPH_SOURCES - 1] = block[n / SPH_SOURCES].y[SPH_SOURCES - 1] = 0;
}

/* One part of a cluster's numbers, each for every source of a turn. */
SPECIALISE vec spread(const double *a, int part, double origin, double unit) {
  vec v;
  for (int k = 0; k < SPH_REALS; k++)
    v[k] = (real)((a[part * SPH_TARGETS + k / SPH_SOURCES] - origin) * unit);
  return v;
}

/* The other way, over the sources of a turn. */
SPECIALISE void collect(double *a, int part, vec v) {
  for (int t = 0; t < SPH_TARGETS; t++) {
    a[part * SPH_TARGETS + t] = 0;
    for (int k = 0; k < SPH_SOURCES; k++) a[part * SPH_TARGETS + t] += v[t * SPH_SOURCES + k];
  }
}

SPECIALISE void collect_most(double *a, int part, vec v) {
  for (int t = 0; t < SPH_TARGETS; t++) {
    a[part * SPH_TARGETS + t] = v[t * SPH_SOURCES];
    for (int k = 1; k < SPH_SOURCES; k++)
      a[part * SPH_TARGETS + t] = fmax(a[part * SPH_TARGETS + t], v[t * SPH_SOURCES + k]);
  }
}

/* The targets of a part, and what walls hide from them. */
struct targets {
  vec x, y, u, v, p, rho, Gx, Gy;
  vec own_u, own_v; /* the velocity from rest, where u and v are the cluster's */
  bool blind;       /* to some source */
  vec_bits lane;    /* the bit of each */
};

SPECIALISE void set_blind(struct targets *i, const struct sph_near *near, int part) {
  if (!near->hidden) return;
  i->blind = true;
  for (int k = 0; k < SPH_REALS; k++)
    i->lane[k] = (real_bits)1 << (part * SPH_TARGETS + k / SPH_SOURCES);
}

SPECIALISE void set_places(struct targets *i, const struct sph_targets *of, const struct frame *f,
                           int part) {
  i->x = spread(of->x, part, f->origin[X], f->unit[X]);
  i->y = spread(of->y, part, f->origin[Y], f->unit[Y]);
}

/* What tells whether a pair is in reach (kernel.h), or beyond the support where a target does not
 * see the source. */
SPECIALISE vec hide(const struct targets *i, const struct turn *j, vec reach2, vec cutoff2) {
  const vec_bits bits = __builtin_convertvector(vec_sources(j->hidden), vec_bits) & i->lane;
  return reach2 + (vec)((vec_bits)cutoff2 & (bits != 0));
}

struct pair {
  vec x, y, q2; /* (r_j - r_i)/h; its square */
  vec reach2;   /* kernel_reach2 */
};

SPECIALISE struct pair pair_with(enum sph_kernel kernel, const struct turn *j,
                                 const struct targets *i, vec cutoff2) {
  const vec xj = vec_sources(j->x), yj = vec_sources(j->y);
  struct pair p = {.x = xj - i->x, .y = yj - i->y};
  p.q2 = p.x * p.x + p.y * p.y;
  p.reach2 = kernel_reach2(kernel, p.x, p.y, p.q2);
  if (i->blind) p.reach2 = hide(i, j, p.reach2, cutoff2);
  return p;
}

/* The three that follow are 0 beyond the support. value V_j: */
SPECIALISE vec value_of(enum sph_kernel kernel, const struct pair *p, const struct turn *j,
                        vec cutoff2) {
  const vec w = kernel_value(kernel, p->x, p->y, p->q2);
  return vec_where_less(w * vec_sources(j->V), p->reach2, cutoff2);
}

/* slope V_j: */
SPECIALISE vec slope_of(enum sph_kernel kernel, const struct pair *p, const struct turn *j,
                        vec cutoff2) {
  const vec e = kernel_slope(kernel, p->x, p->y, p->q2);
  return vec_where_less(e * vec_sources(j->V), p->reach2, cutoff2);
}

/* Either is along the pair and the slope is enough, or x and y are the gradient times V_j. */
struct gradient_of_pair {
  vec e, x, y;
};

SPECIALISE struct gradient_of_pair gradient_of(enum sph_kernel kernel, const struct pair *p,
                                               const struct turn *j, vec cutoff2) {
  struct gradient_of_pair g = {.e = slope_of(kernel, p, j, cutoff2)};
  if (kernel_is_radial(kernel)) return g;
  const vec volume = vec_where_less(vec_sources(j->V), p->reach2, cutoff2);
  kernel_gradient(kernel, p->x, p->y, &g.x, &g.y);
  g.x *= volume;
  g.y *= volume;
  return g;
}

/* Adds factor times the gradient to (ax, ay). */
SPECIALISE void add_along(enum sph_kernel kernel, const struct pair *p,
                          const struct gradient_of_pair *g, vec factor, vec *ax, vec *ay) {
  const bool radial = kernel_is_radial(kernel);
  if (radial) factor *= g->e;
  *ax += factor * (radial ? p->x : g->x);
  *ay += factor * (radial ? p->y : g->y);
}

/* (u, v) times the gradient; `approach` is (u, v) . (x, y). */
SPECIALISE vec flow_along(enum sph_kernel kernel, const struct gradient_of_pair *g, vec u, vec v,
                          vec approach) {
  return kernel_is_radial(kernel) ? approach * g->e : u * g->x + v * g->y;
}
