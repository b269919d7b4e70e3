/* The walls as faces: straight pieces with the water on their left, as long as they are straight,
 * each of which knows what follows it. A wall that neither makes the tank nor is closed has water
 * on both sides and is two faces, to and fro.
 *
 * Faces form chains. A chain ends where a wall does, at edges, which are corners of the solid of 30
 * degrees or less, and in the middle of the end of a wall that is thin. Within a chain there are
 * corners of the water, of less than 180 degrees, and blunt corners of the solid. The water on both
 * sides of a blunt corner is one water, as it is around the corner of a step. What is on the other
 * side of an edge is hidden: there each side has a solid of its own, without an end behind it. That
 * shakes the water next to the edge, at a tenth of sqrt(gH) where it should rest. As one water it
 * rests, to 0.7 % around a step of 90 degrees (H/dx = 20, 20 sqrt(H/g)), to 3 and 4 % around a
 * wedge of 44 and 30 degrees that it covers; one of 44 degrees that holds it on one side only, to 2
 * %.
 *
 * The two sides of a thin wall, each with its half of the end, have solids of their own, too; but
 * water before the end is one with that on either side (sight.h). */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"

enum face_end {
  FACE_END_TOP,    /* nothing follows: water may pass over it */
  FACE_END_CORNER, /* of the water; or a straight one, where another wall meets this one */
  FACE_END_BLUNT,  /* of the solid */
  FACE_END_EDGE,   /* of the solid, where a chain ends */
  FACE_END_HALF /* of the end of a thin wall, whose other half goes on straight in another chain */
};

#define FACE_NONE     UINT32_MAX
#define FACE_NO_POINT UINT32_MAX

struct face {
  double a[2], b[2]; /* m */
  double t[2];       /* unit vector from a to b */
  double length;     /* m */
  enum face_end end[2];
  double turn;           /* of the next face against this one, anticlockwise, rad */
  uint32_t before, next; /* or FACE_NONE */
  uint32_t chain;
  uint32_t point[2]; /* of the walls, at a and b; or FACE_NO_POINT where another wall divides one */
};

struct faces {
  size_t n, room;
  struct face *face; /* [n], owned */
  size_t n_tops, top_room;
  uint32_t *top; /* ends over which water may pass: 2 k of face k's beginning, 2 k + 1; owned */
};

/* Replaces what is in *f. Walls are thin up to `thin` (m); points that `bends` marks (NULL: none)
 * are corners, even where the walls are straight. ERR_MEMORY. */
enum status faces_set(struct faces *f, const struct geo_lines *walls, double thin,
                      const bool *bends);

/* The points of the walls have moved: what follows what stays, but that a corner of the water may
 * become a blunt one of the solid, and back. */
void faces_move(struct faces *f, const double (*p)[2]);
void faces_destroy(struct faces *f);

/* The first face at whose end mirror images of the water do not fill the solid once: at corners of
 * the water that are sharper than a right angle they overlap, at those of the solid they jump from
 * face to face. Or FACE_NONE. */
uint32_t faces_unfilled(const struct faces *f);

/* How far a point is to the left of the line of a face, where the water is, m. */
static inline double face_distance(const struct face *f, double x, double y) {
  return f->t[0] * (y - f->a[1]) - f->t[1] * (x - f->a[0]);
}

/* How far along a face a point's foot is, m. */
static inline double face_along(const struct face *f, double x, double y) {
  return f->t[0] * (x - f->a[0]) + f->t[1] * (y - f->a[1]);
}

/* How far a point is from a face, m. */
static inline double face_way(const struct face *f, double x, double y) {
  const double s = face_along(f, x, y), off = face_distance(f, x, y);
  const double past = s < 0 ? -s : s > f->length ? s - f->length : 0;
  return past > 0 ? hypot(off, past) : off;
}

/* Whether the straight way from p to q goes through a face from the water into the solid; *part is
 * how much of the way is before it. Water counts to the water as far as `slack` (m) behind the
 * face. */
bool face_stops(const struct face *f, const double p[2], const double q[2], double slack,
                double *part);
