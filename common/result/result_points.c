/* The particles of a few outputs of a result, together. */
#include <stdlib.h>

#include "common/base/array.h"
#include "common/result/result.h"

static enum status keep(void *data, size_t k, struct result_water *w) {
  struct result_cloud *cloud = data;
  if (!w->value[0]) TRY(array_create(&w->value[0], w->n, "points")); /* no field was wanted */
  cloud[k] = (struct result_cloud){w->n, w->p, w->value[0]};
  *w = (struct result_water){0};
  return OK;
}

void result_cloud_free(struct result_cloud *cloud) {
  free(cloud->p);
  free(cloud->value);
  *cloud = (struct result_cloud){0};
}

static enum status read_together(const char *path, const char *field, bool vector, size_t n,
                                 const size_t *output, struct result_cloud *cloud) {
  const struct result_wanted wanted = {field, vector, false};
  for (size_t k = 0; k < n; k++) cloud[k] = (struct result_cloud){0};
  const enum status status = result_stream(path, field ? 1 : 0, &wanted, n, output, keep, cloud);
  for (size_t k = 0; k < n && status != OK; k++) result_cloud_free(&cloud[k]);
  return status;
}

enum status result_read_points(const char *path, const char *field, size_t n, const size_t *output,
                               struct result_cloud *cloud) {
  return read_together(path, field, false, n, output, cloud);
}

enum status result_read_vectors(const char *path, const char *field, size_t n, const size_t *output,
                                struct result_cloud *cloud) {
  return read_together(path, field, true, n, output, cloud);
}
