#include "common/result/result_errors.h"

#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_hdf.h"
#include "common/result/result_table.h"

enum { POINT_ROWS = 4096 }; /* of a chunk */

struct result_errors {
  struct result_twin *twin; /* borrowed */
  double share;             /* of a difference that is the standard error */
  struct result_table energy, *probes, *gauges;
  struct hdf_column *distance;
  size_t n_events, event_room;
  char **events; /* names of those that were written, [n_events], owned */
};

static enum status create_energy(struct result_errors *e, struct hdf_columns *all, hid_t group,
                                 const struct result_about *about) {
  struct result_column columns[RESULT_ENERGY_COLUMNS + RESULT_TERMS];
  for (size_t k = 0; k < RESULT_ENERGY_COLUMNS + about->n_terms; k++) {
    const bool term = k >= RESULT_ENERGY_COLUMNS;
    columns[k] = (struct result_column){term ? about->terms[k - RESULT_ENERGY_COLUMNS].name
                                             : result_energy_columns[k].name,
                                        "J/m", "standard error of the column of that name"};
  }
  columns[0] = result_energy_columns[0];
  return result_table_create(all, group, "energy", RESULT_ENERGY_COLUMNS + about->n_terms, columns,
                             &e->energy);
}

/* Of a probe or a gauge. */
static enum status create_series(struct hdf_columns *all, hid_t parent, const char *name,
                                 const char *value, const char *units, struct result_table *t) {
  const struct result_column columns[] = {{"time", "s", "physical time"},
                                          {value, units, "standard error"}};
  hid_t group = -1;
  TRY(result_group_create(parent, name, &group));
  enum status status = result_table_begin(all, group, 2, columns, t);
  H5Gclose(group);
  return status;
}

static enum status create_instruments(struct result_errors *e, struct hdf_columns *all, hid_t group,
                                      const struct result_about *about) {
  hid_t probes = -1, gauges = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(group, "probes", &probes));
  ATTEMPT(hdf_group_create(group, "gauges", &gauges));
  for (size_t i = 0; i < about->n_probes; i++)
    ATTEMPT(create_series(all, probes, about->probes[i].name, "pressure", "Pa", &e->probes[i]));
  for (size_t i = 0; i < about->n_gauges; i++)
    ATTEMPT(create_series(all, gauges, about->gauges[i].name, "elevation", "m", &e->gauges[i]));
done:
  if (gauges >= 0) H5Gclose(gauges);
  if (probes >= 0) H5Gclose(probes);
  return status;
}

static enum status create_surface(struct result_errors *e, struct hdf_columns *all, hid_t parent) {
  const struct hdf_rows points = {H5T_NATIVE_DOUBLE, 0, POINT_ROWS};
  hid_t group = -1;
  TRY(hdf_group_create(parent, "surface", &group));
  enum status status = hdf_column_create(
      all, group, "distance", &points, "m",
      "standard error of each row of /surface/points, across the surface", &e->distance);
  H5Gclose(group);
  return status;
}

static enum status create_group(struct result_errors *e, hid_t file, struct hdf_columns *all,
                                const struct result_about *about,
                                const struct result_coarser *how) {
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(file, "errors", &group));
  ATTEMPT(hdf_set_number(group, "spacing", e->twin->spacing));
  ATTEMPT(hdf_set_number(group, "ratio", how->ratio));
  ATTEMPT(hdf_set_number(group, "order", how->order));
  ATTEMPT(create_energy(e, all, group, about));
  ATTEMPT(create_instruments(e, all, group, about));
  ATTEMPT(create_surface(e, all, group));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_errors_create(hid_t file, struct hdf_columns *all,
                                 const struct result_about *about, struct result_twin *twin,
                                 const struct result_coarser *how, struct result_errors **out) {
  struct result_errors *e = *out = calloc(1, sizeof *e);
  CHECK(e, ERR_MEMORY, "no memory for error bars");
  e->twin = twin;
  e->share = 1 / (pow(how->ratio, how->order) - 1);
  TRY(array_create(&e->probes, about->n_probes, "error bars of probes"));
  TRY(array_create(&e->gauges, about->n_gauges, "error bars of gauges"));
  return create_group(e, file, all, about, how);
}

void result_errors_destroy(struct result_errors *e) {
  if (!e) return;
  for (size_t i = 0; i < e->n_events; i++) free(e->events[i]);
  free(e->events);
  free(e->probes);
  free(e->gauges);
  free(e);
}

/* ---- rows ---- */

static enum status add_row(const struct result_errors *e, struct result_table *t,
                           struct twin_rows *coarser, const double *row) {
  double error[RESULT_ENERGY_COLUMNS + RESULT_TERMS] = {row[0]};
  const double *other = result_twin_row(coarser, row[0]);
  for (size_t k = 1; k < t->n_columns; k++)
    error[k] = other ? e->share * fabs(row[k] - other[k]) : NAN;
  return result_table_add(t, error);
}

enum status result_errors_energy(struct result_errors *e, const double *row) {
  return add_row(e, &e->energy, &e->twin->energy, row);
}

enum status result_errors_probe(struct result_errors *e, size_t probe, const double row[2]) {
  return add_row(e, &e->probes[probe], &e->twin->probes[probe], row);
}

enum status result_errors_gauge(struct result_errors *e, size_t gauge, const double row[2]) {
  return add_row(e, &e->gauges[gauge], &e->twin->gauges[gauge], row);
}

/* ---- surfaces ---- */

/* The point at s = 0..1 between p[1] and p[2] on the cubic through four points, by their number. */
static void cubic_point(double (*p)[2], double s, double out[2]) {
  const double a = s + 1, b = s - 1, c = s - 2;
  const double w[4] = {-s * b * c / 6, a * b * c / 2, -a * s * c / 2, a * s * b / 6};
  for (int k = 0; k < 2; k++)
    out[k] = w[0] * p[0][k] + w[1] * p[1][k] + w[2] * p[2][k] + w[3] * p[3][k];
}

static double segment_distance(const double a[2], const double b[2], const double p[2]) {
  double foot[2];
  geo_segment_foot(a, b, p, foot);
  return hypot(p[0] - foot[0], p[1] - foot[1]);
}

/* From the curve through the points of an open piece near its segment i: its chords would be wrong
 * by an eighth of the curvature times their squares. */
static double curve_distance(double (*piece)[2], size_t n, size_t i, const double p[2]) {
  enum { PARTS = 16 };
  if (i < 1 || i + 3 > n) return segment_distance(piece[i], piece[i + 1], p);
  double least = INFINITY, from[2] = {piece[i][0], piece[i][1]}, to[2];
  for (int k = 1; k <= PARTS; k++) {
    cubic_point(piece + i - 1, (double)k / PARTS, to);
    least = fmin(least, segment_distance(from, to, p));
    memcpy(from, to, sizeof from);
  }
  return least;
}

static double piece_distance(double (*piece)[2], size_t n, const double p[2]) {
  size_t at = 0;
  double least = INFINITY;
  for (size_t i = 0; i + 1 < n; i++) {
    double d = segment_distance(piece[i], piece[i + 1], p);
    if (d < least) least = d, at = i;
  }
  if (n < 2) return least;
  least = curve_distance(piece, n, at, p);
  if (at > 0) least = fmin(least, curve_distance(piece, n, at - 1, p));
  if (at + 2 < n) least = fmin(least, curve_distance(piece, n, at + 1, p));
  return least;
}

static double lines_distance(const struct geo_lines *l, const double p[2]) {
  double least = INFINITY;
  for (size_t k = 0; k < l->pieces; k++)
    least = fmin(least, piece_distance(l->p + l->first[k], l->first[k + 1] - l->first[k], p));
  return least;
}

enum status result_errors_surface(struct result_errors *e, double time,
                                  const struct geo_lines *surface) {
  const struct geo_lines *other = result_twin_surface(e->twin, time);
  for (size_t i = 0; i < surface->points; i++) {
    double error = other ? e->share * lines_distance(other, surface->p[i]) : NAN;
    if (!isfinite(error)) error = NAN;
    TRY(hdf_column_append(e->distance, 1, &error));
  }
  return OK;
}

/* ---- events ---- */

/* How many of that name there were, and one more now. */
static enum status count_event(struct result_errors *e, const char *name, size_t *number) {
  *number = 0;
  for (size_t i = 0; i < e->n_events; i++) *number += !strcmp(e->events[i], name);
  TRY(array_grow(&e->events, &e->event_room, e->n_events + 1, "names of events"));
  e->events[e->n_events] = strdup(name);
  CHECK(e->events[e->n_events], ERR_MEMORY, "no memory for a name");
  e->n_events++;
  return OK;
}

enum status result_errors_event(struct result_errors *e, hid_t group, const char *name,
                                const double at[3]) {
  static const char *const names[3] = {"time_error", "x_error", "y_error"};
  size_t number;
  TRY(count_event(e, name, &number));
  const struct twin_event *other = result_twin_event(e->twin, name, number);
  for (int k = 0; k < 3; k++) {
    double error = other ? e->share * fabs(at[k] - other->at[k]) : NAN;
    TRY(hdf_put_scalar(group, names[k], H5T_NATIVE_DOUBLE, &error, k ? "m" : "s",
                       "standard error"));
  }
  return OK;
}
