/* The first guess of psi at the nodes, from those of the last evaluations: the polynomial in time
 * through them. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

enum { BEM_GUESSES = 3 };

struct bem_guess {
  size_t n, room, count;    /* nodes, allocated for; instants that are known */
  double time[BEM_GUESSES]; /* the latest first */
  double *psi[BEM_GUESSES]; /* [n] each, in `memory` */
  double *memory;           /* owned */
};

/* Forgets all; room for n nodes. ERR_MEMORY. */
enum status bem_guess_begin(struct bem_guess *g, size_t n);
void bem_guess_destroy(struct bem_guess *g);

/* Sets psi to the guess for a time; as it is when nothing is known. */
void bem_guess_make(const struct bem_guess *g, double time, double *psi);
/* Remembers psi as found at a time, in the place of what was found there or later. */
void bem_guess_keep(struct bem_guess *g, double time, const double *psi);
