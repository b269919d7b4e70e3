/* Released columns in tanks that are not rectangular at random, the same in every program: on flat
 * beds before a slope, on slopes that fall or rise, before a step up or down, before a bar; at
 * either side, the radius of rounding left out or given. */
#pragma once
#include <stdbool.h>
#include <string.h>

#include "tests/bem/columns.h"

enum slope_kind { SLOPE_BEACH, SLOPE_FALLING, SLOPE_RISING, SLOPE_STEP, SLOPE_BAR, SLOPE_KINDS };

struct slope {
  enum slope_kind kind;
  double wide, ahead, beyond; /* of the column, of what is dry before the bend and behind it, H */
  double cot;                 /* of the slope: 1 to 20 */
  double rise;                /* of a step or a bar, H; negative: down */
  double rounding;            /* H; 0: left out */
  double share;               /* as of struct column */
  bool right;                 /* the column is at the right wall */
};

struct slope_text {
  char text[2000];
  size_t n;
};

static inline struct slope slope_at(int n) {
  unsigned short seed[3] = {7, 5, 3};
  struct slope s = {0};
  for (int i = 0; i <= n; i++) {
    s.kind = (enum slope_kind)(i % SLOPE_KINDS);
    s.wide = column_between(seed, 0.5, 3);
    s.ahead = column_between(seed, 0.3, 3);
    s.beyond = column_between(seed, 1, 4);
    s.cot = column_between(seed, 1, 20);
    s.rise = column_between(seed, 0.05, 0.4) * (erand48(seed) < 0.5 ? 1 : -1);
    s.rounding = column_between(seed, 0.01, 0.08);
    if (erand48(seed) < 0.5) s.rounding = 0;
    s.share = erand48(seed);
    s.right = erand48(seed) < 0.5;
  }
  return s;
}

/* Points of the bed from the wall that the column stands at to the other one; how many. */
static inline int slope_bed(const struct slope *s, double p[8][2]) {
  const double front = s->wide + s->ahead, end = front + s->beyond;
  const double up = fmin(s->beyond / s->cot, 2), high = fabs(s->rise);
  switch (s->kind) {
  case SLOPE_BEACH:
    memcpy(p, (double[3][2]){{0, 0}, {front, 0}, {front + up * s->cot, up}}, 6 * sizeof(double));
    return 3;
  case SLOPE_FALLING:
    memcpy(p, (double[3][2]){{0, 0}, {front, -front / s->cot}, {end, -front / s->cot}},
           6 * sizeof(double));
    return 3;
  case SLOPE_RISING: { /* so that at its front the column is still 0.4 H high */
    const double cot = fmax(s->cot, s->wide / 0.6);
    memcpy(p, (double[2][2]){{0, 0}, {end, end / cot}}, 4 * sizeof(double));
    return 2;
  }
  case SLOPE_STEP:
    memcpy(p, (double[4][2]){{0, 0}, {front, 0}, {front, s->rise}, {end, s->rise}},
           8 * sizeof(double));
    return 4;
  case SLOPE_BAR:
  case SLOPE_KINDS:
    break;
  }
  const double foot = fmin(high * s->cot, 0.4 * s->beyond);
  memcpy(p,
         (double[5][2]){{0, 0}, {front, 0}, {front + foot, high}, {front + 2 * foot, 0}, {end, 0}},
         10 * sizeof(double));
  return 5;
}

static inline double slope_height(double p[8][2], int n, double x) {
  for (int i = 1; i < n; i++)
    if (p[i - 1][0] < x && x <= p[i][0])
      return p[i - 1][1] + (x - p[i - 1][0]) / (p[i][0] - p[i - 1][0]) * (p[i][1] - p[i - 1][1]);
  return p[0][1];
}

static inline void slope_add(struct slope_text *t, const struct slope *s, double end, double x,
                             double y, const char *before) {
  t->n += (size_t)snprintf(t->text + t->n, sizeof t->text - t->n, "%s[%.9f, %.9f]", before,
                           s->right ? end - x : x, y);
}

/* last: time of the end; 0: one that leaves time for waves to go to and fro. */
static inline void slope_write(struct slope_text *t, const struct slope *s, double resolution,
                               double last) {
  double p[8][2];
  const int n = slope_bed(s, p);
  const double end = p[n - 1][0], foot = slope_height(p, n, s->wide);
  *t = (struct slope_text){0};
  t->n = (size_t)snprintf(t->text, sizeof t->text,
                          "title: slope\nfluid: {density: 1, gravity: 1}\nscales: {H: 1}\n"
                          "tank: {walls: [[");
  if (s->right)
    slope_add(t, s, end, end, 6, "");
  else
    slope_add(t, s, end, 0, 6, "");
  for (int i = 0; i < n; i++)
    slope_add(t, s, end, p[s->right ? n - 1 - i : i][0], p[s->right ? n - 1 - i : i][1], ", ");
  slope_add(t, s, end, s->right ? 0 : end, 6, ", ");
  t->n += (size_t)snprintf(t->text + t->n, sizeof t->text - t->n, "]]}\nwater: {regions: [[");
  slope_add(t, s, end, 0, 0, "");
  slope_add(t, s, end, s->wide, foot, ", ");
  slope_add(t, s, end, s->wide, 1, ", ");
  slope_add(t, s, end, 0, 1, ", ");
  t->n +=
      (size_t)snprintf(t->text + t->n, sizeof t->text - t->n,
                       "]], pressure: hydrostatic}\ntime: {end: %.3f, every: 0.1, sample: 0.05}\n"
                       "runs: [{name: bem, solver: bem, resolution: %.0f",
                       last > 0 ? last : 6 + end, resolution);
  if (s->rounding > 0)
    t->n +=
        (size_t)snprintf(t->text + t->n, sizeof t->text - t->n, ", rounding: %.6f", s->rounding);
  snprintf(t->text + t->n, sizeof t->text - t->n, "}]\n");
}
