/* Datasets of HDF5 files by their paths, as particle codes in Python write them:
 *     columns: {x: particles/fluid/arrays/x, u: particles/fluid/arrays/u}
 *     time_after: solver_data@t          (an attribute; or the path of a dataset of one number)
 * "PATH:1" is component 1 of a dataset with rows. And VTKHDF's points over time, whose columns are
 * Points:0, ... and the names of PointData. */
#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_hdf.h"
#include "common/result/result_open.h"
#include "import/guarded.h"

struct request {
  const struct import_ask *ask;
  size_t n;
  double *times;
  struct import_table *table;
  bool vtkhdf; /* points over time */
  bool steps;  /* of which a column holds several */
};

/* Rows and numbers in each of a dataset. */
static enum status find_shape(hid_t file, const char *path, const char *name, size_t *n,
                              size_t *components) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  hid_t space = set >= 0 ? H5Dget_space(set) : -1;
  hsize_t shape[2] = {1, 1};
  const int rank = space >= 0 ? H5Sget_simple_extent_ndims(space) : -1;
  if (rank >= 1 && rank <= 2) H5Sget_simple_extent_dims(space, shape, NULL);
  if (space >= 0) H5Sclose(space);
  if (set >= 0) H5Dclose(set);
  CHECK(rank == 1 || rank == 2, ERR_INPUT, "%s: '%s' is not a dataset of one or two dimensions",
        path, name);
  *n = (size_t)shape[0];
  *components = rank == 2 ? (size_t)shape[1] : 0;
  return OK;
}

/* What there is beside a dataset that is not there. */
static enum status no_dataset(hid_t file, const char *path, const char *name) {
  char folder[IMPORT_LONGEST + 32];
  char **names = NULL;
  size_t n = 0;
  snprintf(folder, sizeof folder, "%s", name);
  char *slash = strrchr(folder, '/');
  if (slash) *slash = 0;
  hid_t group = slash && *folder && hdf_is_there(file, folder) ? H5Gopen2(file, folder, H5P_DEFAULT)
                                                               : H5Gopen2(file, "/", H5P_DEFAULT);
  if (group >= 0 && hdf_list(group, &n, &names) != OK) n = 0;
  if (group >= 0) H5Gclose(group);
  enum status status = import_no_column(path, name, n, (const char *const *)names);
  if (names) hdf_list_destroy(n, names);
  return status;
}

/* Rows [first, first + n) of a component; n of SIZE_MAX: all of them, and *n is how many. */
static enum status read_column(const struct request *q, hid_t file, const char *column,
                               size_t first, size_t *n, double **out) {
  char name[IMPORT_LONGEST + 1], path[IMPORT_LONGEST + 32];
  const char *file_name = q->ask->path;
  size_t rows = 0, components = 0, component;
  char wrong[IMPORT_WRONG];
  double *values = NULL;
  import_array_name(column, name);
  snprintf(path, sizeof path, "%s%s",
           !q->vtkhdf                ? ""
           : !strcmp(name, "Points") ? "VTKHDF/"
                                     : "VTKHDF/PointData/",
           name);
  if (!hdf_is_there(file, path)) return no_dataset(file, file_name, path);
  TRY(find_shape(file, file_name, path, &rows, &components));
  CHECK(import_pick(column, components ? components : 1, &component, wrong), ERR_INPUT, "%s %s",
        file_name, wrong);
  const bool all = *n == SIZE_MAX;
  CHECK(all || q->steps || rows == *n, ERR_INPUT, "%s: '%s' has %zu rows, other columns %zu",
        file_name, column, rows, *n);
  CHECK(all || (first <= rows && *n <= rows - first), ERR_INPUT, "%s: '%s' has %zu rows, too few",
        file_name, column, rows);
  if (all) *n = rows;
  enum status status = hdf_get_rows(file, path, H5T_NATIVE_DOUBLE, components, first, *n, &values);
  if (status != OK) return status_context(status, "%s: ", file_name);
  for (size_t i = 0; components && i < *n; i++) values[i] = values[i * components + component];
  *out = values;
  return OK;
}

static enum status read_time(hid_t file, const struct import_ask *ask, double *time) {
  char name[IMPORT_LONGEST + 1];
  snprintf(name, sizeof name, "%s", ask->time_after);
  char *at = strrchr(name, '@');
  if (!at) {
    CHECK(hdf_is_there(file, name), ERR_INPUT, "%s has no dataset '%s'", ask->path, name);
    return hdf_get_scalar(file, name, H5T_NATIVE_DOUBLE, time);
  }
  *at = 0;
  CHECK(!*name || hdf_is_there(file, name), ERR_INPUT, "%s has no group '%s'", ask->path, name);
  hid_t object = H5Oopen(file, *name ? name : "/", H5P_DEFAULT);
  CHECK(object >= 0, ERR_INPUT, "%s has no group '%s'", ask->path, name);
  enum status status = H5Aexists(object, at + 1) > 0 ? hdf_get_number(object, at + 1, time)
                                                     : status_raise(ERR_INPUT, "none");
  H5Oclose(object);
  CHECK(status == OK, ERR_INPUT, "%s: '%s' has no numeric attribute '%s'", ask->path, name, at + 1);
  return OK;
}

/* The rows of a step of VTKHDF. */
static enum status find_rows(hid_t file, const struct import_ask *ask, size_t *first, size_t *n) {
  int64_t *offset = NULL, *count = NULL;
  enum status status =
      hdf_get_rows(file, "VTKHDF/Steps/PointOffsets", H5T_NATIVE_INT64, 0, ask->step, 1, &offset);
  if (status == OK)
    status = hdf_get_rows(file, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, 0, ask->step, 1, &count);
  if (status == OK && (*offset < 0 || *count < 0))
    status = status_raise(ERR_INPUT, "its dataset /VTKHDF/NumberOfPoints is inconsistent");
  if (status == OK) {
    *first = (size_t)*offset;
    *n = (size_t)*count;
  } else
    status = status_context(status, "%s: ", ask->path);
  free(offset);
  free(count);
  return status;
}

static enum status read_there(const hid_t *file, void *data) {
  struct request *q = data;
  struct import_table *t = q->table;
  size_t first = 0, n = SIZE_MAX;
  q->steps = q->vtkhdf && hdf_is_there(*file, "VTKHDF/Steps");
  if (q->steps) TRY(find_rows(*file, q->ask, &first, &n));
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    if (!q->ask->names[k]) continue;
    size_t rows = n;
    TRY(read_column(q, *file, q->ask->names[k], first, &rows, &t->column[k]));
    n = rows;
  }
  t->n = n == SIZE_MAX ? 0 : n;
  return q->ask->time_after ? read_time(*file, q->ask, &t->time) : OK;
}

static enum status carry_table(struct carrier *c, void *data) {
  struct request *q = data;
  return import_carry_table(c, q->ask, q->table);
}

static enum status read_table(const struct import_ask *ask, bool vtkhdf, struct import_table *t) {
  struct request q = {.ask = ask, .table = t, .vtkhdf = vtkhdf};
  *t = (struct import_table){.time = NAN};
  enum status status = result_read_safely(&(struct result_request){
      1, {ask->path}, .any = true, .data = &q, .read = read_there, .carry = carry_table});
  if (status != OK) import_table_destroy(t);
  return status;
}

enum status import_hdf5_steps(const struct import_ask *ask, size_t *n, double **times) {
  (void)ask;
  return import_one_step(n, times);
}

enum status import_hdf5_read(const struct import_ask *ask, struct import_table *t) {
  return read_table(ask, false, t);
}

/* ---- VTKHDF ---- */

static enum status read_times(const hid_t *file, void *data) {
  struct request *q = data;
  CHECK(hdf_is_there(*file, "VTKHDF/Points"), ERR_INPUT, "%s has no /VTKHDF/Points", q->ask->path);
  if (!hdf_is_there(*file, "VTKHDF/Steps/Values")) return import_one_step(&q->n, &q->times);
  enum status status =
      hdf_get_all(*file, "VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE, 0, &q->n, &q->times);
  return status == OK ? OK : status_context(status, "%s: ", q->ask->path);
}

static enum status carry_times(struct carrier *c, void *data) {
  struct request *q = data;
  return carry_array(c, &q->n, &q->times);
}

enum status import_vtkhdf_steps(const struct import_ask *ask, size_t *n, double **times) {
  struct request q = {.ask = ask};
  enum status status = result_read_safely(&(struct result_request){
      1, {ask->path}, .any = true, .data = &q, .read = read_times, .carry = carry_times});
  if (status == OK) {
    *n = q.n;
    *times = q.times;
  } else
    free(q.times);
  return status;
}

enum status import_vtkhdf_read(const struct import_ask *ask, struct import_table *t) {
  return read_table(ask, true, t);
}
