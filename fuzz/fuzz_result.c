/* Result files: a small one of the writer's, edited, with the seal put right again so that the
 * edits reach what lies behind it, is read as the program reads it. Counted as a find is an error
 * of our code, a refusal without a message, and a child of more than 1 GB.
 */
#include <stdbool.h>
#include <string.h>
#include <sys/resource.h>

#include "common/result/result_diff.h"
#include "fuzz/fuzz.h"
#include "fuzz/result_edit.h"
#include "fuzz/servant.h"
#include "tests/common/result_bytes.h"
#include "tests/common/result_sample.h"

enum { GOOD_FILE = 101, MOST_BYTES = 1 << 20 };
#define GOOD_PATH "/proc/self/fd/101"

static unsigned char *good; /* the writer's file */
static size_t good_size;
static FILE *nowhere;

static struct work { /* of the servant */
  enum { EDIT, USE } what;
  uint32_t state; /* of the random numbers */
  size_t size;
  uint8_t data[MOST_BYTES];
} * work;

/* ---- the seed ---- */

static void write_seed(const char *path) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  if (result_create(path, c, &c->runs[0], &w) != OK) abort();
  for (size_t k = 0; k < 3; k++)
    if (sample_output(w, k, 12) != OK) abort();
  if (result_finish(w) != OK) abort();
  result_destroy(w);
  sample_case_destroy(c);
}

static void load_seed(void) {
  char path[128];
  snprintf(path, sizeof path, "%s/seed.h5", sample_folder());
  write_seed(path);
  FILE *f = fopen(path, "rb");
  good = malloc(MOST_BYTES);
  good_size = f ? fread(good, 1, MOST_BYTES, f) : 0;
  if (!good_size || good_size == MOST_BYTES) abort();
  fclose(f);
  sample_folder_remove();
}

/* ---- a try ---- */

/* What `result_read` promises. */
static void use(const struct result_file *f) {
  for (size_t k = 0; k < f->n_surfaces; k++)
    if (f->surface[k].pieces && f->surface[k].first[f->surface[k].pieces] != f->surface[k].points)
      abort();
  for (size_t k = 0; k < f->n_outputs; k++)
    if (!(f->output_time[k] >= f->output_time[0]) || f->output_points[k] < 0) abort();
  for (size_t k = 0; k < f->n_probes; k++)
    if (!f->probes[k].name || !f->probes[k].units) abort();
  for (size_t k = 0; k < f->n_points; k++)
    if (!f->points[k].name || !f->points[k].value[CASE_POINT_cover]) abort();
  for (size_t k = 0; k < f->n_diagnostics; k++)
    if (!f->diagnostics[k].help) abort();
  for (size_t k = 0; k < f->n_fields; k++)
    if (!f->fields[k]) abort();
}

static enum status look(void *data, size_t k, struct result_water *w) {
  size_t *seen = data;
  if (k != (*seen)++ || !w->p || !w->value[0]) abort();
  return OK;
}

static enum status try_points(void) {
  static const struct result_wanted pressure = {.name = "pressure"};
  size_t seen = 0;
  enum status status = result_stream(FUZZ_PATH, 1, &pressure, 2, (size_t[]){0, 2}, look, &seen);
  if (status == OK && seen != 2) abort();
  return status;
}

static enum status try_diff(void) {
  static const struct tolerance rule = {.pattern = "*"};
  static const struct result_tolerances exact = {1, 1, (struct tolerance *)&rule};
  struct result_diff *d;
  enum status status = result_diff_create(GOOD_PATH, FUZZ_PATH, &exact, 4, &d);
  if (status != OK) return status;
  result_diff_print(d, nowhere);
  status = result_diff_draft(1, &d, &exact, nowhere);
  result_diff_destroy(d);
  return status;
}

static enum status try_read(void) {
  struct result_file *f = NULL;
  enum status status = result_read(FUZZ_PATH, &f);
  if (status == OK) use(f);
  result_file_destroy(f);
  return status;
}

/* One use of the file, as each costs a child: which, its last byte says (of the seal, thus any). */
static enum status try_use(unsigned char way) {
  switch (way % 8) {
  case 0:
    return try_points();
  case 1:
    return try_diff();
  case 2:
  case 3:
    return result_info(FUZZ_PATH, nowhere);
  default:
    return try_read();
  }
}

/* ---- the servant's work ---- */

static void serve_use(void) {
  fuzz_file_fill(FUZZ_FILE, work->data, work->size);
  if (try_use(work->size ? work->data[work->size - 1] : 0) != OK && !*status_message())
    abort(); /* refused without a word */
  struct rusage children;
  getrusage(RUSAGE_CHILDREN, &children);
  if (children.ru_maxrss > 1 << 20) abort(); /* KB */
}

static void serve(void) {
  if (work->what == EDIT)
    work->size = edit_through_hdf5(work->data, work->size, MOST_BYTES, &work->state);
  else
    serve_use();
}

/* ---- the fuzzer ---- */

int LLVMFuzzerInitialize(int *argc, char ***argv) {
  (void)argc, (void)argv;
  load_seed();
  edit_learn(good, good_size);
  nowhere = fopen("/dev/null", "w");
  fuzz_file_create(FUZZ_FILE);
  fuzz_file_fill(fuzz_file_create(GOOD_FILE), good, good_size);
  work = mmap(NULL, sizeof *work, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (work == MAP_FAILED) abort();
  fuzz_servant_start(serve);
  return 0;
}

/* The new size, 0 when nothing came of it. */
static size_t have_edited(uint8_t *data, size_t size, size_t most, uint32_t state) {
  memcpy(work->data, data, size);
  work->what = EDIT, work->size = size, work->state = state;
  fuzz_servant_call();
  if (work->size > most) return 0;
  memcpy(data, work->data, work->size);
  return work->size;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned int seed);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t most, unsigned int seed) {
  uint32_t state = seed, way = draw(&state, 8);
  if (most < 2 * good_size || size > MOST_BYTES) return size;
  if (size < good_size / 2 || draw(&state, 2)) { /* afresh */
    memcpy(data, good, good_size);
    size = good_size;
  }
  size_t edited = way < 5 ? have_edited(data, size, most, state) : 0;
  if (edited) size = edited;
  if (way >= 4 || !edited) edit_bytes(data, size, &state);
  bytes_seal(data, size);
  return size;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size > MOST_BYTES) return 0;
  memcpy(work->data, data, size);
  work->what = USE, work->size = size;
  fuzz_servant_call();
  return 0;
}
