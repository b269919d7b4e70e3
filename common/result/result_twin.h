/* What error bars need of a coarser run of the same case, in memory. Internal. */
#pragma once
#include "common/result/result_layout.h"

/* Rows of numbers, the time first, which does not fall. */
struct twin_rows {
  size_t width, n, room;
  double *row;   /* [n][width], owned */
  size_t cursor; /* where the last search ended */
};

struct twin_event {
  char *name;
  double at[3]; /* time, x, y */
};

struct result_twin {
  double spacing; /* m */
  size_t n_probes, n_gauges;
  struct twin_rows energy, *probes, *gauges; /* [n_probes], [n_gauges], owned */
  size_t n_events, event_room;
  struct twin_event *events;
  size_t n_surfaces, surface_room;
  double *surface_time; /* [n_surfaces] */
  struct geo_lines *surface;
};

enum status result_twin_create(const struct case_file *c, const struct case_run *r,
                               struct result_twin **out);
void result_twin_destroy(struct result_twin *t); /* NULL is fine */

enum status result_twin_add(struct twin_rows *rows, const double *row);
enum status result_twin_add_event(struct result_twin *t, const char *name, const double at[3]);
enum status result_twin_add_surface(struct result_twin *t, double time,
                                    const struct geo_lines *surface);

/* The row of the same instant, or NULL: times are asked for in their order. */
const double *result_twin_row(struct twin_rows *rows, double time);
/* The event of that name that is the `number`-th of it, from 0; NULL: there is none. */
const struct twin_event *result_twin_event(const struct result_twin *t, const char *name,
                                           size_t number);
const struct geo_lines *result_twin_surface(const struct result_twin *t, double time);
