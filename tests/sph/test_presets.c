/* Named schemes. */
#include "tests/test.h"

#include <omp.h>

#include "sph/pair/derivative.h"
#include "sph/pair/momentum.h"
#include "sph/presets.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

static const struct param *row_of(const char *key) {
  for (size_t i = 0; i < SPH_N_PARAMS; i++)
    if (!strcmp(sph_params[i].key, key)) return &sph_params[i];
  return NULL;
}

/* What the scheme is for: waves in a periodic tank where it needs one, else water let go. */
static const char *head_of(const struct param_preset *p) {
  static const char let_go[] =
      "title: break\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2.5, 0], [2.5, 2]]]}\n"
      "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: released}\n" POOL_TIMES;
  static const char waves[] =
      "title: waves\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: "
      "periodic}\nwater: {wave: {kind: airy, amplitude: 1e-3, wavelength: 1, depth: "
      "0.96875}}\n" POOL_TIMES;
  return param_preset_value(p, "projection") ? waves : let_go;
}

/* The options of a run as text, all but the first row: the name of the scheme. */
static char *options_of(const char *head, const char *run) {
  struct case_file *c = pool_case(head, run);
  char *text = NULL;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  params_write(out, sph_params + 1, SPH_N_PARAMS - 1, c->runs[0].options);
  fclose(out);
  case_destroy(c);
  return text;
}

/* Thirty steps, treatments included: more than any preset waits for one. */
static void march(struct sph *s) {
  for (int k = 0; k < 30; k++) {
    EXPECT_OK(sph_remove_outside(s));
    EXPECT_OK(sph_treat(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 100)));
  }
}

static struct sph *marched(const struct case_file *c, int threads) {
  omp_set_num_threads(threads);
  struct sph *s = pool_create(c);
  march(s);
  omp_set_num_threads(1);
  return s;
}

static bool same_bits(const struct sph *a, const struct sph *b) {
  bool same = a->f.n == b->f.n && a->t == b->t;
#define X(q, unit, help) same = same && !memcmp(a->f.w.q, b->f.w.q, a->f.n * sizeof *a->f.w.q);
  SPH_EVOLVING(X)
#undef X
  return same;
}

static void test_presets_are_the_same_bits_for_any_number_of_threads(void) {
  for (size_t k = 0; k < SPH_N_PRESETS; k++) {
    char run[200];
    snprintf(run, sizeof run, "resolution: 16, scheme: %s", sph_presets[k].name);
    struct case_file *c = pool_case(head_of(&sph_presets[k]), run);
    struct sph *one = marched(c, 1);
    for (int threads = 2; threads <= 3; threads++) {
      struct sph *more = marched(c, threads);
      if (!same_bits(one, more))
        TEST_FAIL("%s differs on %d threads", sph_presets[k].name, threads);
      sph_destroy(more);
    }
    for (size_t i = 0; i < one->f.n; i++) EXPECT(isfinite(one->f.w.rho[i] + one->f.w.u[i]));
    sph_destroy(one);
    case_destroy(c);
  }
}

static bool is_conservative(const struct sph_scheme *o) {
  return o->derivative == SPH_DERIVATIVE_kernel &&
         (o->momentum == SPH_MOMENTUM_plus || o->momentum == SPH_MOMENTUM_mass);
}

/* Sums over the water, without what gravity does, and of their magnitudes. */
struct motion {
  double px, py, fx, fy, torque;
  double p, f, twist;
};

static struct motion motion_of(const struct sph *s) {
  struct motion a = {0};
  for (size_t i = 0; i < s->f.n; i++) {
    const double m = s->f.m[i], x = s->f.w.x[i], y = s->f.w.y[i], u = s->f.w.u[i];
    const double v = s->f.w.v[i] + s->g * s->t, ax = s->f.k[0].u[i], ay = s->f.k[0].v[i] + s->g;
    a.px += m * u, a.py += m * v, a.p += m * hypot(u, v);
    a.fx += m * ax, a.fy += m * ay, a.f += m * hypot(ax, ay);
    a.torque += m * (x * ay - y * ax), a.twist += m * hypot(x, y) * hypot(ax, ay);
  }
  return a;
}

/* A drop in disorder, clear of the walls. Rounding is left: of a few pairs in a sum of tens, which
 * is relative to the sum's magnitude, and of thirty steps. */
static void check_momenta(const struct case_file *c, const char *name) {
  struct sph *s = pool_create(c);
  pool_shake(s, 0.2, 1, 3e3);
  EXPECT_OK(sph_rates(s, 0, true, true));
  const struct motion a = motion_of(s);
  march(s);
  EXPECT_OK(sph_rates(s, 0, true, true));
  const struct motion b = motion_of(s);
  const double change = hypot(b.px - a.px, b.py - a.py) / a.p, force = hypot(b.fx, b.fy) / b.f;
  printf("     %s: momentum to %.0e, force %.0e, torque %.0e\n", name, change, force,
         b.torque / b.twist);
  EXPECT_NEAR(change, 0, 1e-13);
  EXPECT_NEAR(force, 0, 1e-14);
  EXPECT_NEAR(b.torque / b.twist, 0, 1e-14);
  sph_destroy(s);
}

/* Of the others the momentum is divided by rho0 alone or smoothed, so that it changes. */
static void test_presets_of_symmetric_pairs_keep_their_momenta(void) {
  size_t kept = 0;
  for (size_t k = 0; k < SPH_N_PRESETS; k++) {
    if (param_preset_value(&sph_presets[k], "projection")) continue; /* wants a periodic tank */
    char run[200];
    snprintf(run, sizeof run, "resolution: 16, precision: double, scheme: %s", sph_presets[k].name);
    struct case_file *c = pool_case(POOL_DROP, run);
    if (is_conservative(c->runs[0].options)) {
      check_momenta(c, sph_presets[k].name);
      kept++;
    }
    case_destroy(c);
  }
  EXPECT(kept == 4);
}

/* As the papers have them: P (1), (9), (7), (10) with the Gaussian at 4/3 dx; T with the cubic
 * spline and no diffusion: (2.15), (3.20), Tait; (4.40), (4.41); (4.34), (4.35); (4.57) to (4.60).
 */
static void test_presets_are_what_the_papers_have(void) {
  static const char *const keys[] = {"kernel", "eos", "momentum", "continuity", "diffusion"};
  static const char *const value[][6] = {
      {"delta-sph", "gaussian", "linear", "plus", "divergence", "antuono"},
      {"molteni", "gaussian", "linear", "plus", "divergence", "molteni"},
      {"ferrari", "gaussian", "linear", "plus", "divergence", "ferrari"},
      {"ma-sph", "cubic", "tait", "mass", "mass", "none"},
      {"msph", "cubic", "linear", "reference", "divergence", "none"},
      {"msph-dynamic", "cubic", "dynamic", "reference", "divergence", "none"},
      {"msph-split", "cubic", "split", "reference", "divergence", "none"},
      {"hsph", "quintic", "linear", "reference", "reference", "none"},
  };
  _Static_assert(sizeof value / sizeof *value == SPH_N_PRESETS, "every scheme");
  for (size_t k = 0; k < SPH_N_PRESETS; k++) {
    char run[200];
    EXPECT(!strcmp(sph_presets[k].name, value[k][0]));
    snprintf(run, sizeof run, "resolution: 20, scheme: %s", value[k][0]);
    struct case_file *c = pool_case(head_of(&sph_presets[k]), run);
    const struct sph_scheme *o = c->runs[0].options;
    for (size_t q = 0; q < sizeof keys / sizeof *keys; q++)
      if (strcmp(sph_scheme_name(o, keys[q]), value[k][q + 1]) != 0)
        TEST_FAIL("%s has %s: %s", value[k][0], keys[q], sph_scheme_name(o, keys[q]));
    EXPECT_NEAR(o->h_over_dx, k == 7 ? 1 : 4. / 3, 1e-12);
    EXPECT((o->every[SPH_TREATMENT_smoothing] != 0) == (k >= 4 && k <= 6));
    EXPECT((o->every[SPH_TREATMENT_mls_volume] != 0) == (k == 3));
    EXPECT((o->alpha == 0) == (k >= 3));
    case_destroy(c);
  }
}

static void test_values_are_allowed(void) {
  const struct param_scales scales = {1, 9.81};
  struct sph_scheme o;
  char todo[160];
  for (size_t k = 0; k < SPH_N_PRESETS; k++)
    for (const struct param_value *v = sph_presets[k].values; v->key; v++) {
      const struct param *row = row_of(v->key);
      EXPECT(row);
      if (row) EXPECT(param_fill(row, v->value, &scales, &o, todo));
    }
  EXPECT(!strcmp(sph_params[0].key, "scheme"));
}

static void test_presets_are_their_values(void) {
  for (size_t k = 0; k < SPH_N_PRESETS; k++) {
    char named[200], written[2000] = "resolution: 20";
    snprintf(named, sizeof named, "resolution: 20, scheme: %s", sph_presets[k].name);
    for (const struct param_value *v = sph_presets[k].values; v->key; v++) {
      const size_t at = strlen(written);
      snprintf(written + at, sizeof written - at, ", %s: %s", v->key, v->value);
    }
    const char *head = head_of(&sph_presets[k]);
    char *a = options_of(head, named), *b = options_of(head, written);
    EXPECT(!strcmp(a, b));
    free(a);
    free(b);
  }
}

static void test_keys_of_the_run_come_first(void) {
  char *a = options_of(POOL_STILL, "resolution: 20, diffusion: none, scheme: ferrari");
  char *b = options_of(POOL_STILL, "resolution: 20, diffusion: none");
  char *c = options_of(POOL_STILL, "resolution: 20, scheme: ferrari");
  EXPECT(!strcmp(a, b));
  EXPECT(strcmp(a, c) != 0);
  free(a);
  free(b);
  free(c);
}

int main(void) {
  RUN(test_presets_are_what_the_papers_have);
  RUN(test_values_are_allowed);
  RUN(test_presets_are_their_values);
  RUN(test_keys_of_the_run_come_first);
  RUN(test_presets_of_symmetric_pairs_keep_their_momenta);
  RUN(test_presets_are_the_same_bits_for_any_number_of_threads);
  return TEST_RESULT;
}
