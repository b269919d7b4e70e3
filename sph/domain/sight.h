/* Who sees whom past the walls. Water meets a wall particle only if the straight way to it enters
 * the solid through the chain of faces (faces.h) that the particle continues the water behind, and
 * other water only if no wall stands between them that parts them (the visibility criterion of
 * Belytschko, Lu & Gu, Int. J. Numer. Meth. Engng 37, 1994, for cracks). So what a wall does fades
 * as the water rises above its top and vanishes where the water passes over, and the two sides of a
 * thin wall know nothing of each other: each has wall particles of its own, as many as there were
 * if the solid behind it had no end. From before the end of such a wall all water is seen, and from
 * everywhere what is before it; of wall particles those inside the solid.
 *
 * Nearly everywhere all that is near is seen. A grid knows where: there nobody asks. */
#pragma once
#include "common/tank/faces.h"
#include "sph/fluid/neighbours.h"

struct sph_sight {
  double x0, y0, per; /* lower left corner, m; cells a metre */
  size_t nx, ny;
  uint32_t *first; /* [nx * ny + 1], owned */
  uint32_t *face;  /* those within the reach of each cell, owned */
  size_t room;
  unsigned char *plain;      /* [nx * ny], whether all that is near is seen, owned */
  const struct faces *faces; /* the caller's */
};

/* For ways of up to `reach` (m). ERR_MEMORY. */
enum status sph_sight_create(struct sph_sight *t, const struct faces *faces, double reach);
void sph_sight_destroy(struct sph_sight *t);

/* The faces that a way from (x, y) may meet; none far from walls. */
const uint32_t *sph_sight_faces(const struct sph_sight *t, double x, double y, size_t *n);

/* Whether a point sees all that is near. */
bool sph_sight_is_plain(const struct sph_sight *t, double x, double y);

/* The face that the way from p to q enters the solid through first, and where (face_stops); or
 * FACE_NONE. */
uint32_t sph_sight_first(const struct sph_sight *t, const double p[2], const double q[2],
                         double slack, double *part);

/* Marks in the lists of n targets the sources that a target does not see (neighbours.h): water, or
 * wall particles that continue the water behind these chains; those farther than `reach` (m) are
 * nobody's. ERR_MEMORY. */
enum status sph_sight_mark(const struct sph_sight *t, struct sph_lists *lists, size_t n,
                           const double *x, const double *y, const struct sph_sources *sources,
                           const uint32_t *chain, double reach);
