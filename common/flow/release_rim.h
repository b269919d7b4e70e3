/* The rim of water, as straight edges that are wall or surface, and the bends at which the pressure
 * is not smooth (release_mesh.h). */
#pragma once
#include <stdbool.h>

#include "common/base/geometry.h"

/* What an edge is: within the water, a wall, the surface, a wall without thickness that has water
 * on both sides. */
enum release_kind { RELEASE_INSIDE, RELEASE_WALL, RELEASE_SURFACE, RELEASE_SLIT };

struct release_rim {
  double end[2][2]; /* m; the water is on the left */
  enum release_kind kind;
  size_t ring; /* edges of one closed line, in order, have the same; SIZE_MAX: of none, a slit */
};

struct release_bend {
  double at[2];  /* m */
  double lambda; /* the pressure goes like r^lambda there */
};

struct release_rims {
  size_t n, room, bends, bend_room;
  struct release_rim *edge;  /* [n], owned */
  struct release_bend *bend; /* [bends], owned */
  struct geo_box box;        /* m */
  double size, reach;        /* m: of triangles away from bends; from a bend, where that begins */
};

/* Arguments as those of release_mesh_create. ERR_MEMORY. */
enum status release_rims_create(const struct geo_lines *water, const struct geo_lines *walls,
                                double size, double near, struct release_rims *r);
void release_rims_destroy(struct release_rims *r);

/* Whether a body of water has no surface, walls being all round it; a place of its rim. */
bool release_rims_closed(const struct release_rims *r, double at[2]);

/* How large triangles should be at a point, m. */
double release_rims_size(const struct release_rims *r, const double at[2]);
