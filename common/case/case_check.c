/* Whether what a case says makes sense together: each section is checked when it, and what it is
 * checked against, was read without a fault. */
#include <math.h>
#include <string.h>

#include "common/base/geometry_check.h"
#include "common/case/case_draft.h"
#include "common/flow/flow.h"
#include "common/tank/room.h"

enum { MOST_OUTPUTS = 100000, MOST_SAMPLES = 10000000 };

const char *const case_point_fields[CASE_POINT_FIELDS] = {
#define X(name, units, help) #name,
    CASE_POINT(X)
#undef X
};

const double CASE_SAME = 1e-9;

double case_near(const struct case_file *c) {
  return CASE_SAME * case_tank_size(c);
}

double case_tank_size(const struct case_file *c) {
  return fmax(c->tank.max[0] - c->tank.min[0], c->tank.max[1] - c->tank.min[1]);
}

/* ---- time ---- */

/* time.every or time.sample: at most as long as `whole`, key `longest`, and not too many of it. */
static void check_interval(struct case_draft *d, const char *key, double value, const char *longest,
                           double whole, const char *what, int most) {
  char path[32], found[96], allowed[96];
  int line = case_doc_member_line(&d->doc, d->at.time, key);
  snprintf(path, sizeof path, "time.%s", key);
  if (value > whole * (1 + CASE_SAME)) {
    snprintf(found, sizeof found, "%.6g s", value);
    snprintf(allowed, sizeof allowed, "at most %s, %.6g s", longest, whole);
    case_doc_problem(&d->doc, line, path, found, allowed, "make it smaller");
  } else if (d->c->end / value > most) {
    snprintf(found, sizeof found, "%.6g %s up to time.end", d->c->end / value, what);
    snprintf(allowed, sizeof allowed, "at most %d", most);
    case_doc_problem(&d->doc, line, path, found, allowed, "make it larger");
  }
}

static void check_time(struct case_draft *d) {
  const struct case_file *c = d->c;
  size_t faults = d->doc.faults;
  check_interval(d, "every", c->every, "time.end", c->end, "outputs", MOST_OUTPUTS);
  check_interval(d, "sample", c->sample, "time.every", c->every, "samples", MOST_SAMPLES);
  d->good.time = d->doc.faults == faults;
}

/* ---- probes, gauges, names ---- */

/* Every name must be fit for a file or a series, and nobody else's. */
static void check_name(struct case_draft *d, int item, const char *path, const char *name,
                       const char *const *others, size_t n) {
  char found[96], shown[72], full[CASE_PATH + 8];
  int line = case_doc_member_line(&d->doc, item, "name");
  if (!name) return;
  snprintf(full, sizeof full, "%s.name", path);
  case_quote(name, strlen(name), shown, sizeof shown);
  snprintf(found, sizeof found, "'%s'", shown);
  if (!case_name_fits(name)) {
    case_doc_problem(&d->doc, line, full, found,
                     "1 to 64 of the characters A-Z a-z 0-9 . _ - and no '.' in front",
                     "it names a file or a series");
    return;
  }
  for (size_t i = 0; i < n; i++)
    if (others[i] && !strcmp(others[i], name)) {
      snprintf(found, sizeof found, "'%s' a second time", shown);
      case_doc_problem(&d->doc, line, full, found, "a name of its own", "rename one");
      return;
    }
}

/* Of a tank with periodic sides, which has no other wall. */
static bool is_on_bed(const struct case_file *c, double x, double y) {
  size_t first, last;
  double nearest = INFINITY;
  tank_find_bed(&c->walls, &first, &last);
  for (size_t i = first; i < last; i++) {
    double foot[2];
    geo_segment_foot(c->walls.p[i], c->walls.p[i + 1], (double[2]){x, y}, foot);
    nearest = fmin(nearest, hypot(x - foot[0], y - foot[1]));
  }
  return nearest <= 1e-6 * case_tank_size(c);
}

void case_check_probe(struct case_draft *d, const struct case_probe *p, int item,
                      const char *path) {
  const struct case_file *c = d->c;
  double nearest[2] = {0};
  size_t piece = 0;
  char full[CASE_PATH + 8], found[96], todo[96];
  double distance = geo_lines_distance(&c->walls, p->x, p->y, nearest, &piece);
  if (c->periodic[1] || (c->periodic[0] && !is_on_bed(c, p->x, p->y))) {
    snprintf(full, sizeof full, "%s.at", path);
    snprintf(found, sizeof found, "(%.6g, %.6g) m, where a periodic tank has no wall", p->x, p->y);
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "at"), full, found,
                     c->periodic[1] ? "no probe" : "a point on the bed",
                     c->periodic[1] ? "remove the probe" : "move the probe");
  } else if (distance > 1e-6 * case_tank_size(c)) {
    snprintf(full, sizeof full, "%s.at", path);
    snprintf(found, sizeof found, "(%.6g, %.6g) m, %.3g m from the nearest wall", p->x, p->y,
             distance);
    snprintf(todo, sizeof todo, "the nearest is (%.6g, %.6g) m", nearest[0], nearest[1]);
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "at"), full, found,
                     "a point on a wall", todo);
  } else if (p->size > geo_piece_length(&c->walls, piece)) {
    snprintf(full, sizeof full, "%s.size", path);
    snprintf(found, sizeof found, "%.6g m", p->size);
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "size"), full, found,
                     "at most the length of its wall", "make it smaller");
  }
}

void case_check_gauge(struct case_draft *d, double x, int item, const char *path) {
  const struct geo_box *t = &d->c->tank;
  char full[CASE_PATH + 8], found[64], allowed[96];
  if (x >= t->min[0] && x <= t->max[0]) return;
  snprintf(full, sizeof full, "%s.x", path);
  snprintf(found, sizeof found, "%.6g m", x);
  snprintf(allowed, sizeof allowed, "inside the tank, from %.6g to %.6g m", t->min[0], t->max[0]);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "x"), full, found, allowed,
                   "move the gauge");
}

static void check_point(struct case_draft *d, size_t i, int item, const char *path) {
  const struct case_file *c = d->c;
  const struct case_point *p = &c->points[i];
  const struct geo_box *t = &c->tank;
  char full[CASE_PATH + 8], found[96], allowed[128];
  double nearest[2];
  snprintf(full, sizeof full, "%s.at", path);
  if (p->x >= t->min[0] && p->x <= t->max[0] && p->y >= t->min[1] && p->y <= t->max[1]) {
    const double inside = tank_distance(&c->walls, p->x, p->y, nearest);
    if (inside >= -1e-6 * case_tank_size(c)) return;
    snprintf(found, sizeof found, "(%.6g, %.6g) m, %.3g m behind a wall", p->x, p->y, -inside);
    snprintf(allowed, sizeof allowed, "a point in the tank; the nearest is (%.6g, %.6g) m",
             nearest[0], nearest[1]);
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "at"), full, found, allowed,
                     "move the point");
    return;
  }
  snprintf(found, sizeof found, "(%.6g, %.6g) m", p->x, p->y);
  snprintf(allowed, sizeof allowed, "inside the tank, from (%.6g, %.6g) to (%.6g, %.6g) m",
           t->min[0], t->min[1], t->max[0], t->max[1]);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "at"), full, found, allowed,
                   "move the point");
}

/* Nothing before may have the name of a point with one of its fields: that of a series. */
static void check_point_fields(struct case_draft *d, int item, const char *path, const char *name,
                               const char *const *others, size_t n) {
  for (size_t k = 0; name && case_name_fits(name) && k < CASE_POINT_FIELDS; k++) {
    char series[CASE_LONGEST_NAME + 16], full[CASE_PATH + 8], found[160];
    snprintf(series, sizeof series, "%s.%s", name, case_point_fields[k]);
    for (size_t i = 0; i < n; i++) {
      if (!others[i] || strcmp(others[i], series)) continue;
      snprintf(full, sizeof full, "%s.name", path);
      snprintf(found, sizeof found, "'%s', one of its series, a second time", series);
      case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "name"), full, found,
                       "a name of its own", "rename one");
    }
  }
}

/* A body floats free of the bed, from which gauges count. */
static void check_no_gauges(struct case_draft *d) {
  if (!d->c->n_gauges || !d->good.water || !flow_is_body(d->c->flow)) return;
  case_doc_problem(&d->doc, case_doc_line(&d->doc, d->at.gauges), "gauges",
                   "gauges with a body, which has no water on the bed",
                   "gauges with regions or a wave", "remove them; points hold what is inside");
}

/* An experiment names a probe, a gauge, or the front. */
static void check_is_not_front(struct case_draft *d, int item, const char *path,
                               const char *name) {
  char full[CASE_PATH + 8];
  if (!name || strcmp(name, "front") != 0) return;
  snprintf(full, sizeof full, "%s.name", path);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, "name"), full, "'front'",
                   "another name: experiments call the front of the water so", "rename it");
}

static void check_instruments(struct case_draft *d) {
  const struct case_file *c = d->c;
  size_t n = 0;
  const char *names[3 * CASE_MOST_ITEMS];
  char path[CASE_PATH];
  for (size_t i = 0; i < c->n_probes; i++) {
    int item = case_doc_item(&d->doc, d->at.probes, i);
    case_doc_item_path(&d->doc, "probes", item, i, path);
    check_name(d, item, path, c->probes[i].name, names, n);
    check_is_not_front(d, item, path, c->probes[i].name);
    names[n++] = c->probes[i].name;
    if (d->good.probes && d->good.tank) case_check_probe(d, &c->probes[i], item, path);
  }
  for (size_t i = 0; i < c->n_gauges; i++) {
    int item = case_doc_item(&d->doc, d->at.gauges, i);
    case_doc_item_path(&d->doc, "gauges", item, i, path);
    check_name(d, item, path, c->gauges[i].name, names, n);
    check_is_not_front(d, item, path, c->gauges[i].name);
    names[n++] = c->gauges[i].name;
    if (d->good.gauges && d->good.tank) case_check_gauge(d, c->gauges[i].x, item, path);
  }
  for (size_t i = 0; i < c->n_points; i++) {
    int item = case_doc_item(&d->doc, d->at.points, i);
    case_doc_item_path(&d->doc, "points", item, i, path);
    check_name(d, item, path, c->points[i].name, names, n);
    check_point_fields(d, item, path, c->points[i].name, names, c->n_probes + c->n_gauges);
    names[n++] = c->points[i].name;
    if (d->good.points && d->good.tank) check_point(d, i, item, path);
  }
}

static void check_run_names(struct case_draft *d) {
  const struct case_file *c = d->c;
  const char *names[CASE_MOST_ITEMS];
  char path[CASE_PATH];
  for (size_t i = 0; i < c->n_runs; i++) {
    int item = case_doc_item(&d->doc, d->at.runs, i);
    case_doc_item_path(&d->doc, "runs", item, i, path);
    check_name(d, item, path, c->runs[i].name, names, i);
    names[i] = c->runs[i].name;
  }
}

/* ---- compare ---- */

void case_time_words(struct case_draft *d, int node, double seconds, char out[64]) {
  param_in_unit_of(case_doc_text(&d->doc, node), "s", &d->doc.scales, seconds, out, 64);
}

/* Comparison times are output times, where every run has its surface; on the dot after this. */
static void check_times(struct case_draft *d) {
  struct case_file *c = d->c;
  int list = case_doc_member(&d->doc, d->at.compare, "times");
  char path[CASE_PATH], found[64], limit[64], near[64], allowed[128], todo[96];
  for (size_t i = 0; i < c->compare.n_times; i++) {
    double time = c->compare.times[i], n = time / c->every;
    int item = list ? case_doc_item(&d->doc, list, i) : 0;
    int line = list ? case_doc_line(&d->doc, item) : 0;
    snprintf(path, sizeof path, "compare.times[%zu]", i);
    case_time_words(d, item, time, found);
    if (time > c->end * (1 + CASE_SAME)) {
      case_time_words(d, item, c->end, limit);
      snprintf(allowed, sizeof allowed, "at most time.end, %s", limit);
      case_doc_problem(&d->doc, line, path, found, allowed, "compare earlier or compute longer");
    } else if (fabs(n - round(n)) > CASE_SAME * fmax(1, n)) {
      case_time_words(d, item, c->every, limit);
      case_time_words(d, item, round(n) * c->every, near);
      snprintf(allowed, sizeof allowed, "a multiple of time.every, %s", limit);
      snprintf(todo, sizeof todo, "the nearest is %s", near);
      case_doc_problem(&d->doc, line, path, found, allowed, todo);
    } else if (i > 0 && time <= c->compare.times[i - 1] * (1 + CASE_SAME)) {
      case_doc_problem(&d->doc, line, path, found, "times that increase", "put them in order");
    } else {
      c->compare.times[i] = round(n) * c->every;
    }
  }
}

void case_check_compared(struct case_draft *d, int item, const char *key, const char *path,
                         double *time) {
  const struct case_file *c = d->c;
  const double near = CASE_SAME * fmax(*time, c->every);
  char found[64];
  size_t k = 0;
  while (k < c->compare.n_times && fabs(c->compare.times[k] - *time) > near) k++;
  if (k < c->compare.n_times) {
    *time = c->compare.times[k];
    return;
  }
  case_time_words(d, case_doc_member(&d->doc, item, key), *time, found);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, item, key), path, found,
                   "one of compare.times", "add it there or change it");
}

void case_check_tolerances(struct case_draft *d) {
  struct case_file *c = d->c;
  int list = case_doc_member(&d->doc, d->at.compare, "tolerances");
  char path[CASE_PATH];
  for (size_t i = 0; i < c->compare.n_tolerances; i++) {
    struct case_tolerance *t = &c->compare.tolerances[i];
    int item = case_doc_item(&d->doc, list, i);
    if (c->n_runs == 1) {
      case_doc_problem(&d->doc, case_doc_line(&d->doc, item), "compare.tolerances",
                       "a tolerance in a case of one run", "a reference and one more run",
                       "add a run or remove the tolerances");
      return;
    }
    snprintf(path, sizeof path, "compare.tolerances[%zu].at", i);
    if (!isnan(t->at) && t->measure) case_check_compared(d, item, "at", path, &t->at);
  }
}

/* A mean over more than there is would be one number, whatever the time. */
void case_check_averages(struct case_draft *d, double end, const char *what) {
  const struct case_file *c = d->c;
  int list = case_doc_member(&d->doc, d->at.compare, "averages");
  char path[CASE_PATH], found[64], limit[64], allowed[128];
  for (size_t i = 0; i < c->compare.n_averages; i++) {
    const struct case_average *a = &c->compare.averages[i];
    int over = case_doc_member(&d->doc, case_doc_item(&d->doc, list, i), "over");
    if (a->over <= end * (1 + CASE_SAME)) continue;
    snprintf(path, sizeof path, "compare.averages[%zu].over", i);
    case_time_words(d, over, a->over, found);
    case_time_words(d, over, end, limit);
    snprintf(allowed, sizeof allowed, "at most %s, %s", what, limit);
    case_doc_problem(&d->doc, case_doc_line(&d->doc, over), path, found, allowed,
                     "make it smaller");
  }
}

void case_check_window(struct case_draft *d) {
  const struct geo_box *w = &d->c->compare.window, *tank = &d->c->tank;
  if (w->min[0] >= w->max[0] || w->min[1] >= w->max[1]) return; /* reported when it was read */
  if (w->min[0] < tank->max[0] && w->max[0] > tank->min[0] && w->max[1] > tank->min[1]) return;
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, d->at.compare, "window"),
                   "compare.window", "a window without any of the tank in it", "part of the tank",
                   "move it");
}

void case_check(struct case_draft *d) {
  case_check_geometry(d);
  if (d->good.time) check_time(d);
  case_check_motions(d);
  check_instruments(d);
  check_no_gauges(d);
  check_run_names(d);
  if (d->good.time) check_times(d);
  if (d->good.time) case_check_profiles(d);
  if (d->good.time && d->good.runs) case_check_tolerances(d);
  if (d->good.runs) case_check_events(d);
  if (d->good.time) {
    case_check_averages(d, d->c->end, "time.end");
    case_check_filters(d, d->c->sample, d->c->end, "time.end");
    case_check_spectra(d, d->c->end, "time.end");
  }
  if (d->good.tank) case_check_window(d);
}
