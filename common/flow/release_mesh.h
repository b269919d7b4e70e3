/* Triangles that fill water between walls and free surfaces, for the released pressure (release.h).
 *
 * Nodes stand along the outline and, inside, in the middle of the leaves of a quadtree; a Delaunay
 * triangulation joins them, and pieces of the outline that are no side of it are halved until all
 * are. They are graded towards bends where the pressure is not smooth, r^lambda with lambda = pi/a
 * at an angle a between two walls or two surfaces, pi/(2 a) between wall and surface (Grisvard,
 * Elliptic Problems in Nonsmooth Domains, 1985, sec. 2.3): a distance of `size` (r/R)^(1 -
 * lambda/2) keeps the order 2 there, and what bends do to the pressure far from them (Babuska,
 * Kellogg & Pitkaranta, Numer. Math. 33, 1979). */
#pragma once
#include "common/flow/release_rim.h"

struct release_edge {
  size_t end[2];
  enum release_kind kind;
};

struct release_mesh {
  size_t nodes, triangles, edges;
  double (*p)[2];            /* m, [nodes], owned */
  size_t (*corner)[3];       /* nodes, counter-clockwise, [triangles], owned */
  size_t (*across)[3];       /* the edge across from each corner, [triangles], owned */
  struct release_edge *edge; /* [edges], owned */
};

/* `size`: of triangles away from bends, m; those of tips and narrow parts are smaller. What is
 * within `near` (m) is the same place. The surface is what lies along no wall. ERR_MEMORY,
 * ERR_SOLVER. */
enum status release_mesh_create(const struct geo_lines *water, const struct geo_lines *walls,
                                double size, double near, struct release_mesh **out);
void release_mesh_destroy(struct release_mesh *m); /* NULL is fine */
