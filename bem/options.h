/* What a run of this solver may set; the table behind it is in solver.c. */
#pragma once
#include <stdbool.h>

struct bem_options {
  double accuracy;          /* that sets the others, 0: none was asked for */
  bool error_bars;          /* found by a coarser run */
  double tolerance;         /* of CVODE */
  double gmres;             /* relative residual of the boundary system */
  int dense;                /* nodes solved by dense factorisation */
  double film;              /* thickness below which the film on the wall is cut, m */
  double rounding;          /* radius of the arcs at kinks of the water's outline, m */
  double lattice;           /* spacing of points inside the water that are written, m; 0: none */
  bool forces;              /* on the walls are written */
  double filter, smoothing; /* rates, 1/sqrt(H/g) */
};

/* H: thickness of the film at the wall when the surface is cut there after the impact. */
static const double BEM_IMPACT = 0.01;
