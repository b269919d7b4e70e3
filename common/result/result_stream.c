/* The particles of some outputs of a result, one output at a time. */
#include <stdlib.h>
#include <string.h>

#include "common/result/carry.h"
#include "common/result/result.h"
#include "common/result/result_hdf.h"
#include "common/result/result_open.h"

struct stream {
  const char *path;
  struct result_part part;
  size_t n_fields;
  const struct result_wanted *field; /* [n_fields] */
  size_t n;
  const size_t *output; /* [n] */
  enum status (*take)(void *data, size_t k, struct result_water *water);
  void *data;
  hid_t file;         /* in the child */
  enum status status; /* of what could not be read, whose message has been left */
};

/* ---- in the child ---- */

/* x and y of vectors alone. */
static void keep_plane(size_t n, double *value) {
  for (size_t i = 0; i < n; i++)
    for (size_t k = 0; k < 2; k++) value[2 * i + k] = value[3 * i + k];
}

/* Rows of a dataset, those of the points that are wanted, of `n` from row `first` on. */
static enum status read_rows(hid_t group, const char *name, size_t width, const struct stream *q,
                             hsize_t first, size_t n, double **values) {
  const struct result_part *part = &q->part;
  if (!part->point) return hdf_get_rows(group, name, H5T_NATIVE_DOUBLE, width, first, n, values);
  const size_t each = width ? width : 1, low = part->n ? part->point[0] : 0;
  const size_t span = part->n ? part->point[part->n - 1] + 1 - low : 0;
  TRY(hdf_get_rows(group, name, H5T_NATIVE_DOUBLE, width, first + low, span, values));
  for (size_t i = 0; i < part->n; i++)
    memmove(*values + each * i, *values + each * (part->point[i] - low), each * sizeof **values);
  return OK;
}

static enum status read_fields(hid_t file, const struct stream *q, hsize_t first, size_t n,
                               struct result_water *w) {
  hid_t data = -1;
  enum status status = OK;
  if (!q->n_fields) return OK;
  bool any = false;
  for (size_t k = 0; k < q->n_fields; k++) any = any || !q->field[k].optional;
  if (!any && !hdf_is_there(file, "VTKHDF/PointData")) return OK;
  ATTEMPT(hdf_open_group(file, "VTKHDF/PointData", &data));
  for (size_t k = 0; k < q->n_fields; k++) {
    const struct result_wanted *field = &q->field[k];
    if (field->optional && !hdf_is_there(data, field->name)) continue;
    ATTEMPT(read_rows(data, field->name, field->vector ? 3 : 0, q, first, n, &w->value[k]));
    if (field->vector) keep_plane(w->n, w->value[k]);
  }
done:
  if (data >= 0) H5Gclose(data);
  return status;
}

static enum status read_places(hid_t file, const struct stream *q, hsize_t first, size_t n,
                               struct result_water *w) {
  double *xyz = NULL;
  if (q->part.no_places) return OK;
  TRY(read_rows(file, "VTKHDF/Points", 3, q, first, n, &xyz));
  keep_plane(w->n, xyz);
  w->p = (double(*)[2])xyz;
  return OK;
}

static enum status read_water(hid_t file, const struct stream *q, size_t output,
                              struct result_water *w) {
  int64_t *first = NULL, *count = NULL;
  enum status status = OK;
  ATTEMPT(hdf_get_rows(file, "VTKHDF/Steps/PointOffsets", H5T_NATIVE_INT64, 0, output, 1, &first));
  ATTEMPT(hdf_get_rows(file, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, 0, output, 1, &count));
  if (*first < 0 || *count < 0) {
    status = status_raise(ERR_INPUT, "its dataset /VTKHDF/NumberOfPoints is inconsistent");
    goto done;
  }
  const struct result_part *part = &q->part;
  const size_t n = (size_t)*count;
  w->n = part->point ? part->n : n;
  if (part->point && part->n && part->point[part->n - 1] >= n) {
    status = status_raise(ERR_INPUT, "it has %zu points, and none of number %zu", n,
                          part->point[part->n - 1]);
    goto done;
  }
  ATTEMPT(read_places(file, q, (hsize_t)*first, n, w));
  ATTEMPT(read_fields(file, q, (hsize_t)*first, n, w));
done:
  free(first);
  free(count);
  return status;
}

/* Points are read while they are handed over, so that those of one output are in memory. */
static enum status keep_file(const hid_t *file, void *data) {
  struct stream *q = data;
  q->file = *file;
  return OK;
}

/* ---- from the child to its parent ---- */

static enum status carry_water(struct carrier *c, const struct stream *q, struct result_water *w) {
  if (q->part.no_places)
    TRY(carry_number(c, &w->n));
  else
    TRY(carry_array(c, &w->n, &w->p));
  for (size_t k = 0; k < q->n_fields; k++) {
    const size_t all = (q->field[k].vector ? 2 : 1) * w->n;
    size_t there = w->value[k] != NULL, n = all;
    TRY(carry_number(c, &there));
    if (!there) continue;
    TRY(carry_array(c, &n, &w->value[k]));
    CHECK(n == all, ERR_INPUT, "%s is inconsistent", q->path);
  }
  return OK;
}

/* Why an output cannot be read goes in the place of it, and nothing follows. */
static enum status carry_output(struct carrier *c, struct stream *q, size_t k,
                                struct result_water *w) {
  char *message = NULL;
  if (c->sending) {
    q->status = read_water(q->file, q, q->output[k], w);
    if (q->status != OK) status_context(q->status, "%s, output %zu: ", q->path, q->output[k]);
    message = (char *)status_message();
  }
  size_t outcome = q->status;
  TRY(carry_number(c, &outcome));
  if (outcome == OK) return carry_water(c, q, w);
  TRY(carry_text(c, &message));
  if (c->sending) return OK;
  q->status = status_raise(outcome <= INTERRUPTED ? (enum status)outcome : ERR_INPUT, "%s",
                           message ? message : "");
  free(message);
  return OK;
}

void result_water_free(struct result_water *w) {
  free(w->p);
  for (size_t k = 0; k < RESULT_WANTED; k++) free(w->value[k]);
  *w = (struct result_water){0};
}

static enum status carry_stream(struct carrier *c, void *data) {
  struct stream *q = data;
  for (size_t k = 0; k < q->n && q->status == OK; k++) {
    struct result_water w = {0};
    enum status status = carry_output(c, q, k, &w);
    if (status == OK && !c->sending && q->status == OK) q->status = q->take(q->data, k, &w);
    result_water_free(&w);
    if (status != OK) return status;
  }
  return OK;
}

enum status result_stream(const char *path, size_t n_fields, const struct result_wanted *field,
                          size_t n, const size_t *output,
                          enum status (*take)(void *data, size_t k, struct result_water *water),
                          void *data) {
  const struct result_part all = {0};
  return result_stream_part(path, &all, n_fields, field, n, output, take, data);
}

enum status result_stream_part(const char *path, const struct result_part *part, size_t n_fields,
                               const struct result_wanted *field, size_t n, const size_t *output,
                               enum status (*take)(void *data, size_t k, struct result_water *water),
                               void *data) {
  struct stream q = {path, *part, n_fields, field, n, output, take, data, -1, OK};
  CHECK(n_fields <= RESULT_WANTED, ERR_USAGE, "%zu fields at a time are too many", n_fields);
  TRY(result_read_safely(
      &(struct result_request){1, {path}, .data = &q, .read = keep_file, .carry = carry_stream}));
  return q.status;
}
