/* The parts of the section `compare` that look at signals by themselves: filters and spectra. What
 * they say changes no number that is compared. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/wall_shares.h"
#include "common/case/case_draft.h"

/* ---- filters ---- */

static const char *const filter_names[] = {
#define X(name, help) #name,
    CASE_FILTERS(X)
#undef X
        NULL};
static const char *const filter_helps[] = {
#define X(name, help) help,
    CASE_FILTERS(X)
#undef X
};

struct filter_section {
  int probe, kind;
  double period, length;
};
static const struct param filter_rows[] = {
    NODE(struct filter_section, probe, NULL, "the name of a probe"),
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct filter_section, kind),
     .choices = filter_names,
     .value = NULL,
     .help = "what is drawn and tabulated beside the raw pressure (thesis, 3.2.1)",
     .helps = filter_helps},
    REAL(struct filter_section, period, QTY_TIME, PARAM_ABOVE_0, 1e9, "",
         "of low_pass: of a wave that it halves; 2 a h/c0 is the thesis' cut-off frequency "
         "pi c0/(a h), a = 5 there"),
    REAL(struct filter_section, length, QTY_LENGTH, PARAM_ABOVE_0, 1e6, "",
         "of wall: how much of the wall, the probe in its middle; 5 to 10 h in the thesis"),
};

/* A key that a kind needs, or one that it does not know. */
static void check_filter_key(struct case_draft *d, int node, const char *path,
                             enum case_filter_kind kind, enum case_filter_kind of,
                             const char *key) {
  char full[CASE_PATH + 16], found[64], allowed[64];
  const bool there = case_doc_member(&d->doc, node, key);
  if (there == (kind == of)) return;
  snprintf(full, sizeof full, "%s.%s", path, key);
  snprintf(found, sizeof found, there ? "a key of the kind %s" : "nothing", filter_names[of]);
  snprintf(allowed, sizeof allowed, there ? "none with the kind %s" : "a number for the kind %s",
           filter_names[kind]);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, node, key), full, found, allowed,
                   there ? "remove it" : "add this key");
}

static void read_filter(struct case_draft *d, int node, size_t i) {
  struct case_file *c = d->c;
  struct case_filter *f = &c->compare.filters[c->compare.n_filters++];
  struct filter_section s = {0};
  char path[CASE_PATH], key[CASE_PATH + 16];
  f->probe = c->n_probes;
  snprintf(path, sizeof path, "compare.filters[%zu]", i);
  if (!case_read_section(d, node, path, filter_rows, ROWS(filter_rows), &s)) return;
  snprintf(key, sizeof key, "%s.probe", path);
  f->kind = (enum case_filter_kind)s.kind;
  f->period = s.period;
  f->length = s.length;
  f->probe = case_find_probe(d, s.probe, key);
  check_filter_key(d, node, path, f->kind, CASE_FILTER_low_pass, "period");
  check_filter_key(d, node, path, f->kind, CASE_FILTER_wall, "length");
}

enum status case_read_filters(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.filters", 0, CASE_MOST_ITEMS, "filters")) return OK;
  size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.filters, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) read_filter(d, case_doc_item(doc, node, i), i);
  return OK;
}

/* ---- spectra ---- */

struct spectrum_section {
  char *series;
  double from, to;
  int peaks;
};
static const struct param spectrum_rows[] = {
    TEXT(struct spectrum_section, series, 80, NULL,
         "name of a probe, of a gauge, or of a point and one of its fields: NAME.a_y"),
    REAL(struct spectrum_section, from, QTY_TIME, 0, 1e9, "0", "rows before it are left out"),
    REAL(struct spectrum_section, to, QTY_TIME, PARAM_ABOVE_0, 1e9, "",
         "rows after it are left out; default: none"),
    {.key = "peaks",
     .type = PARAM_INT,
     .offset = offsetof(struct spectrum_section, peaks),
     .min = 1,
     .max = CASE_MOST_PEAKS,
     .value = "3",
     .help = "how many peaks are listed, the highest first"},
};

/* Of a point, with a dot and the field. */
typedef char series_name[CASE_LONGEST_NAME + 16];

/* The names of all series that there are, a point's with its fields. */
static enum status series_names(const struct case_file *c, size_t *n, series_name **out) {
  TRY(array_create(out, c->n_probes + c->n_gauges + CASE_POINT_FIELDS * c->n_points + 1,
                   "names of series"));
  series_name *name = *out;
  *n = 0;
  for (size_t i = 0; i < c->n_probes; i++)
    if (c->probes[i].name) snprintf(name[(*n)++], sizeof *name, "%s", c->probes[i].name);
  for (size_t i = 0; i < c->n_gauges; i++)
    if (c->gauges[i].name) snprintf(name[(*n)++], sizeof *name, "%s", c->gauges[i].name);
  for (size_t i = 0; i < c->n_points; i++)
    for (size_t k = 0; c->points[i].name && k < CASE_POINT_FIELDS; k++)
      snprintf(name[(*n)++], sizeof *name, "%.*s.%s", CASE_LONGEST_NAME, c->points[i].name,
               case_point_fields[k]);
  return OK;
}

/* Where no series has the name, says which there are. */
static enum status check_series(struct case_draft *d, int node, const char *path,
                                const char *series) {
  series_name *name = NULL;
  const char *offered[CASE_MOST_ITEMS];
  char found[64];
  size_t n;
  bool there = false;
  enum status status = series_names(d->c, &n, &name);
  for (size_t i = 0; status == OK && i < n && !there; i++) there = !strcmp(name[i], series);
  if (status == OK && !there) {
    if (n > CASE_MOST_ITEMS) n = CASE_MOST_ITEMS;
    for (size_t i = 0; i < n; i++) offered[i] = name[i];
    struct case_offer offer = case_offer(
        n ? "one of " : "none, there are no probes, gauges or points", n, offered, series);
    case_doc_found(&d->doc, node, found);
    case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, found, offer.allowed, offer.todo);
  }
  free(name);
  return status;
}

static enum status read_spectrum(struct case_draft *d, int node, size_t i) {
  struct case_file *c = d->c;
  struct spectrum_section s = {.to = INFINITY};
  char path[CASE_PATH], key[CASE_PATH + 16];
  snprintf(path, sizeof path, "compare.spectra[%zu]", i);
  if (!case_read_section(d, node, path, spectrum_rows, ROWS(spectrum_rows), &s)) {
    params_release(spectrum_rows, ROWS(spectrum_rows), &s);
    return OK;
  }
  c->compare.spectra[c->compare.n_spectra++] =
      (struct case_spectrum){s.series, s.from, s.to, (size_t)s.peaks};
  snprintf(key, sizeof key, "%s.series", path);
  return check_series(d, case_doc_member(&d->doc, node, "series"), key, s.series);
}

enum status case_read_spectra(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.spectra", 0, CASE_MOST_ITEMS, "spectra")) return OK;
  size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.spectra, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) TRY(read_spectrum(d, case_doc_item(doc, node, i), i));
  return OK;
}

const struct case_table case_signal_tables[] = {
    {"compare.filters (a list)", filter_rows, ROWS(filter_rows)},
    {"compare.spectra (a list)", spectrum_rows, ROWS(spectrum_rows)},
    {0},
};

/* ---- whether they make sense ---- */

/* A problem at a key of the i-th item of a list of `compare`, whose value is a time. */
static void time_problem(struct case_draft *d, const char *list, size_t i, const char *key,
                         double value, const char *limit_is, double limit, const char *todo) {
  const int items = case_doc_member(&d->doc, d->at.compare, list);
  const int node = case_doc_member(&d->doc, case_doc_item(&d->doc, items, i), key);
  char path[CASE_PATH], found[64], words[64], allowed[128];
  snprintf(path, sizeof path, "compare.%s[%zu].%s", list, i, key);
  case_time_words(d, node, value, found);
  case_time_words(d, node, limit, words);
  snprintf(allowed, sizeof allowed, "%s, %s", limit_is, words);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, found, allowed, todo);
}

/* At how many places probes are within half the length of it along its wall, itself included. */
static size_t places_along(const struct case_file *c, const struct case_filter *f) {
  double at[CASE_MOST_ITEMS][2], share[CASE_MOST_ITEMS];
  for (size_t k = 0; k < c->n_probes; k++) {
    at[k][0] = c->probes[k].x;
    at[k][1] = c->probes[k].y;
  }
  return geo_wall_shares(&c->walls, c->n_probes, (const double(*)[2])at, f->probe, f->length,
                         share);
}

static void check_wall(struct case_draft *d, size_t i) {
  const struct case_filter *f = &d->c->compare.filters[i];
  const int items = case_doc_member(&d->doc, d->at.compare, "filters");
  const int node = case_doc_member(&d->doc, case_doc_item(&d->doc, items, i), "length");
  char path[CASE_PATH], found[96];
  const size_t n = places_along(d->c, f);
  if (n >= CASE_LEAST_ON_WALL) return;
  snprintf(path, sizeof path, "compare.filters[%zu].length", i);
  snprintf(found, sizeof found, "%.6g m with probes of the case at %zu place%s on it", f->length, n,
           n == 1 ? "" : "s");
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, found,
                   "so much of the wall that probes at three places or more are within half of it "
                   "of the one in its middle",
                   "add probes along that wall, or give the probe a size instead");
}

void case_check_filters(struct case_draft *d, double sample, double end, const char *what) {
  const struct case_file *c = d->c;
  for (size_t i = 0; i < c->compare.n_filters; i++) {
    const struct case_filter *f = &c->compare.filters[i];
    if (f->kind == CASE_FILTER_wall && f->length > 0 && f->probe < c->n_probes && d->good.probes &&
        d->good.tank)
      check_wall(d, i);
    if (f->kind != CASE_FILTER_low_pass || !(f->period > 0)) continue;
    if (f->period > end * (1 + CASE_SAME)) {
      char at_most[64];
      snprintf(at_most, sizeof at_most, "at most %s", what);
      time_problem(d, "filters", i, "period", f->period, at_most, end, "make it smaller");
    } else if (f->period < 2 * sample * (1 - CASE_SAME)) {
      time_problem(d, "filters", i, "period", f->period,
                   "at least two of time.sample, since series hold nothing shorter", 2 * sample,
                   "make it larger, or time.sample smaller");
    }
  }
}

void case_check_spectra(struct case_draft *d, double end, const char *what) {
  const struct case_file *c = d->c;
  char at_most[64];
  snprintf(at_most, sizeof at_most, "at most %s", what);
  for (size_t i = 0; i < c->compare.n_spectra; i++) {
    const struct case_spectrum *s = &c->compare.spectra[i];
    const double to = fmin(s->to, end);
    if (isfinite(s->to) && s->to > end * (1 + CASE_SAME))
      time_problem(d, "spectra", i, "to", s->to, at_most, end, "make it smaller");
    if (s->from >= to)
      time_problem(d, "spectra", i, "from", s->from, "before the end of the spectrum", to,
                   "make it smaller");
  }
}
