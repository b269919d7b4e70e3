#include "bem/map/conformal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/map/prevertices.h"
#include "common/base/array.h"

static const double REACH = 0.1; /* radii of a chart, with BEM_CHART terms */
static const double STRIDE = 0.08;
static const double SMALL = 1e-8;
static const double STRAIGHT = 1e-9; /* rad: walls that bend less do not */
static const double ON_WALL = 1e-6;  /* H: sensors are on walls but for so much */
static const double NEAR = 0.4;      /* radii of a bend's own series, with MANY terms */
enum { MANY = 48, STEPS = 20000, NEWTON = 30 };

void bem_conformal_destroy(struct bem_conformal *m) {
  if (!m) return;
  free(m->point);
  free(m->xi);
  free(m->power);
  free(m);
}

double complex bem_conformal_along(const struct bem_conformal *m, size_t side) {
  double complex way = m->point[side + 1] - m->point[side];
  return way / cabs(way);
}

/* ---- series ---- */

static double gap_without(const struct bem_conformal *m, double complex zeta, size_t without) {
  double least = INFINITY;
  for (size_t k = 0; k < m->n; k++)
    if (k != without) least = fmin(least, cabs(zeta - m->xi[k]));
  return isfinite(least) ? least : 1;
}

double bem_conformal_gap(const struct bem_conformal *m, double complex zeta) {
  return gap_without(m, zeta, m->n);
}

/* C prod (zeta - xi_k)^power_k over all bends but one, zeta on the real axis or above it. */
static double complex product(const struct bem_conformal *m, double complex zeta, size_t without) {
  double complex sum = 0;
  const double x = creal(zeta), y = cimag(zeta) > 0 ? cimag(zeta) : 0.0;
  for (size_t k = 0; k < m->n; k++)
    if (k != without) sum += m->power[k] * clog(CMPLX(x - m->xi[k], y));
  return m->factor * cexp(sum);
}

/* Power series of that product over its value at zeta, in t = (change of zeta)/radius. With r_k =
 * radius/(zeta - xi_k) its logarithmic derivative is sum power_k r_k/(1 + r_k t). */
static void expand(const struct bem_conformal *m, double complex zeta, size_t without,
                   double radius, int terms, double complex *q) {
  double complex sum[MANY] = {0};
  for (size_t k = 0; k < m->n; k++) {
    if (k == without) continue;
    double complex r = radius / (zeta - m->xi[k]), term = m->power[k] * r;
    for (int j = 0; j < terms; j++, term *= -r) sum[j] += term;
  }
  q[0] = 1;
  for (int i = 1; i < terms; i++) {
    q[i] = 0;
    for (int j = 0; j < i; j++) q[i] += sum[j] * q[i - 1 - j];
    q[i] /= i;
  }
}

static void chart_set(const struct bem_conformal *m, double complex z, double complex zeta,
                      struct bem_chart *c) {
  *c = (struct bem_chart){.z = z, .zeta = zeta, .radius = bem_conformal_gap(m, zeta)};
  double complex lead = product(m, zeta, m->n) * c->radius;
  expand(m, zeta, m->n, c->radius, BEM_CHART, c->a);
  for (int j = 0; j < BEM_CHART; j++) c->a[j] *= lead / (j + 1);
}

int bem_chart_find(struct bem_chart *c, double complex z, double complex *zeta,
                   double complex *slope) {
  const double complex d = z - c->z;
  if (!(c->radius > 0) || cabs(d) > 2 * REACH * cabs(c->a[0])) return 0;
  double complex t = c->t, value, rise = 1;
  double step = 1; /* of Newton's method, which squares it: the one after SMALL is rounding */
  for (int i = 0, last = 0; i < NEWTON && !last; i++) {
    last = step < SMALL;
    value = c->a[BEM_CHART - 1];
    rise = BEM_CHART * c->a[BEM_CHART - 1];
    for (int j = BEM_CHART - 1; j-- > 0;) {
      value = value * t + c->a[j];
      rise = rise * t + (j + 1) * c->a[j];
    }
    double complex change = (d - value * t) / rise;
    t += change;
    step = cabs(change);
  }
  *zeta = c->zeta + c->radius * t;
  *slope = c->radius / rise;
  if (!(cabs(t) <= REACH) || cimag(*zeta) < -1e-9 * c->radius) return 0;
  c->t = t;
  return 1;
}

enum status bem_chart_walk(const struct bem_conformal *m, struct bem_chart *c, double complex z) {
  double complex zeta, slope;
  for (int i = 0; i < STEPS; i++) {
    const double complex way = z - c->z;
    const double part = STRIDE * cabs(c->a[0]) / cabs(way);
    double complex to = part < 1 ? c->z + part * way : z;
    for (int half = 0; !bem_chart_find(c, to, &zeta, &slope); half++) {
      CHECK(half < 20, ERR_SOLVER, "the map of the tank cannot be followed to x = %g H, y = %g H",
            creal(z), cimag(z));
      to = 0.5 * (c->z + to);
    }
    chart_set(m, to, zeta, c);
    if (to == z) return OK;
  }
  return status_raise(ERR_SOLVER, "the map of the tank cannot be followed to x = %g H, y = %g H",
                      creal(z), cimag(z));
}

/* ---- near a bend ---- */

/* z - vertex = lead s^alpha sum q_j t^j/(j + alpha), t = s/radius, s = zeta - xi. */
struct corner {
  double radius, alpha;
  double complex lead, q[MANY];
};

static struct corner corner_at(const struct bem_conformal *m, size_t k) {
  struct corner c = {gap_without(m, m->xi[k], k), 1 + m->power[k], product(m, m->xi[k], k), {0}};
  expand(m, m->xi[k], k, c.radius, MANY, c.q);
  return c;
}

/* Distance from the bend along a side of the point that has this s, of the sign of that side;
 * *rise: its derivative by |s|. */
static double corner_distance(const struct corner *c, double s, double *rise) {
  const double t = s / c->radius;
  double sum = 0, slope = 0;
  for (int j = MANY; j-- > 0;) {
    sum = sum * t + creal(c->q[j]) / (j + c->alpha);
    slope = slope * t + creal(c->q[j]);
  }
  const double lead = cabs(c->lead) * pow(fabs(s), c->alpha);
  *rise = lead / fabs(s) * slope;
  return lead * sum;
}

/* |s| of the point at this distance, by Newton's method for the power that is nearly linear. */
static double corner_find(const struct corner *c, double sign, double distance) {
  double s = pow(distance * c->alpha / cabs(c->lead), 1 / c->alpha), rise;
  for (int i = 0; i < NEWTON; i++) {
    s = fmin(s, NEAR * c->radius);
    const double is = corner_distance(c, sign * s, &rise);
    const double next = s * pow(1 + (distance - is) / is, is / (rise * s));
    if (fabs(next - s) <= 1e-16 * s) break;
    s = next;
  }
  return s;
}

double bem_conformal_length(const struct bem_conformal *m, size_t k) {
  const struct corner a = corner_at(m, k), b = corner_at(m, k + 1);
  double rise, length = corner_distance(&a, NEAR * a.radius, &rise) +
                        corner_distance(&b, -NEAR * b.radius, &rise);
  const double end = m->xi[k + 1] - NEAR * b.radius;
  double complex q[MANY];
  for (double at = m->xi[k] + NEAR * a.radius, next; at < end; at = next) {
    const double radius = bem_conformal_gap(m, at);
    double sum = 0, t;
    next = fmin(end, at + NEAR * radius);
    t = (next - at) / radius;
    expand(m, at, m->n, radius, MANY, q);
    for (int j = MANY; j-- > 0;) sum = sum * t + creal(q[j]) / (j + 1);
    length += cabs(product(m, at, m->n)) * sum * (next - at);
  }
  return length;
}

/* The nearest side, and the distance from it. */
static size_t nearest_side(const struct bem_conformal *m, double complex z, double *nearest) {
  size_t side = 0;
  double least = INFINITY;
  for (size_t i = 0; i <= m->n; i++) {
    const double complex a = m->point[i], way = m->point[i + 1] - a;
    double u = creal((z - a) * conj(way)) / creal(way * conj(way));
    u = i == 0 ? fmin(u, 1) : i == m->n ? fmax(u, 0) : fmin(fmax(u, 0), 1);
    const double distance = cabs(z - a - u * way);
    if (distance < least) least = distance, side = i;
  }
  *nearest = least;
  return side;
}

size_t bem_conformal_side(const struct bem_conformal *m, double complex z) {
  double distance;
  return nearest_side(m, z, &distance);
}

double bem_conformal_depth(const struct bem_conformal *m, double complex z) {
  double least = INFINITY;
  for (size_t i = 0; i <= m->n; i++) {
    const double complex a = m->point[i], way = m->point[i + 1] - a;
    if (fabs(creal(way)) < ON_WALL) continue;
    const double u = creal(z - a) / creal(way), depth = cimag(z - a - u * way);
    if ((u < 0 && i > 0) || (u > 1 && i < m->n) || depth < -ON_WALL) continue;
    least = fmin(least, fmax(depth, 0));
  }
  return least;
}

int bem_conformal_is_near(const struct bem_conformal *m, double complex z) {
  double distance;
  nearest_side(m, z, &distance);
  return distance < ON_WALL;
}

enum status bem_conformal_start(const struct bem_conformal *m, size_t side, double complex z,
                                struct bem_chart *c) {
  const int has_first = side > 0, has_last = side < m->n;
  const int from_last =
      !has_first || (has_last && cabs(z - m->point[side + 1]) < cabs(z - m->point[side]));
  const size_t k = from_last ? side : side - 1;
  const double complex bend = m->point[k + 1];
  const double complex away =
      from_last ? -bem_conformal_along(m, side) : bem_conformal_along(m, side);
  const double sign = from_last ? -1 : 1, distance = cabs(z - bend);
  const struct corner corner = corner_at(m, k);
  double s = NEAR * corner.radius, rise, most = corner_distance(&corner, sign * s, &rise);
  CHECK(distance > 0, ERR_SOLVER, "the water's edge is on a bend of the wall");
  if (distance < most) s = corner_find(&corner, sign, distance);
  chart_set(m, bend + away * fmin(distance, most), m->xi[k] + sign * s, c);
  return distance < most ? OK : bem_chart_walk(m, c, z);
}

enum status bem_conformal_on_wall(const struct bem_conformal *m, double complex z,
                                  double complex *zeta, double complex *slope) {
  const size_t side = bem_conformal_side(m, z);
  const double complex a = m->point[side], along = bem_conformal_along(m, side);
  struct bem_chart c;
  z = a + creal((z - a) * conj(along)) * along;
  for (size_t k = 0; k < m->n; k++)
    if (cabs(z - m->point[k + 1]) < STRAIGHT) {
      *zeta = m->xi[k];
      *slope = 0;
      return OK;
    }
  TRY(bem_conformal_start(m, side, z, &c));
  bem_chart_find(&c, z, zeta, slope);
  return OK;
}

/* ---- the walls ---- */

/* Those of the points where the walls bend, and how; the first and the last stay. */
static void set_bends(struct bem_conformal *m, size_t n, const double (*p)[2], const bool *keep) {
  m->point[0] = CMPLX(p[0][0], p[0][1]);
  for (size_t i = 1; i + 1 < n; i++) {
    const double complex at = CMPLX(p[i][0], p[i][1]), next = CMPLX(p[i + 1][0], p[i + 1][1]);
    const double turn = carg((next - at) * conj(at - m->point[m->n]));
    if (fabs(turn) < STRAIGHT && !(keep && keep[i])) continue;
    m->power[m->n++] = -turn / M_PI;
    m->point[m->n] = at;
  }
  m->point[m->n + 1] = CMPLX(p[n - 1][0], p[n - 1][1]);
}

static enum status create(struct bem_conformal *m, size_t n, const double (*point)[2],
                          const bool *keep) {
  TRY(array_create(&m->point, n, "bends of a wall"));
  TRY(array_create(&m->xi, n, "bends of a wall"));
  TRY(array_create(&m->power, n, "bends of a wall"));
  set_bends(m, n, point, keep);
  CHECK(m->n > 0, ERR_SOLVER, "walls without a bend make no tank");
  return bem_prevertices_find(m);
}

enum status bem_conformal_create(size_t n, const double (*point)[2], const bool *keep,
                                 struct bem_conformal **out) {
  struct bem_conformal *m = *out = calloc(1, sizeof *m);
  CHECK(m, ERR_MEMORY, "no memory for the map of a tank");
  return create(m, n, point, keep);
}

enum status bem_conformal_copy(const struct bem_conformal *m, struct bem_conformal **out) {
  struct bem_conformal *c = *out = calloc(1, sizeof *c);
  CHECK(c, ERR_MEMORY, "no memory for the map of a tank");
  TRY(array_create(&c->point, m->n + 2, "bends of a wall"));
  TRY(array_create(&c->xi, m->n + 2, "bends of a wall"));
  TRY(array_create(&c->power, m->n + 2, "bends of a wall"));
  memcpy(c->point, m->point, (m->n + 2) * sizeof *c->point);
  memcpy(c->xi, m->xi, m->n * sizeof *c->xi);
  memcpy(c->power, m->power, m->n * sizeof *c->power);
  c->n = m->n;
  c->factor = m->factor;
  return OK;
}

enum status bem_conformal_move(struct bem_conformal *m, const double complex *point) {
  memcpy(m->point, point, (m->n + 2) * sizeof *point);
  for (size_t k = 1; k <= m->n; k++)
    m->power[k - 1] = -carg((point[k + 1] - point[k]) * conj(point[k] - point[k - 1])) / M_PI;
  m->changes++;
  return bem_prevertices_follow(m);
}
