/* The surface in stretches of a few panels, each in its box: where the boxes are apart, and where
 * the surface turns too little between two stretches, neither of them is another side of the other,
 * and they do not cross. */
#pragma once
#include <stddef.h>

#include "bem/shape/surface.h"

enum { BEM_STRETCH = 16 }; /* panels */

struct bem_stretch {
  double low[2], high[2]; /* its box, H */
  double turn[2];         /* least and largest direction of its panels, see stretches.c */
  size_t from, to;        /* from here and to here the surface turns little; none: from = to */
  double clear;           /* to the boxes of all others, H */
};

/* Panels: in a closed chain also those a period before and behind. */
static inline ptrdiff_t bem_stretches_first(const struct bem_surface *s) {
  return bem_surface_is_closed(s) ? 1 - (ptrdiff_t)s->n : 0;
}

static inline ptrdiff_t bem_stretches_behind(const struct bem_surface *s) {
  return (bem_surface_is_closed(s) ? 2 : 1) * ((ptrdiff_t)s->n - 1);
}

static inline size_t bem_stretches_of(const struct bem_surface *s, ptrdiff_t panel) {
  return (size_t)(panel - bem_stretches_first(s)) / BEM_STRETCH;
}

static inline size_t bem_stretches_count(const struct bem_surface *s) {
  return bem_stretches_of(s, bem_stretches_behind(s) - 1) + 1;
}

/* Panels of a stretch, from and to. */
static inline ptrdiff_t bem_stretches_from(const struct bem_surface *s, size_t stretch) {
  return bem_stretches_first(s) + (ptrdiff_t)(stretch * BEM_STRETCH);
}

static inline ptrdiff_t bem_stretches_to(const struct bem_surface *s, size_t stretch) {
  const ptrdiff_t to = bem_stretches_from(s, stretch + 1), behind = bem_stretches_behind(s);
  return to < behind ? to : behind;
}

/* Of a state (x[n], y[n]) of a surface like *s; all: [bem_stretches_count], output. */
void bem_stretches_set(const struct bem_surface *s, const double *state, struct bem_stretch *all);

/* Square of the distance of two boxes, of which one may be a point. */
static inline double bem_stretches_apart(const double low[2], const double high[2],
                                         const struct bem_stretch *b) {
  double sum = 0;
  for (int axis = 0; axis < 2; axis++) {
    const double before = b->low[axis] - high[axis], behind = low[axis] - b->high[axis];
    const double gap = before > behind ? before : behind;
    if (gap > 0) sum += gap * gap;
  }
  return sum;
}
