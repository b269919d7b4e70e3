/* Surfaces of known shape. Free surfaces have the water on their right. */
#pragma once
#include <math.h>
#include <stdlib.h>

#include "common/base/geometry.h"

static inline void shape_open(struct geo_lines *l) {
  if (geo_lines_begin(l, false) != OK) abort();
}

static inline void shape_point(struct geo_lines *l, double x, double y) {
  if (geo_lines_add(l, x, y) != OK) abort();
}

static inline void shape_line(struct geo_lines *l, double x0, double y0, double x1, double y1,
                              size_t n) {
  shape_open(l);
  for (size_t i = 0; i <= n; i++) {
    double u = (double)i / (double)n;
    shape_point(l, x0 + u * (x1 - x0), y0 + u * (y1 - y0));
  }
}

/* Clockwise (a drop) or counter-clockwise (a cavity). */
static inline void shape_circle(struct geo_lines *l, double x, double y, double r, size_t n,
                                bool clockwise) {
  if (geo_lines_begin(l, true) != OK) abort();
  for (size_t i = 0; i < n; i++) {
    double a = (clockwise ? -2 : 2) * M_PI * (double)i / (double)n;
    shape_point(l, x + r * cos(a), y + r * sin(a));
  }
}

/* A tank from x = 0 to `length`, `height` high. */
static inline struct geo_lines shape_tank(double length, double height) {
  struct geo_lines l = {0};
  shape_open(&l);
  shape_point(&l, 0, height);
  shape_point(&l, 0, 0);
  shape_point(&l, length, 0);
  shape_point(&l, length, height);
  return l;
}

/* Arc of a circle about (x, y) from angle a to b (radians), n segments, appended to the open piece.
 */
static inline void shape_arc(struct geo_lines *l, double x, double y, double r, double a, double b,
                             size_t n) {
  for (size_t i = 0; i <= n; i++) {
    double t = a + (b - a) * (double)i / (double)n;
    shape_point(l, x + r * cos(t), y + r * sin(t));
  }
}

/* A jet that plunges to the left over still water of depth 0.2 in a tank of length 4, height 2. It
 * is the band between half circles about (3, 1) of radii 0.5 and 0.5 + thickness, cut off by a
 * round tip at the angle `tip` (radians, beyond pi/2 it droops); its outer side goes on to the
 * right wall and its inner side down into the water to the right of the cavity. */
static inline void shape_jet(struct geo_lines *l, double thickness, double tip, size_t n) {
  double inner = 0.5, outer = inner + thickness, middle = inner + thickness / 2;
  shape_open(l);
  for (size_t i = 0; i < n; i++) shape_point(l, 3.0 * (double)i / (double)n, 0.2);
  shape_arc(l, 3, 0.7, 0.5, -M_PI / 2, 0, n); /* the trough bends up */
  shape_point(l, 3.5, 0.85);
  shape_arc(l, 3, 1, inner, 0, tip, 2 * n); /* the jet's underside */
  double c[2] = {3 + middle * cos(tip), 1 + middle * sin(tip)};
  for (size_t i = 1; i < n; i++) { /* round tip: from the inner to the outer side, ahead of it */
    double a = tip + M_PI - M_PI * (double)i / (double)n;
    shape_point(l, c[0] + thickness / 2 * cos(a), c[1] + thickness / 2 * sin(a));
  }
  shape_arc(l, 3, 1, outer, tip, M_PI / 2, 2 * n); /* back along the upper side */
  shape_point(l, 4, 1 + outer);
}
