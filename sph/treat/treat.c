#include "sph/treat/treat.h"

#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/pair/rates.h"

static const struct sph_treatment *const treatments[] = {
#define X(name, ...) &sph_treatment_##name,
    SPH_TREATMENTS(X)
#undef X
};

/* Where the budget has their terms. */
static const size_t terms[] = {
#define X(name, ...) offsetof(struct sph_budget, name),
    SPH_TREATMENTS(X)
#undef X
};

enum status sph_treat_create(struct sph *s) {
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++)
    if (s->scheme.every[k] != 0 && treatments[k]->create)
      TRY(treatments[k]->create(s, &s->treated[k]));
  return OK;
}

void sph_treat_destroy(struct sph *s) {
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++)
    if (treatments[k]->destroy) treatments[k]->destroy(s->treated[k]);
}

static bool is_due(const struct sph *s, int treatment) {
  const int every = s->scheme.every[treatment];
  if (every < 0) return s->steps > 0 && treatments[treatment]->due(s);
  return every > 0 && s->steps > 0 && s->steps % (size_t)every == 0;
}

static enum status apply(struct sph *s, int treatment) {
  TRY(sph_neighbours_update(s));
  sph_pack_water(s);
  s->wall->fill(s);
  const double before = sph_energy(s).total;
  treatments[treatment]->apply(s);
  sph_particles_pad(&s->f);
  *(double *)((char *)&s->budget + terms[treatment]) += before - sph_energy(s).total;
  return OK;
}

enum status sph_treat(struct sph *s) {
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++)
    if (is_due(s, k)) TRY(apply(s, k));
  return OK;
}

static const struct sph_correction *const corrections[] = {
#define X(name, ...) &sph_correction_##name,
    SPH_CORRECTIONS(X)
#undef X
};

void sph_treat_rates(struct sph *s, int stage, size_t cluster, struct sph_totals *totals) {
  for (int k = 0; k < SPH_CORRECTION_COUNT; k++)
    if (s->scheme.strength[k] > 0) corrections[k]->rates(s, stage, cluster, totals);
}
