#include "common/result/result_vtkhdf.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/result_hdf.h"

enum { TOPOLOGIES = 4 };
static const char *const topology[TOPOLOGIES] = {"Vertices", "Lines", "Polygons", "Strips"};
enum { STEP_ROWS = 256, POINT_ROWS = 4096 }; /* of a chunk */

struct field {
  size_t width; /* 0: a scalar */
  struct hdf_column *values, *offset;
};

struct vtkhdf {
  hid_t root, steps;
  enum result_cells cells;
  size_t n_fields;

  struct hdf_columns *columns;          /* which own all these: */
  struct hdf_column *n_points, *points; /* one row an output, one row a point */
  struct {
    struct hdf_column *n_cells, *n_ids, *connectivity, *offsets;
  } topology[TOPOLOGIES];
  struct hdf_column *value, *part_offset, *n_parts, *point_offset, *cell_offset, *id_offset;
  struct field *field; /* [n_fields], owned */

  int64_t n_steps;
  size_t room; /* points that the scratch arrays hold */
  double (*scratch)[3];
  int64_t *ids; /* 0, 1, 2 ... [room + 1] */
};

static enum status create_topologies(struct vtkhdf *v) {
  for (int t = 0; t < TOPOLOGIES; t++) {
    hid_t group = -1;
    TRY(hdf_group_create(v->root, topology[t], &group));
    struct hdf_column **column[] = {&v->topology[t].n_cells, &v->topology[t].n_ids,
                                    &v->topology[t].connectivity, &v->topology[t].offsets};
    static const char *const name[][2] = {
        {"NumberOfCells", "cells of each output"},
        {"NumberOfConnectivityIds", "point numbers that the cells of each output list"},
        {"Connectivity", "point numbers; outputs share them, see Steps/ConnectivityIdOffsets"},
        {"Offsets", "where each cell begins in Connectivity; one more than cells in every output"}};
    enum status status = OK;
    for (size_t i = 0; i < 4 && status == OK; i++) {
      const struct hdf_rows rows = {H5T_NATIVE_INT64, 0, i < 2 ? STEP_ROWS : POINT_ROWS};
      status = hdf_column_create(v->columns, group, name[i][0], &rows, "1", name[i][1], column[i]);
    }
    H5Gclose(group);
    TRY(status);
  }
  return OK;
}

static enum status create_steps(struct vtkhdf *v) {
  TRY(hdf_group_create(v->root, "Steps", &v->steps));
  TRY(hdf_set_integers(v->steps, "NSteps", 1, &v->n_steps));
  const struct hdf_rows times = {H5T_NATIVE_DOUBLE, 0, STEP_ROWS};
  TRY(hdf_column_create(v->columns, v->steps, "Values", &times, "s", "physical time of each output",
                        &v->value));
  struct {
    const char *name;
    size_t width;
    struct hdf_column **column;
    const char *help;
  } table[] = {{"PartOffsets", 0, &v->part_offset, "first part of each output"},
               {"NumberOfParts", 0, &v->n_parts, "parts of each output"},
               {"PointOffsets", 0, &v->point_offset, "first row of Points of each output"},
               {"CellOffsets", TOPOLOGIES, &v->cell_offset, "first cell of each output"},
               {"ConnectivityIdOffsets", TOPOLOGIES, &v->id_offset, "first entry of Connectivity"}};
  for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
    const struct hdf_rows rows = {H5T_NATIVE_INT64, table[i].width, STEP_ROWS};
    TRY(hdf_column_create(v->columns, v->steps, table[i].name, &rows, "1", table[i].help,
                          table[i].column));
  }
  return OK;
}

static enum status create_fields(struct vtkhdf *v, const struct result_field *fields) {
  const struct hdf_rows counts = {H5T_NATIVE_INT64, 0, STEP_ROWS};
  hid_t data = -1, offsets = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(v->root, "PointData", &data));
  ATTEMPT(hdf_group_create(v->steps, "PointDataOffsets", &offsets));
  for (size_t i = 0; i < v->n_fields; i++) {
    struct field *f = &v->field[i];
    f->width = fields[i].b ? 3 : 0;
    const struct hdf_rows values = {H5T_NATIVE_DOUBLE, f->width, POINT_ROWS};
    ATTEMPT(hdf_column_create(v->columns, data, fields[i].name, &values, fields[i].units,
                              fields[i].help, &f->values));
    ATTEMPT(hdf_column_create(v->columns, offsets, fields[i].name, &counts, "1",
                              "first row of each output", &f->offset));
  }
done:
  if (offsets >= 0) H5Gclose(offsets);
  if (data >= 0) H5Gclose(data);
  return status;
}

enum status vtkhdf_create(hid_t root, struct hdf_columns *columns, enum result_cells cells,
                          size_t n_fields, const struct result_field *fields, struct vtkhdf **out) {
  enum status status = OK;
  struct vtkhdf *v = *out = calloc(1, sizeof *v);
  CHECK(v, ERR_MEMORY, "no memory for the points of a result");
  v->root = v->steps = -1;
  v->columns = columns;
  v->cells = cells;
  v->n_fields = n_fields;
  v->field = calloc(n_fields + 1, sizeof *v->field);
  if (!v->field) {
    status = status_raise(ERR_MEMORY, "no memory for the points of a result");
    goto done;
  }
  ATTEMPT(hdf_group_create(root, "VTKHDF", &v->root));
  ATTEMPT(hdf_set_integers(v->root, "Version", 2, (int64_t[]){2, 0}));
  ATTEMPT(hdf_set_ascii(v->root, "Type", "PolyData"));
  ATTEMPT(hdf_column_create(columns, v->root, "NumberOfPoints",
                            &(struct hdf_rows){H5T_NATIVE_INT64, 0, STEP_ROWS}, "1",
                            "points of each output", &v->n_points));
  ATTEMPT(hdf_column_create(columns, v->root, "Points",
                            &(struct hdf_rows){H5T_NATIVE_DOUBLE, 3, POINT_ROWS}, "m",
                            "x, y and z = 0 of the points of all outputs", &v->points));
  ATTEMPT(create_topologies(v));
  ATTEMPT(create_steps(v));
  ATTEMPT(create_fields(v, fields));
done:
  if (status != OK) {
    vtkhdf_destroy(v);
    *out = NULL;
  }
  return status;
}

static enum status reserve(struct vtkhdf *v, size_t n) {
  if (v->ids && n <= v->room) return OK;
  size_t room = n + n / 4 + 16;
  free(v->scratch);
  free(v->ids);
  v->scratch = malloc(room * sizeof *v->scratch);
  v->ids = malloc((room + 1) * sizeof *v->ids);
  v->room = v->scratch && v->ids ? room : 0;
  CHECK(v->room, ERR_MEMORY, "no memory for %zu points", n);
  for (size_t i = 0; i <= room; i++) v->ids[i] = (int64_t)i;
  return OK;
}

static enum status append_vectors(struct vtkhdf *v, struct hdf_column *column, size_t n,
                                  const double *a, const double *b) {
  for (size_t i = 0; i < n; i++) {
    v->scratch[i][0] = a[i];
    v->scratch[i][1] = b[i];
    v->scratch[i][2] = 0;
  }
  return hdf_column_append(column, n, v->scratch);
}

/* Every point is a cell of its own, or all are one line; the other kinds of cells are empty. */
static enum status append_cells(struct vtkhdf *v, size_t n) {
  int64_t first[TOPOLOGIES] = {0};
  for (int t = 0; t < TOPOLOGIES; t++) {
    bool ours = t == (v->cells == RESULT_LINE ? 1 : 0);
    int64_t ids = ours ? (int64_t)n : 0, cells = v->cells == RESULT_LINE && ours ? 1 : ids;
    if (ours) /* offsets hold one number more than cells in each output before this one */
      first[t] = (int64_t)hdf_column_length(v->topology[t].offsets) - v->n_steps;
    TRY(hdf_column_append(v->topology[t].n_cells, 1, &cells));
    TRY(hdf_column_append(v->topology[t].n_ids, 1, &ids));
    if (v->cells == RESULT_LINE && ours)
      TRY(hdf_column_append(v->topology[t].offsets, 2, (int64_t[]){0, ids}));
    else
      TRY(hdf_column_append(v->topology[t].offsets, (size_t)cells + 1, v->ids));
    size_t listed = hdf_column_length(v->topology[t].connectivity);
    if ((size_t)ids > listed) /* always 0, 1, 2 ...: the longest output serves all */
      TRY(hdf_column_append(v->topology[t].connectivity, (size_t)ids - listed, v->ids + listed));
  }
  TRY(hdf_column_append(v->cell_offset, 1, first));
  return hdf_column_append(v->id_offset, 1, (int64_t[TOPOLOGIES]){0});
}

enum status vtkhdf_step(struct vtkhdf *v, double time, size_t n, const double *x, const double *y,
                        const struct result_field *fields, size_t *first) {
  TRY(reserve(v, n));
  *first = hdf_column_length(v->points);
  int64_t count = (int64_t)n, row = (int64_t)*first, one = 1;
  TRY(append_cells(v, n));
  TRY(append_vectors(v, v->points, n, x, y));
  TRY(hdf_column_append(v->n_points, 1, &count));
  for (size_t i = 0; i < v->n_fields; i++) {
    const struct field *f = &v->field[i];
    assert((f->width == 3) == (fields[i].b != NULL));
    TRY(hdf_column_append(f->offset, 1, &row));
    TRY(fields[i].b ? append_vectors(v, f->values, n, fields[i].a, fields[i].b)
                    : hdf_column_append(f->values, n, fields[i].a));
  }
  TRY(hdf_column_append(v->value, 1, &time));
  TRY(hdf_column_append(v->part_offset, 1, &v->n_steps));
  TRY(hdf_column_append(v->n_parts, 1, &one));
  TRY(hdf_column_append(v->point_offset, 1, &row));
  v->n_steps++;
  return hdf_set_integers(v->steps, "NSteps", 1, &v->n_steps);
}

void vtkhdf_destroy(struct vtkhdf *v) {
  if (!v) return;
  if (v->steps >= 0) H5Gclose(v->steps);
  if (v->root >= 0) H5Gclose(v->root);
  free(v->field);
  free(v->scratch);
  free(v->ids);
  free(v);
}
