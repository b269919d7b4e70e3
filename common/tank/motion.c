#include "common/tank/motion.h"

#include <lapack.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/tank/tank.h"

const char *tank_motion_name(const struct tank_motion *m) {
  static const char *const names[] = {
#define X(name, help) #name,
      TANK_MOTIONS(X)
#undef X
  };
  return names[m->kind];
}

/* ---- of one motion ---- */

/* R(s) and its derivatives by s. */
static void ramp_at(double s, double r[3]) {
  r[0] = s * s * s * (10 + s * (-15 + s * 6));
  r[1] = 30 * s * s * (1 - s) * (1 - s);
  r[2] = 60 * s * (1 - s) * (1 - 2 * s);
}

static void sine_at(const struct tank_motion *m, double t, double q[3]) {
  const double w = 2 * M_PI / m->sine.period, a = m->sine.amplitude, T = m->sine.ramp;
  const double s = a * sin(w * t + m->sine.phase), s_t = w * a * cos(w * t + m->sine.phase);
  double r[3] = {1, 0, 0};
  if (t < T) {
    ramp_at(t / T, r);
    r[1] /= T;
    r[2] /= T * T;
  }
  q[0] = r[0] * s;
  q[1] = r[1] * s + r[0] * s_t;
  q[2] = r[2] * s + 2 * r[1] * s_t - r[0] * w * w * s;
}

/* Hermite's cubic between two rows; beyond the ends the nearest one goes on. */
void tank_record_at(const struct tank_record *r, double t, double q[3]) {
  size_t low = 0, high = r->n - 1;
  while (high - low > 1) {
    const size_t middle = (low + high) / 2;
    if (t < r->t[middle])
      high = middle;
    else
      low = middle;
  }
  const double h = r->t[high] - r->t[low], s = (t - r->t[low]) / h;
  const double slope = (r->q[high] - r->q[low]) / h;
  const double square = 3 * slope - 2 * r->q_t[low] - r->q_t[high];
  const double cube = r->q_t[low] + r->q_t[high] - 2 * slope;
  q[0] = r->q[low] + h * s * (r->q_t[low] + s * (square + s * cube));
  q[1] = r->q_t[low] + s * (2 * square + 3 * s * cube);
  q[2] = (2 * square + 6 * s * cube) / h;
}

void tank_motion_at(const struct tank_motion *m, double t, double q[3]) {
  q[0] = q[1] = q[2] = 0;
  if (m->file.n)
    tank_record_at(&m->file, t, q);
  else if (m->sine.amplitude != 0 && t >= 0)
    sine_at(m, t, q);
}

/* The slopes of the cubic spline whose first two pieces are one cubic, and whose last two
 * (de Boor, A Practical Guide to Splines, ch. IV). */
static void spline_rows(const struct tank_record *r, double *lower, double *diagonal, double *upper,
                        double *right) {
  const size_t n = r->n;
  const double *t = r->t;
#define STEP(i)  (t[(i) + 1] - t[i])
#define SLOPE(i) ((r->q[(i) + 1] - r->q[i]) / STEP(i))
  for (size_t i = 1; i + 1 < n; i++) {
    lower[i - 1] = STEP(i);
    diagonal[i] = 2 * (STEP(i - 1) + STEP(i));
    upper[i] = STEP(i - 1);
    right[i] = 3 * (STEP(i) * SLOPE(i - 1) + STEP(i - 1) * SLOPE(i));
  }
  const double first = t[2] - t[0], last = t[n - 1] - t[n - 3];
  diagonal[0] = STEP(1);
  upper[0] = first;
  right[0] = ((STEP(0) + 2 * first) * STEP(1) * SLOPE(0) + STEP(0) * STEP(0) * SLOPE(1)) / first;
  diagonal[n - 1] = STEP(n - 3);
  lower[n - 2] = last;
  right[n - 1] = (STEP(n - 2) * STEP(n - 2) * SLOPE(n - 3) +
                  (2 * last + STEP(n - 2)) * STEP(n - 3) * SLOPE(n - 2)) /
                 last;
#undef STEP
#undef SLOPE
}

enum status tank_record_finish(struct tank_record *r) {
  double *bands = NULL;
  TRY(array_create(&r->q_t, r->n, "a spline"));
  TRY(array_create(&bands, 3 * r->n, "a spline"));
  spline_rows(r, bands, bands + r->n, bands + 2 * r->n, r->q_t);
  lapack_int n = (lapack_int)r->n, one = 1, failed;
  LAPACK_dgtsv(&n, &one, bands, bands + r->n, bands + 2 * r->n, r->q_t, &n, &failed);
  free(bands);
  CHECK(!failed, ERR_INPUT, "no spline goes through the rows");
  return OK;
}

void tank_record_destroy(struct tank_record *r) {
  if (!r) return;
  free(r->t);
  free(r->q);
  free(r->q_t);
  *r = (struct tank_record){0};
}

/* ---- of the whole tank ---- */

/* x = about + shift + R(angle) (p - about) */
void tank_frame_at(const struct tank_motion *motions, size_t n, double t, struct tank_frame *f) {
  double shift[2][3] = {{0}}, turn[3] = {0}, q[3];
  const double *about = (const double[2]){0, 0};
  for (size_t i = 0; i < n; i++) {
    const struct tank_motion *m = &motions[i];
    if (tank_motion_is_of_side(m)) continue;
    if (m->kind == TANK_MOTION_roll) about = m->about;
    double *sum = m->kind == TANK_MOTION_roll ? turn : shift[m->kind == TANK_MOTION_heave];
    tank_motion_at(m, t, q);
    for (int k = 0; k < 3; k++) sum[k] += q[k];
  }
  const double cosine = cos(turn[0]), sine = sin(turn[0]);
  const double arm[2] = {-(cosine * about[0] - sine * about[1]),
                         -(sine * about[0] + cosine * about[1])};
  for (int k = 0; k < 2; k++) {
    const double across = k ? arm[0] : -arm[1];
    f->at[k] = about[k] + shift[k][0] + arm[k];
    f->velocity[k] = shift[k][1] + turn[1] * across;
    f->acceleration[k] = shift[k][2] + turn[2] * across - turn[1] * turn[1] * arm[k];
  }
  f->angle = turn[0];
  f->rate = turn[1];
  f->turning = turn[2];
}

void tank_frame_force(const struct tank_frame *f, double gravity, const double p[2],
                      const double u[2], double force[2]) {
  const double cosine = cos(f->angle), sine = sin(f->angle);
  const double felt[2] = {-f->acceleration[0], -gravity - f->acceleration[1]};
  force[0] = cosine * felt[0] + sine * felt[1] + f->turning * p[1] + f->rate * f->rate * p[0] +
             2 * f->rate * u[1];
  force[1] = cosine * felt[1] - sine * felt[0] - f->turning * p[0] + f->rate * f->rate * p[1] -
             2 * f->rate * u[0];
}

/* ---- of its sides ---- */

bool tank_find_side(const struct geo_lines *walls, int side, struct tank_side *s) {
  const size_t vessel = geo_lines_vessel(walls);
  if (vessel == walls->pieces) return false;
  const size_t a = walls->first[vessel], b = walls->first[vessel + 1] - 1;
  const size_t end = side == TANK_RIGHT ? a : b;
#define ALONG(k) (side == TANK_RIGHT ? b - (k) : a + (k))
  const double near = 1e-9 * geo_piece_length(walls, vessel);
  size_t n = 1;
  s->top = ALONG(0);
  for (; ALONG(n) != end; n++) { /* on as long as the line goes on straight */
    double off, part = geo_line_foot(walls->p[s->top], walls->p[ALONG(n)],
                                     walls->p[ALONG(n + 1)][0], walls->p[ALONG(n + 1)][1], &off);
    if (fabs(off) > near || part < 1) break;
  }
  s->foot = ALONG(n);
  s->next = s->foot == end ? end : ALONG(n + 1);
#undef ALONG
  return true;
}

void tank_side_at(const struct tank_motion *motions, size_t n, enum tank_motion_kind kind, int side,
                  double t, double q[3]) {
  q[0] = q[1] = q[2] = 0;
  for (size_t i = 0; i < n; i++) {
    double one[3];
    if (motions[i].kind != kind || motions[i].side != side) continue;
    tank_motion_at(&motions[i], t, one);
    for (int k = 0; k < 3; k++) q[k] += one[k];
  }
}

/* Clockwise by the angle of the flap, about the hinge, which is where the line of the side is at
 * that height. */
static void turn_vertex(const double at[2], const double hinge[2], const double flap[3],
                        double (*out[3])[2], size_t i) {
  const double x = at[0] - hinge[0], y = at[1] - hinge[1];
  const double arm[2] = {cos(flap[0]) * x + sin(flap[0]) * y, cos(flap[0]) * y - sin(flap[0]) * x};
  for (int k = 0; k < 2; k++) {
    const double across = k ? -arm[0] : arm[1];
    out[0][i][k] = hinge[k] + arm[k];
    if (out[1]) out[1][i][k] = flap[1] * across;
    if (out[2]) out[2][i][k] = flap[2] * across - flap[1] * flap[1] * arm[k];
  }
}

void tank_side_move(const struct geo_lines *walls, const struct tank_side *side,
                    const struct tank_shift *shift, double (*p)[2], double (*v)[2],
                    double (*a)[2]) {
  const double *top = walls->p[side->top], *foot = walls->p[side->foot];
  /* a side without a flap has its hinge at infinity, above all of its points */
  const double part = isfinite(shift->hinge) && top[1] != foot[1]
                          ? (shift->hinge - foot[1]) / (top[1] - foot[1])
                          : 0;
  const double hinge[2] = {foot[0] + part * (top[0] - foot[0]), shift->hinge};
  double(*out[3])[2] = {p, v, a};
  size_t i = side->top < side->foot ? side->top : side->foot;
  const size_t last = side->top < side->foot ? side->foot : side->top;
  for (; i <= last; i++) {
    if (walls->p[i][1] > shift->hinge) turn_vertex(walls->p[i], hinge, shift->flap, out, i);
    for (int k = 0; k < 3; k++)
      if (out[k]) out[k][i][0] += shift->piston[k];
  }
}

double tank_hinge(const struct tank_motion *motions, size_t n, int side) {
  for (size_t i = 0; i < n; i++)
    if (motions[i].kind == TANK_MOTION_flap && motions[i].side == side) return motions[i].hinge;
  return INFINITY;
}

static struct tank_shift shift_at(const struct tank_motion *motions, size_t n, int side, double t) {
  struct tank_shift shift = {.hinge = tank_hinge(motions, n, side)};
  tank_side_at(motions, n, TANK_MOTION_piston, side, t, shift.piston);
  tank_side_at(motions, n, TANK_MOTION_flap, side, t, shift.flap);
  return shift;
}

void tank_vertices_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                      double t, double (*p)[2], double (*v)[2], double (*a)[2]) {
  const size_t bytes = walls->points * sizeof *p;
  if (!walls->points) return;
  memcpy(p, walls->p, bytes);
  if (v) memset(v, 0, bytes);
  if (a) memset(a, 0, bytes);
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    struct tank_side s;
    const struct tank_shift shift = shift_at(motions, n, side, t);
    if (tank_find_side(walls, side, &s)) tank_side_move(walls, &s, &shift, p, v, a);
  }
}

void tank_point_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                   double t, double near, double p[2]) {
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    struct tank_side s;
    double foot[2];
    if (!tank_find_side(walls, side, &s)) continue;
    geo_segment_foot(walls->p[s.foot], walls->p[s.top], p, foot);
    if (hypot(p[0] - foot[0], p[1] - foot[1]) > near) continue;
    const struct tank_shift shift = shift_at(motions, n, side, t);
    const double *ends[2] = {walls->p[s.top], walls->p[s.foot]};
    double at[3][2] = {{ends[0][0], ends[0][1]}, {p[0], p[1]}, {ends[1][0], ends[1][1]}};
    double now[3][2];
    memcpy(now, at, sizeof now);
    const struct geo_lines line = {.p = at, .points = 3};
    tank_side_move(&line, &(struct tank_side){0, 2, 2}, &shift, now, NULL, NULL);
    memcpy(p, now[1], sizeof now[1]);
    return; /* no point is on both sides */
  }
}

static bool moves(const struct tank_motion *motions, size_t n, int side) {
  for (size_t i = 0; i < n; i++)
    if (tank_motion_is_of_side(&motions[i]) && motions[i].side == side) return true;
  return false;
}

/* How far a point is behind a side, m: brought back to where the side was at rest, with what of the
 * side is as high as it is. */
static double way_behind(const struct geo_lines *walls, const struct tank_side *side, bool right,
                         const struct tank_shift *shift, const double p[2]) {
  const double *top = walls->p[side->top], *foot = walls->p[side->foot];
  const double rise = top[1] - foot[1], part = (shift->hinge - foot[1]) / rise;
  double x = p[0] - shift->piston[0], y = p[1];
  if (y > shift->hinge) {
    const double hinge = foot[0] + part * (top[0] - foot[0]), up = y - shift->hinge;
    const double out = x - hinge;
    x = hinge + cos(shift->flap[0]) * out - sin(shift->flap[0]) * up;
    y = shift->hinge + sin(shift->flap[0]) * out + cos(shift->flap[0]) * up;
  }
  const double off =
      (rise * (x - foot[0]) - (top[0] - foot[0]) * (y - foot[1])) / hypot(top[0] - foot[0], rise);
  return right ? off : -off;
}

bool tank_hides_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                   double t, double near, const double p[2]) {
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    struct tank_side s;
    if (!moves(motions, n, side) || !tank_find_side(walls, side, &s)) continue;
    const struct tank_shift shift = shift_at(motions, n, side, t);
    if (p[1] < walls->p[s.foot][1] - near) continue;
    if (way_behind(walls, &s, side == TANK_RIGHT, &shift, p) > near) return true;
  }
  return false;
}
