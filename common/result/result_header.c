#include "common/result/result_header.h"

#include <math.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"

static enum status write_attributes(hid_t file, const struct result_about *about) {
  char created[32];
  time_t now = time(NULL);
  strftime(created, sizeof created, "%Y-%m-%dT%H:%M:%SZ", gmtime(&now));
  const char *const text[][2] = {{"format", RESULT_FORMAT},
                                 {"solver", about->solver},
                                 {"run", about->run},
                                 {"title", about->title},
                                 {"version", about->version},
                                 {"revision", about->revision},
                                 {"fingerprint", about->fingerprint},
                                 {"water", about->water_fingerprint},
                                 {"imported", about->imported},
                                 {"created", created}};
  for (size_t i = 0; i < sizeof text / sizeof *text; i++)
    if (text[i][1] && *text[i][1]) TRY(hdf_set_string(file, text[i][0], text[i][1]));
  TRY(hdf_set_integers(file, "format_version", 1, (int64_t[]){RESULT_FORMAT_VERSION}));
  TRY(hdf_set_integers(file, "complete", 1, (int64_t[]){0}));
  TRY(hdf_set_integers(file, "floats", 1, (int64_t[]){about->floats}));
  struct result_file scales = {.H = about->H,
                               .g = about->g,
                               .density = about->density,
                               .spacing = about->H / about->resolution,
                               .rest_potential = about->rest_potential};
  for (int i = 0; i < RESULT_SCALES; i++) {
    const double value = *(double *)((char *)&scales + result_scales[i].offset);
    if (!isnan(value)) TRY(hdf_set_number(file, result_scales[i].name, value));
  }
  return OK;
}

static enum status write_parameter(hid_t group, const struct param *p, const void *options) {
  static const char *const units[] = {
      [QTY_NUMBER] = "1",     [QTY_LENGTH] = "m",       [QTY_TIME] = "s",
      [QTY_VELOCITY] = "m/s", [QTY_DENSITY] = "kg/m^3", [QTY_ACCELERATION] = "m/s^2",
      [QTY_RATE] = "1/s"};
  const char *at = (const char *)options + p->offset;
  switch (p->type) {
  case PARAM_REAL:
    return hdf_put_scalar(group, p->key, H5T_NATIVE_DOUBLE, at, units[p->quantity], p->help);
  case PARAM_INT:
    return hdf_put_scalar(group, p->key, H5T_NATIVE_INT, at, "1", p->help);
  case PARAM_BOOL: {
    int value = *(const bool *)at;
    return hdf_put_scalar(group, p->key, H5T_NATIVE_INT, &value, "1", p->help);
  }
  case PARAM_CHOICE:
    return hdf_put_string(group, p->key, p->choices[*(const int *)at], p->help);
  case PARAM_TEXT: {
    const char *text = *(char *const *)at;
    return hdf_put_string(group, p->key, text ? text : "", p->help);
  }
  case PARAM_NODE:
    return OK; /* stands in the case text */
  }
  return OK;
}

static enum status write_parameters(hid_t file, const struct result_about *about) {
  hid_t group = -1;
  enum status status = hdf_group_create(file, "parameters", &group);
  if (status == OK)
    status = hdf_put_scalar(group, "resolution", H5T_NATIVE_DOUBLE, &about->resolution, "1",
                            "scale of length H over the particle or node spacing");
  for (size_t i = 0; i < about->n_params && status == OK; i++)
    status = write_parameter(group, &about->params[i], about->options);
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status write_walls(hid_t file, const struct geo_lines *walls) {
  static const size_t none = 0;
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(file, "walls", &group));
  ATTEMPT(hdf_put(group, "first_point", H5T_NATIVE_HSIZE, walls->pieces + 1, 0,
                  walls->first ? walls->first : &none, "1",
                  "first row of points of each piece, and the end of the last"));
  ATTEMPT(hdf_put(group, "closed", H5T_NATIVE_UCHAR, walls->pieces, 0, walls->closed, "1",
                  "1 where the last point of a piece joins its first"));
  ATTEMPT(hdf_put(group, "points", H5T_NATIVE_DOUBLE, walls->points, 2, walls->p, "m",
                  "x, y; the water lies on the left"));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

/* Pressure at a probe, else lengths: see the units of experiments in the case file. */
static const char *experiment_units(const struct result_about *about, const char *target) {
  for (size_t i = 0; i < about->n_probes; i++)
    if (!strcmp(about->probes[i].name, target)) return "Pa";
  return "m";
}

static enum status write_experiment(hid_t parent, size_t number, const struct result_about *about,
                                    const struct case_experiment *e) {
  char name[32];
  snprintf(name, sizeof name, "experiment_%zu", number);
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(parent, name, &group));
  ATTEMPT(hdf_set_string(group, "label", e->label ? e->label : ""));
  ATTEMPT(hdf_set_string(group, "source", e->source ? e->source : ""));
  ATTEMPT(hdf_set_string(group, "target", e->target));
  ATTEMPT(hdf_put(group, "time", H5T_NATIVE_DOUBLE, e->n, 0, e->t, "s", "time"));
  ATTEMPT(hdf_put(group, "value", H5T_NATIVE_DOUBLE, e->n, 0, e->value,
                  experiment_units(about, e->target),
                  "measured value, in the units of its target"));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status write_experiments(hid_t file, const struct result_about *about) {
  hid_t group = -1;
  enum status status = hdf_group_create(file, "experiments", &group);
  for (size_t i = 0; i < about->n_experiments && status == OK; i++)
    status = write_experiment(group, i + 1, about, &about->experiments[i]);
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status write_profile(hid_t parent, size_t number, const struct case_profile *p) {
  char name[32];
  snprintf(name, sizeof name, "profile_%zu", number);
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(parent, name, &group));
  ATTEMPT(hdf_set_string(group, "label", p->label));
  ATTEMPT(hdf_set_string(group, "source", p->source));
  ATTEMPT(hdf_set_number(group, "time", p->time));
  ATTEMPT(hdf_put(group, "x", H5T_NATIVE_DOUBLE, p->n, 0, p->x, "m", "place"));
  ATTEMPT(
      hdf_put(group, "y", H5T_NATIVE_DOUBLE, p->n, 0, p->y, "m", "height of the surface there"));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

static enum status write_profiles(hid_t file, const struct result_about *about) {
  hid_t group = -1;
  if (!about->n_profiles) return OK;
  enum status status = hdf_group_create(file, "profiles", &group);
  for (size_t i = 0; i < about->n_profiles && status == OK; i++)
    status = write_profile(group, i + 1, &about->profiles[i]);
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_header_write(hid_t file, const struct result_about *about) {
  TRY(write_attributes(file, about));
  if (*about->case_text)
    TRY(hdf_put_string(file, "case", about->case_text,
                       "the case file as run, with overrides applied"));
  TRY(write_parameters(file, about));
  if (about->walls->pieces) TRY(write_walls(file, about->walls));
  TRY(write_experiments(file, about));
  return write_profiles(file, about);
}
