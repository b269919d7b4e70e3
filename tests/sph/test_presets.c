/* Named schemes. */
#include "tests/test.h"

#include "sph/presets.h"
#include "tests/sph/pool.h"

static const struct param *row_of(const char *key) {
  for (size_t i = 0; i < SPH_N_PARAMS; i++)
    if (!strcmp(sph_params[i].key, key)) return &sph_params[i];
  return NULL;
}

/* The options of a run as text, all but the first row: the name of the scheme. */
static char *options_of(const char *run) {
  struct case_file *c = pool_case(POOL_STILL, run);
  char *text = NULL;
  size_t size;
  FILE *out = open_memstream(&text, &size);
  params_write(out, sph_params + 1, SPH_N_PARAMS - 1, c->runs[0].options);
  fclose(out);
  case_destroy(c);
  return text;
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
    char *a = options_of(named), *b = options_of(written);
    EXPECT(!strcmp(a, b));
    free(a);
    free(b);
  }
}

static void test_keys_of_the_run_come_first(void) {
  char *a = options_of("resolution: 20, diffusion: none, scheme: ferrari");
  char *b = options_of("resolution: 20, diffusion: none");
  char *c = options_of("resolution: 20, scheme: ferrari");
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
  return TEST_RESULT;
}
