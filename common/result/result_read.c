#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/result.h"
#include "common/result/result_carry.h"
#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"
#include "common/result/result_lines.h"
#include "common/result/result_open.h"
#include "common/result/result_series.h"

/* ---- parts: what is not there is no fault, what is there must be right ---- */

/* An attribute that older files and other programs' lack; "" then. */
static enum status read_optional(hid_t object, const char *name, char **value) {
  if (H5Aexists(object, name) > 0) return hdf_get_string(object, name, value);
  *value = strdup("");
  CHECK(*value, ERR_MEMORY, "no memory for a result");
  return OK;
}

/* Columns of one length, gathered into zeroed rows of `width` numbers. `spare`: the column may be
 * missing. */
static enum status read_table(hid_t file, const char *name, size_t n_columns,
                              const struct result_column *columns,
                              bool (*spare)(const char *column), size_t width, size_t *n,
                              void **out) {
  hid_t group = -1;
  enum status status = OK;
  double *column = NULL, *rows = NULL;
  ATTEMPT(hdf_open_group(file, name, &group));
  for (size_t k = 0; k < n_columns; k++) {
    size_t length = 0;
    if (spare(columns[k].name) && !hdf_is_there(group, columns[k].name)) continue;
    ATTEMPT(hdf_get_all(group, columns[k].name, H5T_NATIVE_DOUBLE, 0, &length, &column));
    if (k == 0) {
      ATTEMPT(result_check_times(name, length, column));
      *n = length;
      *out = rows = calloc(length * width + 1, sizeof *rows);
      if (!rows) {
        status = status_raise(ERR_MEMORY, "no memory for %zu rows", length);
        goto done;
      }
    }
    if (length != *n) {
      status = status_raise(ERR_INPUT, "its series %s has columns of different lengths", name);
      goto done;
    }
    for (size_t i = 0; i < length; i++) rows[i * width + k] = column[i];
    free(column);
    column = NULL;
  }
done:
  free(column);
  if (group >= 0) H5Gclose(group);
  return status;
}

/* What results of other programs may not know. */
static bool is_spare_energy(const char *column) {
  return !strcmp(column, "internal") || !strcmp(column, "total") || !strcmp(column, "removed");
}

static bool is_spare_step(const char *column) {
  return strcmp(column, "time") != 0 && strcmp(column, "volume") != 0;
}

static bool is_energy_column(const char *name) {
  for (int k = 0; k < RESULT_ENERGY_COLUMNS; k++)
    if (!strcmp(result_energy_columns[k].name, name)) return true;
  return false;
}

static enum status read_term(hid_t group, const char *link, struct result_term_read *term) {
  int64_t outside = 0;
  term->name = strdup(link);
  CHECK(term->name, ERR_MEMORY, "no memory for a name");
  hid_t set = H5Dopen2(group, link, H5P_DEFAULT);
  if (set < 0) return hdf_raise(ERR_INPUT, "its term of energy %s cannot be read", link);
  enum status status = read_optional(set, "description", &term->help);
  if (status == OK && H5Aexists(set, "outside") > 0)
    status = hdf_get_integer(set, "outside", &outside);
  H5Dclose(set);
  term->outside = outside == 1;
  return status;
}

/* A term of the budget is whatever else the group holds. */
static enum status read_terms(hid_t group, size_t n_links, char *const *links,
                              struct result_file *f) {
  f->terms = calloc(n_links + 1, sizeof *f->terms);
  CHECK(f->terms, ERR_MEMORY, "no memory for %zu terms of the budget of energy", n_links);
  for (size_t i = 0; i < n_links; i++) {
    if (is_energy_column(links[i])) continue;
    CHECK(f->n_terms < RESULT_TERMS, ERR_INPUT,
          "its group /series/energy has more than %d terms beside the usual columns", RESULT_TERMS);
    TRY(read_term(group, links[i], &f->terms[f->n_terms++]));
  }
  return OK;
}

static enum status read_energy(hid_t file, struct result_file *f) {
  struct result_column columns[RESULT_ENERGY_COLUMNS + RESULT_TERMS];
  hid_t group = -1;
  size_t n_links = 0;
  char **links = NULL;
  enum status status = OK;
  if (!hdf_is_there(file, "series/energy")) return OK;
  ATTEMPT(hdf_open_group(file, "series/energy", &group));
  ATTEMPT(hdf_list(group, &n_links, &links));
  ATTEMPT(read_terms(group, n_links, links, f));
  memcpy(columns, result_energy_columns, sizeof result_energy_columns);
  for (size_t k = 0; k < f->n_terms; k++)
    columns[RESULT_ENERGY_COLUMNS + k] = (struct result_column){.name = f->terms[k].name};
  ATTEMPT(array_lend(&f->energy,
                     read_table(file, "/series/energy", RESULT_ENERGY_COLUMNS + f->n_terms, columns,
                                is_spare_energy, sizeof *f->energy / sizeof(double), &f->n_energy,
                                &memory_)));
  for (size_t i = 0; i < f->n_energy && !hdf_is_there(group, "total"); i++)
    f->energy[i].total = f->energy[i].kinetic + f->energy[i].potential + f->energy[i].internal;
  if (f->n_energy && isnan(f->rest_potential))
    status = status_raise(ERR_INPUT, "it has /series/energy, but no attribute rest_potential, from "
                                     "which energies are counted");
done:
  hdf_list_destroy(n_links, links);
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status read_energy_errors(hid_t file, struct result_file *f) {
  struct result_column columns[RESULT_ENERGY_COLUMNS + RESULT_TERMS];
  memcpy(columns, result_energy_columns, sizeof result_energy_columns);
  for (size_t k = 0; k < f->n_terms; k++)
    columns[RESULT_ENERGY_COLUMNS + k] = (struct result_column){.name = f->terms[k].name};
  TRY(array_lend(&f->energy_error,
                 read_table(file, "/errors/energy", RESULT_ENERGY_COLUMNS + f->n_terms, columns,
                            is_spare_energy, sizeof *f->energy_error / sizeof(double),
                            &f->n_energy_errors, &memory_)));
  CHECK(f->n_energy_errors == f->n_energy, ERR_INPUT,
        "its error bars of energy have %zu rows, its energies %zu", f->n_energy_errors,
        f->n_energy);
  return OK;
}

/* Only of a run that was held against a coarser one. */
static enum status read_errors(hid_t file, struct result_file *f) {
  size_t points = 0;
  hid_t group = -1;
  if (!hdf_has(file, "errors")) return OK;
  TRY(hdf_open_group(file, "errors", &group));
  enum status status = hdf_get_number(group, "ratio", &f->coarser.ratio);
  if (status == OK) status = hdf_get_number(group, "order", &f->coarser.order);
  H5Gclose(group);
  TRY(status);
  TRY(hdf_get_all(file, "errors/surface/distance", H5T_NATIVE_DOUBLE, 0, &f->n_surface_errors,
                  &f->surface_error));
  for (size_t k = 0; k < f->n_surfaces; k++) points += f->surface[k].points;
  CHECK(f->n_surface_errors == points, ERR_INPUT,
        "its error bars are of %zu points, its surfaces have %zu", f->n_surface_errors, points);
  return read_energy_errors(file, f);
}

static enum status read_event(hid_t parent, const char *link, void *element) {
  struct result_event_read *e = element;
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_open_group(parent, link, &group));
  ATTEMPT(result_read_name(group, link, &e->name));
  ATTEMPT(hdf_get_scalar(group, "time", H5T_NATIVE_DOUBLE, &e->time));
  ATTEMPT(hdf_get_scalar(group, "x", H5T_NATIVE_DOUBLE, &e->x));
  ATTEMPT(hdf_get_scalar(group, "y", H5T_NATIVE_DOUBLE, &e->y));
  for (int k = 0; k < 3; k++) {
    static const char *const names[3] = {"time_error", "x_error", "y_error"};
    e->error[k] = NAN;
    if (hdf_has(group, names[k]))
      ATTEMPT(hdf_get_scalar(group, names[k], H5T_NATIVE_DOUBLE, &e->error[k]));
  }
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status read_experiment(hid_t parent, const char *link, void *element) {
  struct case_experiment *e = element;
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_open_group(parent, link, &group));
  ATTEMPT(hdf_get_string(group, "label", &e->label));
  ATTEMPT(hdf_get_string(group, "source", &e->source));
  ATTEMPT(hdf_get_string(group, "target", &e->target));
  ATTEMPT(result_read_columns(group, link, "value", &e->n, &e->t, &e->value));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status read_profile(hid_t parent, const char *link, void *element) {
  struct case_profile *p = element;
  hid_t group = -1;
  size_t n_y = 0;
  enum status status = OK;
  ATTEMPT(hdf_open_group(parent, link, &group));
  ATTEMPT(hdf_get_string(group, "label", &p->label));
  ATTEMPT(hdf_get_string(group, "source", &p->source));
  ATTEMPT(hdf_get_number(group, "time", &p->time));
  ATTEMPT(hdf_get_all(group, "x", H5T_NATIVE_DOUBLE, 0, &p->n, &p->x));
  ATTEMPT(hdf_get_all(group, "y", H5T_NATIVE_DOUBLE, 0, &n_y, &p->y));
  if (n_y != p->n)
    status = status_raise(ERR_INPUT, "its profile %s has columns of different lengths", link);
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status read_statistic(hid_t group, const char *link, void *element) {
  struct result_statistic_read *s = element;
  TRY(hdf_get_scalar(group, link, H5T_NATIVE_DOUBLE, &s->value));
  s->name = strdup(link);
  CHECK(s->name, ERR_MEMORY, "no memory for a name");
  hid_t set = H5Dopen2(group, link, H5P_DEFAULT);
  enum status status = read_optional(set, "description", &s->help);
  H5Dclose(set);
  return status;
}

static enum status read_health(hid_t file, char **verdict) {
  hid_t group = file; /* the root has no attribute of that name */
  if (hdf_has(file, "health")) TRY(hdf_open_group(file, "health", &group));
  enum status status = read_optional(group, "verdict", verdict);
  if (group != file) H5Gclose(group);
  return status;
}

/* The name of the file without its folder and ending. */
static enum status name_of_file(const char *path, char **name) {
  const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path,
             *dot = strrchr(base, '.');
  *name = strndup(base, dot && dot > base ? (size_t)(dot - base) : strlen(base));
  CHECK(*name, ERR_MEMORY, "no memory for a result");
  return OK;
}

static enum status read_texts(hid_t file, struct result_file *f) {
  const struct {
    const char *name;
    char **to;
  } text[] = {
      {"solver", &f->solver},     {"title", &f->title},       {"ended", &f->ended},
      {"imported", &f->imported}, {"settings", &f->settings}, {"water", &f->water_fingerprint},
      {"version", &f->version},   {"revision", &f->revision}, {"fingerprint", &f->fingerprint},
      {"created", &f->created}};
  for (size_t k = 0; k < sizeof text / sizeof *text; k++)
    TRY(read_optional(file, text[k].name, text[k].to));
  TRY(read_optional(file, "run", &f->run));
  if (!f->run[strspn(f->run, " \t\n")]) { /* a name that nobody sees is none */
    free(f->run);
    f->run = NULL;
    TRY(name_of_file(f->path, &f->run));
  }
  TRY(read_health(file, &f->health));
  if (hdf_is_there(file, "case")) return hdf_get_text(file, "case", &f->case_text);
  f->case_text = strdup("");
  CHECK(f->case_text, ERR_MEMORY, "no memory for a result");
  return OK;
}

static enum status read_scale(hid_t file, const struct result_scale *scale, double *value) {
  *value = NAN;
  if (scale->any && H5Aexists(file, scale->name) <= 0) return OK; /* asked for with energies */
  TRY(hdf_get_number(file, scale->name, value));
  const double least = scale->any ? -INFINITY : 0;
  CHECK(isfinite(*value) && *value > least, ERR_INPUT, "its attribute %s is %g; it must be %s",
        scale->name, *value, scale->any ? "a number" : "positive");
  return OK;
}

static enum status read_flag(hid_t file, const char *name, bool otherwise, bool *flag) {
  int64_t value = otherwise;
  if (H5Aexists(file, name) > 0) TRY(hdf_get_integer(file, name, &value));
  *flag = value == 1;
  return OK;
}

static enum status read_header(hid_t file, struct result_file *f) {
  TRY(read_texts(file, f));
  TRY(read_flag(file, "complete", true, &f->complete));
  TRY(read_flag(file, "floats", false, &f->floats));
  for (int i = 0; i < RESULT_SCALES; i++)
    TRY(read_scale(file, &result_scales[i], (double *)((char *)f + result_scales[i].offset)));
  f->c0 = NAN;
  if (hdf_is_there(file, "parameters/c0"))
    TRY(hdf_get_scalar(file, "parameters/c0", H5T_NATIVE_DOUBLE, &f->c0));
  return OK;
}

static enum status read_outputs(hid_t file, struct result_file *f) {
  size_t n = 0;
  hid_t data = -1;
  if (!hdf_has(file, "VTKHDF")) return OK;
  TRY(hdf_get_all(file, "VTKHDF/Steps/Values", H5T_NATIVE_DOUBLE, 0, &f->n_outputs,
                  &f->output_time));
  TRY(result_check_times("/VTKHDF", f->n_outputs, f->output_time));
  TRY(hdf_get_all(file, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, 0, &n, &f->output_points));
  bool good = n == f->n_outputs;
  for (size_t k = 0; good && k < n; k++) good = f->output_points[k] >= 0;
  CHECK(good, ERR_INPUT, "its dataset /VTKHDF/NumberOfPoints is inconsistent");
  if (!hdf_is_there(file, "VTKHDF/PointData")) return OK; /* positions alone */
  TRY(hdf_open_group(file, "VTKHDF/PointData", &data));
  enum status status = hdf_list(data, &f->n_fields, &f->fields);
  H5Gclose(data);
  return status;
}

static enum status read_all(hid_t file, struct result_file *f) {
  TRY(read_header(file, f));
  TRY(result_lines_read(file, f));
  TRY(read_energy(file, f));
  if (hdf_is_there(file, "series/run"))
    TRY(array_lend(&f->steps,
                   read_table(file, "/series/run", RESULT_STEP_COLUMNS, result_step_columns,
                              is_spare_step, RESULT_STEP_COLUMNS, &f->n_steps, &memory_)));
  TRY(read_errors(file, f));
  TRY(result_read_series(file, f));
  TRY(array_lend(&f->events, result_read_members(file, "events", sizeof *f->events, read_event,
                                                 &f->n_events, &memory_)));
  TRY(array_lend(&f->experiments,
                 result_read_members(file, "experiments", sizeof *f->experiments, read_experiment,
                                     &f->n_experiments, &memory_)));
  TRY(array_lend(&f->profiles, result_read_members(file, "profiles", sizeof *f->profiles,
                                                   read_profile, &f->n_profiles, &memory_)));
  TRY(array_lend(&f->statistics, result_read_members(file, "statistics", sizeof *f->statistics,
                                                     read_statistic, &f->n_statistics, &memory_)));
  return read_outputs(file, f);
}

/* ---- the public functions ---- */

enum status result_read_all(hid_t file, struct result_file *f) {
  enum status status = read_all(file, f);
  return status == OK ? OK : status_context(status, "%s is not a usable result: ", f->path);
}

static enum status read_file(const hid_t *file, void *data) {
  return result_read_all(*file, data);
}

enum status result_read(const char *path, struct result_file **out) {
  *out = NULL;
  struct result_file *f = calloc(1, sizeof *f);
  CHECK(f, ERR_MEMORY, "no memory to read %s", path);
  f->path = strdup(path);
  enum status status = f->path
                           ? result_read_safely(&(struct result_request){
                                 1, {path}, .data = f, .read = read_file, .carry = result_carry})
                           : status_raise(ERR_MEMORY, "no memory to read %s", path);
  if (status == OK)
    *out = f;
  else
    result_file_destroy(f);
  return status;
}

void result_file_destroy(struct result_file *f) {
  if (!f) return;
  free(f->path);
  free(f->solver);
  free(f->run);
  free(f->title);
  free(f->version);
  free(f->revision);
  free(f->case_text);
  free(f->fingerprint);
  free(f->created);
  free(f->water_fingerprint);
  free(f->settings);
  free(f->ended);
  free(f->imported);
  free(f->health);
  geo_lines_destroy(&f->walls);
  for (size_t i = 0; i < f->n_surfaces; i++) geo_lines_destroy(&f->surface[i]);
  free(f->surface);
  free(f->surface_time);
  free(f->energy);
  free(f->energy_error);
  free(f->surface_error);
  for (size_t i = 0; i < f->n_terms; i++) {
    free(f->terms[i].name);
    free(f->terms[i].help);
  }
  free(f->terms);
  free(f->steps);
  result_series_destroy(f);
  for (size_t i = 0; i < f->n_events; i++) free(f->events[i].name);
  free(f->events);
  for (size_t i = 0; i < f->n_experiments; i++) {
    free(f->experiments[i].label);
    free(f->experiments[i].source);
    free(f->experiments[i].target);
    free(f->experiments[i].t);
    free(f->experiments[i].value);
  }
  free(f->experiments);
  for (size_t i = 0; i < f->n_profiles; i++) case_profile_destroy(&f->profiles[i]);
  free(f->profiles);
  for (size_t i = 0; i < f->n_statistics; i++) {
    free(f->statistics[i].name);
    free(f->statistics[i].help);
  }
  free(f->statistics);
  free(f->output_time);
  free(f->output_points);
  hdf_list_destroy(f->n_fields, f->fields);
  free(f);
}

struct current_request {
  const char *fingerprint;
  bool current;
};

static enum status read_current(const hid_t *file, void *data) {
  struct current_request *q = data;
  char *found = NULL;
  int64_t complete = 0;
  q->current = hdf_get_integer(*file, "complete", &complete) == OK && complete == 1 &&
               hdf_get_string(*file, "fingerprint", &found) == OK && !strcmp(found, q->fingerprint);
  free(found);
  return OK;
}

static enum status carry_current(struct carrier *c, void *data) {
  struct current_request *q = data;
  size_t current = q->current;
  TRY(carry_number(c, &current));
  q->current = current == 1;
  return OK;
}

bool result_is_current(const char *path, const char *fingerprint) {
  struct current_request q = {.fingerprint = fingerprint};
  return result_read_safely(&(struct result_request){
             1, {path}, .data = &q, .read = read_current, .carry = carry_current}) == OK &&
         q.current;
}
