#include "sph/pair/gradient.h"

#include "sph/domain/wall.h"
#include "sph/pair/kernel.h"
#include "sph/pair/moments.h"

static const double smallest_eigenvalue = 0.1;

struct sums {
  vec xx, xy, yy, x, y;
};

SPECIALISE void add_pairs(struct sums *a, const struct sph *s, enum sph_kernel kernel, vec xi,
                          vec yi, vec pi, size_t n, const uint32_t *list,
                          const struct sph_pack *pack, const struct sph_lip *lip) {
  const double per_h2 = 1 / (s->h * s->h), far2 = kernel_cutoff2(s->h);
  const vec cutoff2 = (vec){0} + kernel_cutoff2(s->h);
  struct sums t = *a;
  for (size_t k = 0; k < n; k++) {
    const struct sph_pack *j = &pack[list[k]];
    vec x = j->x - xi, y = j->y - yi, r2 = x * x + y * y;
    if (lip) r2 = sph_lip_hide(lip, j->x, j->y, r2, far2);
    vec e = vec_where_less(kernel_slope(kernel, r2 * per_h2) * j->V, r2, cutoff2);
    vec ex = e * x, ey = e * y, dp = j->p - pi;
    t.xx += ex * x;
    t.xy += ex * y;
    t.yy += ey * y;
    t.x += dp * ex;
    t.y += dp * ey;
  }
  *a = t;
}

SPECIALISE void cluster_gradient(struct sph *s, enum sph_kernel kernel, size_t cluster) {
  const size_t at = cluster * SPH_LANES;
  const struct sph_state *w = &s->f.w;
  vec x = vec_load(w->x + at), y = vec_load(w->y + at);
  vec p = s->c0 * s->c0 * (vec_load(w->rho + at) - s->rho0);
  struct sums a = {0};
  size_t n;
  const uint32_t *list = sph_lists_of(&s->water_water, cluster, &n);
  add_pairs(&a, s, kernel, x, y, p, n, list, s->pack, NULL);
  list = sph_lists_of(&s->water_wall, cluster, &n);
  struct sph_lip lip;
  bool at_lip = n && sph_lip_at(s, x, y, vec_load(s->f.over + at), &lip);
  add_pairs(&a, s, kernel, x, y, p, n, list, s->w.pack, at_lip ? &lip : NULL);

  vec Gx, Gy;
  const double F = kernel_slope_scale(kernel, s->h);
  moments_solve(F * a.xx, F * a.xy, F * a.yy, smallest_eigenvalue, F * a.x, F * a.y, &Gx, &Gy);
  for (size_t l = 0; l < SPH_LANES && at + l < s->f.n; l++) {
    s->pack[at + l].Gx = Gx[l];
    s->pack[at + l].Gy = Gy[l];
  }
}

#define X(k)                                                                                       \
  static void gradient_##k(struct sph *s) {                                                        \
    _Pragma("omp parallel for schedule(dynamic, 16)") for (size_t c = 0;                           \
                                                           c < s->water_water.n_clusters; c++)     \
        cluster_gradient(s, SPH_KERNEL_##k, c);                                                    \
  }
SPH_KERNELS(X)
#undef X

static void (*const gradients[SPH_N_KERNELS])(struct sph *) = {
#define X(k) gradient_##k,
    SPH_KERNELS(X)
#undef X
};

void sph_gradient(struct sph *s) {
  gradients[s->o.kernel](s);
}
