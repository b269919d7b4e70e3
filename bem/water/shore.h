/* The walls of a tank that is not rectangular as the water knows them: those between its edges. The
 * sides that the edges are on go straight on for ever, so that a bend that the water has not come
 * to does not touch the flow; each stretch of walls has a map of its own. */
#pragma once
#include "bem/water/flow.h"

struct bem_shore {
  size_t n;              /* points of the walls, which bend at all but the first and the last */
  double complex *point; /* H, from the top of the left side, [n], owned */
  bool *keep;            /* which of them walls may go straight on at, [n], owned */
  size_t side[2];        /* segments that the edges of the water are on */
  struct bem_conformal **map; /* of segments i to j, at [i n + j], or NULL; all owned */
};

/* Walls through n points (H); keep: those that are kept though walls go straight on there, [n].
 * ERR_MEMORY. */
enum status bem_shore_create(size_t n, const double (*point)[2], const bool *keep,
                             struct bem_shore **s);
void bem_shore_destroy(struct bem_shore *s);

/* Whether walls through n points do not meet themselves if their first and last sides go on. */
enum status bem_shore_goes_on(size_t n, const double complex *point, bool *simple);

/* Takes the edges to be on the segments that these two points (H) are on, and gives the surface the
 * map for that. ERR_MEMORY, ERR_SOLVER. */
enum status bem_shore_place(struct bem_shore *s, const double complex edge[2],
                            struct bem_surface *surface);

/* Whether the left or the right edge is on the segment that ends at the top of the walls. */
bool bem_shore_at_top(const struct bem_shore *s, bool right);

/* Way along its segment from an edge at z to the upper end of it, or to the lower one; negative
 * beyond it. */
double bem_shore_way(const struct bem_shore *s, bool right, bool up, double complex z);

/* Whether an edge has come to a bend that it is to pass now: 1 up, -1 down the walls, else 0. */
int bem_shore_arrives(const struct bem_shore *s, const struct bem_surface *surface, bool right);

/* Lets that edge of the surface of f go on, on the next segment, and places the nodes anew. Call
 * after bem_flow_solve. ERR_MEMORY, ERR_SOLVER. */
enum status bem_shore_pass(struct bem_shore *s, struct bem_flow *f, bool right, int way);
