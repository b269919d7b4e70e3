/* Tridiagonal systems that go round: symmetric and positive definite, with a coefficient between
 * the last unknown and the first. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* Solves for n_f right-hand sides f[i stride], [n] each, in place, n >= 3. diagonal[n], beside[n]
 * (beside[i] between unknowns i and i + 1, the last one between the last and the first) are used
 * up; scratch: [n]. ERR_SOLVER when the matrix is not positive definite. */
enum status bem_cyclic_solve(size_t n, double *diagonal, double *beside, size_t n_f, size_t stride,
                             double *f, double *scratch);
