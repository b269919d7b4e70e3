/* Sides of the tank that move: pistons and flaps (common/tank/motion.h). The faces follow their
 * points, and whatever is an image in a face, or a ghost behind it, follows the face.
 *
 * Behind a face whose normal n is into the water, which is at a + s t and turns at the rate w,
 * water goes on with the velocity R u + 2 (V.n) n, V.n = a'.n + w s: then it moves at the wall as
 * the wall does. On the wall n.(r - a) = 0 at any time; its second derivative is the acceleration
 * of the water there along n,
 *
 *   A = a''.n + w' s + 2 w (u - a').t,
 *
 * so that dp/dn = rho (f.n - A). About the vertex of a corner water is turned half round against
 * the vertex. */
#pragma once
#include <stdbool.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"
#include "common/tank/faces.h"

struct case_file;
struct sph;

struct sph_sides {
  bool move;               /* any does; without, all that follows is empty */
  struct geo_lines rest;   /* the walls as the case draws them, owned */
  struct geo_lines now;    /* where they are, owned */
  double (*v)[2], (*a)[2]; /* of their points, m/s and m/s^2, [points], owned */
  double (*listed)[2];     /* where they were when the walls were listed, m, [points], owned */
  double (*then)[2];       /* scratch, [2 points], owned */
  bool *rides, *bends;     /* points of sides that move; hinges of flaps; [points], owned */
  struct face *before;     /* the faces at the start of the step, [faces], owned */
  double near;             /* m: points closer than this are the same */
  double at;               /* s: when they are there */
  double speed;            /* of the fastest point, m/s */
};

/* The sharpest corner of water or solid that a flap of the case makes at its hinge, rad; pi without
 * one. ERR_MEMORY. */
enum status sph_sides_sharpest(const struct case_file *c, double *angle);

/* Before the faces, to which `bends` belongs; and what needs these. ERR_MEMORY. */
enum status sph_sides_create(struct sph *s, const struct case_file *c);
enum status sph_sides_attach(struct sph *s);
void sph_sides_destroy(struct sph *s);

/* Walls where they are: those at rest are `rest`. */
const struct geo_lines *sph_sides_walls(const struct sph *s, const struct geo_lines *rest);

/* The sides are where they are at t (s). */
void sph_sides_set(struct sph *s, double t);

/* Walls are listed; a step begins. */
void sph_sides_list(struct sph *s);
void sph_sides_begin(struct sph *s);

/* How far anything that follows a wall has gone along with it, at t (s) or now, since the walls
 * were listed, m; an image of still water goes twice as far. */
double sph_sides_way(const struct sph *s, double t);

/* Where a point of the walls is that is p in the case, m. */
void sph_sides_carry(const struct sph *s, double p[2]);

/* Whether such a point is behind a side, where there is none of the water. */
bool sph_sides_hide(const struct sph *s, const double p[2]);

/* What the motion of a wall does to water that is turned by `motion` (images.h) from p, where it
 * moves with u. */
struct sph_drive {
  double V[2], A[2]; /* the velocity and acceleration of the wall, along its normal, m/s, m/s^2 */
  double held[2];    /* that of the wall itself, m/s */
};
struct sph_drive sph_sides_drive(const struct sph *s, uint32_t motion, const double p[2],
                                 const double u[2]);

/* Where a point would be now, had it gone with a face since the step began. */
void sph_sides_follow(const struct sph *s, uint32_t face, const double p[2], double now[2]);
