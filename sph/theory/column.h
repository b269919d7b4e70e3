/* Disturbances of water at rest between a bed and a free surface, in columns of particles that are
 * all alike: the rates of its fields, linearised, are blocks between a column and its neighbours,
 * and a wave e^(i k x) of wavenumber k sees their sum with e^(-i k m dx), whose eigenvalues are how
 * such waves grow and oscillate.
 *
 * The blocks are differences of the solver's own rates (sph_rates), so of any forms, derivative,
 * walls and free surface. Where the columns do not start at rest, their rates at the start, with
 * coefficients frozen, are not those of the water, which moves; those of rows that have settled
 * are. */
#pragma once
#include "sph/sph.h"

struct sph_column;

/* Lets rows that do not start at rest settle: steps of the run, after each of which columns are
 * made alike and the water is slowed, until no acceleration is above `least` (m s^-2). ERR_SOLVER:
 * they do not settle in 30 times that sound takes from bed to surface, or fall apart: accelerations
 * or speeds cut the step to less than a tenth of what water at rest has (sph_timestep_is_cut), or
 * are not finite. */
enum status sph_column_settle(struct sph *s, double least);

/* Of the state now, which is left as it was. ERR_INPUT: the columns are not alike, or fewer
 * than see each other and one more. ERR_SOLVER: rates are not finite. */
enum status sph_column_create(struct sph *s, struct sph_column **out);
void sph_column_destroy(struct sph_column *c); /* NULL is fine */

size_t sph_column_rows(const struct sph_column *c);
/* Columns to either side, and rows, that the rates of a particle may depend on. */
size_t sph_column_reach(const struct sph_column *c);
double sph_column_unrest(const struct sph_column *c); /* largest |acceleration|, m s^-2 */

/* The eigenvalues of waves of k dx = `turn` a column, 1/s: re[n] + i im[n], n = 5 rows of them.
 * `v` [rows], or NULL: the magnitude of the vertical velocity of the one that grows most, from the
 * bed up. ERR_SOLVER. */
enum status sph_column_spectrum(const struct sph_column *c, double turn, double *re, double *im,
                                double *v);
