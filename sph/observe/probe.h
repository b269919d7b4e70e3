/* Pressure sensors on the walls. */
#pragma once
#include "common/case/case.h"
#include "sph/sph.h"

/* Pressure (Pa) fitted to the water by moving least squares (mls.h), from the packs of the last
 * sph_pack_pressure_of_probes: at the probe's centre, or its mean along the wall over the probe's
 * size, by points half a particle spacing apart or closer. 0 where there is no water within the
 * support, NaN where any of it is behind a side that moves. ERR_MEMORY. */
enum status sph_probe(const struct sph *s, const struct case_probe *probe,
                      const struct geo_lines *walls, double *pressure);
