/* How accurate a run shall be: `accuracy` in place of resolution and tolerances; and the
 * coarser run that says how accurate it is. */
#pragma once
#include "bem/options.h"
#include "common/case/case.h"

/* The coarser run: spacings so many times as wide, and the order at which errors are taken to fall.
 * That of the dam break's surface (docs/accuracy.md); those of gentle waves fall with the fourth,
 * so their bars are wide. */
static const double BEM_COARSER = 1.5, BEM_ORDER = 2;

/* Fills what a run with the key `accuracy` does not say itself. */
void bem_accuracy_settle(const struct case_file *c, struct case_run *r);

/* *coarser becomes run *r with everything coarser that its numbers depend on: resolution,
 * tolerances, film, filter and smoothing. o: its options, to be kept with it. */
void bem_accuracy_coarsen(const struct case_file *c, const struct case_run *r,
                          struct bem_options *o, struct case_run *coarser);
