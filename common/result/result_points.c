/* The particles of a few outputs of a result, one field at a time. */
#include <stdlib.h>

#include "common/result/carry.h"
#include "common/result/result.h"
#include "common/result/result_hdf.h"
#include "common/result/result_open.h"

struct points_request {
  const char *path, *field;
  size_t width; /* numbers of a row of the field in the file: 0, a scalar, or 3, a vector */
  size_t n;
  const size_t *output;       /* [n] */
  struct result_cloud *cloud; /* [n] */
};

/* x and y of vectors alone. */
static void keep_plane(struct result_cloud *q) {
  for (size_t i = 0; i < q->n; i++)
    for (size_t k = 0; k < 2; k++) q->value[2 * i + k] = q->value[3 * i + k];
}

static enum status read_points(hid_t file, const char *field, size_t width, size_t output,
                               struct result_cloud *q) {
  int64_t *first = NULL, *count = NULL;
  double(*xyz)[3] = NULL;
  hid_t data = -1;
  enum status status = OK;
  ATTEMPT(hdf_get_rows(file, "VTKHDF/Steps/PointOffsets", H5T_NATIVE_INT64, 0, output, 1, &first));
  ATTEMPT(hdf_get_rows(file, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, 0, output, 1, &count));
  if (*first < 0 || *count < 0) {
    status = status_raise(ERR_INPUT, "its dataset /VTKHDF/NumberOfPoints is inconsistent");
    goto done;
  }
  q->n = (size_t)*count;
  ATTEMPT(hdf_get_rows(file, "VTKHDF/Points", H5T_NATIVE_DOUBLE, 3, (hsize_t)*first, q->n, &xyz));
  if (field) {
    ATTEMPT(hdf_open_group(file, "VTKHDF/PointData", &data));
    ATTEMPT(hdf_get_rows(data, field, H5T_NATIVE_DOUBLE, width, (hsize_t)*first, q->n, &q->value));
  } else
    ATTEMPT(array_create(&q->value, q->n, "points"));
  if (width) keep_plane(q);
  q->p = malloc((q->n + 1) * sizeof *q->p);
  if (!q->p) {
    status = status_raise(ERR_MEMORY, "no memory for %zu points", q->n);
    goto done;
  }
  for (size_t i = 0; i < q->n; i++) {
    q->p[i][0] = xyz[i][0];
    q->p[i][1] = xyz[i][1];
  }
done:
  free(first);
  free(count);
  free(xyz);
  if (data >= 0) H5Gclose(data);
  return status;
}

static enum status read_points_file(const hid_t *file, void *data) {
  struct points_request *q = data;
  for (size_t k = 0; k < q->n; k++) {
    enum status status = read_points(*file, q->field, q->width, q->output[k], &q->cloud[k]);
    if (status != OK) return status_context(status, "%s, output %zu: ", q->path, q->output[k]);
  }
  return OK;
}

static enum status carry_points(struct carrier *c, void *data) {
  struct points_request *q = data;
  for (size_t k = 0; k < q->n; k++) {
    struct result_cloud *cloud = &q->cloud[k];
    const size_t each = q->width ? 2 : 1;
    size_t n = each * cloud->n;
    TRY(carry_array(c, &cloud->n, &cloud->p));
    TRY(carry_array(c, &n, &cloud->value));
    CHECK(n == each * cloud->n, ERR_INPUT, "%s, output %zu, is inconsistent", q->path,
          q->output[k]);
  }
  return OK;
}

void result_cloud_free(struct result_cloud *cloud) {
  free(cloud->p);
  free(cloud->value);
  *cloud = (struct result_cloud){0};
}

static enum status read_safely(struct points_request *q) {
  for (size_t k = 0; k < q->n; k++) q->cloud[k] = (struct result_cloud){0};
  enum status status = result_read_safely(&(struct result_request){
      1, {q->path}, .data = q, .read = read_points_file, .carry = carry_points});
  for (size_t k = 0; k < q->n && status != OK; k++) result_cloud_free(&q->cloud[k]);
  return status;
}

enum status result_read_points(const char *path, const char *field, size_t n, const size_t *output,
                               struct result_cloud *cloud) {
  return read_safely(&(struct points_request){path, field, 0, n, output, cloud});
}

enum status result_read_vectors(const char *path, const char *field, size_t n, const size_t *output,
                                struct result_cloud *cloud) {
  return read_safely(&(struct points_request){path, field, 3, n, output, cloud});
}
