#include "compare/jet.h"

#include <stdint.h>
#include <string.h>

#include "compare/polyline.h"

const double cmp_jet_station[CMP_JET_STATIONS] = {0.05, 0.1, 0.2};

struct fold {         /* between a right-hand and a left-hand vertical tangent of the piece */
  size_t right, left; /* indices of those points, right < left along the piece */
  double overhang;
};

/* Of all places where the surface turns back by more than `least` before going on, the largest. A
 * turn counts only once x has come back by `least`: noise does not. */
static struct fold fold_largest(const double (*p)[2], size_t n, double least) {
  struct fold best = {0, 0, 0};
  size_t high = 0, low = 0;
  bool back = false; /* walking back: high is settled, low is being looked for */
  for (size_t i = 1; i < n; i++) {
    if (!back) {
      if (p[i][0] > p[high][0]) high = i;
      if (p[high][0] - p[i][0] > least) {
        back = true;
        low = i;
      }
    } else {
      if (p[i][0] < p[low][0]) low = i;
      if (p[i][0] - p[low][0] > least || i + 1 == n) {
        double overhang = p[high][0] - p[low][0];
        if (overhang > best.overhang && p[i][0] > p[low][0])
          best = (struct fold){high, low, overhang};
        back = false;
        high = i;
      }
    }
  }
  return best;
}

static double distance(const double *p, const double *q) {
  return hypot(p[0] - q[0], p[1] - q[1]);
}

/* Walks from point `from` by `step` (+1 or -1) up to `last` and finds where the piece leaves the
 * circle of radius r about c; false when it does not. */
static bool leaves_circle(const double (*p)[2], size_t from, size_t last, int step, const double *c,
                          double r, double *at) {
  for (size_t i = from; i != last; i += (size_t)step) {
    const double *a = p[i], *b = p[i + (size_t)step];
    if (distance(b, c) < r) continue;
    double d[2] = {b[0] - a[0], b[1] - a[1]}, f[2] = {a[0] - c[0], a[1] - c[1]};
    double A = d[0] * d[0] + d[1] * d[1], B = f[0] * d[0] + f[1] * d[1];
    double C = f[0] * f[0] + f[1] * f[1] - r * r;
    double u = A > 0 ? (-B + sqrt(fmax(0, B * B - A * C))) / A : 0;
    at[0] = a[0] + u * d[0];
    at[1] = a[1] + u * d[1];
    return true;
  }
  return false;
}

/* The sides of the jet at distance r from its tip: `under` on the cavity's side. */
static bool sides(const double (*p)[2], size_t n, size_t tip, size_t root, double r, double *under,
                  double *over) {
  bool ahead = root > tip; /* the cavity's side lies ahead along the piece */
  return leaves_circle(p, tip, root, ahead ? 1 : -1, p[tip], r, under) &&
         leaves_circle(p, tip, ahead ? 0 : n - 1, ahead ? -1 : 1, p[tip], r, over);
}

/* Moves the tip from its vertical tangent to the point furthest along the jet's own direction. */
static size_t tip_refine(const double (*p)[2], size_t n, size_t tip, size_t root, double H,
                         double *direction) {
  bool known = false;
  for (int pass = 0; pass < 8; pass++) {
    double under[2], over[2];
    if (!sides(p, n, tip, root, cmp_jet_station[1] * H, under, over)) break;
    double d[2] = {p[tip][0] - (under[0] + over[0]) / 2, p[tip][1] - (under[1] + over[1]) / 2};
    double l = hypot(d[0], d[1]);
    if (!(l > 0)) break;
    direction[0] = d[0] / l;
    direction[1] = d[1] / l;
    known = true;
    size_t best = tip;
    for (int step = -1; step <= 1; step += 2)
      for (size_t i = tip; distance(p[i], p[tip]) <= cmp_jet_station[1] * H; i += (size_t)step) {
        if ((p[i][0] - p[best][0]) * d[0] + (p[i][1] - p[best][1]) * d[1] > 0) best = i;
        if (i == (step < 0 ? 0 : n - 1)) break;
      }
    if (best == tip) break;
    tip = best;
  }
  if (!known) direction[0] = direction[1] = NAN;
  return tip;
}

/* Where the vertical below the tip meets the surface beyond the root, and the area enclosed. */
static void cavity_measure(const double (*p)[2], size_t n, size_t tip, size_t root,
                           struct cmp_jet *jet) {
  int step = root > tip ? 1 : -1;
  size_t last = step > 0 ? n - 1 : 0;
  jet->foot[0] = jet->foot[1] = NAN;
  jet->gap = INFINITY;
  for (size_t i = root; i != last; i += (size_t)step) {
    const double *a = p[i], *b = p[i + (size_t)step];
    double d[2] = {b[0] - a[0], b[1] - a[1]}, l2 = d[0] * d[0] + d[1] * d[1];
    if (!(l2 > 0)) continue;
    double u = ((p[tip][0] - a[0]) * d[0] + (p[tip][1] - a[1]) * d[1]) / l2;
    u = fmin(1, fmax(0, u));
    double near[2] = {a[0] + u * d[0], a[1] + u * d[1]};
    jet->gap = fmin(jet->gap, distance(near, p[tip]));
    bool crosses = (a[0] - p[tip][0]) * (b[0] - p[tip][0]) <= 0 && a[0] != b[0];
    double y = a[1] + (p[tip][0] - a[0]) / (b[0] - a[0]) * d[1];
    if (!crosses || y > p[tip][1] || isfinite(jet->foot[0])) continue;
    jet->foot[0] = p[tip][0];
    jet->foot[1] = y;
    /* shoelace relative to the tip: tip ... root ... a, foot */
    double area = 0;
    for (size_t j = tip; j != i; j += (size_t)step) {
      const double *q = p[j], *r = p[j + (size_t)step];
      area += (q[0] - p[tip][0]) * (r[1] - p[tip][1]) - (r[0] - p[tip][0]) * (q[1] - p[tip][1]);
    }
    area += (a[0] - p[tip][0]) * (y - p[tip][1]);
    jet->cavity = cmp_number(fabs(area) / 2);
  }
  if (!isfinite(jet->foot[0])) jet->cavity = cmp_unknown("no surface below the jet's tip");
}

void cmp_jet_find(const struct geo_lines *surface, double H, double least, struct cmp_jet *jet) {
  memset(jet, 0, sizeof *jet);
  jet->direction = jet->cavity = cmp_unknown("the surface does not overhang");
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) jet->thickness[k] = jet->direction;
  size_t piece = cmp_piece_longest(surface);
  if (piece == SIZE_MAX) return;
  const double(*p)[2] = (const double(*)[2])(surface->p + surface->first[piece]);
  size_t n = surface->first[piece + 1] - surface->first[piece];
  struct fold fold = fold_largest(p, n, least);
  if (!(fold.overhang > least)) return;

  /* Water is on the right. Where the fold is walked upwards it lies above its cavity, tip to the
   * left; walked downwards, the tip comes first and to the right. */
  jet->forward = p[fold.left][1] < p[fold.right][1];
  size_t tip = jet->forward ? fold.right : fold.left;
  size_t root = jet->forward ? fold.left : fold.right;
  jet->found = true;
  jet->overhang = fold.overhang;
  double direction[2];
  tip = tip_refine(p, n, tip, root, H, direction);
  memcpy(jet->tip, p[tip], sizeof jet->tip);
  memcpy(jet->root, p[root], sizeof jet->root);
  jet->direction = isfinite(direction[0])
                       ? cmp_number(atan2(direction[1], direction[0]) * 180 / M_PI)
                       : cmp_unknown("the jet is shorter than %g H", cmp_jet_station[1]);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    double under[2], over[2];
    jet->thickness[k] = sides(p, n, tip, root, cmp_jet_station[k] * H, under, over)
                            ? cmp_number(distance(under, over))
                            : cmp_unknown("the jet is shorter than %g H", cmp_jet_station[k]);
  }
  cavity_measure(p, n, tip, root, jet);
}

/* ---- instants ---- */

/* The first output of the run of overhanging outputs in which the largest overhang stands. */
static size_t breaker_first(const struct cmp_jet *jet, size_t n, size_t *peak) {
  *peak = SIZE_MAX;
  for (size_t i = 0; i < n; i++)
    if (jet[i].found && (*peak == SIZE_MAX || jet[i].overhang > jet[*peak].overhang)) *peak = i;
  size_t first = *peak;
  while (first != SIZE_MAX && first > 0 && jet[first - 1].found &&
         jet[first - 1].forward == jet[first].forward)
    first--;
  return first;
}

void cmp_jet_overturning(const struct cmp_jet *jet, const double *t, size_t n,
                         struct cmp_instant *instant) {
  *instant = (struct cmp_instant){cmp_unknown("the surface never overhangs"), NAN, {NAN, NAN}};
  size_t peak, first = breaker_first(jet, n, &peak);
  if (first == SIZE_MAX) return;
  double before = first > 0 ? t[first - 1] : t[0], estimate = t[first];
  if (first + 1 < n && jet[first + 1].found && jet[first + 1].overhang > jet[first].overhang) {
    double a = cbrt(jet[first].overhang * jet[first].overhang);
    double b = cbrt(jet[first + 1].overhang * jet[first + 1].overhang);
    estimate = t[first] - a * (t[first + 1] - t[first]) / (b - a);
  }
  /* an overhang below what noise may have is not seen: the instant may lie before the last output
   * without one, and then the bracket reaches back to it */
  estimate = fmax(estimate, t[0]);
  double lower = fmin(before, estimate);
  instant->time = cmp_number(estimate);
  instant->error = (t[first] - lower) / 2;
  memcpy(instant->at, jet[first].root, sizeof instant->at);
}

void cmp_jet_touchdown(const struct cmp_jet *jet, const double *t, size_t n,
                       struct cmp_instant *instant) {
  *instant = (struct cmp_instant){cmp_unknown("the surface never overhangs"), NAN, {NAN, NAN}};
  size_t peak, last = breaker_first(jet, n, &peak);
  if (last == SIZE_MAX) return;
  /* the cavity is closed when it opens no longer below the jet: the overhang is gone, or what is
   * left of it is another, much smaller one */
  double widest = 0;
  while (last + 1 < n && jet[last + 1].found && jet[last + 1].forward == jet[last].forward) {
    if (cmp_known(&jet[last].cavity)) widest = fmax(widest, jet[last].cavity.value);
    const struct cmp_value *next = &jet[last + 1].cavity;
    if (widest > 0 && cmp_known(next) && next->value < 0.4 * widest) break;
    last++;
  }
  if (last + 1 >= n) {
    instant->time = cmp_unknown("the jet has not touched down when the surfaces end");
    return;
  }
  double estimate = (t[last] + t[last + 1]) / 2;
  if (last > 0 && jet[last - 1].found && jet[last - 1].gap > jet[last].gap &&
      isfinite(jet[last].gap)) {
    double speed = (jet[last - 1].gap - jet[last].gap) / (t[last] - t[last - 1]);
    estimate = fmin(t[last + 1], t[last] + jet[last].gap / speed);
  }
  instant->time = cmp_number(estimate);
  instant->error = (t[last + 1] - t[last]) / 2;
  memcpy(instant->at, isfinite(jet[last].foot[0]) ? jet[last].foot : jet[last].tip,
         sizeof instant->at);
}
