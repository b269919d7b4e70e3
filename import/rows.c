#include "import/rows.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "import/lists.h"

struct walk {
  const struct import_sidecar *s;
  const struct import_section *section;
  const struct import_item *item;
  bool series;
  double last; /* s, time of the rows before */
  enum status (*take)(void *data, const struct import_rows *rows);
  void *data;
};

/* What the rows [a, b) have instead. */
static enum status no_kind(const struct walk *w, const struct import_table *t, size_t a, size_t b) {
  const double *kind = t->column[IMPORT_only], *time = t->column[IMPORT_time];
  double seen[8];
  size_t n = 0;
  char found[256] = "", at[64] = "";
  for (size_t i = a; i < b; i++) {
    size_t k = 0;
    while (k < n && seen[k] != kind[i] && !(isnan(seen[k]) && isnan(kind[i]))) k++;
    if (k < n) continue;
    const bool room = n < sizeof seen / sizeof *seen;
    const size_t end = strlen(found);
    snprintf(found + end, sizeof found - end, room ? "%s%.9g" : "%s...", n ? ", " : "", kind[i]);
    if (!room) break;
    seen[n++] = kind[i];
  }
  if (time) snprintf(at, sizeof at, " at its time %.9g", time[a]);
  return status_raise(ERR_INPUT,
                      "%s: %s has no particle whose '%s' is %.9g%s: found %s; allowed for the key "
                      "is: a value that is there",
                      w->item->where, w->item->file, w->section->column[IMPORT_only],
                      w->section->is, at, found);
}

/* Leaves the rows of another kind out, of which no time may consist. */
static enum status keep_only(const struct walk *w, struct import_table *t) {
  const double *kind = t->column[IMPORT_only], *time = t->column[IMPORT_time];
  size_t n = 0;
  if (!kind) return OK;
  for (size_t a = 0, b; a < t->n; a = b) {
    bool some = false;
    for (b = a; b < t->n && (!time || time[b] == time[a] || b == a); b++)
      some = some || kind[b] == w->section->is;
    if (!some) return no_kind(w, t, a, b);
  }
  for (size_t i = 0; i < t->n; i++) {
    if (kind[i] != w->section->is) continue;
    for (size_t k = 0; k < IMPORT_N_ROLES; k++)
      if (t->column[k]) t->column[k][n] = t->column[k][i];
    n++;
  }
  t->n = n;
  return OK;
}

static void to_si(const struct import_sidecar *s, struct import_table *t) {
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    const double unit = import_unit(s, (enum import_role)k);
    for (size_t i = 0; t->column[k] && i < t->n; i++) t->column[k][i] *= unit;
  }
  for (size_t i = 0; i < t->n; i++) {
    if (t->column[IMPORT_time]) t->column[IMPORT_time][i] += s->offset;
    if (t->column[IMPORT_x]) t->column[IMPORT_x][i] -= s->origin[0];
    if (t->column[IMPORT_y]) t->column[IMPORT_y][i] -= s->origin[1];
    if (t->column[IMPORT_elevation]) t->column[IMPORT_elevation][i] -= s->origin[1];
  }
}

static enum status give(struct walk *w, const struct import_table *t, double time, size_t a,
                        size_t b) {
  struct import_rows rows = {.time = time, .n = b - a, .mesh = &t->mesh, .path = w->item->file};
  for (size_t k = 0; k < IMPORT_N_ROLES; k++)
    if (t->column[k]) rows.column[k] = t->column[k] + a;
  if (!w->series) {
    CHECK(isfinite(time), ERR_INPUT,
          "%s: %s has no time; give it the key time, or name in time_after what holds it",
          w->item->where, w->item->file);
    CHECK(time > w->last, ERR_INPUT,
          "%s: %s has the time %.9g s after %.9g s; times must rise: put the files in order, or "
          "correct the offset and units",
          w->item->where, w->item->file, time, w->last);
    w->last = time;
  }
  enum status status = w->take(w->data, &rows);
  return status == ERR_INPUT ? status_context(status, "%s: ", w->item->where) : status;
}

/* A long table: rows of the same time follow each other. */
static enum status give_by_time(struct walk *w, const struct import_table *t) {
  const double *time = t->column[IMPORT_time];
  for (size_t a = 0, b; a < t->n; a = b) {
    for (b = a + 1; b < t->n && time[b] == time[a];) b++;
    TRY(give(w, t, time[a], a, b));
  }
  return OK;
}

static enum status check_series_times(const struct walk *w, const struct import_table *t) {
  const double *time = t->column[IMPORT_time];
  for (size_t i = 0; i < t->n; i++)
    CHECK(isfinite(time[i]) && (!i || time[i] >= time[i - 1]), ERR_INPUT,
          "%s: row %zu of %s has the time %.9g s; times of a series must be there and not fall",
          w->item->where, i + 1, w->item->file, time[i]);
  return OK;
}

static enum status read_step(struct walk *w, struct import_ask *ask, double own) {
  struct import_table t;
  enum status status = import_formats[w->section->format].read(ask, &t);
  if (status != OK) return status_context(status, "%s: ", w->item->where);
  status = keep_only(w, &t);
  if (status != OK) {
    import_table_destroy(&t);
    return status;
  }
  to_si(w->s, &t);
  const double unit = w->s->unit.time;
  double time = w->item->time;
  if (isnan(time) && !isnan(t.time)) time = t.time * unit;
  if (isnan(time) && !isnan(own)) time = own * unit;
  if (w->series) {
    status = check_series_times(w, &t);
    if (status == OK) status = give(w, &t, NAN, 0, t.n);
  } else if (t.column[IMPORT_time])
    status = give_by_time(w, &t);
  else
    status = give(w, &t, time + w->s->offset, 0, t.n);
  import_table_destroy(&t);
  return status;
}

/* `own`: a time that a list of files gives. */
static enum status read_file(struct walk *w, double own) {
  const struct import_section *section = w->section;
  struct import_ask ask = {.path = w->item->file,
                           .separator = ",;\t "[section->separator],
                           .time_after = section->time_after,
                           .grid = section->column[IMPORT_field] != NULL,
                           .along = section->along,
                           .up = section->up,
                           .slice = section->slice / w->s->unit.length};
  double *times = NULL;
  size_t n = 0;
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) ask.names[k] = section->column[k];
  enum status status = import_formats[section->format].steps(&ask, &n, &times);
  if (status != OK) return status_context(status, "%s: ", w->item->where);
  if (n > 1 && !isnan(w->item->time))
    status =
        status_raise(ERR_INPUT, "%s: %s has %zu times of its own, and the key time beside them",
                     w->item->where, w->item->file, n);
  for (ask.step = 0; ask.step < n && status == OK; ask.step++)
    status = read_step(w, &ask, isnan(own) ? times[ask.step] : own);
  free(times);
  return status;
}

/* One file, or all those that a list names. */
static enum status read_item(struct walk *w) {
  const struct import_item *item = w->item;
  struct import_list list;
  if (w->section->format != IMPORT_FORMAT_vtk || !import_is_list(item->file))
    return read_file(w, NAN);
  enum status status = import_list_read(item->file, &list);
  if (status != OK) return status_context(status, "%s: ", item->where);
  for (size_t i = 0; i < list.n && status == OK; i++) {
    struct import_item one = *item;
    one.file = list.item[i].file;
    w->item = &one;
    status = read_file(w, list.item[i].time);
  }
  w->item = item;
  import_list_destroy(&list);
  return status;
}

enum status import_each(const struct import_sidecar *s, const struct import_section *section,
                        bool series,
                        enum status (*take)(void *data, const struct import_rows *rows),
                        void *data) {
  struct walk w = {s, section, NULL, series, -INFINITY, take, data};
  for (size_t i = 0; i < section->n_items; i++) {
    w.item = &section->items[i];
    TRY(read_item(&w));
  }
  return OK;
}
