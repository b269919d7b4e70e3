/* The weakly compressible SPH solver of P, as the rest of the program sees it. */
#pragma once
#include "common/solver.h"

extern const struct solver sph_solver;
