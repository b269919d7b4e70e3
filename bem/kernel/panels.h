/* The boundary as the integral equation sees it: the free surface in the plane of the map
 *     zeta = sin^2(pi (L - z) / (2 L)),   z = x + i y,
 * which opens the tank 0 < x < L, y > 0 into the lower half plane: the bed becomes 0 <= zeta <= 1,
 * the left wall zeta >= 1, the right wall zeta <= 0. There beta = phi + i psi with psi = 0 on the
 * walls continues to the upper half plane by Schwarz reflection, beta(conj zeta) = conj beta(zeta),
 * so the surface and its mirror image close the contour and walls need no nodes. Other tanks have a
 * map of their own, onto the upper half plane (conformal.h), where all of this holds as well. Water
 * without sides has a closed surface around a circle, its bed (period.h), that it is reflected in.
 *
 * On the panel between nodes j and j+1 beta is the complex polynomial in zeta through BEM_STENCIL
 * neighbouring nodes (Vinje & Brevig 1981 use two; with four the velocity is of fourth order). At
 * the edges of the water, where beta continues into the mirror image, the nodes' images complete
 * the stencils in tanks that are not rectangular, so that these stay centred and know the wall;
 * but not on a side that leans over the water, under a front that does, or where walls accelerate:
 * where the angle between them and the surface is more than a right one velocities have no bound,
 * and polynomials across the edge only spread that.
 *
 * A smooth surface needs no panels (smooth.h), but for what is seen from inside the water. */
#pragma once
#include <complex.h>
#include <stddef.h>

#include "bem/map/conformal.h"
#include "bem/shape/period.h"
#include "common/base/status.h"

enum {
  BEM_STENCIL = 4,    /* nodes that carry the polynomial of a panel */
  BEM_DERIVATIVE = 5, /* nodes that give d beta / d zeta at a node */
  BEM_PARALLEL = 2000 /* nodes from which work that is linear in them, or a product with the matrix,
                         is worth waking other threads for; the rows of the matrix always are */
};

struct bem_panels {
  size_t n, room;      /* nodes in use and allocated; panels are one fewer, or as many in a closed
                          chain, which has each node once */
  double left, length; /* x of the left wall and L of the map, H */
  struct bem_period period; /* of a closed chain */
  int smooth;               /* all is integrated by the trapezoidal rule, see smooth.h */
  int kinked[2]; /* surface and mirror image meet at an angle there, as on walls that accelerate */
  int held[2];   /* edges on sides of a rectangle that move, which the integrator misses by its
                    tolerance */
  int mirrored[2]; /* whether stencils at the left and the right edge reach into the mirror image */
  double complex *zeta;   /* nodes in the mapped plane, [n], owned; so are all arrays below */
  double complex *dzeta;  /* d zeta / d z at the nodes, 1/H, [n] */
  double *re, *im;        /* zeta once more, for vector loops, [n] */
  double complex *middle; /* of the chord of a panel, [n - 1] */
  double complex *half;   /* half its chord: t = middle + half s, -1 <= s <= 1, [n - 1] */
  double *reach;          /* how near to its middle a point is near the panel, [n] */
  double *way; /* from the first panel's middle along the middles, and by what `reach` changes on
                  it, [n] */
  double complex (*basis)[BEM_STENCIL][BEM_STENCIL]; /* [n - 1][node][power of s] */
  double complex (*weight)[BEM_STENCIL];   /* integral of the node's basis function dt, [n - 1] */
  double *weight_re, *weight_im;           /* the same summed at each node, [n]; of a smooth surface
                                              the trapezoidal rule's, half of it on walls */
  double complex (*slope)[BEM_DERIVATIVE]; /* d/dzeta at a node from its stencil, [n] */
  struct bem_chart *chart; /* of the map near every node, [charts], owned; not for rectangles */
  size_t charts;
  const struct bem_conformal *walls; /* whose charts they are, and of which of its changes */
  size_t changes;
};

/* Makes room for n nodes (at least BEM_DERIVATIVE); zero *p before the first call. ERR_MEMORY. */
enum status bem_panels_reserve(struct bem_panels *p, size_t n);
void bem_panels_destroy(struct bem_panels *p);

double complex bem_map(double length, double complex z);
double complex bem_map_slope(double length, double complex z); /* d zeta / d z */

/* Takes over n nodes (x, y in H) for a map that closes a tank of the given length from `left` on.
 */
void bem_panels_set(struct bem_panels *p, size_t n, const double *x, const double *y, double left,
                    double length);

/* The same in a tank of any walls, with the first and the last node on these sides of them.
 * ERR_MEMORY, ERR_SOLVER. */
enum status bem_panels_set_walls(struct bem_panels *p, size_t n, const double *x, const double *y,
                                 const struct bem_conformal *walls, const size_t side[2]);

/* The same for the n nodes of one period. */
void bem_panels_set_round(struct bem_panels *p, size_t n, const double *x, const double *y,
                          const struct bem_period *period);

/* Complex velocity w = u - i v = d beta / dz at every node. */
void bem_panels_velocity(const struct bem_panels *p, const double *phi, const double *psi,
                         double complex *w);

static inline int bem_panels_closed(const struct bem_panels *p) {
  return p->period.length > 0;
}

static inline size_t bem_panels_count(const struct bem_panels *p) {
  return bem_panels_closed(p) ? p->n : p->n - 1;
}

/* Where the mirror image of a point of the mapped plane is. */
static inline double complex bem_panels_mirror(const struct bem_panels *p, double complex tau) {
  return bem_panels_closed(p) ? p->period.bed / conj(tau) : conj(tau);
}

/* First of `count` neighbouring nodes around the middle of panel j (of node k for odd counts);
 * beyond the edges, where stencils are mirrored, they are the mirror images of nodes. A closed
 * chain has no edges: stencils go on round it. */
static inline ptrdiff_t bem_stencil_first(const struct bem_panels *p, size_t at, size_t count) {
  const ptrdiff_t first = (ptrdiff_t)at - ((ptrdiff_t)count - 1) / 2;
  const ptrdiff_t most = (ptrdiff_t)(p->n - count);
  if (bem_panels_closed(p)) return first;
  if (first < 0) return p->mirrored[0] ? first : 0;
  return first > most && !p->mirrored[1] ? most : first;
}

/* The node at this place of a stencil, and whether it is its mirror image that stands there. */
static inline size_t bem_stencil_node(const struct bem_panels *p, ptrdiff_t at, int *image) {
  const ptrdiff_t last = (ptrdiff_t)p->n - 1;
  *image = 0;
  if (bem_panels_closed(p))
    return (size_t)(at < 0 ? at + last + 1 : at > last ? at - last - 1 : at);
  *image = at < 0 || at > last;
  return (size_t)(at < 0 ? -at : at > last ? 2 * last - at : at);
}

/* What an analytic function of these real and imaginary parts at the nodes is at such a place. */
static inline double complex bem_stencil_value(const struct bem_panels *p, ptrdiff_t at,
                                               const double *f, const double *h) {
  int image;
  const size_t k = bem_stencil_node(p, at, &image);
  return CMPLX(f[k], image ? -h[k] : h[k]);
}

/* No node: so far beyond the last that it is in no stencil of a closed chain either, seen once
 * round it. */
static inline size_t bem_stencil_none(const struct bem_panels *p) {
  return 2 * (p->n + BEM_STENCIL);
}

/* Where a node, or none, is in a stencil; outside it if it is not one of it. */
static inline ptrdiff_t bem_stencil_place(const struct bem_panels *p, ptrdiff_t first,
                                          size_t node) {
  const ptrdiff_t n = (ptrdiff_t)p->n, at = (ptrdiff_t)node - first;
  if (!bem_panels_closed(p) || at > n + BEM_STENCIL) return at;
  return at < 0 ? at + n : at >= n ? at - n : at;
}

/* Whether nodes of panel j's stencil are mirror images. */
static inline int bem_panel_is_mirrored(const struct bem_panels *p, size_t j) {
  return (j == 0 && p->mirrored[0]) || (j + 2 == p->n && p->mirrored[1]);
}
