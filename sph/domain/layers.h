/* Wall particles that keep their places behind the walls: a lattice that fills the walls to the
 * depth of the support, its first layer half a spacing behind them.
 *
 * Behind each face (faces.h) lies a strip of it, stretched along the face so that it divides that
 * evenly. Corners of the water have between the strips of their faces a square of the same lattice,
 * where they are right angles, and rings about the vertex else. Blunt corners of the solid are
 * divided between their faces along the bisector. At its edges, and in the middle of the end of a
 * thin wall, where each face has particles of its own (sight.h), the strip goes on beyond. The area
 * of every particle is that of its cell, or of what is left of that.
 *
 * Each particle has a mirror point, that it is the image of by a rigid motion: a reflection in its
 * face, or a half turn about a corner. Where another wall is in the way, such as in corners that
 * are sharper than a right angle, the point lies half-way to it.
 *
 * Near a blunt corner of the solid, wall particles do not slide. With the velocity that the water
 * has along their faces, still water started to circulate there: past the end of a face they flow
 * into each other or into the water, which gives and takes volume, and the walls fed that. At H/dx
 * = 20 the flow grew as exp(t/3), t in sqrt(H/g), up to 0.3 sqrt(gH) over a wedge and round a step.
 * Within a support of the corner they have none of that velocity, from two supports on all; for
 * viscosity the wall is a little rough there. Fast water passes before any of that has grown, and
 * past walls that do not slide it loses its order: of a dam break over a step (H/dx = 20) the
 * budget of energy was off by 0.04 E0 in place of 0.008. So walls slide as water comes near a
 * fiftieth of the speed of sound, which is a fifth of what c0 allows it. A hinge, which is straight
 * twice a period, is no such corner.
 *
 * Where sides of the tank move, the lattice behind each face goes with it, and is stretched where
 * the face gets longer: how many cells there are is settled anew when they are a tenth off. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/status.h"
#include "sph/sph.h"

/* How the strip behind a face, and the corner at its end, are divided. */
struct sph_division {
  size_t cells, beyond; /* and as many past an edge, or half an end, as its support needs */
  bool upright, back;   /* steeper than 45 degrees; counted from its end */
  double turn;          /* of the corner, rad */
};

/* Before they are sorted. */
struct sph_site;

/* The particles in the order of the grid; arrays but those of the wall are [room], padded with the
 * last one. */
struct sph_layers {
  size_t n, room;
  double *x, *y;      /* mirror point, m */
  double *V;          /* m^2 */
  double *slide;      /* how much of the velocity along its face one has: 0 to 1 */
  uint32_t *motion;   /* which one turns what is at the mirror point */
  struct rigid *turn; /* of face k the mirror, 2 k, and the half turn about its beginning,
                              2 k + 1; owned */
  struct sph_division *division; /* of each face, owned */
  size_t n_sites, site_room;
  struct sph_site *site; /* [n_sites], owned */
  uint32_t *order;       /* [n], sites in the order of the grid, owned */
  double *sx, *sy;       /* scratch of the sort, as `key`, [n], owned */
  uint32_t *key;
};

/* Makes s->w.grid, .n, .x, .y and .chain, too. ERR_MEMORY; ERR_INPUT as sph_grid_create. */
enum status sph_layers_create(struct sph *s, struct sph_layers *g);

/* Walls have moved: the particles follow; and are sorted anew, by new numbers. ERR_MEMORY. */
void sph_layers_move(struct sph *s, struct sph_layers *g);
enum status sph_layers_sort(struct sph *s, struct sph_layers *g);
void sph_layers_destroy(struct sph_layers *g);
