/* Water goes on beyond the tank as images of itself, each by a rigid motion: behind walls, for
 * mirror walls (mirror.c) and for the free surface (fraction.c); and beyond the ends of a periodic
 * tank (period.h, and the free surface again). An image of an image is one, too.
 *
 * A particle is mirrored in every segment of the walls on which it has its foot, and turned half
 * round about every vertex on both of whose segments it has one. At a corner of 90 to 180 degrees,
 * straight ones included, water that fills the corner is thereby continued to every side exactly
 * once. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/tank/tank.h"

/* A rigid motion of the plane, r' = at + M r with M orthogonal, which turns velocities and
 * gradients too. */
struct sph_motion {
  double at[2], M[2][2]; /* m, 1 */
};

struct sph_motion sph_motion_mirror(const double a[2], const double b[2]); /* in the line ab */
struct sph_motion sph_motion_half_turn(const double about[2]);
struct sph_motion sph_motion_shift(double x, double y);

/* A vector, turned as the motion turns it. */
static inline void sph_motion_turn(const struct sph_motion *m, double x, double y, double *to_x,
                                   double *to_y) {
  *to_x = m->M[0][0] * x + m->M[0][1] * y;
  *to_y = m->M[1][0] * x + m->M[1][1] * y;
}

/* A segment of the walls, from a to b. */
struct sph_reflector {
  double a[2], b[2];           /* m */
  double from, to;             /* where feet are, 0 at a and 1 at b, for images to be found */
  bool sharp[2];               /* at a, at b: see sph_images_counts */
  bool starts, closes;         /* a piece; closes: ends where that starts */
  uint32_t first, before;      /* segment of the piece; the one that ends in a, or itself */
  struct sph_motion motion[2]; /* the mirror in it, the half turn about a */
};

/* What a point has beyond the tank. */
struct sph_image {
  uint32_t motion; /* sph_images_motion */
  double x, y;     /* where it has it, m */
};

/* Of any points beside the same walls, or in the same periodic tank. */
struct sph_images {
  size_t n, room;
  struct sph_reflector *wall; /* [n], in the order of the walls, owned */
  struct geo_box *beside;     /* [n]: out of which nothing has an image in it, owned */
  double reach;               /* m */
  size_t n_shifts, shift_room;
  struct sph_motion *shift; /* [n_shifts], by whole periods, owned */
  struct geo_box around;    /* in which shifted images are */
  size_t found_room;
  struct sph_image *found; /* [2 n or n_shifts], owned */
};

/* The walls beside which images are; they are not kept. ERR_MEMORY. */
enum status sph_images_set_walls(struct sph_images *t, const struct geo_lines *walls);

/* How far from the line of a segment points have images in it, and how far beyond its ends (m). */
void sph_images_set_reach(struct sph_images *t, double reach, double beyond);
void sph_images_destroy(struct sph_images *t);

/* The periods of a tank, in which images are within `reach` (m) of it. ERR_MEMORY. */
enum status sph_images_set_periods(struct sph_images *t, const struct tank *tank, double reach);

/* The images of a point behind walls, or beyond the ends of the periodic tank that it is in, into
 * t->found; returns how many. */
size_t sph_images_of(struct sph_images *t, double x, double y);
size_t sph_images_beyond(struct sph_images *t, double x, double y);

static inline const struct sph_motion *sph_images_motion(const struct sph_images *t,
                                                         uint32_t motion) {
  return motion < 2 * t->n ? &t->wall[motion / 2].motion[motion % 2] : &t->shift[motion - 2 * t->n];
}

/* Whether an image that has been found `beyond` the ends, or before the point moved to (x, y),
 * counts there: while the foot is on the segment. At a sharp corner, of 90 degrees or less on the
 * left of the walls, where the tank is, it counts beyond the end too: a point there has only passed
 * through the other wall. */
bool sph_images_counts(const struct sph_images *t, uint32_t motion, double x, double y);
