/* Explicit Runge-Kutta methods as tables that share one step (P, section IV). */
#pragma once
#include "sph/fluid/particles.h"

struct rk_table {
  int stages;
  double a[SPH_MAX_STAGES][SPH_MAX_STAGES], b[SPH_MAX_STAGES];
};
