/* Quadrature along the walls of a tank in the plane of its map, where they are the real axis: Gauss
 * and Legendre's points on panels that become shorter towards the bends, where dz/dzeta is a power
 * of the distance; on the panel at a bend a power of that is the variable. */
#pragma once
#include "bem/map/conformal.h"

enum { BEM_RULE = 16 }; /* points of a panel */

/* The points of a panel from -1 to 1, their weights, and those of interpolation between them
 * (Berrut & Trefethen 2004); integral[j][k]: of the polynomial that is one at point k and zero at
 * the others, from -1 to point j. */
struct bem_gauss {
  double point[BEM_RULE], weight[BEM_RULE], between[BEM_RULE], integral[BEM_RULE][BEM_RULE];
};

struct bem_rule_panel {
  double start, half; /* half < 0: laid from right to left */
  size_t side, bend;  /* of the walls; that it goes on from */
  double power;       /* zeta = start + 2 half u^power, from u = 0 to 1; of a bend more than 1 */
};

struct bem_rule {
  size_t panels, room;
  struct bem_rule_panel *panel; /* [panels], owned, as all arrays are */
  double *xi, *weight;          /* points, and |d xi| for each, [BEM_RULE panels] */
  double complex *z, *slope;    /* the points of the walls, H, and dz / d xi there */
  struct bem_gauss gauss;
};

/* Zero *r before the first call. */
void bem_rule_clear(struct bem_rule *r);
void bem_rule_destroy(struct bem_rule *r);

/* Adds a side of the walls between two of its points in the plane of the map, of which those that
 * are bends are given as such. levels: panels at a bend are 3^-levels of the way to what is nearest
 * to it; longest: that a panel is on the wall, H. ERR_MEMORY. */
enum status bem_rule_add(struct bem_rule *r, const struct bem_conformal *m, size_t side,
                         const double end[2], int levels, double longest);
