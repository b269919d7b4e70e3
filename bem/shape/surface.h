/* The free surface: nodes from the left wall's contact point to the right one, water on the right.
 * Inside the solver H = g = rho = 1. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "bem/map/conformal.h"
#include "bem/shape/period.h"
#include "common/base/status.h"

enum bem_end { BEM_END_WALL, BEM_END_BED }; /* what the last node slides along */

struct bem_surface {
  size_t n, room;
  double *state; /* x[n], y[n], phi[n]: H, H, H sqrt(gH); owned */
  bool smooth;   /* its nodes are those of a smooth periodic curve, see smooth.h */
  size_t corner; /* node where the outline has a kink; 0: none */
  enum bem_end right;
  double tip;  /* the last node is the thin tip of a sheet: spacing there over that of the smooth
                  surface; 0: it is not */
  double film; /* thickness below which sheets are cut, H */
  double depth, volume; /* mean depth of the water, H, and how much of it there is, H^2 */
  const struct bem_conformal *walls; /* NULL: those of a rectangular tank */
  size_t side[2];                    /* of the walls, which the first and the last node are on */
  bool blunt[2]; /* the angle of the water there was more than a right one when the integrator was
                    last started */
  double left, tank; /* x of the walls of a rectangular tank, H */
  double length;     /* of the tank that the map closes: longer until the tip has met the wall, H */
  struct bem_period period; /* of water without sides: the last node is the first, a period on */
};

static inline bool bem_surface_is_closed(const struct bem_surface *s) {
  return s->period.length > 0;
}

static const double BEM_TOE = 0.15; /* of water that is to run along a dry bed, see `tip` */

struct bem_totals {
  double volume, kinetic, potential; /* H^2, rho g H^3, rho g H^3 (y from 0) */
};

/* In mean depths: water on the right wall above this is film, half of it where it is so near the
 * wall; thin spikes come loose there. */
static const double BEM_FILM_HIGH = 3.5, BEM_FILM_THIN = 0.32;

enum status bem_surface_reserve(struct bem_surface *s, size_t n); /* keeps nothing */
void bem_surface_destroy(struct bem_surface *s);

/* Gives *s what is known of the shape of *like, and room for n nodes in memory of its own; its
 * nodes are to be set. */
enum status bem_surface_follow(struct bem_surface *s, const struct bem_surface *like, size_t n);

/* *s becomes *fresh, which is not to be used any more. */
void bem_surface_replace(struct bem_surface *s, const struct bem_surface *fresh);

/* Keeps the contact points on their walls: takes away what would move them off, where x and y are
 * the components of a velocity at the nodes, [n]; or the last node of a closed chain at the first.
 */
void bem_surface_hold_ends(const struct bem_surface *s, double *x, double *y);

/* d/di and d2/di2 of a nodal quantity by five-point differences that do not reach over the kink. */
void bem_surface_differences(const struct bem_surface *s, const double *f, double *first,
                             double *second /* or NULL */);

/* 0 in the high part of the film on the right wall, 1 elsewhere, smoothly: the thin spikes that the
 * film throws there are of no account and must not be followed into ever finer detail. */
double bem_surface_importance(const struct bem_surface *s, double x, double y);

/* Integrals over the water from the surface alone: psi = 0 on the walls, and kinetic energy is
 * -1/2 integral phi d psi. Cubic interpolation in the node number: fourth order. */
struct bem_totals bem_surface_totals(const struct bem_surface *s, const double *psi);

/* Integral of f dg along the surface, of two nodal quantities, by the same quadrature. */
double bem_surface_integral(const struct bem_surface *s, const double *f, const double *g);

/* Rate at which a rate of change of the nodes (x[n], y[n], phi[n]) changes the energy of the water,
 * rho g H^3 per unit of that rate, by the same quadrature, with heights counted from `level`: what
 * it does to the volume is an error of the volume. psi, u, v: of this surface. turn: rate at which
 * the frame turns about the point that is at -origin in it; the energy is that of the motion in it.
 */
struct bem_spinning {
  double turn;
  double complex origin;
};
double bem_surface_power(const struct bem_surface *s, double level, const double *psi,
                         const double *u, const double *v, struct bem_spinning frame,
                         const double *rate);
