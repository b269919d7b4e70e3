/* Numbers that tell how noisy a run is, and what its water does to the walls, found at the sampling
 * interval from the state and the rates of the evaluation that a step begins with. Each is a line
 * here and a series of the result file: X(name, unit, help). */
#pragma once
#include "common/result/result.h"
#include "sph/sph.h"

/* Of runs with `diagnostics`. Inner particles: those with sum V W > 0.9 over the water. The noise
 * of a field is the root mean square, over them, of the field less its mean weighted by V W. */
#define SPH_NOISES(X)                                                                              \
  X(shaking, "1",                                                                                  \
    "sum |du/dt|^2 over N g^2 (thesis, eq. (4.56)); water that falls freely counts 1")             \
  X(inner, "1", "share of particles inside the water, sum V W > 0.9 (its walls left out)")         \
  X(noise_u, "1", "rms of u less its kernel mean, inside, over sqrt(gH)")                          \
  X(noise_v, "1", "rms of v less its kernel mean, inside, over sqrt(gH)")                          \
  X(noise_p, "1", "rms of the pressure less its kernel mean, inside, over rho g H")                \
  X(noise_ax, "1", "rms of du/dt less its kernel mean, inside, over g")                            \
  X(noise_ay, "1", "rms of dv/dt less its kernel mean, inside, over g")                            \
  X(compressed, "1", "share of particles whose density is off rho0 by more than 1 %")

/* Of these and of runs with `forces`. */
#define SPH_MOMENTA(X)                                                                             \
  X(momentum_x, "kg/s", "sum m u")                                                                 \
  X(momentum_y, "kg/s", "sum m v")                                                                 \
  X(angular_momentum, "kg m/s", "sum m (x v - y u), about x = y = 0")

/* Of runs with `forces` (forces.h). */
#define SPH_FORCES(X)                                                                              \
  X(force_x, "N/m", "force of the water on all walls along x, by its pressure and viscosity")      \
  X(force_y, "N/m", "the same along y")                                                            \
  X(moment, "N",                                                                                   \
    "its moment about the middle of the lower side of the box round the tank, anticlockwise")      \
  X(force_left, "N/m",                                                                             \
    "force along x on the straight piece of wall that the left edge of the water is on, by its "   \
    "pressure")                                                                                    \
  X(force_right, "N/m", "the same of the right edge")

#define SPH_DIAGNOSTICS(X) SPH_NOISES(X) SPH_MOMENTA(X) SPH_FORCES(X)

enum {
#define X(name, unit, help) SPH_DIAGNOSTIC_##name,
  SPH_DIAGNOSTICS(X)
#undef X
      SPH_DIAGNOSTIC_COUNT
};
extern const struct solver_diagnostic sph_diagnostics[SPH_DIAGNOSTIC_COUNT];

/* Those that the run asks for, after sph_rates(s, 0, ...), in the scales H (m) and g (m s^-2) of
 * the case, whose water may have no gravity; others are 0. The same bits for any number of threads.
 * ERR_MEMORY. */
enum status sph_diagnose(struct sph *s, double H, double g, double value[SPH_DIAGNOSTIC_COUNT]);

/* And a row of them, if there are any. */
enum status sph_diagnose_write(struct sph *s, const struct case_file *c, struct result *result);
