/* A surface that is smooth at its spacing, and goes on smoothly beyond its edges: round a closed
 * chain, or past upright walls that stand still, in which water and potential are mirrored. What is
 * known at its nodes then is a smooth periodic function of the node number: sums over all nodes
 * integrate it as exactly as it is resolved at all (the trapezoidal rule), and symmetric
 * differences of many nodes differentiate it. So Cauchy's integral and all that follows from it are
 * of order 2 BEM_SMOOTH, without logarithms. A surface that has kinks, leans over or grows too
 * rough is one of panels (panels.h). */
#pragma once
#include "bem/shape/surface.h"

enum { BEM_SMOOTH = 6 }; /* nodes on either side that a difference reaches to */

/* How what is given at the nodes goes on behind an upright wall. */
enum bem_parity { BEM_EVEN, BEM_ODD /* about its value on the wall */ };

/* Weight of the node after so many in d/di, that before as much less; [0] is 0. */
extern const double bem_smooth_weight[BEM_SMOOTH + 1];

/* Whether this surface is smooth, with nothing that moves its walls or its frame. */
bool bem_smooth_is(const struct bem_surface *s);

/* f at a node or as many before and behind them as there are. */
double bem_smooth_node(const struct bem_surface *s, const double *f, enum bem_parity parity,
                       ptrdiff_t k);

/* d/di and d2/di2 of a nodal quantity. */
void bem_smooth_differences(const struct bem_surface *s, const double *f, enum bem_parity parity,
                            double *first, double *second /* or NULL */);

/* d/di at one node. */
double bem_smooth_slope(const struct bem_surface *s, const double *f, enum bem_parity parity,
                        size_t k);

/* A quantity between nodes, at the place `at` counted in nodes. */
double bem_smooth_value(const struct bem_surface *s, const double *f, enum bem_parity parity,
                        double at);

/* Where between nodes k and k + 1, counted in nodes, a quantity that grows along the surface is so
 * much. */
double bem_smooth_find(const struct bem_surface *s, const double *f, size_t k, double value);

/* Part of a sum over all nodes that one has: those on walls are half behind them, the last of a
 * closed chain is the first. */
static inline double bem_smooth_share(const struct bem_surface *s, size_t k) {
  if (bem_surface_is_closed(s)) return k + 1 < s->n;
  return k == 0 || k + 1 == s->n ? 0.5 : 1;
}
