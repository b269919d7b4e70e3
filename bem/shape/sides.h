/* Where the surface comes near itself or a wall. The other side of a node is the nearest place of
 * the surface that is much farther along it than straight on: across water it ends a sheet, a film
 * or a neck, across air it closes a cavity. All of it is of the polygon through the nodes, so a
 * distance of zero is the first moment at which that crosses itself. */
#pragma once
#include <complex.h>

#include "bem/shape/stretches.h"
#include "bem/shape/surface.h"

enum { BEM_BUBBLE = 12 }; /* panels round less air or water than is worth following */

struct bem_sides {
  size_t room;
  double *arc; /* along the surface to every node, H, [room], owned */
  size_t stretch_room;
  struct bem_stretch *stretch; /* [stretch_room], owned */
};

enum bem_between { BEM_WATER, BEM_AIR };

struct bem_near {
  double distance; /* H */
  double around;   /* the way to the other side along the surface, H; infinite to a wall that it is
                      not on */
  size_t node;     /* on one side */
  size_t panel;    /* on the other; of no meaning when that is a wall */
  bool wall;
  double x, y; /* the place on the other side */
};

/* Two panels that cross, `first` before `last`: what lies between them is a loop. In a closed chain
 * that goes on behind its last node, and `last` may be n - 1 or more. */
struct bem_crossing {
  size_t first, last;
  double x, y;
  double area; /* of the water (H^2) in the loop, negative: of the air */
};

/* Number of walls with ends, and the ends of one, the water on the left of the way from a to b. The
 * right wall of a rectangular tank is none while the front does not feel it. */
size_t bem_sides_walls(const struct bem_surface *s);
size_t bem_sides_held(const struct bem_surface *s,
                      bool right); /* that an end of the surface is on */
void bem_sides_wall(const struct bem_surface *s, size_t wall, double complex *a, double complex *b);

/* Whether the water at an end of the surface meets its wall at more than a right angle. */
bool bem_sides_is_blunt(const struct bem_surface *s, bool right);

enum status bem_sides_reserve(struct bem_sides *w, const struct bem_surface *s);
void bem_sides_destroy(struct bem_sides *w);

/* Takes over a state (x[n], y[n]) of a surface like *s: the lengths along it, its stretches. */
void bem_sides_set(const struct bem_sides *w, const struct bem_surface *s, const double *state);

/* The other side of node k within `reach`, of the surface alone; false: there is none. */
bool bem_sides_across(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                      size_t k, enum bem_between between, double reach, struct bem_near *near);

/* The same of the walls. */
bool bem_sides_wall_across(const struct bem_sides *w, const struct bem_surface *s,
                           const double *state, size_t k, enum bem_between between, double reach,
                           struct bem_near *near);

/* Whether node k has gone through the nearest wall, with this between them before; distance < 0. */
bool bem_sides_outside(const struct bem_surface *s, const double *state, size_t k,
                       enum bem_between between, struct bem_near *near);

/* The narrowest place, within `reach`; false: there is none. */
bool bem_sides_narrowest(const struct bem_sides *w, const struct bem_surface *s,
                         const double *state, enum bem_between between, double reach,
                         struct bem_near *near);

/* The first panel that crosses another from `from` on, and the first that it crosses. */
bool bem_sides_cross(const struct bem_sides *w, const struct bem_surface *s, const double *state,
                     size_t from, struct bem_crossing *c);
