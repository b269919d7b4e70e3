#include "sph/pair/gradient.h"

#include "sph/pair/loop.h"
#include "sph/pair/moments.h"

static const double smallest_eigenvalue = 0.1;

struct sums {
  vec xx, xy, yy, x, y;
};

SPECIALISE void add_pairs(struct sums *a, enum sph_kernel kernel, double h, vec xi, vec yi, vec pi,
                          const struct near *near) {
  const struct range range = range_of(kernel, h);
  struct sums t = *a;
  for (size_t k = 0; k < near->n; k++) {
    const struct sph_pack *j = &near->pack[near->list[k]];
    struct pair q = pair_with(kernel, &range, near, j, xi, yi);
    vec ex = q.e * q.x, ey = q.e * q.y, dp = j->p - pi;
    t.xx += ex * q.x;
    t.xy += ex * q.y;
    t.yy += ey * q.y;
    t.x += dp * ex;
    t.y += dp * ey;
  }
  *a = t;
}

SPECIALISE void cluster_gradient(struct sph *s, enum sph_kernel kernel, const void *how,
                                 size_t cluster) {
  (void)how;
  const size_t at = cluster * SPH_LANES;
  const struct sph_state *w = &s->f.w;
  vec x = vec_load(w->x + at), y = vec_load(w->y + at), p = vec_load(s->f.p + at);
  struct sums a = {0};
  struct near water = near_of(&s->water_water, cluster, s->pack);
  add_pairs(&a, kernel, s->h, x, y, p, &water);
  struct near walls = near_of(&s->water_wall, cluster, s->w.pack);
  struct sph_lip lip;
  if (walls.n && sph_lip_at(s, x, y, vec_load(s->f.over + at), &lip)) walls.lip = &lip;
  add_pairs(&a, kernel, s->h, x, y, p, &walls);

  vec Gx, Gy;
  const double F = kernel_slope_scale(kernel, s->h);
  moments_solve(F * a.xx, F * a.xy, F * a.yy, smallest_eigenvalue, F * a.x, F * a.y, &Gx, &Gy);
  for (size_t l = 0; l < SPH_LANES && at + l < s->f.n; l++) {
    s->pack[at + l].Gx = Gx[l];
    s->pack[at + l].Gy = Gy[l];
  }
}

SPH_PASS(gradient, cluster_gradient, void)

void sph_gradient(struct sph *s) {
  gradient(s, s->water_water.n_clusters, NULL);
}
