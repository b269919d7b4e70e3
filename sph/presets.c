#include "sph/presets.h"

/* X(variant, name, key-value pairs or nothing, help). */
#define PRESETS(X)                                                                                 \
  X(delta_sph, "delta-sph", ,                                                                      \
    "P eqs. (1), (9): du/dt = -(1/rho) sum (p_j + p_i) V_j gradW + g + viscosity, drho/dt = -rho " \
    "sum (u_j - u_i).gradW V_j + delta h c0 D, with D free of the linear part of the density")     \
  X(molteni, "molteni", SET("diffusion", "molteni"),                                               \
    "the same with D of P eq. (7), psi = rho_j - rho_i")                                           \
  X(ferrari, "ferrari", SET("diffusion", "ferrari"),                                               \
    "the same with D of P eq. (10), psi = (rho_j - rho_i) |r|/2h")

#define SET(key, value) {key, value},

#define VALUES(variant, name, values, help)                                                        \
  static const struct param_value variant##_values[] = {values{NULL, NULL}};
PRESETS(VALUES)
#undef VALUES

#define ROW(variant, name, values, help) {name, help, variant##_values},
const struct param_preset sph_presets[] = {PRESETS(ROW)};
#undef ROW
_Static_assert(sizeof sph_presets / sizeof *sph_presets == SPH_N_PRESETS, "as many as it says");

#define NAME(variant, name, values, help) name,
const char *const sph_preset_names[] = {PRESETS(NAME) NULL};
#undef NAME
