#include "common/result/result_diff.h"

#include <hdf5.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result_carry.h"
#include "common/result/result_differ.h"
#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"
#include "common/result/result_open.h"

/* ---- quantities ---- */

/* A new one, with the rules for it. */
static enum status begin(struct differ *d, const char *name, struct result_quantity **out) {
  struct result_diff *r = d->d;
  TRY(array_grow(&r->quantity, &d->room, r->n + 1, "differences"));
  struct result_quantity *q = &r->quantity[r->n];
  const struct result_spot nowhere = {.time = NAN, .place = {NAN, NAN}};
  *q = (struct result_quantity){.what_time = NAN, .first = nowhere, .worst = nowhere};
  q->name = strdup(name);
  q->units = strdup("");
  r->n++;
  CHECK(q->name && q->units, ERR_MEMORY, "no memory for differences");
  d->n_rules = result_tolerances_match(d->tolerances, name, d->rule);
  for (size_t i = 0; i < d->n_rules; i++) r->matched[d->rule[i] - d->tolerances->rule] = 1;
  TRY(array_create(&q->used, d->n_rules, "rules"));
  *out = q;
  return OK;
}

/* What has no time, and what is not looked at whatever its times are. */
static bool ignored(const struct differ *d, struct result_quantity *q) {
  q->ignored = result_diff_rule(d, NAN)->ignore;
  return q->ignored;
}

static bool ignored_always(const struct differ *d, struct result_quantity *q) {
  size_t i = 0;
  while (i < d->n_rules && d->rule[i]->ignore) i++;
  q->ignored = i == d->n_rules;
  return q->ignored;
}

static void count(struct differ *d, const struct result_quantity *q) {
  d->d->n_ignored += q->ignored;
  d->d->n_differ += q->differs;
  d->d->n_same += !q->differs && !q->ignored;
}

/* ---- a dataset ---- */

struct shape {
  int rank;
  hsize_t dims[2];
  H5T_class_t class;
};

static bool get_shape(hid_t file, const char *name, struct shape *s) {
  hid_t set = H5Dopen2(file, name, H5P_DEFAULT);
  hid_t space = set >= 0 ? H5Dget_space(set) : -1, type = set >= 0 ? H5Dget_type(set) : -1;
  *s = (struct shape){.rank = space >= 0 ? H5Sget_simple_extent_ndims(space) : -1};
  bool good = type >= 0 && s->rank >= 0 && s->rank <= 2;
  if (good) H5Sget_simple_extent_dims(space, s->dims, NULL);
  if (good) s->class = H5Tget_class(type);
  if (type >= 0) H5Tclose(type);
  if (space >= 0) H5Sclose(space);
  if (set >= 0) H5Dclose(set);
  return good;
}

static enum status compare_texts(struct differ *d, struct result_quantity *q) {
  char *text[2] = {NULL, NULL};
  enum status status = OK;
  for (int k = 0; k < 2; k++) ATTEMPT(hdf_get_text(result_diff_turn(d, k), q->name, &text[k]));
  size_t line = 1, at = 0;
  for (; text[0][at] && text[0][at] == text[1][at]; at++) line += text[0][at] == '\n';
  if (text[0][at] != text[1][at])
    status = strchr(text[0], '\n') ? result_diff_say(q, "the texts differ from line %zu on", line)
                                   : result_diff_say(q, "'%s' against '%s'", text[0], text[1]);
done:
  free(text[0]);
  free(text[1]);
  return status;
}

static enum status take_units(struct differ *d, struct result_quantity *q) {
  char *units = NULL;
  hid_t set = H5Dopen2(result_diff_turn(d, 0), q->name, H5P_DEFAULT);
  if (set >= 0) (void)hdf_get_string(set, "units", &units);
  if (set >= 0) H5Dclose(set);
  if (units && strcmp(units, "1")) {
    free(q->units);
    q->units = units;
  } else {
    free(units);
  }
  return OK;
}

static enum status compare_set(struct differ *d, const char *name) {
  struct shape s[2];
  struct result_quantity *q;
  TRY(begin(d, name, &q));
  if (ignored_always(d, q)) return OK;
  for (int k = 0; k < 2; k++)
    CHECK(get_shape(result_diff_turn(d, k), name, &s[k]), ERR_INPUT, "its dataset %s is damaged",
          name);
  if (s[0].class != s[1].class || s[0].rank != s[1].rank || s[0].dims[1] != s[1].dims[1])
    return ignored(d, q) ? OK : result_diff_say(q, "is of another kind");
  if (s[0].class == H5T_STRING) return ignored(d, q) ? OK : compare_texts(d, q);
  q->rank = s[0].rank;
  TRY(take_units(d, q));
  if (!s[0].rank) return result_diff_scalars(d, q);
  if (s[0].rank == 2 && !s[0].dims[1]) return OK; /* rows of nothing */
  return result_diff_tables(d, q, (hsize_t[]){s[0].dims[0], s[1].dims[0]}, (size_t)s[0].dims[1]);
}

static enum status compare_alone(struct differ *d, const char *name, int owner) {
  struct result_quantity *q;
  TRY(begin(d, name, &q));
  return ignored(d, q) ? OK : result_diff_say(q, "only in %s", d->d->path[owner]);
}

/* ---- attributes ---- */

static enum status compare_words(struct differ *d, const char *attribute) {
  struct result_quantity *q;
  char name[64], *text[2] = {NULL, NULL};
  snprintf(name, sizeof name, "@%s", attribute);
  TRY(begin(d, name, &q));
  if (ignored(d, q)) return OK;
  enum status status = OK;
  for (int k = 0; k < 2 && status == OK; k++)
    if (H5Aexists(result_diff_turn(d, k), attribute) > 0)
      status = hdf_get_string(result_diff_turn(d, k), attribute, &text[k]);
  const char *const is[2] = {text[0] ? text[0] : "", text[1] ? text[1] : ""};
  if (status == OK && strcmp(is[0], is[1]))
    status = result_diff_say(q, "'%s' against '%s'", is[0], is[1]);
  free(text[0]);
  free(text[1]);
  return status;
}

/* `absent`: what it is of a file without it. */
static enum status compare_number(struct differ *d, const char *attribute, const char *units,
                                  double absent) {
  struct result_quantity *q;
  char name[64];
  double value[2] = {absent, absent};
  snprintf(name, sizeof name, "@%s", attribute);
  TRY(begin(d, name, &q));
  for (int k = 0; k < 2; k++)
    if (H5Aexists(result_diff_turn(d, k), attribute) > 0)
      TRY(hdf_get_number(result_diff_turn(d, k), attribute, &value[k]));
  free(q->units);
  q->units = strdup(units);
  CHECK(q->units, ERR_MEMORY, "no memory for differences");
  result_diff_numbers(d, q, value, NAN);
  return OK;
}

static enum status compare_attributes(struct differ *d) {
  static const char *const names[] = {"solver",  "run",      "title",       "settings", "imported",
                                      "version", "revision", "fingerprint", "created",  "ended"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) TRY(compare_words(d, names[i]));
  bool both = true; /* files of older programs have none */
  for (int k = 0; k < 2; k++) both = both && H5Aexists(result_diff_turn(d, k), "water") > 0;
  if (both) TRY(compare_words(d, "water"));
  TRY(compare_number(d, "complete", "", NAN)); /* two that are not there are the same */
  TRY(compare_number(d, "floats", "", 0));
  for (int i = 0; i < RESULT_SCALES; i++)
    TRY(compare_number(d, result_scales[i].name, result_scales[i].units, NAN));
  return OK;
}

/* ---- walking through both files ---- */

static herr_t add_set(hid_t object, const char *name, const H5O_info_t *info, void *data) {
  (void)object;
  if (info->type != H5O_TYPE_DATASET) return 0;
  return hdf_names_add(data, name) == OK ? 0 : -1;
}

static enum status compare_sets(struct differ *d, const struct hdf_names s[2]) {
  size_t i = 0, j = 0; /* both lists are in the order of their names */
  while (i < s[0].n || j < s[1].n) {
    int order = i == s[0].n ? 1 : j == s[1].n ? -1 : strcmp(s[0].name[i], s[1].name[j]);
    const char *name = order > 0 ? s[1].name[j] : s[0].name[i];
    TRY(order ? compare_alone(d, name, order > 0) : compare_set(d, name));
    i += order <= 0;
    j += order >= 0;
  }
  return OK;
}

static int by_name(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static enum status compare_files(struct differ *d) {
  struct hdf_names sets[2] = {{0}, {0}};
  double H, g;
  enum status status = OK;
  ATTEMPT(hdf_get_number(result_diff_turn(d, 0), "H", &H));
  ATTEMPT(hdf_get_number(result_diff_turn(d, 0), "g", &g));
  d->d->time_scale = sqrt(H / g);
  for (int k = 0; k < 2; k++) {
    if (H5Ovisit(result_diff_turn(d, k), H5_INDEX_NAME, H5_ITER_NATIVE, add_set, &sets[k]) < 0) {
      status = hdf_raise(ERR_INPUT, "its datasets cannot be listed");
      goto done;
    }
    if (sets[k].n) qsort(sets[k].name, sets[k].n, sizeof *sets[k].name, by_name);
  }
  ATTEMPT(compare_attributes(d));
  ATTEMPT(compare_sets(d, sets));
  for (size_t i = 0; i < d->d->n; i++) count(d, &d->d->quantity[i]);
  if (d->shown) ATTEMPT(result_diff_curves(d));
done:
  for (int k = 0; k < 2; k++) hdf_list_destroy(sets[k].n, sets[k].name);
  return status;
}

/* Says what is wrong with a file better than the walk through its datasets. */
static enum status check_one(struct differ *d, int k) {
  struct result_file *f = calloc(1, sizeof *f);
  CHECK(f, ERR_MEMORY, "no memory to read it");
  f->path = strdup(d->d->path[k]);
  enum status status = f->path ? result_read_all(result_diff_turn(d, k), f)
                               : status_raise(ERR_MEMORY, "no memory to read it");
  if (d->shown && status == OK)
    d->d->file[k] = f;
  else
    result_file_destroy(f);
  return status;
}

/* In the child process. */
static enum status read_both(const hid_t *file, void *data) {
  struct differ *d = data;
  for (int k = 0; k < 2; k++) d->file[k] = file[k];
  for (int k = 0; k < 2; k++) TRY(check_one(d, k));
  enum status status = compare_files(d);
  return status == OK ? OK : status_context(status, "%s: ", d->d->path[d->turn]);
}

/* ---- all of it ---- */

enum status result_diff_create(const char *a, const char *b,
                               const struct result_tolerances *tolerances, size_t shown,
                               struct result_diff **out) {
  struct result_diff *r = *out = calloc(1, sizeof *r);
  CHECK(r, ERR_MEMORY, "no memory to compare %s", a);
  struct differ d = {.d = r, .tolerances = tolerances, .shown = shown};
  enum status status = OK;
  r->n_rules = tolerances->n;
  ATTEMPT(array_create(&r->matched, r->n_rules, "tolerances"));
  ATTEMPT(array_create(&d.rule, r->n_rules, "tolerances"));
  for (int k = 0; k < 2; k++) {
    r->path[k] = strdup(k ? b : a);
    if (!r->path[k]) status = status_raise(ERR_MEMORY, "no memory to compare %s", a);
  }
  if (status == OK)
    status = result_read_safely(&(struct result_request){
        2, {a, b}, .data = &d, .read = read_both, .carry = result_diff_carry});
done:
  free(d.rule);
  if (status != OK) {
    result_diff_destroy(r);
    *out = NULL;
  }
  return status;
}
