/* Energies of the water, J per metre of width.
 *
 * Elastic energy per mass, from de = p / rho^2 d rho with p = c0^2 (rho - rho0) and e(rho0) = 0:
 *   e = c0^2 (ln(rho/rho0) + rho0/rho - 1).
 * With it the discrete momentum and continuity equations of P eq. (1) exchange kinetic and elastic
 * energy without loss (rates.c). */
#pragma once
#include "common/result.h"
#include "sph/sph.h"

struct result_energy sph_energy(const struct sph *s);
double sph_energy_of(const struct sph *s, size_t i); /* total energy of one particle */
double sph_volume(const struct sph *s);              /* sum of m/rho, m^2 */
