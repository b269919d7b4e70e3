/* The schemes of P (Antuono, Colagrossi & Marrone) and T (Kiara's thesis). T's have no diffusion
 * and no viscosity, and the cubic spline with dx = 0.75 h; what T leaves open is chosen so: the
 * radial spline rather than the product, MLS by volumes every 20 steps in MA-SPH, and smoothing as
 * strong as T's best in whatever time steps there are. */
#include "sph/presets.h"

/* X(variant, name, key-value pairs or nothing, help). */
#define PRESETS(X)                                                                                 \
  X(delta_sph, "delta-sph", ,                                                                      \
    "P eqs. (1), (9): du/dt = -(1/rho) sum (p_j + p_i) V_j gradW + g + viscosity, drho/dt = -rho " \
    "sum (u_j - u_i).gradW V_j + delta h c0 D, with D free of the linear part of the density")     \
  X(molteni, "molteni", SET("diffusion", "molteni"),                                               \
    "delta-sph with D of P eq. (7), psi = rho_j - rho_i")                                          \
  X(ferrari, "ferrari", SET("diffusion", "ferrari"),                                               \
    "delta-sph with D of P eq. (10), psi = (rho_j - rho_i) |r|/2h")                                \
  X(ma_sph, "ma-sph",                                                                              \
    T_SPLINE SET("eos", "tait") SET("momentum", "mass") SET("continuity", "mass")                  \
        SET("mls_volume", "20"),                                                                   \
    "T eqs. (2.15), (3.20): du/dt = -sum m_j (p_i/rho_i^2 + p_j/rho_j^2) gradW + g, drho/dt = "    \
    "-sum m_j (u_j - u_i).gradW, Tait's p, densities re-initialised by MLS")                       \
  X(msph, "msph", T_SPLINE SET("momentum", "reference") SET("smoothing", "auto"),                  \
    "T eqs. (4.40), (4.41), (4.51), (4.52): du/dt = -(1/rho0) sum (p_j + p_i) V_j gradW + g, "     \
    "drho/dt = -rho sum (u_j - u_i).gradW V_j, velocity and density smoothed")                     \
  X(msph_dynamic, "msph-dynamic",                                                                  \
    T_SPLINE SET("eos", "dynamic") SET("momentum", "reference") SET("smoothing", "auto")           \
        SET("smoothing_of", "excess"),                                                             \
    "T eqs. (4.34), (4.35): msph driven by p_d = c0^2 (rho - rho0) + rho0 g y in place of p and "  \
    "g; for water that keeps its level")                                                           \
  X(msph_split, "msph-split",                                                                      \
    T_SPLINE SET("eos", "split") SET("momentum", "reference") SET("smoothing", "auto"),            \
    "T eqs. (4.57) to (4.60): msph with p = c0^2 (rho_s - rho0) - rho0 g y, where rho_s is rho0 "  \
    "in water at rest")                                                                            \
  X(hsph, "hsph",                                                                                  \
    T_SCHEME SET("kernel", "quintic") SET("h_over_dx", "1") SET("momentum", "reference")           \
        SET("continuity", "reference") SET("derivative", "mls") SET("free_surface", "fitted")      \
            SET("projection", "15") SET("cfl_acoustic", "1.16"),                                   \
    "T eqs. (4.1), (4.2): du/dt = -grad p/rho0 + g, dp/dt = -rho0 c0^2 div u, derivatives by "     \
    "MLS, p = 0 on the first row, waves re-projected; in a periodic tank")

#define SET(key, value) {key, value},
#define T_SPLINE        T_SCHEME SET("kernel", "cubic")
#define T_SCHEME                                                                                   \
  SET("diffusion", "none") SET("alpha", "0") SET("integrator", "rk4") SET("walls", "mirror")

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
