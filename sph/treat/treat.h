/* Treatments of the water: the phase of a step in which some are applied, before the rates, and
 * what others add to the rates. */
#pragma once
#include "sph/sph.h"

/* A treatment between steps, whose name, help and keys are in list.h. */
struct sph_treatment {
  /* What it keeps from step to step, into s->treated[the treatment]; or NULL. */
  enum status (*create)(struct sph *s, void **own);
  void (*destroy)(void *own); /* both or neither; of NULL, too */
  /* Whether it is due, where a case has a word (list.h) for the number of steps; or NULL. */
  bool (*due)(const struct sph *s);
  /* Changes the evolving fields; positions by less than the lists allow. The water is packed
   * (sph_pack_water) and wall particles are filled, and what is in the packs, and s->f.p, may be
   * overwritten: they are filled anew before they are read again. */
  enum status (*apply)(struct sph *s);
  bool periodic;  /* in a tank with periodic sides only */
  bool redensify; /* it makes densities anew from masses: one of those is enough */
  bool weighs;    /* it takes pressures from the weight of the water */
};

/* A correction of the rates of a cluster, into s->f.k[stage], from the packed water and walls; what
 * it takes out, W/m, into the total of its name. */
struct sph_correction {
  void (*rates)(struct sph *s, int stage, size_t cluster, struct sph_totals *totals);
};

#define X(name, ...) extern const struct sph_treatment sph_treatment_##name;
SPH_TREATMENTS(X)
#undef X
#define X(name, ...) extern const struct sph_correction sph_correction_##name;
SPH_CORRECTIONS(X)
#undef X

struct case_file;
struct case_run;
struct problems;
/* Adds to `problems` the treatments of a run that make no sense in the case. */
void sph_treat_check(const struct case_file *c, const struct case_run *r,
                     struct problems *problems);

enum status sph_treat_create(struct sph *s);
void sph_treat_destroy(struct sph *s);

/* Applies those that are due after s->steps steps, in the order of the list. What each takes out
 * of the energy is a term of the budget with its name. */
enum status sph_treat(struct sph *s);

/* Adds to a cluster's rates what corrections there are. */
void sph_treat_rates(struct sph *s, int stage, size_t cluster, struct sph_totals *totals);
