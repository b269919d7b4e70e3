/* Surfaces of results that have particles alone. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/cloud/surface.h"
#include "common/result/result.h"
#include "common/tank/room.h"
#include "common/tank/tank.h"

struct finding {
  struct result_file *f;
  struct tank tank;
  struct geo_lines walls; /* owned */
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
    q->x[i] = tank_wrap(&q->tank, 0, w->p[i][0]);
    q->y[i] = tank_wrap(&q->tank, 1, w->p[i][1]);
  }
  const struct cloud cloud = {w->n, q->x, q->y, areas_of(q->f, w), q->f->spacing, &q->tank};
  enum status status = cloud_surface_extract(q->finder, &cloud, &q->walls, &q->f->surface[k]);
  return status == ERR_INPUT ? status_context(status, "%s: ", q->f->path) : status;
}

/* `of` has the walls of the tank, and the case that may call its sides periodic. */
static enum status take_tank(const struct result_file *of, struct finding *q) {
  bool periodic[2];
  TRY(case_periodic_ends(of->case_text, periodic));
  const struct geo_box box = geo_lines_box(&of->walls);
  const double wide = box.max[0] - box.min[0], high = box.max[1] - box.min[1];
  const bool round = tank_can_be_round(&of->walls, CASE_SAME * fmax(wide, high)) &&
                     fmin(wide, high) > q->f->spacing;
  for (int axis = 0; axis < 2; axis++) periodic[axis] = periodic[axis] && periodic[0] && round;
  q->tank = tank_of(&of->walls, periodic);
  return tank_outline(&q->tank, &of->walls, &q->walls);
}

static enum status find_surfaces(struct result_file *f, const struct result_file *of) {
  struct finding q = {.f = f};
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
  ATTEMPT(take_tank(of, &q));
  ATTEMPT(cloud_surface_create(&q.finder));
  status = result_stream(f->path, fields_wanted(f, wanted), wanted, f->n_outputs, output, find, &q);
  f->surfaces_found = status == OK;
done:
  cloud_surface_destroy(q.finder);
  geo_lines_destroy(&q.walls);
  free(output);
  free(q.x);
  free(q.y);
  return status;
}

enum status result_find_all_surfaces(size_t n, struct result_file *const *files) {
  const struct result_file *of = files[0];
  for (size_t i = 0; i < n && !of->walls.pieces; i++) of = files[i];
  for (size_t i = 0; i < n && of->walls.pieces; i++)
    TRY(find_surfaces(files[i], files[i]->walls.pieces ? files[i] : of));
  return OK;
}
