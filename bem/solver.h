/* Fully nonlinear potential flow in a tank of straight walls by boundary elements (mixed
 * Eulerian-Lagrangian: Longuet-Higgins & Cokelet 1976; complex potential: Vinje & Brevig 1981). */
#pragma once
#include "common/solver.h"

extern const struct solver bem_solver;
