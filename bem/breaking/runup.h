/* How high an edge of the water comes on the side that it slides along: the highest of the maxima
 * of its height, each of the parabola through three steps. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

struct bem_runup {
  size_t n;        /* steps since the edge was last moved */
  double at[3][3]; /* the last three: time, x, y (sqrt(H/g), H) */
  double top[3];   /* the highest so far, of the same; top[2] = 0: none */
};

/* The edge has been moved: what comes next is no way on from where it was. */
void bem_runup_moved(struct bem_runup *u);

/* Takes over the edge of a surface after a step. */
void bem_runup_add(struct bem_runup *u, double time, double x, double y);

/* Whether it has come up from where it was at t = 0, by more than is of account, and gone down. */
bool bem_runup_found(const struct bem_runup *u, double start);
