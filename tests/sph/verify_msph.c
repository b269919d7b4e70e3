/* The dam break of the thesis (4.3) by mSPH: what smoothing every n steps does to noise and front.
 * Runs without treatment are chaos after the impact, so that medians are compared. */
#include "sph/pair/kernel.h"
#include "sph/pair/sums.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

#define TANK                                                                                       \
  "title: dam break of the thesis\nscales: {H: 0.6}\n"                                             \
  "tank: {walls: [[[0, 4 H], [0, 0], [5.366 H, 0], [5.366 H, 4 H]]]}\n"                            \
  "water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]], pressure: hydrostatic}\n" POOL_TIMES

/* 64 x 32 particles, c = sqrt(700) m/s, h = dx/0.75, c dt/h = 0.8. */
#define COMMON                                                                                     \
  "resolution: 32, kernel: cubic, c0: 26.457513, alpha: 0, diffusion: none, integrator: rk4, "     \
  "dt: 7.559e-4, "

enum { U, V, AX, AY, P, FIELDS };
enum { INSTANTS = 9, STEPS = 40, MOST = 20000 };

struct outcome {
  double arrival;                 /* of the front at the right wall, s */
  double Q;                       /* median of mean |du/dt|^2/g^2, 0.7 to 1.5 s */
  double noise[FIELDS][INSTANTS]; /* medians around 0.7, 0.8, ... 1.5 s */
};

static int rising(const void *a, const void *b) {
  const double x = *(const double *)a, y = *(const double *)b;
  return (x > y) - (x < y);
}

static double median(double *a, size_t n) {
  qsort(a, n, sizeof *a, rising);
  return n ? a[n / 2] : NAN;
}

/* Sums of squares of u, v and p less their means over the neighbours, where supports are full. */
static size_t add_departures(const struct sph *s, double sum[3]) {
  const double W = kernel_value_scale((enum sph_kernel)s->scheme.kernel);
  size_t n = 0;
  for (size_t c = 0; c < s->water_water.n_clusters; c++) {
    const struct sph_fit_sums a = sph_sums_around(s, c, SPH_OF_WATER | SPH_OF_WALLS);
    for (size_t l = 0; l < SPH_LANES; l++) {
      const size_t i = c * SPH_LANES + l;
      if (i >= s->f.n || W * a.w[l] < 0.9) continue;
      const double u = s->pack[i].u - a.u[l] / a.w[l], v = s->pack[i].v - a.v[l] / a.w[l];
      const double p = s->pack[i].p - a.p[l] / a.w[l];
      sum[0] += u * u;
      sum[1] += v * v;
      sum[2] += p * p;
      n++;
    }
  }
  return n;
}

/* In sqrt(gH), g and rho g H, from the rates of stage 0. Of accelerations, walls reflect them as
 * they do velocities, and are left out here: full supports have no share of them beside none. */
static void measure_noise(struct sph *s, double H, double noise[FIELDS]) {
  double of[3] = {0}, rates[3] = {0};
  const double n = (double)add_departures(s, of);
  for (size_t i = 0; i < s->f.n; i++) {
    s->pack[i].u = s->f.k[0].u[i];
    s->pack[i].v = s->f.k[0].v[i];
  }
  for (size_t k = 0; k < s->w.n; k++) s->w.pack[k].V = 0;
  const double inside = (double)add_departures(s, rates);
  noise[U] = sqrt(of[0] / n / (s->g * H));
  noise[V] = sqrt(of[1] / n / (s->g * H));
  noise[P] = sqrt(of[2] / n) / (s->rho0 * s->g * H);
  noise[AX] = sqrt(rates[0] / inside) / s->g;
  noise[AY] = sqrt(rates[1] / inside) / s->g;
}

/* Whether it is one of the STEPS around an instant, of steps dt long. */
static int instant_of(double t, double dt) {
  const int k = (int)lround((t - 0.7) / 0.1);
  return k >= 0 && k < INSTANTS && fabs(t - 0.7 - 0.1 * k) <= STEPS / 2 * dt ? k : -1;
}

static double mean_acceleration2(const struct sph *s) {
  double sum = 0;
  for (size_t i = 0; i < s->f.n; i++)
    sum += s->f.k[0].u[i] * s->f.k[0].u[i] + s->f.k[0].v[i] * s->f.k[0].v[i];
  return sum / (double)s->f.n / (s->g * s->g);
}

static double front(const struct sph *s) {
  double x = 0;
  for (size_t i = 0; i < s->f.n; i++) x = fmax(x, s->f.w.x[i]);
  return x;
}

/* `every`: of what is not sampled, the steps of a treatment; 0: none. */
static struct outcome march(const char *run, size_t every) {
  static double Q[MOST], noise[FIELDS][INSTANTS][10 * STEPS];
  size_t n = 0, sampled[INSTANTS] = {0};
  struct outcome o = {0};
  char all[500];
  snprintf(all, sizeof all, COMMON "%s", run);
  struct case_file *c = pool_case(TANK, all);
  struct sph *s = pool_create(c);
  const double usual = 0.8 * s->h / s->c0;
  while (s->t < 1.52) {
    EXPECT_OK(sph_remove_outside(s));
    EXPECT_OK(sph_treat(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    const bool fair = every <= 1 || s->steps % every;
    if (o.arrival == 0 && front(s) > s->tank.box.max[0] - s->dx / 2) o.arrival = s->t;
    if (fair && s->t >= 0.7 && s->t <= 1.5 && n < MOST) Q[n++] = mean_acceleration2(s);
    const int k = instant_of(s->t, usual);
    if (fair && k >= 0 && sampled[k] < 10 * STEPS) {
      double now[FIELDS];
      measure_noise(s, c->H, now);
      for (int f = 0; f < FIELDS; f++) noise[f][k][sampled[k]] = now[f];
      sampled[k]++;
      EXPECT_OK(sph_rates(s, 0, true, true)); /* packs and walls anew */
    }
    if (sph_step(s, sph_timestep(s, 2)) != OK) {
      TEST_FAIL("%s: %s", run, status_message());
      break;
    }
  }
  o.Q = median(Q, n);
  for (int f = 0; f < FIELDS; f++)
    for (int k = 0; k < INSTANTS; k++) o.noise[f][k] = median(noise[f][k], sampled[k]);
  printf("     %-45s Q/(N g^2) %8.3f, front arrives at %.4f s, at 1.2 s noise of u %.4f, ax %.3f, "
         "p %.4f; %zu steps\n",
         run, o.Q, o.arrival, o.noise[U][5], o.noise[AX][5], o.noise[P][5], s->steps);
  fflush(stdout);
  sph_destroy(s);
  case_destroy(c);
  return o;
}

/* At every instant. */
static void expect_below(const struct outcome *a, int field, const struct outcome *b, double by) {
  for (int k = 0; k < INSTANTS; k++)
    if (!(a->noise[field][k] < b->noise[field][k] / by))
      TEST_FAIL("field %d at %.1f s: %g is not below %g/%g", field, 0.7 + 0.1 * k,
                a->noise[field][k], b->noise[field][k], by);
}

/* Steps between smoothings; 0: never. */
static const int every[] = {0, 100, 50, 30, 10, 5, 2, 1};
enum { NEVER, EVERY_100, EVERY_50, EVERY_30, EVERY_10, EVERY_5, EVERY_2, EVERY_1, RUNS };
static struct outcome smoothed[RUNS], ma_sph;

static void march_all(void) {
  for (int r = 0; r < RUNS; r++) {
    char run[80];
    snprintf(run, sizeof run, "walls: mirror, momentum: reference, smoothing: %d", every[r]);
    smoothed[r] = march(run, (size_t)every[r]);
  }
  ma_sph =
      march("walls: mirror-plain, eos: tait, momentum: mass, continuity: mass, mls_volume: 20", 20);
}

/* Thesis, figure 4-45, as a run of 4.3 by itself has it: none 427, then 12, 4.6, 2.3, 1.66, 1.18,
 * and at 2 and 1 1.51 and 2.10. */
static void test_acceleration_is_least_at_every_fifth_step(void) {
  EXPECT(smoothed[NEVER].Q > 20 * smoothed[EVERY_100].Q);
  for (int r = EVERY_100; r < EVERY_5; r++) EXPECT(smoothed[r].Q > smoothed[r + 1].Q);
  EXPECT(smoothed[EVERY_5].Q < 2);
  EXPECT(smoothed[EVERY_5].Q < smoothed[EVERY_2].Q);
  EXPECT(smoothed[EVERY_5].Q < smoothed[EVERY_1].Q);
}

/* What smoothing costs: figure 4-46. Noise moves the front by a step or two where smoothing is
 * rare. */
static void test_front_is_the_later_the_more_is_smoothed(void) {
  for (int r = EVERY_50; r < EVERY_1; r++) EXPECT(smoothed[r].arrival < smoothed[r + 1].arrival);
  EXPECT(smoothed[NEVER].arrival < smoothed[EVERY_30].arrival);
  EXPECT(smoothed[EVERY_100].arrival < smoothed[EVERY_30].arrival);
}

/* Figures 4-20 to 4-44, after the impact: smoothed every fifth step, a quarter at most. */
static void test_noise_is_less_than_without_smoothing(void) {
  for (int f = 0; f < FIELDS; f++) expect_below(&smoothed[EVERY_5], f, &smoothed[NEVER], 4);
}

/* The same figures: below MA-SPH with plain images, whose accelerations a run of 4.3 by itself has
 * at 2.1, 1.2 and 4.0 g (a_x at 0.9, 1.2 and 1.5 s; here 1.85, 1.23 and 5.7). */
static void test_noise_is_less_than_that_of_ma_sph(void) {
  for (int f = 0; f < FIELDS; f++)
    expect_below(&smoothed[EVERY_5], f, &ma_sph, f == U || f == V ? 4 : 1.5);
}

int main(void) {
  march_all();
  RUN(test_acceleration_is_least_at_every_fifth_step);
  RUN(test_front_is_the_later_the_more_is_smoothed);
  RUN(test_noise_is_less_than_without_smoothing);
  RUN(test_noise_is_less_than_that_of_ma_sph);
  return TEST_RESULT;
}
