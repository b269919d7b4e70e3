#include "common/result/result_table.h"

#include <stdio.h>
#include <string.h>

#include "common/result/result_hdf.h"

enum status result_table_begin(struct hdf_columns *all, hid_t group, size_t n,
                               const struct result_column *columns, struct result_table *t) {
  const struct hdf_rows rows = {H5T_NATIVE_DOUBLE, 0, RESULT_ROWS};
  for (t->n_columns = 0; t->n_columns < n; t->n_columns++) {
    const struct result_column *c = &columns[t->n_columns];
    TRY(hdf_column_create(all, group, c->name, &rows, c->units, c->help, &t->column[t->n_columns]));
  }
  return OK;
}

enum status result_table_create(struct hdf_columns *all, hid_t parent, const char *name, size_t n,
                                const struct result_column *columns, struct result_table *t) {
  hid_t group = -1;
  TRY(hdf_group_create(parent, name, &group));
  enum status status = result_table_begin(all, group, n, columns, t);
  H5Gclose(group);
  return status;
}

enum status result_table_add(struct result_table *t, const double *row) {
  for (size_t k = 0; k < t->n_columns; k++) TRY(hdf_column_append(t->column[k], 1, &row[k]));
  return OK;
}

enum status result_group_create(hid_t parent, const char *name, hid_t *group) {
  char link[strlen(name) + 16];
  strcpy(link, name);
  for (char *p = link; *p; p++)
    if (*p == '/') *p = '_';
  size_t length = strlen(link);
  for (int k = 2; H5Lexists(parent, link, H5P_DEFAULT) > 0 && k < 10000; k++)
    sprintf(link + length, "_%d", k);
  TRY(hdf_group_create(parent, link, group));
  return hdf_set_string(*group, "name", name);
}
