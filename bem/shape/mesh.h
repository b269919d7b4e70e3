/* Where the nodes should be, and how they get there without regridding: each moves with the normal
 * velocity of the water and with a tangential velocity of its own that keeps the wanted spacing, so
 * that the time integrator is re-initialised only when their number no longer fits. */
#pragma once
#include "bem/shape/curve.h"
#include "bem/shape/surface.h"

enum { BEM_MOST_NODES = 6000 }; /* on a surface: their dense matrix takes 0.3 GB */

struct bem_mesh {
  double resolution; /* nodes per H where the surface is smooth */
  struct {           /* scratch: no call finds there what another has left */
    size_t room;
    double *memory;  /* [11 room], owned: of the arrays below, [room] each */
    double *rho;     /* nodes wanted per length of the panel after a node, 1/H */
    double *share;   /* nodes that the panel after a node is worth */
    double *growth;  /* rate at which the water changes that, sqrt(g/H) */
    double *dx, *dy; /* d/di and d2/di2 of the nodes' places, H */
    double *ddx, *ddy;
    double *bend;              /* square of the curvature that counts, 1/H^2 */
    double *diagonal, *beside; /* of a tridiagonal matrix */
    double *round;             /* for one that goes round */
  } work;
  struct bem_curve curve; /* scratch of regridding */
};

enum status bem_mesh_reserve(struct bem_mesh *m, size_t n);
void bem_mesh_destroy(struct bem_mesh *m);

/* Tangential velocity of every node relative to the water. u, v: velocity of the water; tx, ty:
 * unit tangents (output); q: output; all [n]. state: x[n], y[n], of a surface like *s. */
void bem_mesh_velocity(struct bem_mesh *m, const struct bem_surface *s, const double *state,
                       const double *u, const double *v, double *tx, double *ty, double *q);

/* Whether the number of nodes or their spacing has left what the shape asks for. */
bool bem_mesh_is_poor(struct bem_mesh *m, const struct bem_surface *s);

/* New nodes on the same curve (not-a-knot splines of x, y, phi in arc length, piece by piece).
 * ERR_MEMORY; ERR_SOLVER when the shape asks for more nodes than can be served. */
enum status bem_mesh_regrid(struct bem_mesh *m, struct bem_surface *s);
