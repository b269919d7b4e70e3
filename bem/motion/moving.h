/* Walls of any shape of which sides move: pistons and flaps. The map is found anew whenever it is
 * asked for at another time, from where its parameters were: a few steps of Newton's method. */
#pragma once
#include <stdbool.h>

#include "bem/map/conformal.h"
#include "bem/motion/flux.h"
#include "common/case/case.h"

struct bem_moving {
  const struct case_file *c;
  size_t vertex[BEM_MOST_BENDS + 2]; /* of the case's walls, that each point of the map is */
  struct bem_conformal *map;         /* at `time`; owned; NULL: nothing moves */
  size_t changes;                    /* of the map, whichever it was */
  double time;                       /* sqrt(H/g) */
  double complex velocity[BEM_MOST_BENDS + 2]; /* of the points */
  struct bem_rigid body[BEM_MOST_BENDS + 1];   /* what the sides of the map move like */
  struct bem_rigid rate[BEM_MOST_BENDS + 1];   /* d/dt of that */
};

/* Which points of the case's walls are hinges that walls may bend at, [c->walls.points]. */
void bem_moving_keep(const struct case_file *c, bool *keep);

/* From the map of walls where the case draws them. ERR_MEMORY. */
enum status bem_moving_start(struct bem_moving *m, const struct case_file *c,
                             const struct bem_conformal *at_rest);
/* *m becomes a copy of *like. ERR_MEMORY. */
enum status bem_moving_follow(struct bem_moving *m, const struct bem_moving *like);
void bem_moving_destroy(struct bem_moving *m);

/* Moves the walls. ERR_SOLVER. */
enum status bem_moving_set(struct bem_moving *m, double time);

/* Where a point of a wall that is named by its place at rest is. */
double complex bem_moving_place(const struct bem_moving *m, double complex z);

/* d/dt of the map's parameters. */
struct bem_map_rate {
  double xi[BEM_MOST_BENDS], power[BEM_MOST_BENDS];
  double complex factor; /* of its logarithm */
  bool drifts;           /* what is followed goes along with the images of all bends, see sweep.h */
};

/* turns: all walls have a flux, as those of a tank that rolls. ERR_MEMORY, ERR_SOLVER. */
enum status bem_moving_rate(const struct bem_moving *m, bool turns, struct bem_map_rate *rate);
