#include "compare/jet.h"

#include <stdint.h>
#include <string.h>

#include "compare/polyline.h"

const double cmp_jet_station[CMP_JET_STATIONS] = {0.05, 0.1, 0.2};

struct fold {         /* between a right-hand and a left-hand vertical tangent of the piece */
  size_t right, left; /* indices of those points, right < left along the piece */
  double overhang;
};

/* Whether a fold can be a jet: in the window, and its cavity not inside a film on a wall. */
static bool fold_counts(const double (*p)[2], size_t right, size_t left,
                        const struct cmp_jet_place *place) {
  return geo_box_contains(&place->window, p[right][0], p[right][1]) &&
         geo_box_contains(&place->window, p[left][0], p[left][1]) &&
         cmp_wall_distance(place->walls, p[right]) >= place->film &&
         cmp_wall_distance(place->walls, p[left]) >= place->film;
}

/* Of all places where the surface turns back by more than `least` before going on, the largest. A
 * turn counts only once x has come back by `least`: noise does not. */
static struct fold fold_largest(const double (*p)[2], size_t n, const struct cmp_jet_place *place) {
  double least = place->least;
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
        if (overhang > best.overhang && p[i][0] > p[low][0] && fold_counts(p, high, low, place))
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

/* How far the piece rises across point i, within `reach` to both sides. Water is on the right: a
 * fold walked upwards lies above its cavity with the tip to the left; walked downwards, its tip
 * comes first and to the right. (Which end is higher does not tell: a jet that falls droops below.)
 */
static double heading_up(const double (*p)[2], size_t n, size_t i, double reach) {
  size_t a = i, b = i;
  while (a > 0 && distance(p[a], p[i]) < reach) a--;
  while (b + 1 < n && distance(p[b], p[i]) < reach) b++;
  return p[b][1] - p[a][1];
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

/* The point a length away along the piece from point i; false when the piece ends before. */
static bool along(const double (*p)[2], size_t n, size_t i, int step, double length, double *at) {
  for (double left = length; i != (step < 0 ? 0 : n - 1); i += (size_t)step) {
    const double *a = p[i], *b = p[i + (size_t)step];
    double l = distance(a, b);
    if (l < left) {
      left -= l;
      continue;
    }
    at[0] = a[0] + left / l * (b[0] - a[0]);
    at[1] = a[1] + left / l * (b[1] - a[1]);
    return true;
  }
  return false;
}

/* The tip is where the surface turns most sharply around water: where points `reach` before and
 * after it along the surface are closest. It is looked for from `reach` beyond the jet's vertical
 * tangent, which a drooping jet leaves behind, to the root. */
static size_t tip_refine(const double (*p)[2], size_t n, size_t tangent, size_t root,
                         double reach) {
  int step = root > tangent ? 1 : -1; /* towards the root */
  size_t best = tangent, start = tangent;
  double sharpest = INFINITY, walked = 0;
  while (start != (step < 0 ? n - 1 : 0) && walked < reach) {
    walked += distance(p[start], p[start - (size_t)step]);
    start -= (size_t)step;
  }
  for (size_t i = start; i != root; i += (size_t)step) {
    double a[2], c[2];
    if (!along(p, n, i, -1, reach, a) || !along(p, n, i, 1, reach, c)) continue;
    double turn = (p[i][0] - a[0]) * (c[1] - p[i][1]) - (p[i][1] - a[1]) * (c[0] - p[i][0]);
    if (turn >= 0 || distance(a, c) >= sharpest) continue; /* turns around air */
    sharpest = distance(a, c);
    best = i;
  }
  return best;
}

/* From the middle of the section furthest behind the tip that there is to the tip. */
static struct cmp_value direction_measure(const double (*p)[2], size_t n, size_t tip, size_t root,
                                          double H) {
  for (size_t k = CMP_JET_STATIONS; k-- > 0;) {
    double under[2], over[2];
    if (!sides(p, n, tip, root, cmp_jet_station[k] * H, under, over)) continue;
    return cmp_number(
        atan2(p[tip][1] - (under[1] + over[1]) / 2, p[tip][0] - (under[0] + over[0]) / 2) * 180 /
        M_PI);
  }
  return cmp_unknown("the jet is shorter than %g H", cmp_jet_station[0]);
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
    double near[2];
    geo_segment_foot(a, b, p[tip], near);
    jet->gap = fmin(jet->gap, distance(near, p[tip]));
    bool crosses = (a[0] - p[tip][0]) * (b[0] - p[tip][0]) <= 0 && a[0] != b[0];
    double y = a[1] + (p[tip][0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
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

void cmp_jet_find(const struct geo_lines *surface, const struct cmp_jet_place *place,
                  struct cmp_jet *jet) {
  double H = place->H, least = place->least;
  memset(jet, 0, sizeof *jet);
  jet->direction = jet->cavity = cmp_unknown("the surface does not overhang");
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) jet->thickness[k] = jet->direction;
  size_t piece = cmp_piece_longest(surface);
  if (piece == SIZE_MAX) return;
  const double(*p)[2] = (const double(*)[2])(surface->p + surface->first[piece]);
  size_t n = surface->first[piece + 1] - surface->first[piece];
  struct fold fold = fold_largest(p, n, place);
  if (!(fold.overhang > least)) return;

  jet->forward = heading_up(p, n, fold.right, least) + heading_up(p, n, fold.left, least) < 0;
  size_t tip = jet->forward ? fold.right : fold.left;
  size_t root = jet->forward ? fold.left : fold.right;
  jet->found = true;
  jet->overhang = fold.overhang;
  tip = tip_refine(p, n, tip, root, cmp_jet_station[CMP_JET_STATIONS - 1] * H);
  memcpy(jet->tip, p[tip], sizeof jet->tip);
  memcpy(jet->root, p[root], sizeof jet->root);
  jet->direction = direction_measure(p, n, tip, root, H);
  for (size_t k = 0; k < CMP_JET_STATIONS; k++) {
    double under[2], over[2];
    jet->thickness[k] = sides(p, n, tip, root, cmp_jet_station[k] * H, under, over)
                            ? cmp_number(distance(under, over))
                            : cmp_unknown("the jet is shorter than %g H", cmp_jet_station[k]);
  }
  cavity_measure(p, n, tip, root, jet);
}

/* ---- instants ---- */

/* Whether two jets in successive outputs, dt apart, can be the same one: it plunges the same way,
 * and its tip has moved no faster than 4 sqrt(gH), the speed of water fallen from 8 H. */
static bool same_jet(const struct cmp_jet *a, const struct cmp_jet *b, double dt) {
  return a->found && b->found && a->forward == b->forward &&
         distance(a->tip, b->tip) <= 4 * dt + 0.1;
}

/* The last of the outputs from the first on that show one jet: a shape that overhangs to begin
 * with. SIZE_MAX: none does. */
static size_t initial_last(const struct cmp_jet_sequence *s) {
  if (!s->n || !s->jet[0].found) return SIZE_MAX;
  size_t k = 0;
  while (k + 1 < s->n && same_jet(&s->jet[k], &s->jet[k + 1], s->t[k + 1] - s->t[k])) k++;
  return k;
}

/* The stretch [*first, *last] of outputs that show the main breaker: the jet that has the largest
 * overhang of all, followed from there both ways. Otherwise says why there is none. */
static bool breaker_follow(const struct cmp_jet_sequence *s, size_t *first, size_t *last,
                           struct cmp_instant *why) {
  const struct cmp_jet *jet = s->jet;
  const double *t = s->t;
  size_t peak = SIZE_MAX, initial = initial_last(s);
  for (size_t i = initial == SIZE_MAX ? 0 : initial + 1; i < s->n; i++)
    if (jet[i].found && (peak == SIZE_MAX || jet[i].overhang > jet[peak].overhang)) peak = i;
  *why = (struct cmp_instant){initial == SIZE_MAX
                                  ? cmp_unknown("the surface never overhangs")
                                  : cmp_unknown("the surface overhangs from the start"),
                              NAN,
                              false,
                              {NAN, NAN}};
  if (peak == SIZE_MAX) return false;
  *first = *last = peak;
  while (*first > 0 && same_jet(&jet[*first - 1], &jet[*first], t[*first] - t[*first - 1]))
    (*first)--;
  while (*last + 1 < s->n && same_jet(&jet[*last], &jet[*last + 1], t[*last + 1] - t[*last]))
    (*last)++;
  return true;
}

/* overhang^(2/3) is linear in time at first: where a line through its growth up to half the largest
 * begins. */
static double overhang_begins(const struct cmp_jet_sequence *s, size_t first, size_t last) {
  const struct cmp_jet *jet = s->jet;
  const double *t = s->t;
  double largest = 0, sum[4] = {0};
  size_t points = 0;
  for (size_t i = first; i <= last; i++) largest = fmax(largest, jet[i].overhang);
  for (size_t i = first; i <= last && (points < 2 || jet[i].overhang <= largest / 2); i++) {
    double x = t[i] - t[first], y = cbrt(jet[i].overhang * jet[i].overhang);
    sum[0] += x;
    sum[1] += y;
    sum[2] += x * x;
    sum[3] += x * y;
    points++;
  }
  double m = (double)points,
         slope = (m * sum[3] - sum[0] * sum[1]) / (m * sum[2] - sum[0] * sum[0]);
  if (!(points > 1 && slope > 0)) return t[first];
  return fmax(t[0], fmin(t[first], t[first] + (sum[0] - sum[1] / slope) / m));
}

/* Whether a section of the surface within `reach` of `at`, on the jet's side, could be vertical:
 * six spacings high, and no longer than one. Moves `at` there. */
static bool steep_near(const struct cmp_jet_sequence *s, size_t k, bool forward, double reach,
                       double *at) {
  const struct geo_lines *l = &s->surface[k];
  size_t piece = cmp_piece_longest(l);
  if (piece == SIZE_MAX) return false;
  const double(*p)[2] = (const double(*)[2])(l->p + l->first[piece]);
  size_t n = l->first[piece + 1] - l->first[piece];
  double rise = 6 * s->spacing, nearest = reach, found[2] = {NAN, NAN};
  for (size_t i = 0; i < n; i++) {
    if (distance(p[i], at) > reach + rise) continue;
    for (size_t j = i + 1; j < n && p[j][0] - p[i][0] <= s->spacing; j++) {
      double middle[2] = {(p[i][0] + p[j][0]) / 2, (p[i][1] + p[j][1]) / 2};
      if (distance(p[j], p[i]) > 2 * rise) break;
      if ((forward ? p[i][1] - p[j][1] : p[j][1] - p[i][1]) < rise) continue;
      if (distance(middle, at) < nearest && fold_counts(p, i, j, &s->place)) {
        nearest = distance(middle, at);
        memcpy(found, middle, sizeof found);
      }
      break;
    }
  }
  if (!isfinite(found[0])) return false;
  memcpy(at, found, sizeof found);
  return true;
}

/* The earliest time at which the surface may have been vertical, from the output that shows its
 * jet backwards. */
static double vertical_since(const struct cmp_jet_sequence *s, size_t first) {
  const struct cmp_jet *jet = &s->jet[first];
  double at[2] = {(jet->tip[0] + jet->root[0]) / 2, (jet->tip[1] + jet->root[1]) / 2};
  size_t k = first;
  while (s->surface && k > 0 &&
         steep_near(s, k - 1, jet->forward, 4 * (s->t[k] - s->t[k - 1]) + 0.1, at))
    k--;
  return k > 0 ? (s->t[k - 1] + s->t[k]) / 2 : s->t[0];
}

void cmp_jet_overturning(const struct cmp_jet_sequence *s, struct cmp_instant *instant) {
  size_t first, last;
  if (!breaker_follow(s, &first, &last, instant)) return;
  double estimate = overhang_begins(s, first, last), since = vertical_since(s, first);
  double interval = first > 0 ? s->t[first] - s->t[first - 1] : 0;
  instant->time = cmp_number(estimate);
  instant->error = fmax(fmax(interval / 2, s->t[first] - estimate), estimate - since);
  for (int k = 0; k < 2; k++) instant->at[k] = (s->jet[first].tip[k] + s->jet[first].root[k]) / 2;
}

/* The last output before the cavity closed: the breaker is seen no more, or all but its mouth has
 * gone. */
static size_t cavity_closes(const struct cmp_jet_sequence *s, size_t first, size_t last) {
  double widest = 0;
  for (size_t i = first; i < last; i++) {
    if (cmp_known(&s->jet[i].cavity)) widest = fmax(widest, s->jet[i].cavity.value);
    const struct cmp_value *next = &s->jet[i + 1].cavity;
    if (widest > 0 && cmp_known(next) && next->value < 0.4 * widest) return i;
  }
  return last;
}

void cmp_jet_touchdown(const struct cmp_jet_sequence *s, struct cmp_instant *instant) {
  const struct cmp_jet *jet = s->jet;
  const double *t = s->t;
  size_t first, last;
  if (!breaker_follow(s, &first, &last, instant)) return;
  last = cavity_closes(s, first, last);
  if (last + 1 >= s->n) {
    instant->time = cmp_unknown("the jet has not touched down when the surfaces end");
    return;
  }
  double interval = t[last + 1] - t[last], speed = NAN, estimate = t[last] + interval / 2;
  if (last > first && jet[last - 1].gap > jet[last].gap)
    speed = (jet[last - 1].gap - jet[last].gap) / (t[last] - t[last - 1]);
  if (isfinite(speed)) {
    if (jet[last].gap > 2 * (speed * interval + s->spacing)) {
      instant->time = cmp_unknown("the jet is lost %.2g H above the water at t* = %.4g",
                                  jet[last].gap, t[last]);
      return;
    }
    estimate = fmin(t[last + 1], t[last] + jet[last].gap / speed);
  }
  instant->time = cmp_number(estimate);
  /* tip and water may each be half a spacing off */
  instant->error = fmax(interval / 2, isfinite(speed) ? s->spacing / speed : interval);
  memcpy(instant->at, isfinite(jet[last].foot[0]) ? jet[last].foot : jet[last].tip,
         sizeof instant->at);
}
