/* The linear system for psi at the inner surface nodes (psi = 0 at the two contact points; a closed
 * chain has inner nodes only), and who
 * solves it: LAPACK's dense factorisation for few nodes; for many GMRES (SUNDIALS SPGMR), without a
 * preconditioner: the system is of the second kind, its condition number 2 to 33 in a dam break,
 * and a factorised near field saved fewer iterations than it cost. The bits do not depend on the
 * number of threads. */
#pragma once
#include "bem/kernel/panels.h"

struct bem_solve; /* opaque: it holds handles of SUNDIALS */

struct bem_solve_options {
  double tolerance;   /* of GMRES, residual relative to the right-hand side */
  size_t dense_up_to; /* nodes that are still solved by dense factorisation */
};

struct bem_solve_counts {
  double assemblies, iterations, dense_factorisations;
};

enum status bem_solve_create(const struct bem_solve_options *options, struct bem_solve **s);
void bem_solve_destroy(struct bem_solve *s);

/* Assembles the matrix of these panels and finds psi (H sqrt(gH)) from phi; psi on entry is the
 * guess that GMRES starts from. keep: keep what bem_solve_again needs. ERR_SOLVER, ERR_MEMORY. */
enum status bem_solve_first(struct bem_solve *s, const struct bem_panels *p, const double *phi,
                            double *psi, int keep);
/* The same matrix with another right-hand side. Call after bem_solve_first with keep. */
enum status bem_solve_again(struct bem_solve *s, const double *phi, double *psi);

struct bem_solve_counts bem_solve_count(const struct bem_solve *s);
