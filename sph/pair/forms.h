/* What the forms of a scheme (momentum, continuity, equation of state) are together. */
#pragma once
#include "common/case/case.h"
#include "sph/pair/momentum.h"
#include "sph/sph.h"

/* Whether the sums of momentum and continuity are adjoint, so that pairs of water exchange kinetic
 * and elastic energy without loss, whatever the disorder. */
bool sph_forms_adjoint(const struct sph_scheme *o);

/* Refuses what makes no sense together, for a reason that the message gives. */
void sph_forms_check(const struct case_run *r, struct problems *problems);

/* The first of these: its key, and what follows "found "; NULL when there is none. */
const char *sph_forms_refusal(const struct sph_scheme *o, const char **key);

/* What a user of these forms should know before the run; NULL when there is nothing. */
const char *sph_forms_warning(const struct sph_scheme *o, double g /* m s^-2 */);

/* What may help a run that goes astray, of what this scheme uses, and the warning. */
enum { SPH_ADVICE = 400 };
void sph_forms_advise(const struct sph *s, char advice[SPH_ADVICE]);

/* The gradient of the driving pressure in water at (x, y) whose velocity (u, v) in the frame of the
 * tank changes by A (m/s^2), Pa/m, by the momentum equation: from the density that evolves. */
static inline struct sph_vector sph_weight(const struct sph *s, double stored, double x, double y,
                                           double u, double v, const double A[2]) {
  const double rho = momentum_density((enum sph_momentum)s->scheme.momentum, s->rho0,
                                      eos_density(&s->eos, stored, y));
  double f[2];
  sph_force_at(&s->force, x, y, u, v, f);
  return (struct sph_vector){rho * (f[0] - A[0]), rho * (f[1] - A[1])};
}
