/* Columns of equal length in a group of a result file that is being written. Internal. */
#pragma once
#include <hdf5.h>

#include "common/result/result_column.h"
#include "common/result/result_layout.h"

enum { RESULT_ROWS = 1024 }; /* of a chunk */

struct result_table {
  size_t n_columns;
  struct hdf_column *column[RESULT_ENERGY_COLUMNS + RESULT_TERMS];
};
_Static_assert(RESULT_STEP_COLUMNS <= RESULT_ENERGY_COLUMNS + RESULT_TERMS, "a table holds either");

/* In an existing group. */
enum status result_table_begin(struct hdf_columns *all, hid_t group, size_t n,
                               const struct result_column *columns, struct result_table *t);
/* In a new one. */
enum status result_table_create(struct hdf_columns *all, hid_t parent, const char *name, size_t n,
                                const struct result_column *columns, struct result_table *t);
enum status result_table_add(struct result_table *t, const double *row);

/* A new group for what a person has named. A link's name cannot hold a slash; the attribute `name`
 * is exact. */
enum status result_group_create(hid_t parent, const char *name, hid_t *group);
