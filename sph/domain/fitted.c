#include "sph/domain/fitted.h"

#include "sph/sph.h"

void sph_fitted_set(struct sph *s) {
  if (!s->fitted) return;
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    const double y = s->f.w.y[i];
    if (s->fitted[s->f.id[i]])
      s->f.w.rho[i] = eos_stored(&s->eos, eos_driving_of(&s->eos, 0, y), y);
  }
}

void sph_fitted_rates(struct sph *s, int stage, size_t cluster) {
  if (!s->fitted) return;
  for (size_t i = cluster * SPH_LANES; i < (cluster + 1) * SPH_LANES && i < s->f.n; i++)
    if (s->fitted[s->f.id[i]]) s->f.k[stage].rho[i] = -eos_density_rises(&s->eos) * s->f.w.v[i];
}
