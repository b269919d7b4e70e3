/* Treatments of the water between steps. One is a file in this folder with a function
 * sph_treat_NAME, and a line here: X(name, help) makes the key NAME of a run, the number of steps
 * after which it is applied again, 0 for never. */
#pragma once

#define SPH_TREATMENTS(X)                                                                          \
  X(shepard, "every so many steps, pressures become means weighted by W V (Shepard); 0: never")

enum {
#define X(name, help) SPH_TREATMENT_##name,
  SPH_TREATMENTS(X)
#undef X
      SPH_TREATMENT_COUNT
};
