/* The right-hand side of P eq. (1). */
#pragma once
#include "sph/pair/loops.h"
#include "sph/sph.h"

/* Rates of the state s->f.w into s->f.k[stage], totals into s->totals. Walls, and at stage 0 the
 * lists, are brought up to date first. With `diffuse` the diffusive term is evaluated (unless it
 * has steps of its own, s->split) and kept in s->f.D; without, the kept one is used again (P eq.
 * (25)). With `bounds` totals.acceleration2 and .speed are found as well. */
enum status sph_rates(struct sph *s, int stage, bool diffuse, bool bounds);

/* What wall particles do to a cluster's water, by their pressure and by viscosity, m s^-2. */
struct sph_push {
  double x[SPH_LANES], y[SPH_LANES];
  double drag_x[SPH_LANES], drag_y[SPH_LANES];
};

/* That of wall particles which have these packs, and as viscosity has them these others (which may
 * be the same), as in the last sph_rates; of derivatives other than those of the kernel nobody can
 * tell. */
void sph_rates_push(const struct sph *s, const struct sph_targets *i, const struct sph_near *walls,
                    const struct sph_pack *pressing, const struct sph_pack *holding,
                    struct sph_push *p);

/* Copies the water's state to the neighbours' side of the pair loops (pressure from the density);
 * or the pressure alone, where volumes are to stay as they are. */
void sph_pack_water(struct sph *s);
void sph_pack_pressure(struct sph *s);

/* sph_pack_water with the pressure itself where another drives the water (eos.h). */
void sph_pack_pressure_of_probes(struct sph *s);
