#include "sph/scheme.h"

#include <stddef.h>
#include <string.h>

#include "sph/domain/fitted.h"
#include "sph/domain/wall.h"
#include "sph/pair/continuity.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/eos.h"
#include "sph/pair/kernel.h"
#include "sph/pair/momentum.h"
#include "sph/pair/viscosity.h"
#include "sph/presets.h"
#include "sph/theory/scale.h"
#include "sph/time/integrator.h"

/* What a case may name, and the help, of each family. */
#define NAME(name, help) #name,
#define HELP(name, help) help,
#define FAMILY(tag, LIST)                                                                          \
  static const char *const tag##_names[] = {LIST(NAME) NULL};                                      \
  static const char *const tag##_helps[] = {LIST(HELP)};
FAMILY(kernel, SPH_KERNELS)
FAMILY(eos, SPH_EOS)
FAMILY(derivative, SPH_DERIVATIVES)
FAMILY(momentum, SPH_MOMENTUMS)
FAMILY(continuity, SPH_CONTINUITIES)
FAMILY(viscosity, SPH_VISCOSITIES)
FAMILY(diffusion, SPH_DIFFUSIONS)
FAMILY(free_surface, SPH_FREE_SURFACES)
FAMILY(slip, SPH_SLIPS)
#define CHOICE(key, LIST, first, help) FAMILY(key, LIST)
SPH_TREATMENT_CHOICES(CHOICE)
#undef CHOICE
#define WORDS(name, LIST, help)                                                                    \
  static const char *const name##_words[] = {LIST(NAME) NULL};                                     \
  static const char *const name##_word_helps[] = {LIST(HELP) NULL};
SPH_TREATMENTS(WORDS)
#undef WORDS

const char *const sph_delta_words[] = {"auto", NULL};
const char *const sph_delta_word_helps[] = {
    "the usual one of the diffusion (paper), times (D/w)(gaussian, h/dx = 4/3)/(D/w), with D "
    "the largest decay rate by the diffusion and w the largest frequency of sound on a lattice",
    NULL};

static const char *const precision_names[] = {"single", "double", NULL};
static const char *const precision_helps[] = {
    "differences of doubles, rounded: costs 1e-6 of a pair's contribution",
    "takes up to twice the time; conserves to 1e-13"};

#define AT(member) offsetof(struct sph_scheme, member)
const struct param sph_params[] = {
    {"scheme", PARAM_CHOICE, QTY_NUMBER, AT(preset), 0, 0, "delta-sph", sph_preset_names,
     "named scheme: sets the keys below, as far as the run does not (see the list of schemes)",
     NULL},
    {"kernel", PARAM_CHOICE, QTY_NUMBER, AT(kernel), 0, 0, "gaussian", kernel_names,
     "smoothing kernel", kernel_helps},
    {"h_over_dx", PARAM_REAL, QTY_NUMBER, AT(h_over_dx), 0.8, 3, "1.3333333333333333", NULL,
     "smoothing length over particle spacing (4/3: paper, III.A)", NULL},
    {"eos", PARAM_CHOICE, QTY_NUMBER, AT(eos), 0, 0, "linear", eos_names,
     "equation of state, the pressure of a density", eos_helps},
    {"derivative", PARAM_CHOICE, QTY_NUMBER, AT(derivative), 0, 0, "kernel", derivative_names,
     "how grad p and div u are taken from neighbours", derivative_helps},
    {"derivative_radius", PARAM_REAL, QTY_NUMBER, AT(derivative_radius), 1, 3, "1.5", NULL,
     "radius of the neighbours in mls and mueller, in h, at most the kernel's support", NULL},
    {"momentum", PARAM_CHOICE, QTY_NUMBER, AT(momentum), 0, 0, "plus", momentum_names,
     "form of the pressure force", momentum_helps},
    {"continuity", PARAM_CHOICE, QTY_NUMBER, AT(continuity), 0, 0, "divergence", continuity_names,
     "form of the continuity equation", continuity_helps},
    {"viscosity", PARAM_CHOICE, QTY_NUMBER, AT(viscosity), 0, 0, "artificial", viscosity_names,
     "form of the viscous force, whose strength is alpha", viscosity_helps},
    {"diffusion", PARAM_CHOICE, QTY_NUMBER, AT(diffusion), 0, 0, "antuono", diffusion_names,
     "density diffusion in the continuity equation (paper, eqs. 7, 9, 10)", diffusion_helps},
    {"delta", PARAM_REAL, QTY_NUMBER, AT(delta), 0, 10, "auto", sph_delta_words,
     "strength of the diffusion", sph_delta_word_helps},
    {"alpha", PARAM_REAL, QTY_NUMBER, AT(alpha), 0, 1, "0.01", NULL,
     "strength of the artificial viscosity (paper, eqs. 1 and 2)", NULL},
    {"c0", PARAM_REAL, QTY_VELOCITY, AT(c0), 1e-6, 1e6, "20 sqrt(gH)", NULL,
     "speed of sound; at least 10 times the largest velocity, about 2 sqrt(gH) in a dam break",
     NULL},
    {"free_surface", PARAM_CHOICE, QTY_NUMBER, AT(free_surface), 0, 0, "natural",
     free_surface_names, "condition on the free surface", free_surface_helps},
    {"integrator", PARAM_CHOICE, QTY_NUMBER, AT(integrator), 0, 0, "auto", sph_integrator_names,
     "time integration (paper, IV; rk4-frozen is eq. 25)", sph_integrator_helps},
    {"walls", PARAM_CHOICE, QTY_NUMBER, AT(walls), 0, 0, "ghost", sph_wall_names,
     "walls: fixed ghost particles (paper), or mirror images, which do no work", sph_wall_helps},
    {"slip", PARAM_CHOICE, QTY_NUMBER, AT(slip), 0, 0, "free", slip_names,
     "of water along walls, as viscosity has it", slip_helps},
    {"precision", PARAM_CHOICE, QTY_NUMBER, AT(precision), 0, 0, "single", precision_names,
     "of the sums over neighbours; all else is double", precision_helps},
    {"cfl_acoustic", PARAM_REAL, QTY_NUMBER, AT(cfl_acoustic), 1e-3, 10, "2.2", NULL,
     "factor of the bound from sound and convection (paper, eq. 29): of rk4 with the gaussian "
     "kernel and h/dx = 4/3, scaled for others, and other derivatives, as sound on a lattice is",
     NULL},
    {"cfl_diffusive", PARAM_REAL, QTY_NUMBER, AT(cfl_diffusive), 1e-3, 10, "0.44", NULL,
     "factor of the bound from diffusion (paper, eq. 27): of rk4 with the gaussian kernel and h/dx "
     "= 4/3, scaled for others as decay on a lattice is",
     NULL},
    {"cfl_viscous", PARAM_REAL, QTY_NUMBER, AT(cfl_viscous), 1e-3, 10, "0.125", NULL,
     "factor of the bound from viscosity (paper, eq. 28)", NULL},
    {"cfl_acceleration", PARAM_REAL, QTY_NUMBER, AT(cfl_acceleration), 1e-3, 10, "0.25", NULL,
     "factor of the bound from acceleration (paper, eq. 28)", NULL},
    {"dt", PARAM_REAL, QTY_TIME, AT(dt), 0, 1e6, "0", NULL,
     "time step, or as much less as makes outputs a whole number of them apart; 0: the largest "
     "that the bounds allow",
     NULL},
    {"damping", PARAM_REAL, QTY_NUMBER, AT(damping), 0, 1e6, "0", NULL,
     "Gamma of the integrator damped-pc, du/dt = ... - Gamma u, 1/s (thesis, eqs. 3.36 to 3.45)",
     NULL},
    {"diagnostics", PARAM_BOOL, QTY_NUMBER, AT(diagnostics), 0, 0, "false", NULL,
     "whether noise, shaking, compression and momenta are written as series; takes half an "
     "evaluation a sample",
     NULL},
    {"forces", PARAM_BOOL, QTY_NUMBER, AT(forces), 0, 0, "false", NULL,
     "whether the forces on the walls, their moment, and the water's momentum are written as "
     "series",
     NULL},
    {"accelerations", PARAM_BOOL, QTY_NUMBER, AT(accelerations), 0, 0, "false", NULL,
     "whether outputs of particles hold their accelerations",
     NULL},
    {"damping_end", PARAM_REAL, QTY_TIME, AT(damping_end), 0, 1e9, "0", NULL,
     "until when it damps; 0: to the end", NULL},
#define ROW(name, LIST, help)                                                                      \
  {#name,        PARAM_INT, QTY_NUMBER,       AT(every[SPH_TREATMENT_##name]), 0, 1e9, "0",        \
   name##_words, help,      name##_word_helps},
    SPH_TREATMENTS(ROW)
#undef ROW
#define ROW(name, most, help)                                                                      \
  {#name, PARAM_REAL, QTY_NUMBER, AT(strength[SPH_CORRECTION_##name]), 0, most, "0",               \
   NULL,  help,       NULL},
        SPH_CORRECTIONS(ROW)
#undef ROW
#define ROW(key, least, most, first, help)                                                         \
  {#key, PARAM_INT, QTY_NUMBER, AT(key), least, most, first, NULL, help, NULL},
            SPH_TREATMENT_NUMBERS(ROW)
#undef ROW
#define ROW(key, least, most, first, help)                                                         \
  {#key, PARAM_REAL, QTY_NUMBER, AT(key), least, most, first, NULL, help, NULL},
                SPH_TREATMENT_REALS(ROW)
#undef ROW
#define ROW(key, LIST, first, help)                                                                \
  {#key, PARAM_CHOICE, QTY_NUMBER, AT(key), 0, 0, first, key##_names, help, key##_helps},
                    SPH_TREATMENT_CHOICES(ROW)
#undef ROW
};

double sph_scheme_delta(const struct sph_scheme *o) {
  if (o->delta >= 0) return o->delta;
  const struct sph_scale scale = sph_scale_of(o);
  return diffusion_delta((enum sph_diffusion)o->diffusion) * (scale.diffusive / scale.acoustic);
}

const char *sph_scheme_name(const struct sph_scheme *o, const char *key) {
  for (const struct param *p = sph_params; p < sph_params + SPH_N_PARAMS; p++)
    if (p->type == PARAM_CHOICE && !strcmp(p->key, key))
      return p->choices[*(const int *)((const char *)o + p->offset)];
  return "";
}
