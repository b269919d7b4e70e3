#include <assert.h>
#include <hdf5.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/result/health.h"
#include "common/result/result.h"
#include "common/result/result_column.h"
#include "common/result/result_errors.h"
#include "common/result/result_hdf.h"
#include "common/result/result_header.h"
#include "common/result/result_layout.h"
#include "common/result/result_store.h"
#include "common/result/result_surface_table.h"
#include "common/result/result_table.h"
#include "common/result/result_vtkhdf.h"
#include "common/result/result_xdmf.h"
#include "revision.h"

struct result {
  char *path;
  struct result_store *store;
  struct xdmf *xdmf;
  hid_t file, events, statistics;
  struct hdf_columns *columns;
  struct result_surface_table surface;
  struct result_table energy, steps, diagnostics;
  struct result_about about;            /* what is in it is borrowed */
  struct result_table *probes, *gauges; /* of each, owned */
  struct result_table *points_at;       /* of each, owned; without columns until its first row */
  struct health_watch watch;            /* over what is written */
  struct vtkhdf *points;                /* from the first output on */
  struct result_errors *errors;         /* where there is a coarser run */
  struct result_twin *twin; /* of one that is itself the coarser: nothing else of it is */
  bool broken;              /* a write into memory failed: what is there is not committed */
  bool finished;
};

/* ---- the empty datasets that the run fills ---- */

static enum status create_probe(struct result *w, hid_t parent, const struct case_probe *p,
                                struct result_table *s) {
  static const struct result_column columns[] = {{"time", "s", "physical time"},
                                                 {"pressure", "Pa", "gauge pressure on the wall"}};
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(result_group_create(parent, p->name, &group));
  ATTEMPT(hdf_set_number(group, "x", p->x));
  ATTEMPT(hdf_set_number(group, "y", p->y));
  ATTEMPT(hdf_set_number(group, "size", p->size));
  ATTEMPT(result_table_begin(w->columns, group, 2, columns, s));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status create_gauge(struct result *w, hid_t parent, const struct case_gauge *g,
                                struct result_table *s) {
  static const struct result_column columns[] = {
      {"time", "s", "physical time"}, {"elevation", "m", "y of the top of the water on the bed"}};
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(result_group_create(parent, g->name, &group));
  ATTEMPT(hdf_set_number(group, "x", g->x));
  ATTEMPT(result_table_begin(w->columns, group, 2, columns, s));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

/* Of a term that is no loss: whoever reads the series must not take it for one. */
static enum status mark_term(hid_t parent, const struct solver_term *term) {
  hid_t group = -1, set = -1;
  enum status status = OK;
  if (!term->outside) return OK;
  ATTEMPT(hdf_open_group(parent, "energy", &group));
  set = H5Dopen2(group, term->name, H5P_DEFAULT);
  ATTEMPT(set < 0 ? hdf_raise(ERR_IO, "the term %s cannot be marked", term->name)
                  : hdf_set_integers(set, "outside", 1, (const int64_t[]){1}));
done:
  if (set >= 0) H5Dclose(set);
  if (group >= 0) H5Gclose(group);
  return status;
}

/* What all solvers have, then the terms that this one has. */
static enum status create_energy(struct result *w, hid_t parent) {
  const struct result_about *about = &w->about;
  struct result_column columns[RESULT_ENERGY_COLUMNS + RESULT_TERMS];
  assert(about->n_terms <= RESULT_TERMS);
  memcpy(columns, result_energy_columns, sizeof result_energy_columns);
  for (size_t k = 0; k < about->n_terms; k++)
    columns[RESULT_ENERGY_COLUMNS + k] =
        (struct result_column){about->terms[k].name, "J/m", about->terms[k].help};
  TRY(result_table_create(w->columns, parent, "energy", RESULT_ENERGY_COLUMNS + about->n_terms,
                          columns, &w->energy));
  for (size_t k = 0; k < about->n_terms; k++) TRY(mark_term(parent, &about->terms[k]));
  return OK;
}

static enum status create_series(struct result *w) {
  const struct result_about *about = &w->about;
  hid_t series = -1, probes = -1, gauges = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(w->file, "series", &series));
  ATTEMPT(create_energy(w, series));
  ATTEMPT(result_table_create(w->columns, series, "run", RESULT_STEP_COLUMNS, result_step_columns,
                              &w->steps));
  ATTEMPT(hdf_group_create(series, "probes", &probes));
  for (size_t i = 0; i < about->n_probes; i++)
    ATTEMPT(create_probe(w, probes, &about->probes[i], &w->probes[i]));
  ATTEMPT(hdf_group_create(series, "gauges", &gauges));
  for (size_t i = 0; i < about->n_gauges; i++)
    ATTEMPT(create_gauge(w, gauges, &about->gauges[i], &w->gauges[i]));
done:
  if (gauges >= 0) H5Gclose(gauges);
  if (probes >= 0) H5Gclose(probes);
  if (series >= 0) H5Gclose(series);
  return status;
}

static enum status create_content(struct result *w) {
  TRY(result_header_write(w->file, &w->about));
  TRY(result_surface_table_create(w->columns, w->file, &w->surface));
  TRY(create_series(w));
  TRY(hdf_group_create(w->file, "events", &w->events));
  return hdf_group_create(w->file, "statistics", &w->statistics);
}

static enum status create_tables(struct result *w) {
  TRY(array_create(&w->probes, w->about.n_probes, "the series of probes"));
  TRY(array_create(&w->gauges, w->about.n_gauges, "the series of gauges"));
  return array_create(&w->points_at, w->about.n_points, "the series of points");
}

enum status result_begin(const char *path, const struct result_about *about, struct result **out) {
  enum status status = OK;
  hdf_quiet();
  struct result *w = *out = calloc(1, sizeof *w);
  CHECK(w, ERR_MEMORY, "no memory to write %s", path);
  w->file = w->events = w->statistics = -1;
  w->broken = true; /* until the header is complete */
  w->about = *about;
  w->path = strdup(path);
  if (!w->path) {
    status = status_raise(ERR_MEMORY, "no memory to write %s", path);
    goto done;
  }
  ATTEMPT(create_tables(w));
  health_watch_begin(&w->watch, about->rest_potential,
                     about->density * about->g * about->H * about->H * about->H);
  for (size_t k = 0; k < about->n_terms; k++) w->watch.outside[k] = about->terms[k].outside;
  ATTEMPT(hdf_columns_create(&w->columns));
  ATTEMPT(result_store_create(path, &w->store));
  ATTEMPT(result_store_open(w->store, &w->file));
  ATTEMPT(create_content(w));
  w->broken = false;
  ATTEMPT(result_flush(w));
  ATTEMPT(xdmf_create(path, &w->xdmf));
done:
  if (status != OK) {
    w->broken = true;
    result_destroy(w);
    *out = NULL;
  }
  return status;
}

enum status result_create(const char *path, const struct case_file *c, const struct case_run *r,
                          struct result **out) {
  const struct solver *solver = r->solver;
  char fingerprint[33], water[33];
  case_fingerprint(c, r, fingerprint);
  case_water_fingerprint(c, water);
  const struct result_about about = {
      .solver = solver->name,
      .run = r->name,
      .title = c->title,
      .version = PLUNGE_VERSION,
      .revision = PLUNGE_REVISION,
      .case_text = c->text,
      .fingerprint = fingerprint,
      .water_fingerprint = water,
      .floats = flow_is_body(c->flow),
      .H = c->H,
      .g = c->g,
      .density = c->density,
      .resolution = r->resolution,
      .rest_potential = case_rest_potential(c),
      .walls = &c->walls,
      .n_probes = c->n_probes,
      .n_gauges = c->n_gauges,
      .n_points = c->n_points,
      .probes = c->probes,
      .gauges = c->gauges,
      .points = c->points,
      .n_terms = solver->n_terms,
      .terms = solver->terms,
      .n_params = solver->n_params,
      .params = solver->params,
      .options = r->options,
      .n_experiments = c->compare.n_experiments,
      .n_profiles = c->compare.n_profiles,
      .experiments = c->compare.experiments,
      .profiles = c->compare.profiles,
  };
  return result_begin(path, &about, out);
}

/* ---- appending ---- */

/* A write that fails half-way leaves datasets of different lengths in memory, so nothing after the
 * last flush may reach the disk. */
static enum status guard(struct result *w, enum status status) {
  if (status == OK) return OK;
  w->broken = true;
  return status_context(status, "%s: ", w->path);
}

/* ---- error bars ---- */

enum status result_create_coarser(const struct case_file *c, const struct case_run *r,
                                  struct result **out) {
  struct result *w = *out = calloc(1, sizeof *w);
  CHECK(w, ERR_MEMORY, "no memory for a coarser run");
  w->file = w->events = w->statistics = -1;
  w->broken = true; /* nothing is ever committed */
  return result_twin_create(c, r, &w->twin);
}

enum status result_hold_against(struct result *w, const struct result *coarser,
                                const struct result_coarser *how) {
  return guard(
      w, result_errors_create(w->file, w->columns, &w->about, coarser->twin, how, &w->errors));
}

/* ---- points, surfaces, rows ---- */

static enum status append_points(struct result *w, double time, size_t n, const double *x,
                                 const double *y, enum result_cells cells, size_t n_fields,
                                 const struct result_field *fields) {
  size_t first;
  if (!w->points) TRY(vtkhdf_create(w->file, w->columns, cells, n_fields, fields, &w->points));
  TRY(vtkhdf_step(w->points, time, n, x, y, fields, &first));
  return xdmf_step(w->xdmf, time, first, n, cells, n_fields, fields);
}

enum status result_points(struct result *w, double time, size_t n, const double *x, const double *y,
                          enum result_cells cells, size_t n_fields,
                          const struct result_field *fields) {
  if (w->twin) return OK;
  return guard(w, append_points(w, time, n, x, y, cells, n_fields, fields));
}

static enum status append_surface(struct result *w, double time, const struct geo_lines *surface) {
  TRY(result_surface_table_add(&w->surface, time, surface));
  return w->errors ? result_errors_surface(w->errors, time, surface) : OK;
}

enum status result_surface(struct result *w, double time, const struct geo_lines *surface) {
  if (w->twin) return result_twin_add_surface(w->twin, time, surface);
  return guard(w, append_surface(w, time, surface));
}

enum status result_energy(struct result *w, const struct result_energy *row) {
  if (w->twin) return result_twin_add(&w->twin->energy, &row->time);
  health_watch_energy(&w->watch, row);
  TRY(guard(w, result_table_add(&w->energy, &row->time)));
  return w->errors ? guard(w, result_errors_energy(w->errors, &row->time)) : OK;
}

enum status result_step(struct result *w, const struct result_step *row) {
  if (w->twin) return OK;
  health_watch_step(&w->watch, row);
  return guard(w, result_table_add(&w->steps, &row->time));
}

enum status result_probe(struct result *w, size_t probe, double time, double pressure) {
  const double row[2] = {time, pressure};
  if (w->twin) return result_twin_add(&w->twin->probes[probe], row);
  TRY(guard(w, result_table_add(&w->probes[probe], row)));
  return w->errors ? guard(w, result_errors_probe(w->errors, probe, row)) : OK;
}

enum status result_gauge(struct result *w, size_t gauge, double time, double elevation) {
  const double row[2] = {time, elevation};
  if (w->twin) return result_twin_add(&w->twin->gauges[gauge], row);
  TRY(guard(w, result_table_add(&w->gauges[gauge], row)));
  return w->errors ? guard(w, result_errors_gauge(w->errors, gauge, row)) : OK;
}

/* Its datasets, when the first row comes. */
static enum status create_point(struct result *w, const struct case_point *p,
                                struct result_table *s) {
  hid_t series = -1, parent = -1, group = -1;
  enum status status = OK;
  ATTEMPT(hdf_open_group(w->file, "series", &series));
  if (hdf_has(series, "points"))
    ATTEMPT(hdf_open_group(series, "points", &parent));
  else
    ATTEMPT(hdf_group_create(series, "points", &parent));
  ATTEMPT(result_group_create(parent, p->name, &group));
  ATTEMPT(hdf_set_number(group, "x", p->x));
  ATTEMPT(hdf_set_number(group, "y", p->y));
  ATTEMPT(result_table_begin(w->columns, group, 1 + CASE_POINT_FIELDS, result_point_columns, s));
done:
  if (group >= 0) H5Gclose(group);
  if (parent >= 0) H5Gclose(parent);
  if (series >= 0) H5Gclose(series);
  return status;
}

static enum status add_point(struct result *w, size_t point, double time, const double *value) {
  struct result_table *s = &w->points_at[point];
  double row[1 + CASE_POINT_FIELDS] = {time};
  if (!s->n_columns) TRY(create_point(w, &w->about.points[point], s));
  memcpy(row + 1, value, CASE_POINT_FIELDS * sizeof *value);
  return result_table_add(s, row);
}

enum status result_point(struct result *w, size_t point, double time,
                         const double value[CASE_POINT_FIELDS]) {
  if (w->twin) return OK;
  return guard(w, add_point(w, point, time, value));
}

/* Their datasets, when the first row comes. */
static enum status create_diagnostics(struct result *w, size_t n,
                                      const struct solver_diagnostic *of) {
  struct result_column columns[1 + RESULT_DIAGNOSTICS] = {{"time", "s", "physical time"}};
  hid_t group = -1;
  assert(n <= RESULT_DIAGNOSTICS);
  for (size_t k = 0; k < n; k++)
    columns[1 + k] = (struct result_column){of[k].name, of[k].units, of[k].help};
  enum status status = hdf_open_group(w->file, "series", &group);
  if (status == OK)
    status = result_table_create(w->columns, group, "diagnostics", 1 + n, columns, &w->diagnostics);
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status add_diagnostics(struct result *w, double time, size_t n,
                                   const struct solver_diagnostic *columns, const double *values) {
  double row[1 + RESULT_DIAGNOSTICS] = {time};
  if (!w->diagnostics.n_columns) TRY(create_diagnostics(w, n, columns));
  memcpy(row + 1, values, n * sizeof *values);
  return result_table_add(&w->diagnostics, row);
}

enum status result_diagnostics(struct result *w, double time, size_t n,
                               const struct solver_diagnostic *columns, const double *values) {
  if (w->twin) return OK;
  return guard(w, add_diagnostics(w, time, n, columns, values));
}

static enum status add_event(struct result *w, const char *name, double time, double x, double y) {
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(result_group_create(w->events, name, &group));
  ATTEMPT(hdf_put_scalar(group, "time", H5T_NATIVE_DOUBLE, &time, "s", "when it happened"));
  ATTEMPT(hdf_put_scalar(group, "x", H5T_NATIVE_DOUBLE, &x, "m", "where it happened"));
  ATTEMPT(hdf_put_scalar(group, "y", H5T_NATIVE_DOUBLE, &y, "m", "where it happened"));
  if (w->errors) ATTEMPT(result_errors_event(w->errors, group, name, (const double[]){time, x, y}));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_event(struct result *w, const char *name, double time, double x, double y) {
  if (w->twin) return result_twin_add_event(w->twin, name, (double[]){time, x, y});
  return guard(w, add_event(w, name, time, x, y));
}

enum status result_statistic(struct result *w, const char *name, double value, const char *units,
                             const char *help) {
  if (w->twin) return OK;
  health_watch_statistic(&w->watch, name, value);
  if (hdf_has(w->statistics, name)) H5Ldelete(w->statistics, name, H5P_DEFAULT);
  return guard(w, hdf_put_scalar(w->statistics, name, H5T_NATIVE_DOUBLE, &value, units, help));
}

enum status result_rest(struct result *w, double potential) {
  if (w->twin) return OK;
  w->watch.rest = potential;
  return guard(w, hdf_set_number(w->file, "rest_potential", potential));
}

enum status result_ended(struct result *w, const char *why) {
  if (w->twin) return OK;
  return guard(w, hdf_set_string(w->file, "ended", why));
}

/* ---- health ---- */

static enum status write_measure(hid_t group, const struct health_measure *m, double value) {
  char help[256];
  snprintf(help, sizeof help, "%s; doubtful above %g, failed above %g", m->help, m->doubtful,
           m->failed);
  return hdf_put_scalar(group, m->name, H5T_NATIVE_DOUBLE, &value, "1", help);
}

static enum status write_health(struct result *w, const struct health *h) {
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(w->file, "health", &group));
  ATTEMPT(hdf_set_string(group, "verdict", health_verdicts[h->verdict]));
  ATTEMPT(hdf_set_string(group, "reasons", h->reasons));
  for (size_t k = 0; k < HEALTH_N; k++)
    if (isfinite(h->value[k])) ATTEMPT(write_measure(group, &health_measures[k], h->value[k]));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_health(struct result *w, const char *broke_off, struct health *h) {
  health_judge(&w->watch, broke_off, h);
  return guard(w, write_health(w, h));
}

/* ---- flushing ---- */

static enum status flush_hdf(struct result *w) {
  TRY(hdf_columns_flush(w->columns));
  return H5Fflush(w->file, H5F_SCOPE_LOCAL) >= 0 ? OK : hdf_raise(ERR_IO, "cannot flush");
}

static enum status flush(struct result *w, bool last) {
  CHECK(!w->broken, ERR_IO, "%s keeps only what was flushed before an earlier failure", w->path);
  TRY(guard(w, flush_hdf(w)));
  TRY(result_store_commit(w->store, last));
  return w->xdmf ? xdmf_write(w->xdmf, last) : OK; /* after the data that it points to */
}

enum status result_flush(struct result *w) {
  if (w->twin) return OK;
  return flush(w, false);
}

enum status result_finish(struct result *w) {
  TRY(guard(w, hdf_set_integers(w->file, "complete", 1, (int64_t[]){1})));
  TRY(flush(w, true));
  w->finished = true;
  return OK;
}

void result_destroy(struct result *w) {
  if (!w) return;
  if (!w->broken && !w->finished) {
    /* whoever needs to know calls result_flush; the message may be why the run ended */
    char message[2048];
    snprintf(message, sizeof message, "%s", status_message());
    enum status status = flush(w, true);
    if (status != OK) (void)status_raise(status, "%s", message);
  }
  result_errors_destroy(w->errors);
  result_twin_destroy(w->twin);
  vtkhdf_destroy(w->points);
  xdmf_destroy(w->xdmf);
  hdf_columns_destroy(w->columns);
  if (w->events >= 0) H5Gclose(w->events);
  if (w->statistics >= 0) H5Gclose(w->statistics);
  if (w->file >= 0) H5Fclose(w->file); /* into memory, not to the disk */
  result_store_destroy(w->store);
  free(w->probes);
  free(w->gauges);
  free(w->points_at);
  free(w->path);
  free(w);
}

void result_discard(struct result *w) {
  if (!w) return;
  w->broken = true; /* no flush any more */
  xdmf_remove(w->xdmf);
  if (w->path) unlink(w->path);
  result_destroy(w);
}
