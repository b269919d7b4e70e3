#include "common/result/result_series.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"

enum status result_check_times(const char *what, size_t n, const double *t) {
  for (size_t i = 0; i < n; i++)
    CHECK(isfinite(t[i]) && (i == 0 || t[i] >= t[i - 1]), ERR_INPUT,
          "its times of %s do not increase at row %zu (%g s)", what, i, t[i]);
  return OK;
}

enum status result_read_members(hid_t file, const char *path, size_t size,
                                enum status (*read)(hid_t group, const char *link, void *element),
                                size_t *n, void **array) {
  hid_t group = -1;
  size_t n_links = 0;
  char **links = NULL;
  enum status status = OK;
  if (!hdf_is_there(file, path)) return OK;
  ATTEMPT(hdf_open_group(file, path, &group));
  ATTEMPT(hdf_list(group, &n_links, &links));
  *array = calloc(n_links + 1, size);
  if (!*array) {
    status = status_raise(ERR_MEMORY, "no memory for %zu members of %s", n_links, path);
    goto done;
  }
  while (*n < n_links) {
    size_t i = (*n)++; /* counted first: what is half read is freed as well */
    ATTEMPT(read(group, links[i], (char *)*array + i * size));
  }
done:
  hdf_list_destroy(n_links, links);
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_read_name(hid_t group, const char *link, char **name) {
  if (H5Aexists(group, "name") > 0) return hdf_get_string(group, "name", name);
  *name = strdup(link);
  CHECK(*name, ERR_MEMORY, "no memory for a name");
  return OK;
}

enum status result_read_columns(hid_t group, const char *link, const char *name, size_t *n,
                                double **t, double **value) {
  size_t n_values = 0;
  TRY(hdf_get_all(group, "time", H5T_NATIVE_DOUBLE, 0, n, t));
  TRY(hdf_get_all(group, name, H5T_NATIVE_DOUBLE, 0, &n_values, value));
  TRY(result_check_times(link, *n, *t));
  CHECK(n_values == *n, ERR_INPUT, "its series %s has columns of different lengths", link);
  return OK;
}

static enum status read_series(hid_t parent, const char *link, const char *value, const char *units,
                               struct result_series *s) {
  hid_t group = -1;
  enum status status = OK;
  s->y = s->size = NAN;
  s->units = strdup(units);
  s->help = strdup("");
  CHECK(s->units && s->help, ERR_MEMORY, "no memory for a unit");
  ATTEMPT(hdf_open_group(parent, link, &group));
  ATTEMPT(result_read_name(group, link, &s->name));
  ATTEMPT(hdf_get_number(group, "x", &s->x));
  if (H5Aexists(group, "y") > 0) ATTEMPT(hdf_get_number(group, "y", &s->y));
  if (H5Aexists(group, "size") > 0) ATTEMPT(hdf_get_number(group, "size", &s->size));
  ATTEMPT(result_read_columns(group, link, value, &s->n, &s->t, &s->value));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status read_probe(hid_t parent, const char *link, void *element) {
  return read_series(parent, link, "pressure", "Pa", element);
}

static enum status read_gauge(hid_t parent, const char *link, void *element) {
  return read_series(parent, link, "elevation", "m", element);
}

/* Standard errors of the rows of a probe or a gauge, where the file has them at `path`. */
static enum status read_series_errors(hid_t file, const char *path, const char *value, size_t n,
                                      struct result_series *s) {
  hid_t group = -1, own = -1;
  size_t n_links = 0, rows = 0;
  char **links = NULL;
  double *t = NULL;
  enum status status = OK;
  if (!hdf_has(file, path)) return OK;
  ATTEMPT(hdf_open_group(file, path, &group));
  ATTEMPT(hdf_list(group, &n_links, &links));
  if (n_links != n) {
    status = status_raise(ERR_INPUT, "its error bars in %s are of %zu series, not %zu", path,
                          n_links, n);
    goto done;
  }
  for (size_t i = 0; i < n; i++) {
    ATTEMPT(hdf_open_group(group, links[i], &own));
    ATTEMPT(result_read_columns(own, links[i], value, &rows, &t, &s[i].error));
    s[i].n_errors = rows;
    free(t);
    t = NULL;
    H5Gclose(own);
    own = -1;
    if (rows != s[i].n) {
      status = status_raise(ERR_INPUT, "its error bars of %s have %zu rows, not %zu", links[i],
                            rows, s[i].n);
      goto done;
    }
  }
done:
  free(t);
  hdf_list_destroy(n_links, links);
  if (own >= 0) H5Gclose(own);
  if (group >= 0) H5Gclose(group);
  return status;
}

/* One column of a group that has a time for all. */
static enum status read_diagnostic(hid_t group, const char *link, struct result_series *s) {
  s->x = s->y = s->size = NAN;
  s->name = strdup(link);
  CHECK(s->name, ERR_MEMORY, "no memory for a name");
  hid_t set = H5Dopen2(group, link, H5P_DEFAULT);
  if (set < 0) return hdf_raise(ERR_INPUT, "its diagnostic %s cannot be read", link);
  enum status status = hdf_get_string(set, "units", &s->units);
  if (status == OK) status = hdf_get_string(set, "description", &s->help);
  H5Dclose(set);
  TRY(status);
  return result_read_columns(group, "/series/diagnostics", link, &s->n, &s->t, &s->value);
}

/* Older files, and most others, have none. */
static enum status read_diagnostics(hid_t file, struct result_file *f) {
  hid_t group = -1;
  size_t n_links = 0;
  char **links = NULL;
  enum status status = OK;
  if (!hdf_has(file, "series/diagnostics")) return OK;
  ATTEMPT(hdf_open_group(file, "series/diagnostics", &group));
  ATTEMPT(hdf_list(group, &n_links, &links));
  f->diagnostics = calloc(n_links + 1, sizeof *f->diagnostics);
  if (!f->diagnostics || n_links > 1 + RESULT_DIAGNOSTICS) {
    status = f->diagnostics
                 ? status_raise(ERR_INPUT, "it has more than %d diagnostics", RESULT_DIAGNOSTICS)
                 : status_raise(ERR_MEMORY, "no memory for %zu diagnostics", n_links);
    goto done;
  }
  for (size_t k = 0; k < n_links; k++)
    if (strcmp(links[k], "time"))
      ATTEMPT(read_diagnostic(group, links[k], &f->diagnostics[f->n_diagnostics++]));
done:
  hdf_list_destroy(n_links, links);
  if (group >= 0) H5Gclose(group);
  return status;
}

/* NaN where the file does not have it. */
static enum status read_point_column(hid_t group, const char *link, const char *name, size_t n,
                                     double **value) {
  size_t n_values = 0;
  if (hdf_is_there(group, name)) {
    TRY(hdf_get_all(group, name, H5T_NATIVE_DOUBLE, 0, &n_values, value));
    CHECK(n_values == n, ERR_INPUT, "its series %s has columns of different lengths", link);
    return OK;
  }
  TRY(array_create(value, n, "rows of a point"));
  for (size_t i = 0; i < n; i++) (*value)[i] = NAN;
  return OK;
}

static enum status read_point(hid_t parent, const char *link, void *element) {
  struct result_point_read *p = element;
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_open_group(parent, link, &group));
  ATTEMPT(result_read_name(group, link, &p->name));
  ATTEMPT(hdf_get_number(group, "x", &p->x));
  ATTEMPT(hdf_get_number(group, "y", &p->y));
  ATTEMPT(hdf_get_all(group, "time", H5T_NATIVE_DOUBLE, 0, &p->n, &p->t));
  ATTEMPT(result_check_times(link, p->n, p->t));
  for (int k = 0; k < CASE_POINT_FIELDS; k++)
    ATTEMPT(read_point_column(group, link, result_point_columns[1 + k].name, p->n, &p->value[k]));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_read_series(hid_t file, struct result_file *f) {
  TRY(array_lend(&f->probes, result_read_members(file, "series/probes", sizeof *f->probes,
                                                 read_probe, &f->n_probes, &memory_)));
  TRY(array_lend(&f->gauges, result_read_members(file, "series/gauges", sizeof *f->gauges,
                                                 read_gauge, &f->n_gauges, &memory_)));
  TRY(read_series_errors(file, "errors/probes", "pressure", f->n_probes, f->probes));
  TRY(read_series_errors(file, "errors/gauges", "elevation", f->n_gauges, f->gauges));
  TRY(array_lend(&f->points, result_read_members(file, "series/points", sizeof *f->points,
                                                 read_point, &f->n_points, &memory_)));
  return read_diagnostics(file, f);
}

static void series_destroy(size_t n, struct result_series *s) {
  for (size_t i = 0; i < n; i++) {
    free(s[i].name);
    free(s[i].units);
    free(s[i].help);
    free(s[i].t);
    free(s[i].value);
    free(s[i].error);
  }
  free(s);
}

static void point_destroy(struct result_point_read *p) {
  free(p->name);
  free(p->t);
  for (int k = 0; k < CASE_POINT_FIELDS; k++) free(p->value[k]);
}

void result_series_destroy(struct result_file *f) {
  series_destroy(f->n_probes, f->probes);
  series_destroy(f->n_gauges, f->gauges);
  series_destroy(f->n_diagnostics, f->diagnostics);
  for (size_t i = 0; i < f->n_points; i++) point_destroy(&f->points[i]);
  free(f->points);
}
