#include "gallery/sources/water.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

#define X(name, ...) #name,
const char *const gallery_water_field_names[] = {WATER_FIELDS(X) NULL};
#undef X
#define X(name, ...) {__VA_ARGS__},
const struct water_field_about gallery_water_fields[] = {WATER_FIELDS(X)};
#undef X
const char *const gallery_water_choice_names[] = {"all", "row", "column", NULL};

/* Of a row are particles that stood within this of the height of one of them, in spacings. */
static const double SAME_ROW = 0.4;

/* ---- what a field is made of ---- */

static bool needs_places(enum water_field field) {
  return field < WATER_FIRST_STORED || field == WATER_dynamic || field == WATER_excess;
}

double gallery_water_value(enum water_field field, const struct result_file *f, double level,
                           const struct result_water *r, size_t i) {
  const double *a = r->value[0], H = f->H, g = f->g, p = f->density * g * H;
  const double up = r->p ? r->p[i][1] / H - level : NAN;
  switch (field) {
  case WATER_x:
    return r->p[i][0] / H;
  case WATER_y:
    return r->p[i][1] / H;
  case WATER_u:
    return a[2 * i] / sqrt(g * H);
  case WATER_v:
    return a[2 * i + 1] / sqrt(g * H);
  case WATER_speed:
    return hypot(a[2 * i], a[2 * i + 1]) / sqrt(g * H);
  case WATER_pressure:
    return a[i] / p;
  case WATER_excess:
    return a[i] / p + up;
  case WATER_dynamic: { /* less rho c^2 (e^(-2 delta y) - 1), 2 delta = g/c^2 */
    const double c2 = f->c0 * f->c0 / (g * H);
    return a[i] / p - c2 * expm1(-up / c2);
  }
  case WATER_density:
    return a[i] / f->density;
  case WATER_mass:
    return a[i] / (f->density * H * H);
  case WATER_volume:
    return a[i] / (H * H);
  case WATER_a_x:
    return a[2 * i] / g;
  case WATER_a_y:
    return a[2 * i + 1] / g;
  case WATER_acceleration:
    return hypot(a[2 * i], a[2 * i + 1]) / g;
  }
  __builtin_unreachable();
}

/* ---- which particles ---- */

static enum status keep_places(void *data, size_t k, struct result_water *r) {
  (void)k;
  *(struct result_water *)data = *r;
  *r = (struct result_water){0};
  return OK;
}

static size_t nearest(const struct result_water *r, double x, double y) {
  size_t best = 0;
  for (size_t i = 1; i < r->n; i++)
    if (hypot(r->p[i][0] - x, r->p[i][1] - y) < hypot(r->p[best][0] - x, r->p[best][1] - y))
      best = i;
  return best;
}

static enum status choose(const struct water_source *s, enum water_choice of,
                          const struct result_water *first, struct gallery_water *w) {
  const size_t middle = nearest(first, s->x * w->file->H, s->y * w->file->H);
  const int axis = of == WATER_OF_row;
  const double reach = SAME_ROW * w->file->spacing;
  TRY(array_create(&w->chosen, first->n, "particles"));
  for (size_t i = 0; i < first->n; i++)
    if (of == WATER_OF_nearest ? i == middle
                               : fabs(first->p[i][axis] - first->p[middle][axis]) <= reach)
      w->chosen[w->n_chosen++] = i;
  return OK;
}

static enum status find_chosen(const struct water_source *s, enum water_choice of,
                               struct gallery_water *w) {
  struct result_water first = {0};
  const size_t zero = 0;
  if (of == WATER_OF_all) return OK;
  enum status status = result_stream(w->file->path, 0, NULL, 1, &zero, keep_places, &first);
  if (status == OK) status = choose(s, of, &first, w);
  result_water_free(&first);
  return status;
}

/* ---- which outputs ---- */

static enum status find_instant(const struct water_source *s, struct gallery_water *w) {
  const struct result_file *f = w->file;
  const size_t last = f->n_outputs - 1;
  const double t = s->at * w->T;
  const double interval = last ? (f->output_time[last] - f->output_time[0]) / (double)last : 0;
  size_t best = 0;
  for (size_t k = 1; k <= last; k++)
    if (fabs(f->output_time[k] - t) < fabs(f->output_time[best] - t)) best = k;
  CHECK(fabs(f->output_time[best] - t) <= 0.5001 * interval + 1e-9 * w->T, ERR_INPUT,
        "run %s has no output near t = %g; the nearest is at %g", s->run, s->at,
        f->output_time[best] / w->T);
  w->output[w->n++] = best;
  return OK;
}

static enum status find_outputs(const struct water_source *s, bool instant,
                                struct gallery_water *w) {
  const struct result_file *f = w->file;
  const double slack = 1e-9 * w->T;
  TRY(array_create(&w->output, f->n_outputs, "outputs"));
  if (instant) return find_instant(s, w);
  for (size_t k = 0; k < f->n_outputs; k += (size_t)s->every)
    if (f->output_time[k] >= s->start * w->T - slack && f->output_time[k] <= s->to * w->T + slack)
      w->output[w->n++] = k;
  CHECK(w->n, ERR_INPUT, "run %s has no output between t = %g and %g", s->run, s->start, s->to);
  return OK;
}

enum status gallery_water_open(struct gallery_desk *desk, const struct water_source *s,
                               enum water_choice of, bool instant, struct gallery_water *w) {
  *w = (struct gallery_water){.field = (enum water_field)s->field, .level = s->level};
  TRY(gallery_desk_result(desk, s->run, &w->file));
  const struct result_file *f = w->file;
  CHECK(f->n_outputs && f->output_points[0] > 0, ERR_INPUT, "run %s has no particles", s->run);
  CHECK(w->field != WATER_dynamic || f->c0 > 0, ERR_INPUT,
        "run %s has no speed of sound, which the field dynamic needs; take excess", s->run);
  w->T = sqrt(f->H / f->g);
  enum status status = find_outputs(s, instant, w);
  if (status == OK) status = find_chosen(s, of, w);
  if (status != OK) gallery_water_close(w);
  return status;
}

void gallery_water_close(struct gallery_water *w) {
  free(w->chosen);
  free(w->output);
  *w = (struct gallery_water){0};
}

/* ---- their values ---- */

struct walk {
  const struct gallery_water *w;
  enum status (*take)(void *data, const struct water_state *state);
  void *data;
  double *value; /* [room] */
  size_t room;
};

static enum status hand_over(void *data, size_t k, struct result_water *r) {
  struct walk *walk = data;
  const struct gallery_water *w = walk->w;
  TRY(array_grow(&walk->value, &walk->room, r->n, "particles"));
  for (size_t i = 0; i < r->n; i++)
    walk->value[i] = gallery_water_value(w->field, w->file, w->level, r, i);
  for (size_t i = 0; r->p && i < r->n; i++)
    for (int axis = 0; axis < 2; axis++) r->p[i][axis] /= w->file->H;
  const struct water_state state = {w->file->output_time[w->output[k]] / w->T, r->n,
                                    (const double(*)[2])r->p, walk->value};
  return walk->take(walk->data, &state);
}

enum status gallery_water_each(const struct gallery_water *w, bool places,
                               enum status (*take)(void *data, const struct water_state *state),
                               void *data) {
  const struct result_file *f = w->file;
  const struct water_field_about *about = &gallery_water_fields[w->field];
  const struct result_wanted wanted = {about->stored, about->vector, false};
  const struct result_part part = {w->n_chosen, w->chosen, !places && !needs_places(w->field)};
  struct walk walk = {.w = w, .take = take, .data = data};
  size_t known = 0; /* who is taken out does not come back */
  while (known < w->n && (!w->chosen || f->output_points[w->output[known]] == f->output_points[0]))
    known++;
  enum status status = result_stream_part(f->path, &part, wanted.name ? 1 : 0, &wanted, known,
                                          w->output, hand_over, &walk);
  for (size_t k = known; k < w->n && status == OK; k++)
    status = take(data, &(struct water_state){.t = f->output_time[w->output[k]] / w->T});
  free(walk.value);
  return status;
}
