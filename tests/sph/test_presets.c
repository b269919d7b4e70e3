/* Named schemes. */
#include "tests/test.h"

#include <omp.h>

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
static struct sph *marched(const struct case_file *c, int threads) {
  omp_set_num_threads(threads);
  struct sph *s = pool_create(c);
  for (int k = 0; k < 30; k++) {
    EXPECT_OK(sph_remove_outside(s));
    EXPECT_OK(sph_treat(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT_OK(sph_step(s, sph_timestep(s, 100)));
  }
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
  RUN(test_values_are_allowed);
  RUN(test_presets_are_their_values);
  RUN(test_keys_of_the_run_come_first);
  RUN(test_presets_are_the_same_bits_for_any_number_of_threads);
  return TEST_RESULT;
}
