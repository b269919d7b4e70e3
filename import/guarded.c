#include "import/guarded.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/result/result_guard.h"

enum status import_carry_table(struct carrier *c, const struct import_ask *ask,
                               struct import_table *t) {
  TRY(carry_number(c, &t->n));
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    size_t n = t->n;
    if (!ask->names[k]) continue;
    TRY(carry_array(c, &n, &t->column[k]));
    CHECK(n == t->n, ERR_INPUT, "%s has columns of different lengths", ask->path);
  }
  TRY(carry_bytes(c, &t->time, sizeof t->time));
  if (!ask->grid) return OK;
  for (size_t k = IMPORT_x; k <= IMPORT_y; k++) { /* of a grid they come unasked */
    size_t n = t->n;
    TRY(carry_array(c, &n, &t->column[k]));
    CHECK(n == t->n, ERR_INPUT, "%s has places of different lengths", ask->path);
  }
  size_t n = 3 * t->mesh.n;
  TRY(carry_array(c, &n, &t->mesh.corner));
  t->mesh.n = n / 3;
  for (size_t i = 0; i < 3 * t->mesh.n; i++)
    CHECK(t->mesh.corner[i] < t->n, ERR_INPUT, "%s has a cell of points that it has not",
          ask->path);
  return OK;
}

static enum status read_there(void *data) {
  struct import_guarded *g = data;
  return g->read ? g->read(g->ask, g->table) : g->steps(g->ask, &g->n, &g->times);
}

static enum status carry_back(struct carrier *c, void *data) {
  struct import_guarded *g = data;
  return g->read ? import_carry_table(c, g->ask, g->table) : carry_array(c, &g->n, &g->times);
}

enum status import_guard(struct import_guarded *g) {
  struct stat about;
  CHECK(!stat(g->ask->path, &about), ERR_INPUT, "cannot read %s: %s", g->ask->path,
        strerror(errno));
  CHECK(S_ISREG(about.st_mode), ERR_INPUT, "%s is not a file", g->ask->path);
  enum status status = guard_run(&(struct guard){.name = {g->ask->path},
                                                 .size = (size_t)about.st_size + g->extra,
                                                 .data = g,
                                                 .read = read_there,
                                                 .carry = carry_back});
  if (status != OK && g->table) import_table_destroy(g->table);
  if (status != OK) {
    free(g->times);
    g->times = NULL;
  }
  return status;
}
