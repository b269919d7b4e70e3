/* The smoothed volume fraction of a particle cloud, on a grid:
 *     F(x) = sum_j V_j W(x - x_j),   W(r) = exp(-r^2/s^2) / (pi s^2),   s = dx.
 * Water that touches a wall is continued through it, and beyond the ends of a periodic tank
 * (images.h). */
#pragma once
#include <stdbool.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/tank/images.h"

struct cloud {
  size_t n;
  const double *x, *y;  /* m, [n] */
  const double *volume; /* m^2, [n]; NULL: dx^2 each */
  double dx;            /* mean spacing, m */
  /* Beyond whose periodic ends, if it has any, the water goes on; or NULL. Particles are in it. */
  const struct tank *tank;
};

enum {
  CLOUD_BAND = 32
}; /* rows of nodes that one thread fills; a particle reaches into two at most */

/* Nodes lie at whole multiples of half a particle spacing, so that they do not shift from one
 * output to the next. */
struct cloud_fraction {
  double dx, spacing;   /* of particles and of nodes, m */
  double origin[2];     /* node (0, 0) of the whole cloud, m */
  size_t first, nx, ny; /* columns first .. first + nx - 1 of the nodes are there, all rows */
  double *f;            /* F, [ny] rows, `stride` apart, of [nx] */
  size_t stride;
  double *memory; /* of f: rows go on at both ends, where particles reach beyond the strip; owned */
  size_t room;

  struct images images, beyond; /* behind walls; of periodic ends */
  struct geo_lines walls;       /* scratch */
  struct cloud_source *source;  /* particles and images, [sources], owned */
  size_t sources, source_room;
  size_t *band; /* where the list of each band of rows begins, [bands + 1], owned */
  size_t band_room;
  uint32_t *listed; /* sources that reach into a band, in order, [band[bands]]; owned */
  size_t list_room;
};

/* F of the particles, continued through `walls` (none: nowhere), those that are periodic ends left
 * out, on the nodes from x = strip[0] to
 * strip[1] (m), where the cloud reaches so far, by all threads: each node has the same bits for any
 * number of them and any strip that it is in. Particles that are not finite, or farther out of the
 * box of the walls than its diagonal, are left out. ERR_MEMORY; ERR_INPUT when the particles are so
 * scattered that no grid fits. */
enum status cloud_fraction_fill(struct cloud_fraction *g, const struct cloud *c,
                                const struct geo_lines *walls, const double strip[2]);
void cloud_fraction_destroy(struct cloud_fraction *g); /* frees the arrays */

/* Whether no particle is near the rows j and j + 1. */
static inline bool cloud_fraction_is_dry(const struct cloud_fraction *g, size_t j) {
  return g->band[j / CLOUD_BAND] == g->band[(j + 1) / CLOUD_BAND + 1];
}
