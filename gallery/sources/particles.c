/* Curves of particles: of one over time, of many by a number of theirs, of a row by its waves, and
 * of a row or column at one instant. */
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "gallery/sources/water.h"

struct making {
  const struct water_source *s;
  struct gallery_curve *curve;
  double start;
};

static enum status over_time(struct gallery_desk *desk, const struct water_source *s,
                             enum water_choice of, bool places,
                             enum status (*take)(void *data, const struct water_state *state),
                             struct gallery_curve *curve) {
  struct gallery_water w;
  struct making m = {s, curve, NAN};
  TRY(gallery_water_open(desk, s, of, false, &w));
  const enum status status = gallery_water_each(&w, places, take, &m);
  gallery_water_close(&w);
  return status;
}

/* ---- one particle ---- */

static const char *const less_names[] = {"nothing", "start", NULL};

static const struct param particle_params[] = {
    SOURCE_RUN(water_source),
    WATER_PLACE(NULL, "the particle"),
    WATER_FIELD,
    SOURCE_CHOICE(water_source, less, less_names, "nothing",
                  "what is taken off: start, its value at the first output"),
    WATER_TIMES,
};

static enum status take_particle(void *data, const struct water_state *now) {
  struct making *m = data;
  const double value = now->n ? now->value[0] : NAN;
  if (!m->curve->n) m->start = value;
  return gallery_curve_add(m->curve, now->t, m->s->less ? value - m->start : value);
}

static enum status particle(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  return over_time(desk, with, WATER_OF_nearest, false, take_particle, curve);
}

/* ---- a number of many ---- */

#define NUMBERS(X) X(largest) X(least) X(most) X(mean) X(rms) X(sum) X(count)
#define X(name)    #name,
static const char *const number_names[] = {NUMBERS(X) NULL};
#undef X
enum number {
#define X(name) NUMBER_##name,
  NUMBERS(X)
#undef X
};

static const struct param particles_params[] = {
    SOURCE_RUN(water_source),
    SOURCE_CHOICE(water_source, of, gallery_water_choice_names, "all", "which particles"),
    WATER_PLACE("0", "one of the row or column"),
    WATER_FIELD,
    SOURCE_CHOICE(water_source, take, number_names, NULL, "the number; largest: of the magnitude"),
    WATER_TIMES,
};

static double number_of(enum number take, size_t n, const double *value) {
  double least = INFINITY, most = -INFINITY, sum = 0, squares = 0;
  for (size_t i = 0; i < n; i++) {
    if (isnan(value[i])) return NAN;
    least = fmin(least, value[i]);
    most = fmax(most, value[i]);
    sum += value[i];
    squares += value[i] * value[i];
  }
  switch (take) {
  case NUMBER_largest:
    return fmax(fabs(least), fabs(most));
  case NUMBER_least:
    return least;
  case NUMBER_most:
    return most;
  case NUMBER_mean:
    return sum / (double)n;
  case NUMBER_rms:
    return sqrt(squares / (double)n);
  case NUMBER_sum:
    return sum;
  case NUMBER_count:
    return (double)n;
  }
  __builtin_unreachable();
}

static enum status take_particles(void *data, const struct water_state *now) {
  const struct making *m = data;
  const double value = now->n ? number_of((enum number)m->s->take, now->n, now->value) : NAN;
  return gallery_curve_add(m->curve, now->t, value);
}

static enum status particles(struct gallery_desk *desk, const void *with,
                             struct gallery_curve *curve) {
  const struct water_source *s = with;
  return over_time(desk, s, (enum water_choice)s->of, false, take_particles, curve);
}

/* ---- waves along a row ---- */

#define PARTS(X) X(cos) X(sin) X(amplitude) X(phase)
#define X(name)  #name,
static const char *const part_names[] = {PARTS(X) NULL};
#undef X
enum part {
#define X(name) PART_##name,
  PARTS(X)
#undef X
};

static const struct param row_params[] = {
    SOURCE_RUN(water_source),
    WATER_PLACE(NULL, "one of the row"),
    WATER_FIELD,
    SOURCE_REAL(water_source, k, 0, 1e9, NULL, "wavenumber, 1/H"),
    SOURCE_CHOICE(
        water_source, take, part_names, "amplitude",
        "2/N sum f cos(k x), the same of the sine, and A and phase of A cos(k x - phase)"),
    WATER_TIMES,
};

static double part_of(enum part take, double c, double s) {
  switch (take) {
  case PART_cos:
    return c;
  case PART_sin:
    return s;
  case PART_amplitude:
    return hypot(c, s);
  case PART_phase:
    return atan2(s, c);
  }
  __builtin_unreachable();
}

static enum status take_row(void *data, const struct water_state *now) {
  const struct making *m = data;
  const double weight = now->n ? 2 / (double)now->n : NAN;
  double c = 0, s = 0;
  for (size_t i = 0; i < now->n; i++) {
    c += now->value[i] * cos(m->s->k * now->place[i][0]);
    s += now->value[i] * sin(m->s->k * now->place[i][0]);
  }
  return gallery_curve_add(m->curve, now->t,
                           part_of((enum part)m->s->take, weight * c, weight * s));
}

static enum status row(struct gallery_desk *desk, const void *with, struct gallery_curve *curve) {
  return over_time(desk, with, WATER_OF_row, true, take_row, curve);
}

/* ---- at one instant ---- */

static const char *const axis_names[] = {"x", "y", NULL};

static const struct param cut_params[] = {
    SOURCE_RUN(water_source),
    SOURCE_CHOICE(water_source, of, gallery_water_choice_names, NULL, "which particles"),
    WATER_PLACE("0", "one of the row or column"),
    WATER_FIELD,
    SOURCE_REAL(water_source, at, -1e9, 1e9, NULL, "the instant"),
    SOURCE_CHOICE(water_source, over, axis_names, NULL, "what the curve is over"),
};

struct point {
  double x, y;
};

static int by_x(const void *a, const void *b) {
  const struct point *p = a, *q = b;
  return (p->x > q->x) - (p->x < q->x);
}

static enum status take_cut(void *data, const struct water_state *now) {
  const struct making *m = data;
  struct point *point;
  enum status status = OK;
  TRY(array_create(&point, now->n, "points"));
  for (size_t i = 0; i < now->n; i++)
    point[i] = (struct point){now->place[i][m->s->over], now->value[i]};
  qsort(point, now->n, sizeof *point, by_x);
  for (size_t i = 0; i < now->n && status == OK; i++)
    status = gallery_curve_add(m->curve, point[i].x, point[i].y);
  free(point);
  return status;
}

static enum status cut(struct gallery_desk *desk, const void *with, struct gallery_curve *curve) {
  const struct water_source *s = with;
  struct gallery_water w;
  struct making m = {s, curve, NAN};
  TRY(gallery_water_open(desk, s, (enum water_choice)s->of, true, &w));
  enum status status = gallery_water_each(&w, true, take_cut, &m);
  gallery_water_close(&w);
  if (status != OK || curve->n) return status;
  return status_raise(ERR_INPUT,
                      "run %s has lost particles by t = %g, so that it is not known "
                      "which are of the %s",
                      s->run, s->at, gallery_water_choice_names[s->of]);
}

/* ---- the sources ---- */

#define PARTICLES(what, text)                                                                      \
  const struct gallery_source gallery_source_##what = {                                            \
      .name = #what,                                                                               \
      .help = text,                                                                                \
      .params = what##_params,                                                                     \
      .n_params = sizeof what##_params / sizeof *what##_params,                                    \
      .params_size = sizeof(struct water_source),                                                  \
      .evaluate = what,                                                                            \
  };
PARTICLES(particle, "a field of the particle nearest to a place at t = 0, over t")
PARTICLES(particles, "a number of a field over all particles, a row or a column, over t")
PARTICLES(row, "a field's wave of one wavenumber along a row of particles, over t")
PARTICLES(cut, "a field of all particles, a row or a column at one instant, over their x or y")
