/* Energies of the water, J per metre of width; the elastic one is that of eos.h. */
#pragma once
#include "common/result/result.h"
#include "common/solver.h"
#include "sph/sph.h"

enum {
#define X(name, ...) SPH_TERM_##name,
  SPH_TERMS(X)
#undef X
      SPH_TERM_COUNT
};
_Static_assert((int)SPH_TERM_COUNT <= (int)RESULT_TERMS, "a result holds them all");
extern const struct solver_term sph_terms[SPH_TERM_COUNT];

struct result_energy sph_energy(const struct sph *s);
double sph_energy_of(const struct sph *s, size_t i); /* total energy of one particle */

/* Potential energy of the same mass at rest in the tank: compressed by its own weight according to
 * the solver's equation of state, and summed over layers of the solver's spacing, as water that
 * starts at rest is (initial.h), so that such water lies exactly zero above it. Without the
 * compression, which raises the mass of a region by g H/2c0^2 of it, small waves would drown: that
 * offset is (2/3) (g H/c0^2) (H/a)^2 times the energy of a wave of amplitude a. */
double sph_rest_potential(const struct sph *s);
double sph_volume(const struct sph *s); /* sum of m/rho, m^2 */
