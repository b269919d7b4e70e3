/* What treatments of waves in a periodic tank share: the surface at rest, and pressures that are
 * counted from the hydrostatic one below it. */
#pragma once
#include "sph/sph.h"

/* Height of the water's surface at rest, m. */
double sph_treat_level(const struct sph *s);

/* Volume of water that belongs to a particle: of the first row, where it lies on the surface, half,
 * since the other half of its cells is above. */
double sph_treat_volume(const struct sph *s, size_t i);

/* p - rho0 g (level - y) of a particle, Pa; and its density anew from that. */
double sph_treat_dynamic(const struct sph *s, size_t i, double level);
void sph_treat_set_dynamic(struct sph *s, size_t i, double level, double p);

/* Whether |sum V v|, which waves have none of, has grown to growth_limit L^2 sqrt(g L), L the
 * length of the tank (thesis, 4.2.4: a tenth of the waves' amplitude, over L, for the limit). */
bool sph_treat_has_grown(const struct sph *s);
