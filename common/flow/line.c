#include "common/flow/line.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

static const double LITTLE_GAIN = 1e-3; /* of the potential's largest, in a period */
enum { PARTS = 8 };                     /* of the way between two rows, to look for heights */

void flow_line_destroy(struct flow_line *l) {
  tank_record_destroy(&l->x);
  tank_record_destroy(&l->y);
  tank_record_destroy(&l->phi);
}

/* u x' + v y' */
static double gain_at(const struct flow_way *w, double t) {
  double x[3], y[3], u[3], v[3];
  tank_record_at(&w->x, t, x);
  tank_record_at(&w->y, t, y);
  tank_record_at(&w->u, t, u);
  tank_record_at(&w->v, t, v);
  return u[0] * x[1] + v[0] * y[1];
}

void flow_way_integrate(const struct flow_way *w, bool round, double *phi) {
  const size_t n = w->x.n;
  const double *t = w->x.t;
  double largest = 0;
  phi[0] = 0;
  for (size_t i = 0; i + 1 < n; i++) {
    const double a = t[i], b = t[i + 1];
    phi[i + 1] =
        phi[i] + (b - a) / 6 * (gain_at(w, a) + 4 * gain_at(w, (a + b) / 2) + gain_at(w, b));
    largest = fmax(largest, fabs(phi[i + 1]));
  }
  const double gain = phi[n - 1];
  if (!round || fabs(gain) > LITTLE_GAIN * largest) return;
  for (size_t i = 1; i < n; i++) phi[i] -= gain * (t[i] - t[0]) / (t[n - 1] - t[0]);
}

/* ---- rows ---- */

/* A spline through values at the rows, whose ways are t; in `round` water a period is between two
 * more of them, in each of which it gains `step`. */
static enum status set(struct tank_record *r, size_t n, const double *t, const double *value,
                       bool round, double step) {
  const size_t periods = round ? 3 : 1, m = n - 1;
  r->n = periods * m + 1;
  TRY(array_create(&r->t, r->n, "a surface"));
  TRY(array_create(&r->q, r->n, "a surface"));
  for (size_t i = 0; i < r->n; i++) {
    const size_t of = i < r->n - 1 ? i / m : periods - 1, k = i - of * m;
    const double before = round ? (double)of - 1 : 0;
    r->t[i] = t[k] + before * t[m];
    r->q[i] = value[k] + before * step;
  }
  return tank_record_finish(r);
}

static enum status find_ways(const struct flow_rows *rows, double **way) {
  TRY(array_create(way, rows->n, "a surface"));
  for (size_t i = 1; i < rows->n; i++)
    (*way)[i] = (*way)[i - 1] + hypot(rows->x[i] - rows->x[i - 1], rows->y[i] - rows->y[i - 1]);
  return OK;
}

/* The potential at the rows along the velocities there. */
static enum status find_potential(const struct flow_rows *rows, const double *way, bool round,
                                  double **phi) {
  struct flow_way w = {0};
  enum status status = OK;
  const size_t n = rows->n;
  ATTEMPT(array_create(phi, n, "a surface"));
  ATTEMPT(set(&w.x, n, way, rows->x, false, 0));
  ATTEMPT(set(&w.y, n, way, rows->y, false, 0));
  ATTEMPT(set(&w.u, n, way, rows->u, false, 0));
  ATTEMPT(set(&w.v, n, way, rows->v, false, 0));
  flow_way_integrate(&w, round, *phi);
done:
  tank_record_destroy(&w.x);
  tank_record_destroy(&w.y);
  tank_record_destroy(&w.u);
  tank_record_destroy(&w.v);
  return status;
}

enum status flow_line_create(const struct flow_rows *rows, bool round, struct flow_line *l) {
  double *way = NULL, *found = NULL;
  const size_t n = rows->n;
  enum status status = OK;
  *l = (struct flow_line){0};
  ATTEMPT(find_ways(rows, &way));
  if (rows->v) ATTEMPT(find_potential(rows, way, round, &found));
  const double *phi = rows->v ? found : rows->u;
  ATTEMPT(set(&l->x, n, way, rows->x, round, rows->x[n - 1] - rows->x[0]));
  ATTEMPT(set(&l->y, n, way, rows->y, round, 0));
  if (phi) ATTEMPT(set(&l->phi, n, way, phi, round, 0));
  l->from = 0;
  l->to = way[n - 1];
done:
  free(way);
  free(found);
  if (status != OK) flow_line_destroy(l);
  return status;
}

/* ---- points ---- */

/* The last row itself, without the rounding of the piece before it. */
static void at_row(const struct tank_record *r, double way, double q[3]) {
  tank_record_at(r, way, q);
  if (way == r->t[r->n - 1]) q[0] = r->q[r->n - 1];
}

struct flow_line_point flow_line_at(const struct flow_line *l, double way) {
  double x[3], y[3], phi[3] = {0};
  at_row(&l->x, way, x);
  at_row(&l->y, way, y);
  if (l->phi.n) at_row(&l->phi, way, phi);
  return (struct flow_line_point){{x[0], y[0]}, phi[0], {x[1], y[1], phi[1]}};
}

static double x_at(const struct flow_line *l, double way) {
  double x[3];
  tank_record_at(&l->x, way, x);
  return x[0];
}

/* The way between a and b at which x is passed, by bisection to the last digit. */
static double cross(const struct flow_line *l, double x, double a, double b) {
  const bool up = x_at(l, b) > x_at(l, a);
  for (int i = 0; i < 60; i++) {
    const double middle = (a + b) / 2;
    if ((x_at(l, middle) < x) == up)
      a = middle;
    else
      b = middle;
  }
  return (a + b) / 2;
}

bool flow_line_turn(struct flow_line *l, double left, double length) {
  const size_t panels = (l->x.n - 1) / 3, n = panels * PARTS;
  const double whole = l->to - l->from;
  double before = floor((x_at(l, 0) - left) / length), from = 0;
  size_t passages = 0;
  for (size_t i = 0; i < n; i++) {
    const double *t = l->x.t + panels + i / PARTS, step = (t[1] - t[0]) / PARTS;
    const double a = t[0] + step * (double)(i % PARTS), b = i + 1 < n ? a + step : whole;
    const double after = floor((x_at(l, b) - left) / length);
    if (after != before) {
      from = cross(l, left + length * fmax(before, after), a, b);
      passages++;
    }
    before = after;
  }
  const double periods = round((x_at(l, from) - left) / length);
  for (size_t i = 0; i < l->x.n; i++) l->x.q[i] -= periods * length;
  l->from = from;
  l->to = from + whole;
  return passages <= 1;
}

double flow_line_top(const struct flow_line *l, double x) {
  double top = -INFINITY;
  for (size_t i = 0; i + 1 < l->x.n; i++) {
    const double a = l->x.t[i], step = (l->x.t[i + 1] - a) / PARTS;
    if (l->x.t[i + 1] <= l->from || a >= l->to) continue;
    double before = l->x.q[i];
    for (int k = 1; k <= PARTS; k++) {
      const double after = k < PARTS ? x_at(l, a + k * step) : l->x.q[i + 1];
      if (fmin(before, after) <= x && x <= fmax(before, after))
        top = fmax(top, flow_line_at(l, cross(l, x, a + (k - 1) * step, a + k * step)).p[1]);
      before = after;
    }
  }
  return top;
}

/* Points of one stretch between two rows, the first one left out. */
static enum status add_stretch(double a, double b, double longest, size_t *n, size_t *room,
                               double **way) {
  const size_t parts = (size_t)fmax(1, ceil((b - a) / longest * (1 - 1e-9)));
  TRY(array_grow(way, room, *n + parts, "points of a surface"));
  for (size_t k = 1; k <= parts; k++)
    (*way)[(*n)++] = k < parts ? a + (b - a) * (double)k / (double)parts : b;
  return OK;
}

enum status flow_line_sample(const struct flow_line *l, double shortest, double longest, size_t *n,
                             double **way) {
  size_t room = 0;
  *n = 0;
  *way = NULL;
  TRY(array_grow(way, &room, 1, "points of a surface"));
  (*way)[(*n)++] = l->from;
  for (size_t i = 0; i < l->x.n; i++) {
    const double last = (*way)[*n - 1], next = l->x.t[i];
    const bool end = next >= l->to;
    if (next <= last || (!end && (next - last < shortest || l->to - next < shortest))) continue;
    TRY(add_stretch(last, end ? l->to : next, longest, n, &room, way));
    if (end) break;
  }
  return OK;
}
