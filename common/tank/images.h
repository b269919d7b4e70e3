/* Water goes on beyond the tank as images of itself, each by a rigid motion: behind walls, for
 * walls that fill them with particles and for the free surface (common/cloud); and beyond the ends
 * of a periodic tank, for both. An image of an image is one, too.
 *
 * A particle is mirrored in every face of the walls (faces.h) on which it has its foot, and turned
 * half round about every corner of the water on both of whose faces it has one. At a corner of 90
 * to 180 degrees water that fills the corner is thereby continued to every side exactly once.
 * Beside a blunt corner of the solid the images in either face go as far as the bisector. At an
 * edge, whose sides see images of their own, water beside a face has an image in it
 * beyond the edge, too. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/tank/faces.h"
#include "common/tank/tank.h"

/* A rigid motion of the plane, r' = at + M r with M orthogonal, which turns velocities and
 * gradients too. */
struct rigid {
  double at[2], M[2][2]; /* m, 1 */
};

struct rigid rigid_mirror(const double a[2], const double b[2]); /* in the line ab */
struct rigid rigid_half_turn(const double about[2]);
struct rigid rigid_shift(double x, double y);

/* A vector, turned as the motion turns it. */
static inline void rigid_turn(const struct rigid *m, double x, double y, double *to_x,
                              double *to_y) {
  *to_x = m->M[0][0] * x + m->M[0][1] * y;
  *to_y = m->M[1][0] * x + m->M[1][1] * y;
}

/* Of a face. */
struct reflector {
  double from, to;        /* where feet are, 0 at a and 1 at b, for images to be found */
  bool sharp[2];          /* at a, at b: see images_counts */
  double across[2][2];    /* at a, at b: normal to the bisector of a blunt corner, out of its
                             part; or 0 */
  struct rigid motion[2]; /* the mirror in it, the half turn about a */
};

/* What a point has beyond the tank. */
struct image {
  uint32_t motion; /* images_motion */
  double x, y;     /* where it has it, m */
};

/* Of any points beside the same walls, or in the same periodic tank. */
struct images {
  size_t n, room;
  struct faces faces;
  struct reflector *wall; /* [n], one for each of the faces, owned */
  bool *here;             /* [n], scratch, owned */
  struct geo_box *beside; /* [n]: out of which nothing has an image in it, owned */
  double reach;           /* m */
  size_t n_shifts, shift_room;
  struct rigid *shift;   /* [n_shifts], by whole periods, owned */
  struct geo_box around; /* in which shifted images are */
  size_t found_room;
  struct image *found; /* [2 n or n_shifts], owned */
};

/* The walls beside which images are, thin up to `thin` (m, faces.h); they are not kept. Without
 * thin ones all images are in one room, and edges are divided like blunt corners. ERR_MEMORY. */
enum status images_set_walls(struct images *t, const struct geo_lines *walls, double thin);

/* The walls have moved to where these faces of the same walls are, whose corners have kept their
 * angles. */
void images_move(struct images *t, const struct faces *faces);

/* How far from the line of a segment points have images in it, and how far beyond its ends (m). */
void images_set_reach(struct images *t, double reach, double beyond);
void images_destroy(struct images *t);

/* The periods of a tank, in which images are within `reach` (m) of it. ERR_MEMORY. */
enum status images_set_periods(struct images *t, const struct tank *tank, double reach);

/* The images of a point behind walls, or beyond the ends of the periodic tank that it is in, into
 * t->found; returns how many. */
size_t images_of(struct images *t, double x, double y);
size_t images_beyond(struct images *t, double x, double y);

static inline const struct rigid *images_motion(const struct images *t, uint32_t motion) {
  return motion < 2 * t->n ? &t->wall[motion / 2].motion[motion % 2] : &t->shift[motion - 2 * t->n];
}

/* Whether an image that has been found `beyond` the ends, or before the point moved to (x, y),
 * counts there: while the foot is on the face, and the image on its side of the bisectors. At a
 * sharp corner, of 90 degrees or less on the left of the walls, where the tank is, it counts beyond
 * the end too: a point there has only passed through the other wall; and at an edge. */
bool images_counts(const struct images *t, uint32_t motion, double x, double y);
