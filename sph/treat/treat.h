/* The phase of a step in which the water is treated: before the rates. */
#pragma once
#include "sph/sph.h"

/* A treatment, whose name, help and keys are in list.h. */
struct sph_treatment {
  /* What it keeps from step to step, into s->treated[the treatment]; or NULL. */
  enum status (*create)(struct sph *s, void **own);
  void (*destroy)(void *own); /* both or neither; of NULL, too */
  /* Changes the evolving fields; positions by less than the lists allow. The water is packed
   * (sph_pack_water) and wall particles are filled, and what is in either pack may be overwritten:
   * both are filled anew before they are read again. */
  void (*apply)(struct sph *s);
};

#define X(name, help) extern const struct sph_treatment sph_treatment_##name;
SPH_TREATMENTS(X)
#undef X

enum status sph_treat_create(struct sph *s);
void sph_treat_destroy(struct sph *s);

/* Applies those that are due after s->steps steps, in the order of the list. What each takes out
 * of the energy is a term of the budget with its name. */
enum status sph_treat(struct sph *s);
