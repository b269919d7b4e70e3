/* Speed of the SPH solver: nanoseconds per particle of water for one evaluation of the right-hand
 * side, on the dam break of Buchner's tank some time after release, by resolution, diffusion,
 * kernel or named scheme, and number of threads; and what the phases of an evaluation cost.
 *
 *   bench_sph [largest H/dx, default 200]
 *
 * Processors of one kind differ by half, and busy ones by more, so that times are given a second
 * time as counts of a reference: one fused multiply-add of a register of floats, as wide as the
 * processor has them, in a loop of twelve independent ones that runs before each repeat.
 *
 * Medians of repeats. On one thread the processor's time is taken, which a busy machine does not
 * lengthen; on more, the time of the clock on the wall. */
#include <math.h>
#include <omp.h>
#include <stdio.h>
#include <stdlib.h>

#define SPH_SINGLE
#include "bench/bench.h"
#include "common/base/array.h"
#include "common/case/case.h"
#include "sph/domain/wall.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/gradient.h"
#include "sph/pair/rates.h"
#include "sph/pair/vec.h"
#include "sph/presets.h"
#include "sph/solver.h"
#include "sph/sph.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"
#include "sph/treat/treat.h"

enum { REPEATS = 15, CHAINS = 12, ROUNDS = 20000 };

/* Nanoseconds for a fused multiply-add of a register: as many as go into the pipes at once. */
static double reference(void) {
  static volatile float one = 1; /* which the compiler does not know */
  vec a[CHAINS];
  const vec factor = vec_of(0.999f * one), term = vec_of(1e-3f * one);
  for (int k = 0; k < CHAINS; k++) a[k] = vec_of((float)k * one);
  const double start = bench_seconds();
  for (int n = 0; n < ROUNDS; n++)
#pragma GCC unroll 12
    for (int k = 0; k < CHAINS; k++) a[k] = a[k] * factor + term;
  const double seconds = bench_seconds() - start;
  vec sum = {0};
  for (int k = 0; k < CHAINS; k++) sum += a[k];
  one = sum[0] < 1e30f; /* the loop is for something */
  return seconds / ROUNDS / CHAINS * 1e9;
}

static double median(double t[REPEATS]) {
  qsort(t, REPEATS, sizeof *t, array_ascending);
  return t[REPEATS / 2];
}

/* What is timed; `stage` and `diffuse` as in sph_rates. */
static enum status evaluate(struct sph *s) {
  return sph_rates(s, 0, true, false);
}

static enum status pack(struct sph *s) {
  sph_pack_water(s);
  return OK;
}

static enum status walls(struct sph *s) {
  s->wall->fill(s);
  return OK;
}

static enum status gradient(struct sph *s) {
  sph_gradient(s);
  return OK;
}

static enum status lists(struct sph *s) {
  s->f.x_listed[0] += 100 * s->dx; /* as if it had moved far */
  return sph_neighbours_update(s);
}

static enum status step(struct sph *s) {
  TRY(sph_treat(s));
  TRY(sph_rates(s, 0, true, true));
  return sph_step(s, 1e-9);
}

/* Nanoseconds per particle, the median; into *fma (or NULL) that of how many references it is. */
static double measure(struct sph *s, enum status (*what)(struct sph *), double *fma) {
  double t[REPEATS], ratio[REPEATS];
  for (int r = 0; r < REPEATS; r++) {
    const double unit = fma ? reference() : 1;
    double start = bench_seconds();
    if (what(s) != OK) {
      fprintf(stderr, "%s\n", status_message());
      exit(1);
    }
    t[r] = (bench_seconds() - start) / (double)s->f.n * 1e9;
    ratio[r] = t[r] / unit;
  }
  if (fma) *fma = median(ratio);
  return median(t);
}

static struct case_file *parse(char *text) {
  static const struct solver *const solvers[] = {&sph_solver};
  const struct registry registry = {.solvers = solvers, .n_solvers = 1};
  struct problems problems = {0};
  struct case_file *c = NULL;
  if (!text || case_parse("bench", text, &registry, &problems, &c) != OK) {
    for (size_t k = 0; k < problems.n; k++) fprintf(stderr, "%s\n", problems.text[k]);
    fprintf(stderr, "%s\n", text ? status_message() : "no memory");
    exit(1);
  }
  problems_destroy(&problems);
  free(text);
  return c;
}

/* A preset that projects on waves needs some, and a periodic tank. */
static bool is_of_waves(const struct param_preset *p) {
  return param_preset_value(p, "projection");
}

static void add_presets(FILE *f, double resolution, bool of_waves) {
  for (const struct param_preset *p = sph_presets; p < sph_presets + SPH_N_PRESETS; p++)
    if (param_preset_value(p, "walls") &&
        is_of_waves(p) == of_waves) /* else: those of diffusions */
      fprintf(f, "  - {name: %s, solver: sph, resolution: %g, scheme: %s}\n", p->name, resolution,
              p->name);
}

/* Buchner's dam break with one run for each diffusion, and at the lowest resolution for each kernel
 * and named scheme. */
static struct case_file *dam_break(double resolution, bool all) {
  char *text = NULL;
  size_t size;
  FILE *f = open_memstream(&text, &size);
  if (!f) return parse(NULL);
  fprintf(f, "title: speed\nscales: {H: 0.6}\n"
             "tank: {walls: [[[0, 3 H], [0, 0], [5.366 H, 0], [5.366 H, 3 H]]]}\n"
             "water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]], pressure: released}\n"
             "time: {end: 1, every: 1, sample: 1}\nruns:\n");
#define X(name, help)                                                                              \
  fprintf(f, "  - {name: %s, solver: sph, resolution: %g, diffusion: %s}\n", #name, resolution,    \
          #name);
  SPH_DIFFUSIONS(X)
#undef X
#define X(name, help)                                                                              \
  fprintf(f, "  - {name: %s, solver: sph, resolution: %g, kernel: %s}\n", #name, resolution, #name);
  if (all) {
    SPH_KERNELS(X)
    add_presets(f, resolution, false);
  }
#undef X
  fclose(f);
  return parse(text);
}

/* As many particles in one wave. */
static struct case_file *wave(double resolution) {
  char *text = NULL;
  size_t size;
  FILE *f = open_memstream(&text, &size);
  if (!f) return parse(NULL);
  fprintf(f,
          "title: speed\nscales: {H: 1}\n"
          "tank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: periodic}\n"
          "water: {wave: {kind: airy, profile: deep, amplitude: 1e-3, wavelength: 1, depth: 1}}\n"
          "time: {end: 1, every: 1, sample: 1}\nruns:\n");
  add_presets(f, round(M_SQRT2 * resolution), true);
  fclose(f);
  return parse(text);
}

static size_t pairs_listed(const struct sph_lists *l) {
  size_t sum = 0, n;
  for (size_t c = 0; c < l->n_clusters; c++) {
    sph_lists_of(l, c, &n);
    sum += n;
  }
  return sum;
}

/* Some way into the run: the lattice has bent, and caches are as in a run. */
static struct sph *begun(const struct case_file *c, const struct case_run *r) {
  struct sph *s;
  if (sph_create(c, r->resolution, r->options, &s) != OK) {
    fprintf(stderr, "%s\n", status_message());
    exit(1);
  }
  omp_set_num_threads(omp_get_num_procs());
  const int warm = 200;
  for (int k = 0; k < warm; k++)
    if (sph_rates(s, 0, true, true) != OK || sph_step(s, sph_timestep(s, 1)) != OK) exit(1);
  return s;
}

static void bench(const struct case_file *c, const struct case_run *r) {
  struct sph *s = begun(c, r);
  double resolution = r->resolution;
  int most = omp_get_num_procs();
  for (int threads = 1; threads <= most; threads *= 2) {
    omp_set_num_threads(threads);
    double per_evaluation, per_step;
    const double evaluation = measure(s, evaluate, &per_evaluation);
    const double whole = measure(s, step, &per_step);
    printf("%5g %7zu  %-12s %7d %9.1f %6.0f %9.1f %6.0f %7.1f %7.1f %9.1f %7.1f %8.1f\n",
           resolution, s->f.n, r->name, threads, evaluation, per_evaluation, whole, per_step,
           measure(s, pack, NULL), measure(s, walls, NULL), measure(s, gradient, NULL),
           measure(s, lists, NULL),
           (double)pairs_listed(&s->water_water) / (double)s->water_water.n_clusters);
    fflush(stdout);
  }
  sph_destroy(s);
}

/* Nanoseconds per particle of as many steps as take a few milliseconds. */
static double time_of_steps(struct sph *s) {
  const int n = (int)(1 + 1e5 / (double)s->f.n);
  const double start = bench_seconds();
  for (int k = 0; k < n; k++)
    if (step(s) != OK) exit(1);
  return (bench_seconds() - start) / n / (double)s->f.n * 1e9;
}

/* How the time of a step grows with the number of particles, as its power: two runs take turns,
 * since the machine's own speed comes and goes. */
static void growth(const struct case_file *small, const struct case_file *large, size_t run) {
  struct sph *s = begun(small, &small->runs[run]), *l = begun(large, &large->runs[run]);
  double power[REPEATS];
  omp_set_num_threads(1);
  for (int r = 0; r < REPEATS; r++) {
    const double before = time_of_steps(s), t = time_of_steps(l), after = time_of_steps(s);
    power[r] = 1 + log(2 * t / (before + after)) / log((double)l->f.n / (double)s->f.n);
  }
  printf("%s, %zu to %zu particles: one thread's time grows as n^%.3f\n", small->runs[run].name,
         s->f.n, l->f.n, median(power));
  sph_destroy(s);
  sph_destroy(l);
}

int main(int argc, char **argv) {
  double largest = argc > 1 ? atof(argv[1]) : 200;
  printf("ns per particle of water, and (fma) how many times a fused multiply-add of %d floats; "
         "alpha = 0.01; listed: sources per cluster of %d\n"
         " H/dx       n  run         threads  evaluate    fma      step    fma    pack   walls  "
         "gradient   lists   listed\n",
         SPH_REALS, SPH_LANES);
  struct case_file *first = NULL, *c = NULL;
  for (double resolution = 50; resolution <= largest; resolution *= 2) {
    if (c && c != first) case_destroy(c);
    c = dam_break(resolution, !first);
    if (!first) first = c;
    for (size_t r = 0; r < c->n_runs; r++) bench(c, &c->runs[r]);
    if (c != first) continue;
    struct case_file *waves = wave(resolution);
    for (size_t r = 0; r < waves->n_runs; r++) bench(waves, &waves->runs[r]);
    case_destroy(waves);
  }
  if (c != first) {
    for (size_t r = 0; r < c->n_runs; r++) growth(first, c, r);
    case_destroy(c);
  }
  if (first) case_destroy(first);
  return 0;
}
