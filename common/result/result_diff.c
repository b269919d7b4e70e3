#include "common/result/result_diff.h"

#include <hdf5.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/text.h"
#include "common/result/result.h"
#include "common/result/result_carry.h"
#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"
#include "common/result/result_open.h"

enum { BLOCK = 65536 }; /* rows that are compared at a time */

struct diff {
  const char *path[2];
  const struct result_tolerances *tolerances;
  hid_t file[2];
  int turn;          /* which of them is being read */
  double time_scale; /* sqrt(H/g), s */
  bool draft;
  FILE *out; /* into `text` */
  char *text;
  size_t size;
  size_t n_same, n_differ, n_ignored;
};

/* The file to be read from now on, which is to blame for what goes wrong. */
static hid_t turn_to(struct diff *d, int k) {
  d->turn = k;
  result_blame((size_t)k);
  return d->file[k];
}

/* ---- where in a dataset a row is ---- */

/* The last k with first[k] <= row. */
static size_t find_part(size_t n, const int64_t *first, size_t row) {
  size_t k = 0;
  while (k + 1 < n && first[k + 1] <= (int64_t)row) k++;
  return k;
}

static bool look_up(hid_t file, const char *name, size_t *n, int64_t **values) {
  return hdf_get_all(file, name, H5T_NATIVE_INT64, 0, n, values) == OK;
}

/* The time of a row of `name`, NaN when it has none. */
static double row_time(hid_t file, const char *name, size_t row) {
  char times[512];
  const char *slash = strrchr(name, '/');
  int64_t *first = NULL;
  size_t n = 0;
  double *t = NULL, time = NAN;
  snprintf(times, sizeof times, "%.*stime", slash ? (int)(slash - name) + 1 : 0, name);
  if (!strcmp(name, "surface/points")) {
    if (look_up(file, "surface/first_point", &n, &first)) row = find_part(n, first, row);
    free(first);
    first = NULL;
    if (look_up(file, "surface/first_piece", &n, &first)) row = find_part(n, first, row);
  } else if (!strcmp(name, "VTKHDF/Points") || !strncmp(name, "VTKHDF/PointData/", 17)) {
    snprintf(times, sizeof times, "VTKHDF/Steps/Values");
    if (look_up(file, "VTKHDF/Steps/PointOffsets", &n, &first)) row = find_part(n, first, row);
  } else if (strncmp(name, "series/", 7) && strncmp(name, "surface/time", 12)) {
    return NAN;
  }
  free(first);
  if (hdf_get_all(file, times, H5T_NATIVE_DOUBLE, 0, &n, &t) == OK && row < n) time = t[row];
  free(t);
  return time;
}

/* ---- reporting: what comes from the files shows what it holds, and stays on its line ---- */

static void show_name(struct diff *d, const char *name) {
  int n = (int)strlen(name);
  text_show(d->out, name, "");
  fprintf(d->out, "%*s", d->draft && n < 40 ? 40 - n : 0, "");
}

/* What is different in `name` by no number. */
static void report_text(struct diff *d, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void report_text(struct diff *d, const char *name, const char *format, ...) {
  va_list args;
  d->n_differ++;
  show_name(d, name);
  if (d->draft) {
    fputs(" ignore\n", d->out);
    return;
  }
  char *text = NULL;
  va_start(args, format);
  if (vasprintf(&text, format, args) < 0) text = NULL;
  va_end(args);
  fputs(": ", d->out);
  text_show(d->out, text ? text : "differs", "");
  fputc('\n', d->out);
  free(text);
}

struct shape {
  int rank;
  hsize_t dims[2];
  H5T_class_t class;
};

struct worst {
  double difference, scale; /* largest difference; largest magnitude in both */
  double value[2];
  size_t row, component;
};

static void report_number(struct diff *d, const char *name, const char *units,
                          const struct shape *shape, const struct worst *w) {
  d->n_differ++;
  double relative = w->scale > 0 ? w->difference / w->scale : 0;
  show_name(d, name);
  if (d->draft) {
    if (isfinite(relative))
      fprintf(d->out, " %.1e 0\n", 1.1 * relative);
    else
      fputs(" ignore\n", d->out);
    return;
  }
  fprintf(d->out, ": %.10g against %.10g%s", w->value[0], w->value[1], *units ? " " : "");
  text_show(d->out, units, "");
  fprintf(d->out, ", differs by %.3g (relative %.3g)", w->difference, relative);
  double t = shape->rank ? row_time(turn_to(d, 0), name, w->row) : NAN;
  if (isfinite(t)) fprintf(d->out, " at t = %.6g s (t sqrt(g/H) = %.4g)", t, t / d->time_scale);
  if (shape->rank) fprintf(d->out, ", row %zu", w->row);
  if (shape->rank == 2) fprintf(d->out, ", %c", "xyzw"[w->component % 4]);
  fputc('\n', d->out);
}

/* Judges a finished comparison of numbers. */
static void judge(struct diff *d, const char *name, const char *units, const struct shape *shape,
                  const struct worst *w) {
  const struct tolerance *t = result_tolerances_find(d->tolerances, name);
  if (w->difference == 0 || w->difference <= t->absolute + t->relative * w->scale)
    d->n_same++;
  else
    report_number(d, name, units, shape, w);
}

static void compare_value(struct worst *w, double a, double b, size_t row, size_t component) {
  if (isfinite(a)) w->scale = fmax(w->scale, fabs(a));
  if (isfinite(b)) w->scale = fmax(w->scale, fabs(b));
  double difference = a == b || (isnan(a) && isnan(b)) ? 0 : fabs(a - b);
  if (isnan(difference)) difference = INFINITY;
  if (difference > w->difference) {
    w->difference = difference;
    w->value[0] = a;
    w->value[1] = b;
    w->row = row;
    w->component = component;
  }
}

/* ---- comparing ---- */

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

static enum status compare_texts(struct diff *d, const char *name) {
  char *text[2] = {NULL, NULL};
  enum status status = OK;
  for (int k = 0; k < 2; k++) ATTEMPT(hdf_get_text(turn_to(d, k), name, &text[k]));
  size_t line = 1, at = 0;
  for (; text[0][at] && text[0][at] == text[1][at]; at++) line += text[0][at] == '\n';
  if (text[0][at] == text[1][at])
    d->n_same++;
  else if (strchr(text[0], '\n'))
    report_text(d, name, "the texts differ from line %zu on", line);
  else
    report_text(d, name, "'%s' against '%s'", text[0], text[1]);
done:
  free(text[0]);
  free(text[1]);
  return status;
}

static enum status compare_rows(struct diff *d, const char *name, const struct shape *s,
                                struct worst *w) {
  size_t width = s->rank == 2 ? (size_t)s->dims[1] : 0, wide = width ? width : 1;
  if (s->rank == 0) {
    double value[2];
    for (int k = 0; k < 2; k++)
      TRY(hdf_get_scalar(turn_to(d, k), name, H5T_NATIVE_DOUBLE, &value[k]));
    compare_value(w, value[0], value[1], 0, 0);
    return OK;
  }
  for (hsize_t first = 0; first < s->dims[0]; first += BLOCK) {
    hsize_t n = s->dims[0] - first < BLOCK ? s->dims[0] - first : BLOCK;
    double *rows[2] = {NULL, NULL};
    enum status status = OK;
    for (int k = 0; k < 2 && status == OK; k++)
      status = hdf_get_rows(turn_to(d, k), name, H5T_NATIVE_DOUBLE, width, first, n, &rows[k]);
    for (size_t i = 0; status == OK && i < (size_t)n * wide; i++)
      compare_value(w, rows[0][i], rows[1][i], (size_t)first + i / wide, i % wide);
    free(rows[0]);
    free(rows[1]);
    TRY(status);
  }
  return OK;
}

static enum status compare_set(struct diff *d, const char *name) {
  struct shape s[2];
  if (result_tolerances_find(d->tolerances, name)->ignore) {
    d->n_ignored++;
    return OK;
  }
  for (int k = 0; k < 2; k++)
    CHECK(get_shape(turn_to(d, k), name, &s[k]), ERR_INPUT, "its dataset %s is damaged", name);
  if (s[0].class != s[1].class || s[0].rank != s[1].rank || s[0].dims[1] != s[1].dims[1]) {
    report_text(d, name, "is of another kind");
    return OK;
  }
  if (s[0].dims[0] != s[1].dims[0]) {
    report_text(d, name, "%llu rows against %llu", (unsigned long long)s[0].dims[0],
                (unsigned long long)s[1].dims[0]);
    return OK;
  }
  if (s[0].class == H5T_STRING) return compare_texts(d, name);

  struct worst w = {0};
  TRY(compare_rows(d, name, &s[0], &w));
  char *units = NULL;
  hid_t set = H5Dopen2(turn_to(d, 0), name, H5P_DEFAULT);
  if (set >= 0) (void)hdf_get_string(set, "units", &units);
  if (set >= 0) H5Dclose(set);
  judge(d, name, units && strcmp(units, "1") ? units : "", &s[0], &w);
  free(units);
  return OK;
}

static enum status compare_attributes(struct diff *d) {
  static const char *const names[] = {"solver",   "run",         "title",  "version",
                                      "revision", "fingerprint", "created"};
  for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
    char name[64], *text[2] = {NULL, NULL};
    snprintf(name, sizeof name, "@%s", names[i]);
    if (result_tolerances_find(d->tolerances, name)->ignore) {
      d->n_ignored++;
      continue;
    }
    enum status status = OK;
    for (int k = 0; k < 2 && status == OK; k++)
      if (H5Aexists(turn_to(d, k), names[i]) > 0)
        status = hdf_get_string(turn_to(d, k), names[i], &text[k]);
    const char *const is[2] = {text[0] ? text[0] : "", text[1] ? text[1] : ""};
    if (status == OK && strcmp(is[0], is[1]))
      report_text(d, name, "'%s' against '%s'", is[0], is[1]);
    else
      d->n_same++;
    free(text[0]);
    free(text[1]);
    TRY(status);
  }
  for (int i = -1; i < RESULT_SCALES; i++) {
    const char *attribute = i < 0 ? "complete" : result_scales[i].name;
    char name[64];
    double value[2] = {NAN, NAN}; /* two that are not there are the same */
    snprintf(name, sizeof name, "@%s", attribute);
    if (result_tolerances_find(d->tolerances, name)->ignore) continue;
    for (int k = 0; k < 2; k++)
      if (H5Aexists(turn_to(d, k), attribute) > 0)
        TRY(hdf_get_number(turn_to(d, k), attribute, &value[k]));
    struct worst w = {0};
    compare_value(&w, value[0], value[1], 0, 0);
    judge(d, name, i < 0 ? "" : result_scales[i].units, &(struct shape){.rank = 0}, &w);
  }
  return OK;
}

/* ---- walking through both files ---- */

static herr_t add_set(hid_t object, const char *name, const H5O_info_t *info, void *data) {
  (void)object;
  if (info->type != H5O_TYPE_DATASET) return 0;
  return hdf_names_add(data, name) == OK ? 0 : -1;
}

static enum status compare_sets(struct diff *d, const struct hdf_names s[2]) {
  size_t i = 0, j = 0; /* both lists are in the order of their names */
  while (i < s[0].n || j < s[1].n) {
    int order = i == s[0].n ? 1 : j == s[1].n ? -1 : strcmp(s[0].name[i], s[1].name[j]);
    const char *name = order > 0 ? s[1].name[j] : s[0].name[i];
    if (!order)
      TRY(compare_set(d, name));
    else if (result_tolerances_find(d->tolerances, name)->ignore)
      d->n_ignored++;
    else
      report_text(d, name, "only in %s", d->path[order > 0]);
    i += order <= 0;
    j += order >= 0;
  }
  return OK;
}

static int by_name(const void *a, const void *b) {
  return strcmp(*(char *const *)a, *(char *const *)b);
}

static enum status compare_files(struct diff *d) {
  struct hdf_names sets[2] = {{0}, {0}};
  double H, g;
  enum status status = OK;
  ATTEMPT(hdf_get_number(turn_to(d, 0), "H", &H));
  ATTEMPT(hdf_get_number(turn_to(d, 0), "g", &g));
  d->time_scale = sqrt(H / g);
  for (int k = 0; k < 2; k++) {
    if (H5Ovisit(turn_to(d, k), H5_INDEX_NAME, H5_ITER_NATIVE, add_set, &sets[k]) < 0) {
      status = hdf_raise(ERR_INPUT, "its datasets cannot be listed");
      goto done;
    }
    if (sets[k].n) qsort(sets[k].name, sets[k].n, sizeof *sets[k].name, by_name);
  }
  ATTEMPT(compare_attributes(d));
  ATTEMPT(compare_sets(d, sets));
done:
  for (int k = 0; k < 2; k++) hdf_list_destroy(sets[k].n, sets[k].name);
  return status;
}

/* Says what is wrong with a file better than the walk through its datasets. */
static enum status check_one(struct diff *d, int k) {
  struct result_file *f = calloc(1, sizeof *f);
  CHECK(f, ERR_MEMORY, "no memory to read it");
  f->path = strdup(d->path[k]);
  enum status status = result_read_all(turn_to(d, k), f);
  result_file_destroy(f);
  return status;
}

/* In a process that may not print: into memory, and the caller prints. */
static enum status read_both(const hid_t *file, void *data) {
  struct diff *d = data;
  for (int k = 0; k < 2; k++) d->file[k] = file[k];
  for (int k = 0; k < 2; k++) TRY(check_one(d, k));
  d->out = open_memstream(&d->text, &d->size);
  CHECK(d->out, ERR_MEMORY, "no memory for a report");
  enum status status = compare_files(d);
  bool good = !ferror(d->out);
  fclose(d->out);
  if (status != OK) return status_context(status, "%s: ", d->path[d->turn]);
  CHECK(good, ERR_MEMORY, "no memory for a report");
  return OK;
}

static enum status carry_report(struct carrier *c, void *data) {
  struct diff *d = data;
  TRY(carry_text(c, &d->text));
  TRY(carry_number(c, &d->n_same));
  TRY(carry_number(c, &d->n_differ));
  return carry_number(c, &d->n_ignored);
}

enum status result_diff(const char *a, const char *b, const struct result_tolerances *tolerances,
                        bool draft, FILE *out, bool *same) {
  struct diff d = {.path = {a, b}, .tolerances = tolerances, .draft = draft};
  enum status status = result_read_safely(
      &(struct result_request){2, {a, b}, .data = &d, .read = read_both, .carry = carry_report});
  if (status == OK) {
    if (draft) fprintf(out, "# worst differences between %s and %s, and a tenth more\n", a, b);
    fputs(d.text ? d.text : "", out);
    if (!draft)
      fprintf(out, "%zu of %zu quantities differ, %zu ignored\n", d.n_differ, d.n_differ + d.n_same,
              d.n_ignored);
    *same = d.n_differ == 0;
  }
  free(d.text);
  return status;
}
