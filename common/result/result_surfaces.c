/* Surfaces of results that have particles alone. */
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/cloud/surface.h"
#include "common/result/result.h"

struct finding {
  struct result_file *f;
  const struct geo_lines *walls;
  struct cloud_surface *finder;
  double *x, *y; /* of one output, [room], owned */
  size_t room;
};

static bool has_field(const struct result_file *f, const char *name) {
  for (size_t k = 0; k < f->n_fields; k++)
    if (!strcmp(f->fields[k], name)) return true;
  return false;
}

/* What areas are made of: volumes, or masses, over densities where the file has them. */
static size_t fields_wanted(const struct result_file *f, struct result_wanted *wanted) {
  if (has_field(f, "volume")) {
    wanted[0] = (struct result_wanted){.name = "volume"};
    return 1;
  }
  if (!has_field(f, "mass")) return 0;
  wanted[0] = (struct result_wanted){.name = "mass"};
  wanted[1] = (struct result_wanted){.name = "density"};
  return has_field(f, "density") ? 2 : 1;
}

/* The area of each particle, in place of what was read: NULL where the file has none of it. */
static const double *areas_of(const struct result_file *f, struct result_water *w) {
  double *area = w->value[0];
  if (area && !has_field(f, "volume"))
    for (size_t i = 0; i < w->n; i++) area[i] /= w->value[1] ? w->value[1][i] : f->density;
  return area;
}

static enum status find(void *data, size_t k, struct result_water *w) {
  struct finding *q = data;
  if (w->n > q->room) {
    TRY(array_resize(&q->x, w->n, "particles"));
    TRY(array_resize(&q->y, w->n, "particles"));
    q->room = w->n;
  }
  for (size_t i = 0; i < w->n; i++) {
    q->x[i] = w->p[i][0];
    q->y[i] = w->p[i][1];
  }
  const struct cloud cloud = {w->n, q->x, q->y, areas_of(q->f, w), q->f->spacing, NULL};
  enum status status = cloud_surface_extract(q->finder, &cloud, q->walls, &q->f->surface[k]);
  return status == ERR_INPUT ? status_context(status, "%s: ", q->f->path) : status;
}

enum status result_find_surfaces(struct result_file *f, const struct geo_lines *walls) {
  struct finding q = {.f = f, .walls = walls};
  struct result_wanted wanted[2];
  size_t *output = NULL;
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
  ATTEMPT(array_create(&output, f->n_outputs, "outputs"));
  for (size_t k = 0; k < f->n_outputs; k++) output[k] = k;
  ATTEMPT(cloud_surface_create(&q.finder));
  status = result_stream(f->path, fields_wanted(f, wanted), wanted, f->n_outputs, output, find, &q);
  f->surfaces_found = status == OK;
done:
  cloud_surface_destroy(q.finder);
  free(output);
  free(q.x);
  free(q.y);
  return status;
}

enum status result_find_all_surfaces(size_t n, struct result_file *const *files) {
  const struct geo_lines *walls = &files[0]->walls;
  for (size_t i = 0; i < n && !walls->pieces; i++) walls = &files[i]->walls;
  for (size_t i = 0; i < n && walls->pieces; i++)
    TRY(result_find_surfaces(files[i], files[i]->walls.pieces ? &files[i]->walls : walls));
  return OK;
}
