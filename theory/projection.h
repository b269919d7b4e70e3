/* Filters that find the amplitude of the decaying mode in a column of velocities (T,
 * section 2.4.2). Units: g = H = 1. */
#pragma once
#include "theory/modes.h"

enum theory_filter {
  THEORY_FILTER_PLAIN,    /* int e^(kappa z) (v - i u)/(2 kappa int e^(2 kappa z)) (2.95) */
  THEORY_FILTER_WEIGHTED, /* the same with e^((kappa - 2 delta) z), e^(2 (kappa - delta) z): (2.94)
                             with psi_-1 = e^(kappa y), as it should be */
  THEORY_FILTER_EXACT,    /* (2.93) with the modes of the tank */
  THEORY_FILTER_PRINTED /* the first form of (2.94), int e^((kappa - 3 delta) z) ((kappa - delta) v
                           - i kappa u)/((2 kappa^2 - 2 kappa delta + delta^2) int e^(2 (kappa - 2
                           delta) z)) */
};
extern const char *const theory_filter_names[], *const theory_filter_helps[];

/* What the filter finds in the potential psi e^(i kappa x): 1 in its own decaying mode, of the
 * printed one in e^((kappa - delta) y). */
double theory_filter_apply(enum theory_filter filter, const struct theory_mode *decaying,
                           double (*psi)(double y, const void *with),
                           double (*slope)(double y, const void *with), const void *with);
