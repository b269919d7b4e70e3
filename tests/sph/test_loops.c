/* What the pair loops are given, and what they make of it: lists against all pairs while water is
 * thrown about, and the loops of the paper's forms against the one of all others. */
#include "tests/test.h"

#include "sph/domain/wall.h"
#include "sph/pair/continuity.h"
#include "sph/pair/gradient.h"
#include "sph/pair/loops.h"
#include "tests/sph/pool.h"

/* ---- lists ---- */

/* How many of `n` sources from `first` on are within the support of a particle of the cluster, and
 * not listed once: counted into *missing. Returns how many are. */
static size_t count_near(const struct sph *s, const struct sph_lists *lists, size_t cluster,
                         const struct sph_pack *pack, size_t first, size_t n, size_t *missing) {
  size_t length, near = 0;
  const uint32_t *list = sph_lists_of(lists, cluster, &length);
  unsigned char *times = calloc(first + n + 1, 1);
  for (size_t k = 0; k < length; k++) times[list[k] < first + n ? list[k] : first + n]++;
  for (size_t i = cluster * SPH_LANES; i < (cluster + 1) * SPH_LANES && i < s->f.n; i++)
    for (size_t j = first; j < first + n; j++) {
      const double x = pack[j].x - s->f.w.x[i], y = pack[j].y - s->f.w.y[i];
      if (x * x + y * y >= s->support * s->support) continue;
      *missing += times[j] != 1;
      near++;
    }
  free(times);
  return near;
}

/* Every source within the support, of water, its images and walls, is in the list, once. */
static void expect_lists(const struct sph *s, size_t *pairs, size_t *images, size_t *walls) {
  size_t missing = 0;
  for (size_t c = 0; c < s->water_water.n_clusters; c++) {
    *pairs += count_near(s, &s->water_water, c, s->pack, 0, s->f.n, &missing);
    *images += count_near(s, &s->water_water, c, s->pack, s->f.room, s->period.copies.n, &missing);
    *walls += count_near(s, &s->water_wall, c, s->w.pack, 0, s->w.n, &missing);
  }
  EXPECT(missing == 0);
}

static void run_violently(const char *head, const char *walls, bool periodic) {
  char run[100];
  size_t pairs = 0, images = 0, on_walls = 0;
  snprintf(run, sizeof run, "resolution: 12, walls: %s", walls);
  struct case_file *c = pool_case(head, run);
  struct sph *s = pool_create(c);
  pool_shake(s, 0.2, 0.1 * s->c0, 0);
  for (int k = 0; k < 150; k++) {
    EXPECT_OK(sph_remove_outside(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    if (k % 3 == 0) expect_lists(s, &pairs, &images, &on_walls);
    EXPECT_OK(sph_step(s, sph_timestep(s, 1e9)));
  }
  EXPECT(s->rebuilds > 5);
  EXPECT(pairs > 50 * 10 * s->f.n && on_walls > 50 * s->f.n / 10);
  EXPECT((images > 0) == periodic);
  sph_destroy(s);
  case_destroy(c);
}

static void test_lists_hold_every_pair_while_water_is_thrown_about(void) {
  run_violently(POOL_DAM, "ghost", false);
  run_violently("title: layer\nscales: {H: 1}\n"
                "tank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]], sides: periodic}\n"
                "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]]}\n" POOL_TIMES,
                "mirror", true);
}

/* ---- loops ---- */

/* Sums of the magnitudes of what is summed, and the largest of what bounds the step. */
struct sizes {
  double p, div, D, drag, pi;
};

static void add_sizes(const struct sph *s, size_t i, size_t j, struct sizes *m) {
  const struct sph_pack *a = &s->pack[i], *b = &s->pack[j];
  const enum sph_kernel kernel = (enum sph_kernel)s->scheme.kernel;
  const double x = fabs(b->x - a->x) / s->h, y = fabs(b->y - a->y) / s->h, q2 = x * x + y * y;
  if (q2 > pow(kernel_support(kernel), 2)) return;
  const double e = kernel_slope(kernel, vec_of(x), vec_of(y), vec_of(q2))[0] * b->V / (s->h * s->h);
  const double p = (fabs(a->p) + fabs(b->p)) / (s->rho0 * s->c0 * s->c0);
  const double flow = (fabs(b->u - a->u) * x + fabs(b->v - a->v) * y) / s->c0;
  const double G =
      (fabs(s->G[i].x) + fabs(s->G[j].x)) * x + (fabs(s->G[i].y) + fabs(s->G[j].y)) * y;
  m->p += p * e * sqrt(q2);
  m->div += flow * e;
  m->D += (p * fmax(1, sqrt(q2)) + G * s->h / (s->rho0 * s->c0 * s->c0)) * e;
  if (i == j) return;
  m->drag += flow / sqrt(q2) * e;
  m->pi = fmax(m->pi, flow / q2);
}

/* The worst difference of the two loops, over 2^-53 or 2^-24 and the magnitudes. */
static double compare(struct sph *s, size_t cluster, enum sph_diffusion d, double eps) {
  const struct sph_targets i = sph_targets_of(s, cluster);
  struct sph_near water = sph_near_of(&s->water_water, cluster, s->pack);
  const struct sph_rates_how how = {d, true, 1e-24};
  struct sph_rates_sums sums[2];
  double worst = 0;
  water.G = s->G;
  for (int k = 0; k < 2; k++) {
    /* the same flux, by the loop of all forms */
    s->scheme.continuity = k ? SPH_CONTINUITY_reference : SPH_CONTINUITY_divergence;
    sph_loops_for(s, &i)->rates(s, &how, &i, &water, &sums[k]);
  }
  for (size_t l = 0, at = cluster * SPH_LANES; l < SPH_LANES && at + l < s->f.n; l++) {
    struct sizes m = {0};
    for (size_t k = 0; k < water.n; k++) add_sizes(s, at + l, water.list[k], &m);
#define WORSE(q, size) worst = fmax(worst, fabs(sums[1].q[l] - sums[0].q[l]) / (eps * (size)))
    WORSE(px, m.p);
    WORSE(py, m.p);
    WORSE(div, m.div);
    WORSE(D, m.D);
    WORSE(vx, m.drag);
    WORSE(vy, m.drag);
    WORSE(pi_most, m.pi);
#undef WORSE
  }
  return worst;
}

/* A list has some hundred sources, each with a rounding when it is added and a few dozen before: at
 * worst they add up. */
static void test_loops_of_the_paper_are_the_loop_of_all_forms(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 16, alpha: 0.1");
  for (int kernel = 0; kernel < SPH_KERNEL_COUNT; kernel++)
    for (int d = 0; d < SPH_DIFFUSION_COUNT; d++)
      for (int precision = 0; precision < 2; precision++) {
        struct sph_scheme o = *(const struct sph_scheme *)c->runs[0].options;
        struct sph *s;
        double worst = 0;
        o.kernel = kernel;
        o.diffusion = d;
        o.precision = precision;
        EXPECT_OK(sph_create(c, 16, &o, &s));
        pool_shake(s, 0.3, 1, 1e3);
        EXPECT_OK(sph_neighbours_update(s));
        sph_pack_water(s);
        s->wall->fill(s);
        if (diffusion_needs_gradient((enum sph_diffusion)d)) sph_gradient(s);
        for (size_t k = 0; k < s->water_water.n_clusters; k++)
          worst = fmax(worst, compare(s, k, (enum sph_diffusion)d, precision ? 1.1e-16 : 6e-8));
        EXPECT(worst < 150);
        sph_destroy(s);
      }
  case_destroy(c);
}

int main(void) {
  RUN(test_lists_hold_every_pair_while_water_is_thrown_about);
  RUN(test_loops_of_the_paper_are_the_loop_of_all_forms);
  return TEST_RESULT;
}
