/* The water of runs at some times as particles, coloured by a field. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/cloud.h"
#include "compare/panels.h"
#include "compare/panes.h"
#include "gallery/desk.h"
#include "gallery/drawer.h"
#include "gallery/figures/grid.h"
#include "gallery/figures/keys.h"
#include "gallery/sources/water.h"

/* ---- reading ---- */

static const char *const ways[] = {"runs", "times", NULL};
enum way { ACROSS_RUNS, ACROSS_TIMES };

struct snapshots_spec {
  int field, across; /* field: of those from WATER_FIRST_STORED on */
  double level;
  bool wide;
  char *surface;
  int runs, names, times, range, window, marks_node; /* nodes */
  size_t n_runs, n_names, n_times;
  char **run, **name;
  double *time;       /* sqrt(H/g) */
  double limits[2];   /* of the colours; NaN: by the values */
  struct geo_box box; /* H; NaN: by the walls */
  struct gallery_marks marks;
};

static const struct param rows[] = {
    {.key = "field",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct snapshots_spec, field),
     .choices = gallery_water_field_names + WATER_FIRST_STORED,
     .help = "what particles are coloured by"},
    SOURCE_REAL(snapshots_spec, level, -1e9, 1e9, "1",
                "height of the water at rest, for dynamic and excess"),
    NODE(struct snapshots_spec, runs, NULL, "a list of runs, CASE/RUN"),
    NODE(struct snapshots_spec, names, "", "a list of their names in the figure"),
    NODE(struct snapshots_spec, times, NULL, "a list of times, sqrt(H/g)"),
    {.key = "across",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct snapshots_spec, across),
     .choices = ways,
     .value = "runs",
     .help = "what is beside each other; the others are below each other"},
    NODE(struct snapshots_spec, range, "", "a list of 2 numbers: the ends of the colours"),
    TEXT(struct snapshots_spec, surface, 160, "", "a run whose surface is drawn over"),
    NODE(struct snapshots_spec, window, "", "a list of 2 points [x, y], H: what is seen"),
    {.key = "marks",
     .type = PARAM_NODE,
     .offset = offsetof(struct snapshots_spec, marks_node),
     .value = "",
     .help = "a list of places and lengths that are written into it"},
    {.key = "wide",
     .type = PARAM_BOOL,
     .offset = offsetof(struct snapshots_spec, wide),
     .value = "true",
     .help = "two columns of a journal, else one"},
};
static const struct param number = {.key = "number", .type = PARAM_REAL, .help = "a number"};

static enum status times_read(struct gallery_reader *r, const char *path,
                              struct snapshots_spec *s) {
  const struct gallery_list list = gallery_list_of(r, s->times, path, "times", 1);
  TRY(array_create(&s->time, list.n, "times"));
  s->n_times = list.n;
  for (size_t k = 0; k < list.n; k++) {
    char full[CASE_PATH];
    const int item = gallery_list_item(r, &list, k, full);
    case_doc_value(&r->doc, item, full, &number, &s->time[k]);
  }
  return OK;
}

static void window_read(struct gallery_reader *r, const char *path, struct snapshots_spec *s) {
  char full[CASE_PATH + 8], corner[CASE_PATH + 16];
  snprintf(full, sizeof full, "%s.window", path);
  if (!s->window || !case_doc_expect_list(&r->doc, s->window, full, 2, 2, "points [x, y]")) return;
  double *const corners[] = {s->box.min, s->box.max};
  bool good = true;
  for (size_t k = 0; k < 2; k++) {
    snprintf(corner, sizeof corner, "%s[%zu]", full, k);
    good &= case_read_pair(&r->doc, case_doc_item(&r->doc, s->window, k), corner, &number,
                           "numbers", corners[k]);
  }
  if (good && !(s->box.min[0] < s->box.max[0] && s->box.min[1] < s->box.max[1]))
    gallery_complain(r, s->window, full, "a window of no size",
                     "its lower left and its upper right corner", "");
}

static enum status lists_read(struct gallery_reader *r, int node, const char *path,
                              struct snapshots_spec *s) {
  char full[CASE_PATH + 8];
  snprintf(full, sizeof full, "%s.runs", path);
  TRY(gallery_read_texts(r, s->runs, full, "runs", &s->n_runs, &s->run));
  if (!s->n_runs) gallery_complain(r, node, full, "no run", "a list of runs", "");
  snprintf(full, sizeof full, "%s.names", path);
  TRY(gallery_read_texts(r, s->names, full, "names", &s->n_names, &s->name));
  if (s->n_names && s->n_names != s->n_runs)
    gallery_complain(r, s->names, full, "another number of names than of runs", "a name a run", "");
  TRY(times_read(r, path, s));
  snprintf(full, sizeof full, "%s.range", path);
  if (s->range && case_read_pair(&r->doc, s->range, full, &number, "numbers", s->limits) &&
      !(s->limits[0] < s->limits[1]))
    gallery_complain(r, s->range, full, "a range that ends where it begins, or before",
                     "[low, high]", "");
  window_read(r, path, s);
  return gallery_marks_read(r, s->marks_node, path, &s->marks);
}

static void destroy(void *spec) {
  struct snapshots_spec *s = spec;
  if (!s) return;
  params_release(rows, ROWS(rows), s);
  gallery_texts_free(s->n_runs, s->run);
  gallery_texts_free(s->n_names, s->name);
  free(s->time);
  gallery_marks_free(&s->marks);
  free(s);
}

static enum status read(struct gallery_reader *r, int node, const char *path, void **spec) {
  struct snapshots_spec *s = calloc(1, sizeof *s);
  const size_t faults = r->doc.faults;
  enum status status = OK;
  *spec = NULL;
  CHECK(s, ERR_MEMORY, "no memory for a figure");
  s->limits[0] = s->limits[1] = NAN;
  s->box = (struct geo_box){{NAN, NAN}, {NAN, NAN}};
  if (gallery_figure_read(r, node, path, rows, ROWS(rows), s))
    status = lists_read(r, node, path, s);
  if (status == OK && r->doc.faults == faults)
    *spec = s;
  else
    destroy(s);
  return status;
}

static enum status runs(const void *spec, enum status (*take)(void *data, const char *run),
                        void *data) {
  const struct snapshots_spec *s = spec;
  for (size_t i = 0; i < s->n_runs; i++) TRY(take(data, s->run[i]));
  return s->surface ? take(data, s->surface) : OK;
}

/* ---- drawing ---- */

/* An output may be so far from the time that is asked for, before the first and behind the last
 * (sqrt(H/g)); and the figure says its time when it is further away than this. */
#define OUTSIDE 0.02
#define EXACT   0.005

/* px of a PNG for each of a screen: 305 in an inch of print, where journals ask for 300. The page
 * links it: it need not be small. */
#define FINE 2.4

struct drawing {
  const struct snapshots_spec *spec;
  enum water_field field;
  struct cmp_figures *f;
  struct cmp_figure *fig;
  struct gallery_grid grid;
  struct geo_box seen; /* of all points, H */
  double low, high;    /* of all but one in a hundred of the values of each pane */
  FILE *lines;
  size_t n_lines; /* series in it so far */
  /* of the run at hand */
  const struct result_file *file;
  size_t r;
  const size_t *time; /* which of the times an output is of */
};

static size_t pane_of(const struct drawing *d, size_t r, size_t time) {
  return d->spec->across == ACROSS_RUNS ? time * d->spec->n_runs + r : r * d->spec->n_times + time;
}

/* The nearest of n times (s) to t (sqrt(H/g)); SIZE_MAX: there is none then. */
static size_t nearest(const struct result_file *f, size_t n, const double *times, double t) {
  const double T = sqrt(f->H / f->g);
  size_t best = SIZE_MAX;
  if (!n || t < times[0] / T - OUTSIDE || t > times[n - 1] / T + OUTSIDE) return SIZE_MAX;
  for (size_t i = 0; i < n; i++)
    if (best == SIZE_MAX || fabs(times[i] / T - t) < fabs(times[best] / T - t)) best = i;
  return best;
}

static void box_include(struct geo_box *box, const double p[2]) {
  for (int k = 0; k < 2; k++) {
    box->min[k] = fmin(box->min[k], p[k]);
    box->max[k] = fmax(box->max[k], p[k]);
  }
}

static enum status points_write(struct drawing *d, size_t pane, const struct result_water *w,
                                double *value) {
  const double H = d->file->H;
  char suffix[48];
  FILE *out;
  snprintf(suffix, sizeof suffix, "-points-%zu.csv", pane + 1);
  TRY(cmp_figure_data(d->f, d->fig, suffix, &out));
  fprintf(out, "x [H],y [H],%s\n", gallery_water_fields[d->field].head);
  for (size_t i = 0; i < w->n; i++) {
    const double p[2] = {w->p[i][0] / H, w->p[i][1] / H};
    value[i] = gallery_water_value(d->field, d->file, d->spec->level, w, i);
    box_include(&d->seen, p);
    fprintf(out, "%.6g,%.6g,%.5g\n", p[0], p[1], value[i]);
  }
  return cmp_figure_data_end(d->fig, out);
}

static enum status water_take(void *data, size_t k, struct result_water *w) {
  struct drawing *d = data;
  struct gallery_pane *pane = &d->grid.pane[pane_of(d, d->r, d->time[k])];
  double *value;
  if (!w->n) return OK;
  pane->side = cmp_cloud_spacing(d->file, w->n) / d->file->H;
  TRY(array_create(&value, w->n, "points"));
  const enum status status = points_write(d, (size_t)(pane - d->grid.pane), w, value);
  qsort(value, w->n, sizeof *value, array_ascending);
  d->low = fmin(d->low, value[w->n / 100]);
  d->high = fmax(d->high, value[w->n - 1 - w->n / 100]);
  free(value);
  return status;
}

static enum status lines_add(struct drawing *d, const char *name, const struct geo_lines *lines,
                             double H, size_t *series) {
  struct geo_lines scaled = {0};
  TRY(geo_lines_copy(&scaled, lines));
  for (size_t i = 0; i < scaled.points; i++)
    for (int axis = 0; axis < 2; axis++) scaled.p[i][axis] /= H;
  *series = d->n_lines++;
  cmp_pane_lines(d->lines, *series, name, &scaled);
  geo_lines_destroy(&scaled);
  return OK;
}

static void pane_note(struct gallery_pane *pane, double t, double asked) {
  if (fabs(t - asked) > EXACT) snprintf(pane->note, sizeof pane->note, "(at %.4g)", t);
}

/* Between the sides of a tank and above its bed; everywhere where there is none. */
static void room_include(struct geo_box *room, const struct result_file *f) {
  const struct geo_box walls = geo_lines_box(&f->walls);
  const bool any = f->walls.points > 0;
  for (int k = 0; k < 2; k++)
    room->min[k] = fmin(room->min[k], any ? walls.min[k] / f->H : -INFINITY);
  room->max[0] = fmax(room->max[0], any ? walls.max[0] / f->H : INFINITY);
  room->max[1] = INFINITY;
}

/* The outputs of a run at the times: of those that it has. */
static enum status outputs_find(struct drawing *d, size_t *output, size_t *time, size_t *n) {
  const struct snapshots_spec *s = d->spec;
  const struct result_file *f = d->file;
  size_t walls = SIZE_MAX;
  room_include(&d->grid.room, f);
  if (f->walls.points) TRY(lines_add(d, "tank", &f->walls, f->H, &walls));
  *n = 0;
  for (size_t k = 0; k < s->n_times; k++) {
    struct gallery_pane *pane = &d->grid.pane[pane_of(d, d->r, k)];
    const size_t i = nearest(f, f->n_outputs, f->output_time, s->time[k]);
    *pane = (struct gallery_pane){.walls = walls, .surface = SIZE_MAX};
    if (i == SIZE_MAX) {
      snprintf(pane->note, sizeof pane->note, "no output then");
      continue;
    }
    pane_note(pane, f->output_time[i] / sqrt(f->H / f->g), s->time[k]);
    output[*n] = i;
    time[(*n)++] = k;
  }
  return OK;
}

static enum status run_take(struct drawing *d, const char *run, const struct result_file *file,
                            size_t r) {
  const struct water_field_about *about = &gallery_water_fields[d->field];
  const struct result_wanted wanted = {about->stored, about->vector, false};
  size_t *output = NULL, *time = NULL, n;
  enum status status;
  d->file = file;
  d->r = r;
  CHECK(cmp_cloud_has_field(file, about->stored), ERR_INPUT,
        "run %s has no points with %s in its outputs", run, about->stored);
  CHECK(d->field != WATER_dynamic || file->c0 > 0, ERR_INPUT,
        "run %s has no speed of sound, which the field dynamic needs; take excess", run);
  ATTEMPT(array_create(&output, d->spec->n_times, "a figure"));
  ATTEMPT(array_create(&time, d->spec->n_times, "a figure"));
  ATTEMPT(outputs_find(d, output, time, &n));
  d->time = time;
  if (n) status = result_stream(file->path, 1, &wanted, n, output, water_take, d);
done:
  free(output);
  free(time);
  return status;
}

/* The surface of one run in the panes of all. */
static enum status surface_take(struct drawing *d, const struct result_file *f) {
  const struct snapshots_spec *s = d->spec;
  for (size_t k = 0; k < s->n_times; k++) {
    const size_t i = nearest(f, f->n_surfaces, f->surface_time, s->time[k]);
    size_t series = SIZE_MAX;
    if (i != SIZE_MAX) TRY(lines_add(d, s->surface, &f->surface[i], f->H, &series));
    for (size_t r = 0; r < s->n_runs; r++) {
      struct gallery_pane *pane = &d->grid.pane[pane_of(d, r, k)];
      pane->surface = series;
      if (i == SIZE_MAX && !*pane->note) snprintf(pane->note, sizeof pane->note, "no line then");
    }
  }
  return OK;
}

static enum status water_read(struct gallery_desk *desk, struct drawing *d) {
  const struct snapshots_spec *s = d->spec;
  const struct result_file *file;
  for (size_t r = 0; r < s->n_runs; r++) {
    TRY(gallery_desk_result(desk, s->run[r], &file));
    TRY(run_take(d, s->run[r], file, r));
  }
  if (!s->surface) return OK;
  TRY(gallery_desk_result(desk, s->surface, &file));
  return surface_take(d, file);
}

/* By the walls, as high as there is water. */
static struct geo_box view_of(const struct drawing *d) {
  const struct geo_box *window = &d->spec->box;
  struct geo_box view = d->seen;
  if (isfinite(window->min[0])) return *window;
  if (!(view.min[0] < view.max[0])) return (struct geo_box){{0, 0}, {1, 1}};
  double margin = 0.02 * (view.max[0] - view.min[0]);
  if (d->file->walls.points) {
    const struct geo_box walls = geo_lines_box(&d->file->walls);
    const double H = d->file->H;
    margin = 0.01 * (walls.max[0] - walls.min[0]) / H;
    view.min[0] = walls.min[0] / H;
    view.max[0] = walls.max[0] / H;
    view.min[1] = walls.min[1] / H;
    view.max[1] = fmin(view.max[1] + 0.1, walls.max[1] / H);
  }
  for (int k = 0; k < 2; k++) {
    view.min[k] -= margin;
    view.max[k] += margin;
  }
  return view;
}

/* Round numbers around the values; of what may have either sign as far on both sides. */
static void colours_choose(struct drawing *d) {
  struct gallery_grid *g = &d->grid;
  g->low = d->spec->limits[0];
  g->high = d->spec->limits[1];
  if (isfinite(g->low)) return;
  double low = d->low, high = d->high;
  if (gallery_water_fields[d->field].sign) {
    high = fmax(fabs(low), fabs(high));
    low = -high;
  }
  if (!(low < high)) {
    low = isfinite(low) ? low - 0.5 : 0;
    high = low + 1;
  }
  const double step = cmp_tick_step(&(struct cmp_frame){low, high});
  g->low = step * floor(low / step + 1e-9);
  g->high = step * ceil(high / step - 1e-9);
}

/* Heads of runs and times; those of times are owned. */
struct heads {
  const char **run;
  char (*text)[48];
  const char **time;
};

static enum status heads_make(const struct snapshots_spec *s, struct heads *h) {
  TRY(array_create(&h->run, s->n_runs, "a figure"));
  TRY(array_create(&h->time, s->n_times, "a figure"));
  TRY(array_create(&h->text, s->n_times, "a figure"));
  for (size_t r = 0; r < s->n_runs; r++) {
    const char *slash = strrchr(s->run[r], '/');
    h->run[r] = s->n_names ? s->name[r] : slash ? slash + 1 : s->run[r];
  }
  for (size_t k = 0; k < s->n_times; k++) {
    snprintf(h->text[k], sizeof h->text[k], "t = %.4g √(H/g)", s->time[k]);
    h->time[k] = h->text[k];
  }
  return OK;
}

static enum status draw(struct gallery_desk *desk, const struct gallery_entry *e, const void *spec,
                        const char *name, struct cmp_figures *f) {
  const struct snapshots_spec *s = spec;
  struct heads heads = {0};
  struct drawing d = {.spec = s,
                      .field = (enum water_field)(s->field + WATER_FIRST_STORED),
                      .f = f,
                      .seen = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}},
                      .grid.room = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}},
                      .low = INFINITY,
                      .high = -INFINITY};
  const bool across = s->across == ACROSS_RUNS;
  enum status status;
  (void)e;
  ATTEMPT(heads_make(s, &heads));
  ATTEMPT(array_create(&d.grid.pane, s->n_runs * s->n_times, "a figure"));
  ATTEMPT(cmp_figure_begin(f, CMP_SECTION_OVERLAY, true, gallery_grid_width(s->wide), 0, &d.fig,
                           "%s", name));
  d.fig->fine = d.fig->layer = FINE;
  ATTEMPT(cmp_figure_data(f, d.fig, "-surfaces.csv", &d.lines));
  fputs(CMP_PANE_LINES_HEAD, d.lines);
  status = water_read(desk, &d);
  const enum status written = cmp_figure_data_end(d.fig, d.lines);
  if (status == OK) status = written;
  if (status != OK) goto done;
  colours_choose(&d);
  d.grid.view = view_of(&d);
  d.grid.label = gallery_water_fields[d.field].label;
  d.grid.marks = &s->marks;
  d.grid.columns = across ? s->n_runs : s->n_times;
  d.grid.rows = across ? s->n_times : s->n_runs;
  d.grid.column = across ? heads.run : heads.time;
  d.grid.row = across ? heads.time : heads.run;
  status = gallery_grid_draw(&d.grid, d.fig);
done:
  free(heads.run);
  free(heads.time);
  free(heads.text);
  free(d.grid.pane);
  return status;
}

const struct gallery_drawer gallery_drawer_snapshots = {
    .name = "snapshots",
    .help = "the water of runs at some times, coloured by a field",
    .read = read,
    .destroy = destroy,
    .runs = runs,
    .draw = draw,
};
