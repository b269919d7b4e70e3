#include "sph/treat/treat.h"

#include "common/case/case.h"
#include "sph/domain/fitted.h"
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

static const char *const names[] = {
#define X(name, ...) #name,
    SPH_TREATMENTS(X)
#undef X
};

/* Two particles to the shortest wave, and one for the mean. */
static void check_waves(const struct case_file *c, const struct case_run *r,
                        struct problems *problems) {
  const struct sph_scheme *o = r->options;
  const double length = c->tank.max[0] - c->tank.min[0];
  const size_t most = (geo_intervals(length, c->H / r->resolution) - 1) / 2;
  if (o->every[SPH_TREATMENT_projection] == 0 || (size_t)o->projection_modes <= most) return;
  problems_add(problems, case_run_line(r, "projection_modes"),
               "runs.%s.projection_modes: found %d, more waves than particles tell apart along a "
               "tank of %g m; allowed: at most %zu; lower it or raise the resolution",
               r->name, o->projection_modes, length, most);
}

void sph_treat_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems) {
  const struct sph_scheme *o = r->options;
  const char *other = NULL; /* that makes densities anew */
  for (int k = 0; k < SPH_TREATMENT_COUNT; k++) {
    if (o->every[k] == 0) continue;
    if (treatments[k]->periodic && !c->periodic[0])
      problems_add(problems, case_run_line(r, names[k]),
                   "runs.%s.%s: found in a tank whose sides are walls; allowed: with tank.sides: "
                   "periodic, where waves are harmonics of its length; write %s: 0",
                   r->name, names[k], names[k]);
    if (treatments[k]->weighs && case_is_turned(c))
      problems_add(
          problems, case_run_line(r, names[k]),
          "runs.%s.%s: found under gravity along (%g, %g), where no wave has the pressures "
          "that it gives; allowed: with gravity downwards; write %s: 0",
          r->name, names[k], c->down[0], c->down[1], names[k]);
    if (treatments[k]->weighs && c->gravity == 0)
      problems_add(
          problems, case_run_line(r, names[k]),
          "runs.%s.%s: found in water without weight, whose waves it takes pressures from; "
          "allowed: with gravity; write %s: 0",
          r->name, names[k], names[k]);
    if (treatments[k]->redensify && other)
      problems_add(problems, case_run_line(r, names[k]),
                   "runs.%s.%s: found beside %s; allowed: one of the treatments that make "
                   "densities anew, since the last would undo the other; leave one out",
                   r->name, names[k], other);
    if (treatments[k]->redensify) other = names[k];
  }
  check_waves(c, r, problems);
}

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
  sph_wall_fill(s);
  const double before = sph_energy(s).total;
  TRY(treatments[treatment]->apply(s));
  s->applied[treatment]++;
  sph_fitted_set(s);
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
