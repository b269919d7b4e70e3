/* The solver `exact`: wave theory, written into a result file like any other run. */
#pragma once
#include "common/solver.h"

extern const struct solver exact_solver;
