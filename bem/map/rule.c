#include "bem/map/rule.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double RATIO = 3; /* of neighbouring panels at most */

/* Legendre's polynomials of degrees 0 to BEM_RULE at s. */
static void legendre(double s, double p[BEM_RULE + 1]) {
  p[0] = 1;
  p[1] = s;
  for (int k = 1; k < BEM_RULE; k++) p[k + 1] = ((2 * k + 1) * s * p[k] - k * p[k - 1]) / (k + 1);
}

static double legendre_slope(double s, const double p[BEM_RULE + 1]) {
  return BEM_RULE * (s * p[BEM_RULE] - p[BEM_RULE - 1]) / (s * s - 1);
}

static void create_gauss(struct bem_gauss *g) {
  double p[BEM_RULE][BEM_RULE + 1];
  for (int j = 0; j < BEM_RULE; j++) {
    double s = -cos(M_PI * (j + 0.75) / (BEM_RULE + 0.5));
    for (int i = 0; i < 6; i++) { /* Newton's method: to rounding */
      legendre(s, p[j]);
      s -= p[j][BEM_RULE] / legendre_slope(s, p[j]);
    }
    legendre(s, p[j]);
    const double slope = legendre_slope(s, p[j]);
    g->point[j] = s;
    g->weight[j] = 2 / ((1 - s * s) * slope * slope);
    g->between[j] = 1 / slope;
  }
  for (int j = 0; j < BEM_RULE; j++)
    for (int k = 0; k < BEM_RULE; k++) {
      double sum = g->point[j] + 1;
      for (int i = 1; i < BEM_RULE; i++) sum += p[k][i] * (p[j][i + 1] - p[j][i - 1]);
      g->integral[j][k] = 0.5 * g->weight[k] * sum;
    }
}

void bem_rule_clear(struct bem_rule *r) {
  if (!(r->gauss.weight[0] > 0)) create_gauss(&r->gauss);
  r->panels = 0;
}

void bem_rule_destroy(struct bem_rule *r) {
  free(r->panel);
  free(r->xi);
  free(r->weight);
  free(r->z);
  free(r->slope);
  *r = (struct bem_rule){0};
}

static enum status reserve(struct bem_rule *r, size_t panels) {
  if (panels <= r->room) return OK;
  const size_t room = panels + panels / 2 + 16, points = room * BEM_RULE;
  TRY(array_resize(&r->panel, room, "panels of walls"));
  TRY(array_resize(&r->xi, points, "points of walls"));
  TRY(array_resize(&r->weight, points, "points of walls"));
  TRY(array_resize(&r->z, points, "points of walls"));
  TRY(array_resize(&r->slope, points, "points of walls"));
  r->room = room;
  return OK;
}

/* A part of a side that goes on from a bend. */
struct stretch {
  const struct bem_conformal *m;
  size_t side, bend;
  double way;           /* of zeta from the bend on: 1, -1 */
  double complex along; /* of z */
};

/* |dz/dzeta| at this distance from the bend. */
static double rise(const struct stretch *t, double distance) {
  const struct bem_conformal *m = t->m;
  double sum = 0;
  for (size_t k = 0; k < m->n; k++) {
    const double from = k == t->bend ? distance : m->xi[t->bend] - m->xi[k] + t->way * distance;
    sum += m->power[k] * log(fabs(from));
  }
  return cabs(m->factor) * exp(sum);
}

/* Adds the panel between two distances from the bend, `arc` (H) along the wall from there on. */
static enum status add_panel(struct bem_rule *r, const struct stretch *t, double from, double to,
                             double *arc) {
  TRY(reserve(r, r->panels + 1));
  const struct bem_gauss *g = &r->gauss;
  const size_t at = BEM_RULE * r->panels;
  const double half = 0.5 * (to - from), bend = t->m->xi[t->bend];
  const double power = from > 0 ? 1 : fmax(4, ceil(3 / (1 + t->m->power[t->bend])));
  double pace[BEM_RULE], length = 0; /* pace: by the variable of the points */
  r->panel[r->panels++] =
      (struct bem_rule_panel){bend + t->way * from, t->way * half, t->side, t->bend, power};
  for (int j = 0; j < BEM_RULE; j++) {
    const double u = 0.5 * (1 + g->point[j]), part = pow(u, power - 1);
    const double distance = from + 2 * half * part * u, size = half * power * part;
    const double slope = rise(t, distance);
    r->xi[at + j] = bend + t->way * distance;
    r->weight[at + j] = g->weight[j] * size;
    r->slope[at + j] = t->way * slope * t->along;
    pace[j] = slope * size;
  }
  for (int j = 0; j < BEM_RULE; j++) {
    double to_here = *arc;
    for (int k = 0; k < BEM_RULE; k++) to_here += g->integral[j][k] * pace[k];
    r->z[at + j] = t->m->point[t->bend + 1] + to_here * t->along;
    length += g->weight[j] * pace[j];
  }
  *arc += length;
  return OK;
}

/* From the bend to a distance. */
static enum status add_stretch(struct bem_rule *r, const struct stretch *t, double until,
                               double least, double longest) {
  const double ratio = log(until / least) / log(RATIO);
  const int levels = ratio > 0 ? (int)ceil(ratio) : 0;
  double arc = 0, from = 0;
  for (int i = 0; i <= levels; i++) {
    const double to = i == levels ? until : until * pow(least / until, 1 - (double)i / levels);
    const double length = (to - from) * rise(t, 0.5 * (from + to));
    const int parts = i && length > longest ? (int)fmin(1000, ceil(length / longest)) : 1;
    for (int k = 0; k < parts; k++)
      TRY(add_panel(r, t, from + (to - from) * k / parts, from + (to - from) * (k + 1) / parts,
                    &arc));
    from = to;
  }
  return OK;
}

static double nearest(const struct bem_conformal *m, size_t bend, double least) {
  for (size_t k = 0; k < m->n; k++)
    if (k != bend) least = fmin(least, fabs(m->xi[k] - m->xi[bend]));
  return least;
}

enum status bem_rule_add(struct bem_rule *r, const struct bem_conformal *m, size_t side,
                         const double end[2], int levels, double longest) {
  const bool left = side > 0 && end[0] == m->xi[side - 1];
  const bool right = side < m->n && end[1] == m->xi[side];
  const double length = end[1] - end[0];
  const double complex along = bem_conformal_along(m, side);
  for (int i = 0; i < 2; i++) {
    if (!(i ? right : left)) continue;
    const struct stretch t = {m, side, i ? side : side - 1, i ? -1 : 1, i ? -along : along};
    const double until = left && right ? 0.5 * length : length;
    TRY(add_stretch(r, &t, until, nearest(m, t.bend, length) * pow(RATIO, -levels), longest));
  }
  return OK;
}
