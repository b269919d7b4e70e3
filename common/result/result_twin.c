#include "common/result/result_twin.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

static const double SAME = 1e-9; /* of a time: so near it is the same instant */

static void rows_destroy(size_t n, struct twin_rows *rows) {
  for (size_t i = 0; rows && i < n; i++) free(rows[i].row);
}

enum status result_twin_create(const struct case_file *c, const struct case_run *r,
                               struct result_twin **out) {
  struct result_twin *t = *out = calloc(1, sizeof *t);
  CHECK(t, ERR_MEMORY, "no memory for a coarser run");
  t->spacing = c->H / r->resolution;
  t->energy.width = RESULT_ENERGY_COLUMNS + r->solver->n_terms;
  TRY(array_create(&t->probes, c->n_probes, "probes of a coarser run"));
  TRY(array_create(&t->gauges, c->n_gauges, "gauges of a coarser run"));
  t->n_probes = c->n_probes;
  t->n_gauges = c->n_gauges;
  for (size_t i = 0; i < t->n_probes; i++) t->probes[i].width = 2;
  for (size_t i = 0; i < t->n_gauges; i++) t->gauges[i].width = 2;
  return OK;
}

void result_twin_destroy(struct result_twin *t) {
  if (!t) return;
  rows_destroy(1, &t->energy);
  rows_destroy(t->n_probes, t->probes);
  rows_destroy(t->n_gauges, t->gauges);
  for (size_t i = 0; i < t->n_events; i++) free(t->events[i].name);
  for (size_t i = 0; i < t->n_surfaces; i++) geo_lines_destroy(&t->surface[i]);
  free(t->probes);
  free(t->gauges);
  free(t->events);
  free(t->surface);
  free(t->surface_time);
  free(t);
}

enum status result_twin_add(struct twin_rows *rows, const double *row) {
  TRY(array_grow(&rows->row, &rows->room, (rows->n + 1) * rows->width, "rows of a coarser run"));
  memcpy(rows->row + rows->n++ * rows->width, row, rows->width * sizeof *row);
  return OK;
}

enum status result_twin_add_event(struct result_twin *t, const char *name, const double at[3]) {
  TRY(array_grow(&t->events, &t->event_room, t->n_events + 1, "events of a coarser run"));
  struct twin_event *e = &t->events[t->n_events];
  e->name = strdup(name);
  CHECK(e->name, ERR_MEMORY, "no memory for a name");
  memcpy(e->at, at, sizeof e->at);
  t->n_events++;
  return OK;
}

enum status result_twin_add_surface(struct result_twin *t, double time,
                                    const struct geo_lines *surface) {
  size_t room = t->surface_room; /* the two arrays grow together */
  TRY(array_grow(&t->surface_time, &room, t->n_surfaces + 1, "surfaces of a coarser run"));
  TRY(array_grow(&t->surface, &t->surface_room, t->n_surfaces + 1, "surfaces of a coarser run"));
  t->surface_time[t->n_surfaces] = time;
  t->surface[t->n_surfaces] = (struct geo_lines){0};
  return geo_lines_copy(&t->surface[t->n_surfaces++], surface);
}

static bool same(double a, double b) {
  return fabs(a - b) <= SAME * fabs(b);
}

const double *result_twin_row(struct twin_rows *rows, double time) {
  while (rows->cursor < rows->n) {
    const double *row = rows->row + rows->cursor * rows->width;
    if (same(row[0], time)) return row;
    if (row[0] > time) return NULL;
    rows->cursor++;
  }
  return NULL;
}

const struct twin_event *result_twin_event(const struct result_twin *t, const char *name,
                                           size_t number) {
  for (size_t i = 0; i < t->n_events; i++)
    if (!strcmp(t->events[i].name, name) && !number--) return &t->events[i];
  return NULL;
}

const struct geo_lines *result_twin_surface(const struct result_twin *t, double time) {
  for (size_t i = 0; i < t->n_surfaces; i++)
    if (same(t->surface_time[i], time)) return &t->surface[i];
  return NULL;
}
