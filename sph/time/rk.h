/* Explicit Runge-Kutta methods as tables that share one step (P, section IV). */
#pragma once
#include "sph/time/integrator.h"

struct rk_table {
  int stages;
  double a[SPH_MAX_STAGES][SPH_MAX_STAGES], b[SPH_MAX_STAGES];
};

extern const struct rk_table sph_rk_classic; /* of order 4 */

/* The step of method->table, as struct sph_integrator's. */
enum status sph_rk_step(struct sph *s, const struct sph_integrator *method, double dt,
                        struct sph_totals *spent, bool *held);
