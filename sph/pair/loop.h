/* The pair loops. A cluster of SPH_LANES particles i stands in the lanes of vector registers and
 * meets the neighbours j of its list one at a time; each i sums over its own j and writes only
 * itself, so the bits do not depend on the number of threads.
 *
 * A pass (rates.c, gradient.c, the fit of ghost.c) is a function of one cluster, compiled once for
 * each kernel. Its other choices do not change inside the loops: a pass makes them at run time, for
 * all lanes at once, or has a loop for each where that was measured to pay (rates.c). */
#pragma once
#include "sph/domain/wall.h"
#include "sph/pair/kernel.h"
#include "sph/sph.h"

/* The neighbours of one kind. */
struct near {
  size_t n;
  const uint32_t *list;
  const struct sph_pack *pack;
  const struct sph_lip *lip; /* what hides some of them, or NULL */
};

SPECIALISE struct near near_of(const struct sph_lists *lists, size_t cluster,
                               const struct sph_pack *pack) {
  struct near a = {.pack = pack};
  a.list = sph_lists_of(lists, cluster, &a.n);
  return a;
}

struct range {
  double per_h2, far2;
  vec cutoff2;
};

SPECIALISE struct range range_of(enum sph_kernel kernel, double h) {
  double cutoff2 = kernel_cutoff2(kernel, h);
  return (struct range){1 / (h * h), cutoff2, (vec){0} + cutoff2};
}

/* A source j as the lanes see it. */
struct pair {
  vec x, y, r2; /* r_j - r_i, m; its square, beyond the support where j is hidden */
  vec e;        /* slope V_j without its constant factor, 0 beyond the support */
};

SPECIALISE struct pair pair_with(enum sph_kernel kernel, const struct range *range,
                                 const struct near *a, const struct sph_pack *j, vec xi, vec yi) {
  struct pair p = {.x = j->x - xi, .y = j->y - yi};
  p.r2 = p.x * p.x + p.y * p.y;
  if (a->lip) p.r2 = sph_lip_hide(a->lip, j->x, j->y, p.r2, range->far2);
  p.e = vec_where_less(kernel_slope(kernel, p.r2 * range->per_h2) * j->V, p.r2, range->cutoff2);
  return p;
}

/* SPH_PASS(name, what, type): a function name(s, n_clusters, how) that calls what(s, kernel, how,
 * cluster) for every cluster, with the kernel of the scheme as a constant; `how` is a const type *.
 */
#define SPH_PASS_OF(k, help, name, what, type)                                                     \
  static void name##_##k(struct sph *s, size_t n_clusters, const type *how) {                      \
    _Pragma("omp parallel for schedule(dynamic, 16)") for (size_t c = 0; c < n_clusters; c++)      \
        what(s, SPH_KERNEL_##k, how, c);                                                           \
  }
#define SPH_PASS_NAME(k, help, name, what, type) name##_##k,
#define SPH_PASS(name, what, type)                                                                 \
  SPH_KERNELS(SPH_PASS_OF, name, what, type)                                                       \
  static void name(struct sph *s, size_t n_clusters, const type *how) {                            \
    static void (*const of[])(struct sph *, size_t,                                                \
                              const type *) = {SPH_KERNELS(SPH_PASS_NAME, name, what, type)};      \
    of[s->scheme.kernel](s, n_clusters, how);                                                      \
  }
