/* The boundary as the integral equation sees it: the free surface in the plane of the map
 *     zeta = sin^2(pi (L - z) / (2 L)),   z = x + i y,
 * which opens the tank 0 < x < L, y > 0 into the lower half plane: the bed becomes 0 <= zeta <= 1,
 * the left wall zeta >= 1, the right wall zeta <= 0. There beta = phi + i psi with psi = 0 on the
 * walls continues to the upper half plane by Schwarz reflection, beta(conj zeta) = conj beta(zeta),
 * so the surface and its mirror image close the contour and walls need no nodes. Other tanks have a
 * map of their own, onto the upper half plane (conformal.h), where all of this holds as well.
 *
 * On the panel between nodes j and j+1 beta is the complex polynomial in zeta through BEM_STENCIL
 * neighbouring nodes (Vinje & Brevig 1981 use two; with four the velocity is of fourth order). */
#pragma once
#include <complex.h>
#include <stddef.h>

#include "bem/conformal.h"
#include "common/base/status.h"

enum {
  BEM_STENCIL = 4,    /* nodes that carry the polynomial of a panel */
  BEM_DERIVATIVE = 5, /* nodes that give d beta / d zeta at a node */
  BEM_PARALLEL = 2000 /* nodes from which work that is linear in them, or a product with the matrix,
                         is worth waking other threads for; the rows of the matrix always are */
};

struct bem_panels {
  size_t n, room;         /* nodes in use and allocated; panels are one fewer */
  double length;          /* L of the map, H */
  double complex *zeta;   /* nodes in the mapped plane, [n], owned; so are all arrays below */
  double complex *dzeta;  /* d zeta / d z at the nodes, 1/H, [n] */
  double *re, *im;        /* zeta once more, for vector loops, [n] */
  double complex *middle; /* of the chord of a panel, [n - 1] */
  double complex *half;   /* half its chord: t = middle + half s, -1 <= s <= 1, [n - 1] */
  double complex (*basis)[BEM_STENCIL][BEM_STENCIL]; /* [n - 1][node][power of s] */
  double complex (*weight)[BEM_STENCIL];   /* integral of the node's basis function dt, [n - 1] */
  double *weight_re, *weight_im;           /* the same summed at each node, [n] */
  double complex (*slope)[BEM_DERIVATIVE]; /* d/dzeta at a node from its stencil, [n] */
  struct bem_chart *chart; /* of the map near every node, [charts], owned; not for rectangles */
  size_t charts;
};

/* Makes room for n nodes (at least BEM_DERIVATIVE); zero *p before the first call. ERR_MEMORY. */
enum status bem_panels_reserve(struct bem_panels *p, size_t n);
void bem_panels_destroy(struct bem_panels *p);

double complex bem_map(double length, double complex z);
double complex bem_map_slope(double length, double complex z); /* d zeta / d z */

/* Takes over n nodes (x, y in H) for a map that closes a tank of the given length. */
void bem_panels_set(struct bem_panels *p, size_t n, const double *x, const double *y,
                    double length);

/* The same in a tank of any walls, with the first node on this side of them. ERR_MEMORY,
 * ERR_SOLVER.
 */
enum status bem_panels_set_walls(struct bem_panels *p, size_t n, const double *x, const double *y,
                                 const struct bem_conformal *walls, size_t side);

/* Complex velocity w = u - i v = d beta / dz at every node. */
void bem_panels_velocity(const struct bem_panels *p, const double *phi, const double *psi,
                         double complex *w);

/* First of `count` neighbouring nodes around the middle of panel j (of node k for odd counts). */
static inline size_t bem_stencil_first(size_t n, size_t at, size_t count) {
  size_t left = (count - 1) / 2;
  size_t first = at > left ? at - left : 0;
  return first + count > n ? n - count : first;
}
