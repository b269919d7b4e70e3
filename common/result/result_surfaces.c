/* Surfaces of results that have particles alone. */
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/cloud/surface.h"
#include "common/result/result.h"

enum { MOST_POINTS = 4000000 }; /* read at once; the file is opened and checked each time */

struct batch {
  size_t n;
  size_t *output;                      /* [n] */
  struct result_cloud *volume, *other; /* [n] */
  double *x, *y, *area;                /* of one output */
  size_t room;
};

static bool has_field(const struct result_file *f, const char *name) {
  for (size_t k = 0; k < f->n_fields; k++)
    if (!strcmp(f->fields[k], name)) return true;
  return false;
}

/* The area of each particle: NULL where the file has none of it. */
static enum status read_batch(const struct result_file *f, struct batch *b) {
  const bool volume = has_field(f, "volume"), mass = has_field(f, "mass");
  TRY(result_read_points(f->path,
                         volume ? "volume"
                         : mass ? "mass"
                                : NULL,
                         b->n, b->output, b->volume));
  if (volume || !mass || !has_field(f, "density")) return OK;
  return result_read_points(f->path, "density", b->n, b->output, b->other);
}

static enum status find(const struct result_file *f, const struct geo_lines *walls, struct batch *b,
                        size_t k, struct cloud_surface *finder, struct geo_lines *out) {
  const struct result_cloud *q = &b->volume[k];
  const bool volume = has_field(f, "volume"), mass = has_field(f, "mass");
  if (q->n > b->room) {
    TRY(array_resize(&b->x, q->n, "particles"));
    TRY(array_resize(&b->y, q->n, "particles"));
    TRY(array_resize(&b->area, q->n, "particles"));
    b->room = q->n;
  }
  for (size_t i = 0; i < q->n; i++) {
    b->x[i] = q->p[i][0];
    b->y[i] = q->p[i][1];
    b->area[i] = volume ? q->value[i]
                 : mass ? q->value[i] / (b->other[k].n ? b->other[k].value[i] : f->density)
                        : 0;
  }
  const struct cloud cloud = {q->n, b->x, b->y, volume || mass ? b->area : NULL, f->spacing, NULL};
  enum status status = cloud_surface_extract(finder, &cloud, walls, out);
  return status == ERR_INPUT ? status_context(status, "%s: ", f->path) : status;
}

static enum status go_through(struct result_file *f, const struct geo_lines *walls, struct batch *b,
                              struct cloud_surface *finder) {
  for (size_t from = 0; from < f->n_outputs; from += b->n) {
    size_t points = 0;
    for (b->n = 0; from + b->n < f->n_outputs; b->n++) {
      points += (size_t)f->output_points[from + b->n];
      if (b->n && points > MOST_POINTS) break;
      b->output[b->n] = from + b->n;
    }
    enum status status = read_batch(f, b);
    for (size_t k = 0; k < b->n && status == OK; k++)
      status = find(f, walls, b, k, finder, &f->surface[from + k]);
    for (size_t k = 0; k < b->n; k++) {
      result_cloud_free(&b->volume[k]);
      result_cloud_free(&b->other[k]);
    }
    TRY(status);
  }
  return OK;
}

enum status result_find_surfaces(struct result_file *f, const struct geo_lines *walls) {
  struct batch b = {0};
  struct cloud_surface *finder = NULL;
  enum status status = OK;
  if (f->n_surfaces || !f->n_outputs) return OK;
  free(f->surface_time);
  free(f->surface);
  f->surface_time = NULL;
  f->surface = NULL;
  ATTEMPT(array_create(&f->surface_time, f->n_outputs, "surfaces"));
  ATTEMPT(array_create(&f->surface, f->n_outputs + 1, "surfaces"));
  f->n_surfaces = f->n_outputs;
  for (size_t k = 0; k < f->n_outputs; k++) f->surface_time[k] = f->output_time[k];
  ATTEMPT(array_create(&b.output, f->n_outputs, "outputs"));
  ATTEMPT(array_create(&b.volume, f->n_outputs, "outputs"));
  ATTEMPT(array_create(&b.other, f->n_outputs, "outputs"));
  ATTEMPT(cloud_surface_create(&finder));
  status = go_through(f, walls, &b, finder);
  f->surfaces_found = status == OK;
done:
  cloud_surface_destroy(finder);
  free(b.output);
  free(b.volume);
  free(b.other);
  free(b.x);
  free(b.y);
  free(b.area);
  return status;
}

enum status result_find_all_surfaces(size_t n, struct result_file *const *files) {
  const struct geo_lines *walls = &files[0]->walls;
  for (size_t i = 0; i < n && !walls->pieces; i++) walls = &files[i]->walls;
  for (size_t i = 0; i < n && walls->pieces; i++)
    TRY(result_find_surfaces(files[i], files[i]->walls.pieces ? &files[i]->walls : walls));
  return OK;
}
