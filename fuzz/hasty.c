#include "fuzz/hasty.h"

#include <hdf5.h>
#include <stdbool.h>
#include <sys/resource.h>

#include "common/result/result_guard.h"
#include "fuzz/fuzz.h"

enum { HASTY_FILE = 102, MORE_MEMORY = 512 << 20, MOST_RECEIVED = 256 << 20 /* bytes */ };

static bool hasty;

/* The linker puts these in the place of the guard's own (--wrap). */
enum status __real_guard_run(const struct guard *g);
enum status __wrap_guard_run(const struct guard *g);
void __real_guard_blame(size_t which);
void __wrap_guard_blame(size_t which);

static void limit_memory(void) {
  size_t pages = 0;
  FILE *f = fopen("/proc/self/statm", "r");
  if (!f || fscanf(f, "%zu", &pages) != 1) abort();
  fclose(f);
  size_t limit = pages * (size_t)sysconf(_SC_PAGESIZE) + MORE_MEMORY;
  setrlimit(RLIMIT_AS, &(struct rlimit){limit, limit});
}

void fuzz_hasten(void) {
  hasty = true;
  fuzz_file_create(HASTY_FILE);
  limit_memory();
}

static enum status send(const struct guard *g) {
  static struct carrier c;
  c = (struct carrier){.pipe = HASTY_FILE, .sending = true};
  fuzz_file_fill(HASTY_FILE, "", 0);
  lseek(HASTY_FILE, 0, SEEK_SET);
  TRY(g->carry(&c, g->data));
  return carry_end(&c);
}

static enum status receive(const struct guard *g) {
  static struct carrier c;
  c = (struct carrier){.pipe = HASTY_FILE, .room = MOST_RECEIVED};
  lseek(HASTY_FILE, 0, SEEK_SET);
  return g->carry(&c, g->data);
}

/* What a reader leaves open, as its process would end. */
static void close_files(void) {
  hid_t file[8];
  ssize_t n = H5Fget_obj_ids(H5F_OBJ_ALL, H5F_OBJ_FILE, 8, file);
  for (ssize_t i = 0; i < n; i++) H5Fclose(file[i]);
}

enum status __wrap_guard_run(const struct guard *g) {
  if (!hasty) return __real_guard_run(g);
  enum status status = g->read(g->data);
  if (status == ERR_MEMORY) _exit(1);
  if (status == OK) status = send(g);
  close_files();
  return status == OK ? receive(g) : status;
}

void __wrap_guard_blame(size_t which) {
  if (!hasty) __real_guard_blame(which);
}
