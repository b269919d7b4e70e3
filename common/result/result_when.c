#include "common/result/result_when.h"

#include <fnmatch.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/result_hdf.h"

static bool begins(const char *name, const char *with) {
  return !strncmp(name, with, strlen(with));
}

/* ---- when ---- */

struct index {
  size_t n;
  int64_t *at; /* [n]; NULL: the k-th is k, as where every surface has one piece */
};

static bool index_read(hid_t file, const char *name, struct index *x) {
  *x = (struct index){0};
  return !hdf_is_there(file, name) ||
         hdf_get_all(file, name, H5T_NATIVE_INT64, 0, &x->n, &x->at) == OK;
}

/* How the rows of `name` are put into parts: through up to two lists of first rows, each counted in
 * the next. One without a list has a row for each time. `ends`: its first row is zero, and each
 * further one where a part ends. */
struct kind {
  const char *pattern, *times;
  const char *list[2];
  bool ends;
};

static const struct kind kinds[] = {
    {"surface/points", "surface/time", {"surface/first_piece", "surface/first_point"}, false},
    {"errors/surface/distance",
     "surface/time",
     {"surface/first_piece", "surface/first_point"},
     false},
    {"surface/first_point", "surface/time", {"surface/first_piece", NULL}, true},
    {"surface/closed", "surface/time", {"surface/first_piece", NULL}, false},
    {"surface/first_piece", "surface/time", {NULL, NULL}, true},
    {"surface/time", "surface/time", {NULL, NULL}, false},
    {"VTKHDF/Points", "VTKHDF/Steps/Values", {"VTKHDF/Steps/PointOffsets", NULL}, false},
    {"VTKHDF/PointData/*", "VTKHDF/Steps/Values", {"VTKHDF/Steps/PointOffsets", NULL}, false},
    {"VTKHDF/*NumberOf*", "VTKHDF/Steps/Values", {NULL, NULL}, false},
    {"VTKHDF/Steps/*", "VTKHDF/Steps/Values", {NULL, NULL}, false},
};

static const struct kind *kind_of(const char *name) {
  for (size_t k = 0; k < sizeof kinds / sizeof *kinds; k++)
    if (!fnmatch(kinds[k].pattern, name, 0)) return &kinds[k];
  return NULL;
}

/* The dataset with the times of a member of a group of its own: "series/energy/time". */
static bool sibling_times(const char *name, char *times, size_t room) {
  const char *slash = strrchr(name, '/');
  const bool errors = begins(name, "errors/");
  if (!slash || !(errors || begins(name, "series/") || begins(name, "events/"))) return false;
  const char *from = errors ? name + strlen("errors/") : name;
  if (from > slash) return false;
  snprintf(times, room, "%s%.*stime", errors ? "series/" : "", (int)(slash - from) + 1, from);
  return true;
}

static bool part_row(size_t part, const struct index list[2], size_t *row) {
  *row = part;
  for (int k = 0; k < 2; k++) {
    if (!list[k].at) continue;
    if (*row >= list[k].n || list[k].at[*row] < 0) return false;
    *row = (size_t)list[k].at[*row];
  }
  return true;
}

/* The first row of each of w->n parts, as far as they are in order and within `rows`. */
static void parts_take(hid_t file, const struct kind *kind, size_t rows, struct result_when *w) {
  struct index list[2] = {{0}, {0}};
  bool good = true;
  for (int k = 0; k < 2 && kind && kind->list[k]; k++)
    good = index_read(file, kind->list[k], &list[k]) && good;
  size_t n = 0;
  for (; good && n < w->n; n++) {
    size_t row;
    if (!part_row(n, list, &row)) break;
    row += kind && kind->ends && n;
    if (row > rows || (n && row < w->first[n - 1])) break;
    w->first[n] = row;
  }
  w->n = n;
  free(list[0].at);
  free(list[1].at);
}

void result_when_read(hid_t file, const char *name, size_t rows, struct result_when *w) {
  char times[512];
  const struct kind *kind = kind_of(name);
  *w = (struct result_when){0};
  if (kind)
    snprintf(times, sizeof times, "%s", kind->times);
  else if (!sibling_times(name, times, sizeof times))
    return;
  if (!hdf_is_there(file, times)) return;
  if (begins(times, "events/")) { /* one number */
    w->time = malloc(sizeof *w->time);
    w->n = w->time && hdf_get_scalar(file, times, H5T_NATIVE_DOUBLE, w->time) == OK;
  } else if (hdf_get_all(file, times, H5T_NATIVE_DOUBLE, 0, &w->n, &w->time) != OK) {
    w->n = 0;
  }
  w->first = calloc(w->n + 1, sizeof *w->first);
  if (!w->first) w->n = 0;
  parts_take(file, kind, rows, w);
}

void result_when_free(struct result_when *w) {
  free(w->first);
  free(w->time);
  *w = (struct result_when){0};
}

size_t result_when_part(const struct result_when *w, size_t row) {
  size_t low = 0, high = w->n; /* the last part that begins at the row or before */
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    if (w->first[middle] <= row)
      low = middle;
    else
      high = middle;
  }
  return low;
}

double result_when_at(const struct result_when *w, size_t row) {
  return w->n ? w->time[result_when_part(w, row)] : NAN;
}

/* ---- where ---- */

/* A row of points, of which the first two numbers are its place. */
static void point_read(hid_t file, const char *name, size_t width, size_t row, double place[2]) {
  double *p = NULL;
  if (hdf_is_there(file, name) &&
      hdf_get_rows(file, name, H5T_NATIVE_DOUBLE, width, row, 1, &p) == OK)
    memcpy(place, p, 2 * sizeof *place);
  free(p);
}

static void group_read(hid_t file, const char *name, double place[2]) {
  static const char *const axis[] = {"x", "y"};
  char path[512];
  hid_t group = -1;
  snprintf(path, sizeof path, "%.*s", (int)(strrchr(name, '/') - name), name);
  if (hdf_open_group(file, path, &group) != OK) return;
  for (int k = 0; k < 2; k++) {
    const bool attribute = H5Aexists(group, axis[k]) > 0;
    if (attribute)
      (void)hdf_get_number(group, axis[k], &place[k]);
    else if (begins(name, "events/") && hdf_is_there(group, axis[k]))
      (void)hdf_get_scalar(group, axis[k], H5T_NATIVE_DOUBLE, &place[k]);
  }
  H5Gclose(group);
}

void result_place_read(hid_t file, const char *name, size_t row, double place[2]) {
  place[0] = place[1] = NAN;
  if (begins(name, "VTKHDF/PointData/") || !strcmp(name, "VTKHDF/Points"))
    point_read(file, "VTKHDF/Points", 3, row, place);
  else if (!strcmp(name, "surface/points") || !strcmp(name, "errors/surface/distance"))
    point_read(file, "surface/points", 2, row, place);
  else if (begins(name, "series/probes/") || begins(name, "series/gauges/") ||
           begins(name, "series/points/") || begins(name, "events/"))
    group_read(file, name, place);
}
