#include "import/table.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/params.h"

const char *const import_roles[IMPORT_N_ROLES] = {
#define X(name, unit, help) #name,
    IMPORT_ROLES(X)
#undef X
};

void import_table_destroy(struct import_table *t) {
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) free(t->column[k]);
  free(t->mesh.corner);
  *t = (struct import_table){.time = NAN};
}

enum status import_table_make(struct import_table *t, const char *const names[IMPORT_N_ROLES],
                              size_t n) {
  *t = (struct import_table){.time = NAN};
  for (size_t k = 0; k < IMPORT_N_ROLES; k++)
    if (names[k]) TRY(array_create(&t->column[k], n, "columns of a file"));
  t->n = n;
  return OK;
}

enum status import_no_column(const char *path, const char *column, size_t n,
                             const char *const *names) {
  char list[512] = "";
  size_t at = 0;
  for (size_t i = 0; i < n; i++) {
    const size_t more = strlen(names[i]) + 2;
    if (at + more + 5 > sizeof list) {
      at += (size_t)snprintf(list + at, sizeof list - at, ", ...");
      break;
    }
    at += (size_t)snprintf(list + at, sizeof list - at, "%s%s", i ? ", " : "", names[i]);
  }
  const char *near = param_nearest(column, n, names);
  return status_raise(ERR_INPUT, "%s has no column '%s'; it has %s%s%s%s", path, column,
                      n ? list : "none", near ? "; did you mean '" : "", near ? near : "",
                      near ? "'?" : "");
}
