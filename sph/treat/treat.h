/* The phase of a step in which the water is treated: after the neighbour lists were brought up to
 * date, before the rates. */
#pragma once
#include "sph/sph.h"
#include "sph/treat/list.h"

/* Each changes the evolving fields of the packed water (sph_pack_water, wall particles filled);
 * positions by less than the lists allow. */
#define X(name, help) void sph_treat_##name(struct sph *s);
SPH_TREATMENTS(X)
#undef X

/* Applies those that are due after s->steps steps, in the order of the list. What they take out of
 * the energy is booked with that of the diffusion, whose part they play. */
enum status sph_treat(struct sph *s);
