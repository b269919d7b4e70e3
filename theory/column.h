/* Sound in a column of particles at rest under gravity, by RK4, perturbations e^(i k y) (T, section
 * 2.6.4.1), dx = h: matrices of a step for position over h, velocity times dt/h, and density over
 * rho_f. s1 = sin kh, s2 = sin^2(kh/2). */
#pragma once
#include "theory/linear.h"

/* How (2.273) is read. It stands with five entries that are not those of RK4, and the text that we
 * have of it is not sure in its third row. */
enum theory_reading {
  THEORY_LITERAL, /* as it stands */
  THEORY_SIGN,    /* the minus before the first entry of the third row as a mark of the layout */
  THEORY_FIRST    /* 8/3 for 1/3 in the first entry, which others suggest */
};
extern const char *const theory_reading_names[], *const theory_reading_helps[];
struct theory_matrix theory_column_printed(double courant, double kh, enum theory_reading reading);

/* y' = u,  u' = -(c/h)^2 [(8 theta s2 - 2 i theta' h s1) y + i s1 r],  r' = -i (s1/h) u. With
 * theta = 1 and theta' = 0 that is (2.270)-(2.272) as printed, whose factor -8 c^2 s2/h^2 belongs
 * to a pressure c^2 rho_f that was not subtracted; with P = c^2 (rho - rho_f), theta = 2 delta |y|
 * and theta' = -2 delta. `slope` is theta' h. The rates are dt times these. */
struct theory_matrix theory_column_rates(double courant, double kh, double theta, double slope);
struct theory_matrix theory_column_step(double courant, double kh, double theta, double slope);

/* The column whose particles have the masses that rest needs, m = rho h, and gamma = 1: 2 x 2, of
 * position and velocity. `stratification` is delta h. */
struct theory_matrix theory_column_stratified(double courant, double kh, double theta,
                                              double stratification);
