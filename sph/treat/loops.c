/* Compiled twice, like pair/loops.c. */
#include "sph/treat/loops.h"

#include "sph/pair/loop.h"
#include "sph/pair/momentum.h"

enum sum { MIX, CROWD, TENSION };

struct choice {
  enum sum sum;
  enum sph_kernel kernel;
  enum sph_momentum momentum;
  int power;     /* of f */
  real crowding; /* of f^power */
  real per_W;    /* 1/W(dx) */
};

struct vectors {
  vec x, y;
};

/* f^power, and 0 beyond the support, where the kernel's value is anything. */
SPECIALISE vec crowding_of(const struct choice *o, const struct pair *q, vec cutoff2) {
  const vec value = kernel_value(o->kernel, q->x, q->y, q->q2);
  const vec f = vec_where_less(value, q->reach2, cutoff2) * o->per_W;
  vec product = f;
  for (int k = 1; k < o->power; k++) product *= f;
  return product;
}

/* V_ij over V_j; densities are counted from rho0. */
SPECIALISE vec share_of(const struct turn *j, const struct targets *i) {
  const vec rho = vec_sources(j->rho);
  return (rho + (real)1) * (real)2 / (rho + i->rho + (real)2);
}

SPECIALISE void add_vectors(const struct choice o, const struct targets *i,
                            const struct turn *block, size_t n, struct vectors *sums) {
  struct vectors a = *sums;
  const vec cutoff2 = vec_of(kernel_cutoff2(o.kernel)), zero = {0};
  for (const struct turn *j = block; j < block + n; j++) {
    const struct pair q = pair_with(o.kernel, j, i, cutoff2);
    switch (o.sum) {
    case MIX: {
      const vec w = value_of(o.kernel, &q, j, cutoff2) * share_of(j, i);
      a.x += w * (vec_sources(j->u) - i->u);
      a.y += w * (vec_sources(j->v) - i->v);
      break;
    }
    case CROWD: {
      const vec e = slope_of(o.kernel, &q, j, cutoff2) * share_of(j, i);
      const vec w = e * ((real)1 + o.crowding * crowding_of(&o, &q, cutoff2));
      a.x += w * q.x;
      a.y += w * q.y;
      break;
    }
    case TENSION: {
      const struct gradient_of_pair g = gradient_of(o.kernel, &q, j, cutoff2);
      const vec pj = vec_sources(j->p), most = vec_max(i->p, pj);
      const vec ri = i->rho + (real)1, rj = vec_sources(j->rho) + (real)1;
      const vec p = momentum_pressure(o.momentum, i->p, pj, ri, rj) * crowding_of(&o, &q, cutoff2);
      add_along(o.kernel, &q, &g, vec_where_less(p, most, zero), &a.x, &a.y);
      break;
    }
    }
  }
  *sums = a;
}

SPECIALISE void sum_vectors(struct choice o, const struct sph *s, const struct sph_targets *of,
                            const struct sph_near *near, struct sph_vector_sums *sums) {
  const struct frame f = frame_of(s, of->x[0], of->y[0], of->u[0], of->v[0], 0);
  const real first = (real)(s->dx / s->h);
  o.per_W = 1 / kernel_value(o.kernel, vec_of(first), (vec){0}, vec_of(first * first))[0];
  struct targets i[SPH_PARTS] = {0};
  struct vectors a[SPH_PARTS] = {0};
  for (int part = 0; part < SPH_PARTS; part++) {
    set_places(&i[part], of, &f, part);
    set_blind(&i[part], near, part);
    i[part].u = spread(of->u, part, f.origin[U], f.unit[U]);
    i[part].v = spread(of->v, part, f.origin[V], f.unit[V]);
    i[part].p = spread(of->p, part, f.origin[P], f.unit[P]);
    i[part].rho = spread(of->rho, part, f.origin[RHO], f.unit[RHO]);
  }
  struct turn block[BLOCK / SPH_SOURCES];
  for (size_t from = 0; from < near->n; from += BLOCK) {
    const size_t n = gather(&f, near, from, block);
    for (int part = 0; part < SPH_PARTS; part++) add_vectors(o, &i[part], block, n, &a[part]);
  }
  for (int part = 0; part < SPH_PARTS; part++) {
    collect(sums->x, part, a[part].x);
    collect(sums->y, part, a[part].y);
  }
}

#define LOOPS(k, help)                                                                             \
  static void mix_##k(const struct sph *s, const struct sph_targets *i,                            \
                      const struct sph_near *near, struct sph_vector_sums *sums) {                 \
    sum_vectors((struct choice){.sum = MIX, .kernel = SPH_KERNEL_##k}, s, i, near, sums);          \
  }                                                                                                \
  static void crowd_##k(const struct sph *s, double crowding, const struct sph_targets *i,         \
                        const struct sph_near *near, struct sph_vector_sums *sums) {               \
    sum_vectors(                                                                                   \
        (struct choice){                                                                           \
            .sum = CROWD, .kernel = SPH_KERNEL_##k, .power = 4, .crowding = (real)crowding},       \
        s, i, near, sums);                                                                         \
  }                                                                                                \
  static void tension_##k(const struct sph *s, const struct sph_targets *i,                        \
                          const struct sph_near *near, struct sph_vector_sums *sums) {             \
    sum_vectors((struct choice){.sum = TENSION,                                                    \
                                .kernel = SPH_KERNEL_##k,                                          \
                                .momentum = (enum sph_momentum)s->scheme.momentum,                 \
                                .power = s->scheme.tensile_power},                                 \
                s, i, near, sums);                                                                 \
  }
SPH_KERNELS(LOOPS)

#ifdef SPH_SINGLE
const struct sph_treat_loops sph_treat_loops_single[SPH_KERNEL_COUNT] = {
#else
const struct sph_treat_loops sph_treat_loops_double[SPH_KERNEL_COUNT] = {
#endif
#define ROW(k, help) {mix_##k, crowd_##k, tension_##k},
    SPH_KERNELS(ROW)
#undef ROW
};
