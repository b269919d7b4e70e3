/* The water of a run at rest. */
#pragma once
#include "common/case/case.h"
#include "sph/sph.h"

/* Potential energy, J/m, of the run's particles when they have come to rest in the tank, compressed
 * by their own weight. In rectangular tanks exactly; of still water in others as it is set up,
 * cells that slopes cut included; else to first order in g H/c0^2, the compression: with the excess
 * e(d) of the density at a depth d below the level eta of the case's water, and m - rho0 A of the
 * mass over it, that of the incompressible water plus g eta (m - rho0 A) - g (integral of d e(d)
 * dA). Where gravity is turned, that of the incompressible water. ERR_MEMORY. */
enum status sph_rest_find(const struct case_file *c, const struct sph *s, double *potential);
