/* Curves of free surfaces: one at an instant, its heights, its distance from another run's, fronts,
 * jets and instants, as the comparator finds them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/bed.h"
#include "compare/data.h"
#include "compare/outline.h"
#include "compare/polyline.h"
#include "gallery/desk.h"
#include "gallery/source.h"

struct surface_source {
  char *run, *against;
  double at, start, to, left, right, bottom, top, depth;
  int take, side, event;
};

#define SURFACE_SIDES                                                                              \
  SOURCE_REAL(surface_source, left, -1e9, 1e9, "-1e9", "only to the right of this x"),             \
      SOURCE_REAL(surface_source, right, -1e9, 1e9, "1e9", "only to the left of this x")
#define SURFACE_TIMES                                                                              \
  SOURCE_REAL(surface_source, start, -1e9, 1e9, "0", "first time"),                                \
      SOURCE_REAL(surface_source, to, -1e9, 1e9, "1e9", "last time")
#define SURFACE_WINDOW                                                                             \
  SURFACE_SIDES, SOURCE_REAL(surface_source, bottom, -1e9, 1e9, "-1e9", "only above this y"),      \
      SOURCE_REAL(surface_source, top, -1e9, 1e9, "1e9", "only below this y")
#define SURFACE_DEPTH                                                                              \
  SOURCE_REAL(surface_source, depth, 0, 1e9, "0",                                                  \
              "of water that counts as the front, films on walls being thinner; 0: two spacings")

/* ---- surfaces of a file ---- */

/* Their outputs have times; NULL: no surface. */
static const struct geo_lines *surface_near(const struct result_file *f, double t, double slack) {
  size_t best = SIZE_MAX;
  for (size_t k = 0; k < f->n_surfaces; k++)
    if (fabs(f->surface_time[k] - t) <= slack &&
        (best == SIZE_MAX || fabs(f->surface_time[k] - t) < fabs(f->surface_time[best] - t)))
      best = k;
  return best == SIZE_MAX ? NULL : &f->surface[best];
}

static enum status file_of(struct gallery_desk *desk, const char *run, const struct result_file **f,
                           double *T) {
  TRY(gallery_desk_result(desk, run, f));
  CHECK((*f)->n_surfaces, ERR_INPUT, "run %s has no free surface", run);
  *T = sqrt((*f)->H / (*f)->g);
  return OK;
}

/* Whether output k is between the times of a source; T: sqrt(H/g), s. */
static bool is_asked_for(const struct surface_source *s, const struct result_file *f, size_t k,
                         double T) {
  const double t = f->surface_time[k] / T;
  return t >= s->start - 1e-9 && t <= s->to + 1e-9;
}

static double interval(const struct result_file *f) {
  const size_t n = f->n_surfaces;
  return n > 1 ? (f->surface_time[n - 1] - f->surface_time[0]) / (double)(n - 1) : 0;
}

/* ---- one surface ---- */

static const struct param surface_params[] = {
    SOURCE_RUN(surface_source),
    SOURCE_REAL(surface_source, at, -1e9, 1e9, NULL, "the instant"),
};

static enum status surface(struct gallery_desk *desk, const void *with,
                           struct gallery_curve *curve) {
  const struct surface_source *s = with;
  const struct result_file *f = NULL;
  double T = NAN;
  TRY(file_of(desk, s->run, &f, &T));
  const struct geo_lines *l = surface_near(f, s->at * T, 0.5001 * interval(f) + 1e-9 * T);
  CHECK(l, ERR_INPUT, "run %s has no surface near t = %g; its last is at %g", s->run, s->at,
        f->surface_time[f->n_surfaces - 1] / T);
  const size_t main = cmp_piece_longest(l);
  CHECK(main != SIZE_MAX, ERR_INPUT, "run %s has no surface left at t = %g", s->run, s->at);
  for (size_t i = l->first[main]; i < l->first[main + 1]; i++)
    TRY(gallery_curve_add(curve, l->p[i][0] / f->H, l->p[i][1] / f->H));
  return OK;
}

/* ---- heights ---- */

#define HEIGHTS(X) X(highest) X(lowest) X(mean)
#define X(name)    #name,
static const char *const height_names[] = {HEIGHTS(X) NULL};
#undef X
enum height {
#define X(name) HEIGHT_##name,
  HEIGHTS(X)
#undef X
};

static const struct param elevation_params[] = {
    SOURCE_RUN(surface_source),
    SURFACE_SIDES,
    SURFACE_TIMES,
    SOURCE_CHOICE(surface_source, take, height_names, NULL, "which height; mean: along x"),
};

/* Of the main piece between two x, in m; NaN: there is nothing. */
static double height_of(const struct geo_lines *l, double left, double right, enum height take) {
  const size_t main = cmp_piece_longest(l);
  double high = -INFINITY, low = INFINITY, sum = 0, length = 0;
  for (size_t i = main == SIZE_MAX ? l->points : l->first[main];
       main != SIZE_MAX && i < l->first[main + 1]; i++) {
    const double *p = l->p[i], *next = l->p[i + 1 < l->first[main + 1] ? i + 1 : i];
    if (p[0] < left || p[0] > right) continue;
    high = fmax(high, p[1]);
    low = fmin(low, p[1]);
    if (next[0] < left || next[0] > right) continue;
    sum += (next[0] - p[0]) * (p[1] + next[1]) / 2;
    length += next[0] - p[0];
  }
  if (!isfinite(high)) return NAN;
  return take == HEIGHT_highest ? high : take == HEIGHT_lowest ? low : sum / length;
}

static enum status elevation(struct gallery_desk *desk, const void *with,
                             struct gallery_curve *curve) {
  const struct surface_source *s = with;
  const struct result_file *f = NULL;
  double T = NAN;
  TRY(file_of(desk, s->run, &f, &T));
  for (size_t k = 0; k < f->n_surfaces; k++) {
    if (!is_asked_for(s, f, k, T)) continue;
    const double y =
        height_of(&f->surface[k], s->left * f->H, s->right * f->H, (enum height)s->take);
    TRY(gallery_curve_add(curve, f->surface_time[k] / T, y / f->H));
  }
  return OK;
}

/* ---- the distance from another run's ---- */

static const struct param distance_params[] = {
    SOURCE_RUN(surface_source),
    SOURCE_TEXT(surface_source, against, NULL, "another run, CASE/RUN"),
    SURFACE_WINDOW,
    SURFACE_TIMES,
};

/* Outputs this close (in sqrt(H/g)) are simultaneous, as for plunge compare. */
static const double SIMULTANEOUS = 0.01;

static struct geo_box window_of(const struct surface_source *s, double unit) {
  return (struct geo_box){{s->left * unit, s->bottom * unit}, {s->right * unit, s->top * unit}};
}

/* In m; NaN: one of them has no surface in the window. */
static enum status distance_between(struct cmp_geos *g, const struct surface_source *s,
                                    const struct result_file *a, const struct result_file *b,
                                    const struct geo_lines *of_a, const struct geo_lines *of_b,
                                    double *mean) {
  const struct geo_box window = window_of(s, a->H);
  const double step = fmax(a->spacing / 2, 1e-3 * a->H), film = 2 * a->spacing;
  struct cmp_outline *p = NULL, *q = NULL;
  struct cmp_distance both;
  struct cmp_value value, largest;
  enum status status = OK;
  ATTEMPT(cmp_outline_create(g, of_a, &a->walls, &window, step, film, &p));
  ATTEMPT(cmp_outline_create(g, of_b, &b->walls, &window, step, film, &q));
  ATTEMPT(cmp_outline_distance(p, q, &both, &value, &largest));
  *mean = value.value;
done:
  cmp_outline_destroy(p);
  cmp_outline_destroy(q);
  return status;
}

static enum status add_distances(struct cmp_geos *g, const struct surface_source *s,
                                 const struct result_file *a, const struct result_file *b, double T,
                                 struct gallery_curve *curve) {
  CHECK(fabs(a->H - b->H) <= 1e-9 * a->H, ERR_INPUT, "runs %s and %s differ in H, %g and %g m",
        s->run, s->against, a->H, b->H);
  for (size_t k = 0; k < a->n_surfaces; k++) {
    const struct geo_lines *other = surface_near(b, a->surface_time[k], SIMULTANEOUS * T);
    double mean = NAN;
    if (!other || !is_asked_for(s, a, k, T)) continue;
    TRY(distance_between(g, s, a, b, &a->surface[k], other, &mean));
    TRY(gallery_curve_add(curve, a->surface_time[k] / T, mean / a->H));
  }
  CHECK(curve->n, ERR_INPUT, "runs %s and %s have no outputs at the same times that are asked for",
        s->run, s->against);
  return OK;
}

static enum status distance(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  const struct surface_source *s = with;
  const struct result_file *a = NULL, *b = NULL;
  double T = NAN;
  TRY(file_of(desk, s->run, &a, &T));
  TRY(file_of(desk, s->against, &b, &T));
  struct cmp_geos *g = cmp_geos_create();
  CHECK(g, ERR_MEMORY, "no memory for GEOS");
  const enum status status = add_distances(g, s, a, b, T, curve);
  cmp_geos_destroy(g);
  return status;
}

/* ---- what the comparator finds: fronts, jets, instants ---- */

static enum status data_of(struct gallery_desk *desk, const struct surface_source *s,
                           const struct geo_box *window, double *depth, struct cmp_scales *scales,
                           struct cmp_data *d) {
  const struct result_file *f = NULL;
  double T = NAN;
  TRY(file_of(desk, s->run, &f, &T));
  CHECK(f->walls.pieces, ERR_INPUT, "run %s has no walls, without which no front or jet is known",
        s->run);
  *depth = s->depth > 0 ? s->depth : 2 * f->spacing / f->H;
  *scales = (struct cmp_scales){.H = f->H, .T = T, .p = f->density * f->g * f->H, .E = 1};
  const enum status status = cmp_data_create(f, &f->walls, scales, *depth, window, d);
  if (status != OK) cmp_data_destroy(d);
  return status;
}

static const struct geo_box everywhere = {{-1e9, -1e9}, {1e9, 1e9}};

static const char *const side_names[] = {"left", "right", NULL};
_Static_assert(CMP_LEFT == 0 && CMP_RIGHT == 1, "sides are in this order");

static const struct param front_params[] = {
    SOURCE_RUN(surface_source),
    SOURCE_CHOICE(surface_source, side, side_names, "right", "to which side"),
    SURFACE_DEPTH,
};

static enum status front(struct gallery_desk *desk, const void *with, struct gallery_curve *curve) {
  const struct surface_source *s = with;
  struct cmp_data d = {0};
  struct cmp_scales scales = {0};
  double depth = NAN;
  TRY(data_of(desk, s, &everywhere, &depth, &scales, &d));
  const struct cmp_series *f = &d.fronts[s->side];
  enum status status = OK;
  for (size_t i = 0; i < f->n && status == OK; i++)
    status = gallery_curve_add(curve, f->t[i], f->value[i]);
  cmp_data_destroy(&d);
  return status;
}

#define JET_PARTS(X) X(x) X(y) X(overhang) X(gap) X(cavity)
#define X(name)      #name,
static const char *const jet_names[] = {JET_PARTS(X) NULL};
#undef X
enum jet_part {
#define X(name) JET_##name,
  JET_PARTS(X)
#undef X
};

static const struct param jet_params[] = {
    SOURCE_RUN(surface_source),
    SURFACE_WINDOW,
    SOURCE_CHOICE(surface_source, take, jet_names, NULL,
                  "x, y of its tip; its overhang; gap below the tip; area of air below"),
    SURFACE_DEPTH,
};

static double jet_part(const struct cmp_jet *jet, enum jet_part take) {
  if (!jet->found) return NAN;
  switch (take) {
  case JET_x:
    return jet->tip[0];
  case JET_y:
    return jet->tip[1];
  case JET_overhang:
    return jet->overhang;
  case JET_gap:
    return jet->gap;
  case JET_cavity:
    return jet->cavity.value;
  }
  __builtin_unreachable();
}

static enum status jet(struct gallery_desk *desk, const void *with, struct gallery_curve *curve) {
  const struct surface_source *s = with;
  const struct geo_box window = window_of(s, 1);
  struct cmp_data d = {0};
  struct cmp_scales scales = {0};
  double depth = NAN;
  TRY(data_of(desk, s, &window, &depth, &scales, &d));
  enum status status = OK;
  for (size_t k = 0; k < d.n && status == OK; k++)
    status = gallery_curve_add(curve, d.t[k], jet_part(&d.jet[k], (enum jet_part)s->take));
  cmp_data_destroy(&d);
  return status;
}

#define X(name, help) #name,
static const char *const event_names[] = {CASE_EVENTS(X) NULL};
#undef X
static const char *const part_names[] = {"time", "x", "y", NULL};

static const struct param event_params[] = {
    SOURCE_RUN(surface_source),
    SOURCE_CHOICE(surface_source, event, event_names, NULL,
                  "what happens then; wall_impact: of the front that runs farthest"),
    SOURCE_CHOICE(surface_source, take, part_names, "time", "its time, or its place"),
    SURFACE_WINDOW,
    SURFACE_DEPTH,
};

static struct cmp_instant instant_of(const struct cmp_data *d, const struct cmp_scales *s,
                                     int event) {
  if (event == CASE_EVENT_OF_wall_impact) return d->impact;
  if (event == CASE_EVENT_OF_overturning) return d->overturning;
  if (event == CASE_EVENT_OF_touchdown) return d->touchdown;
  const struct result_file *f = d->file;
  for (size_t k = 0; k < f->n_events; k++)
    if (!strcmp(f->events[k].name, event_names[event]))
      return (struct cmp_instant){.time = cmp_number(f->events[k].time / s->T),
                                  .at = {f->events[k].x / s->H, f->events[k].y / s->H}};
  return (struct cmp_instant){.time = cmp_unknown("it has not happened")};
}

/* One that has not happened has no point. */
static enum status event(struct gallery_desk *desk, const void *with, struct gallery_curve *curve) {
  const struct surface_source *s = with;
  const struct geo_box window = window_of(s, 1);
  struct cmp_data d = {0};
  struct cmp_scales scales = {0};
  double depth = NAN;
  TRY(data_of(desk, s, &window, &depth, &scales, &d));
  cmp_data_face(&d, &scales, cmp_data_side(&d, depth));
  const struct cmp_instant i = instant_of(&d, &scales, s->event);
  const double part[] = {i.time.value, i.at[0], i.at[1]};
  cmp_data_destroy(&d);
  return cmp_known(&i.time) ? gallery_curve_add(curve, i.time.value, part[s->take]) : OK;
}

/* ---- the sources ---- */

#define SURFACES(what, text)                                                                       \
  const struct gallery_source gallery_source_##what = {                                            \
      .name = #what,                                                                               \
      .help = text,                                                                                \
      .params = what##_params,                                                                     \
      .n_params = sizeof what##_params / sizeof *what##_params,                                    \
      .params_size = sizeof(struct surface_source),                                                \
      .evaluate = what,                                                                            \
  };
SURFACES(surface, "the main free surface at one instant, y over x, H")
SURFACES(elevation, "a height of the main free surface, H, over t")
SURFACES(distance, "mean distance of the free surface from another run's, H, over t")
SURFACES(front, "x where the water that stands on the bed ends, H, over t")
SURFACES(jet, "a part of the plunging jet, H, over t")
SURFACES(event, "one point: an instant, or its place, over its time")
