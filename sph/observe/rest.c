#include "sph/observe/rest.h"

#include "common/base/geometry_check.h"
#include "common/flow/flow.h"
#include "sph/fluid/energy.h"
#include "sph/pair/eos.h"

/* g (integral of d e(d) dA) by the midpoint rule in layers of the tank. */
static enum status find_compression(const struct case_file *c, const struct sph *s, double level,
                                    double *sum) {
  const double bed = c->tank.min[1], D = level - bed;
  const size_t n = geo_intervals(D, s->dx);
  struct eos at_rest = s->eos;
  double below = 0, area, centre[2];
  at_rest.level = D; /* counted from the bed */
  *sum = 0;
  for (size_t j = 0; j < n; j++) {
    const double Y = ((double)j + 0.5) * D / (double)n, p = s->rho0 * s->g * (D - Y);
    const double rho = eos_stored(&at_rest, eos_driving_of(&at_rest, p, Y), Y);
    TRY(geo_area_below(&c->walls, bed + ((double)j + 1) * D / (double)n, &area, centre));
    *sum += s->g * (D - Y) * (rho - s->rho0) * (area - below);
    below = area;
  }
  return OK;
}

enum status sph_rest_find(const struct case_file *c, const struct sph *s, double *potential) {
  if (c->rectangular && !case_is_turned(c)) {
    *potential = sph_rest_potential(s);
    return OK;
  }
  *potential = c->flow == &flow_still ? sph_energy(s).potential : case_rest_potential(c);
  if (c->flow == &flow_still || case_is_turned(c)) return OK;
  const double level = case_rest_level(c);
  double mass = 0, compression;
  for (size_t i = 0; i < s->f.n; i++) mass += s->f.m[i];
  TRY(find_compression(c, s, level, &compression));
  *potential += s->g * level * (mass - s->rho0 * case_water_area(c)) - compression;
  return OK;
}
