#include "sph/pair/forms.h"

#include <stdio.h>

#include "sph/domain/fitted.h"
#include "sph/domain/wall.h"
#include "sph/pair/continuity.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/kernel.h"
#include "sph/pair/momentum.h"
#include "sph/time/integrator.h"

bool sph_forms_adjoint(const struct sph_scheme *o) {
  if (derivative_is_fit((enum sph_derivative)o->derivative)) return false;
  if (!eos_is_plain((enum sph_eos)o->eos)) return false;
  switch ((enum sph_momentum)o->momentum) {
  case SPH_MOMENTUM_plus:
    return o->continuity == SPH_CONTINUITY_divergence;
  case SPH_MOMENTUM_mass:
    return o->continuity == SPH_CONTINUITY_mass;
  case SPH_MOMENTUM_neighbour:
    return o->continuity == SPH_CONTINUITY_absolute;
  case SPH_MOMENTUM_minus:
  case SPH_MOMENTUM_reference:
    return false;
  }
  __builtin_unreachable();
}

static bool shares_gravity(const struct sph_scheme *o) {
  return !eos_is_plain((enum sph_eos)o->eos);
}

static bool is_light_momentum(const struct sph_scheme *o) {
  return shares_gravity(o) && !momentum_is_of_reference((enum sph_momentum)o->momentum);
}

static bool is_mixed_density(const struct sph_scheme *o) {
  return shares_gravity(o) && o->continuity != SPH_CONTINUITY_divergence;
}

static bool is_curved_exponential(const struct sph_scheme *o) {
  return !eos_is_linear((enum sph_eos)o->eos) && sph_integrators[sph_integrator_chosen(o)]->split;
}

static bool is_split_gradient(const struct sph_scheme *o) {
  return diffusion_needs_gradient((enum sph_diffusion)o->diffusion) &&
         sph_integrators[sph_integrator_chosen(o)]->split;
}

static bool sums(const struct sph_scheme *o) {
  return continuity_sums((enum sph_continuity)o->continuity);
}

static bool is_diffused_sum(const struct sph_scheme *o) {
  return sums(o) && o->diffusion != SPH_DIFFUSION_none;
}

static bool is_treated_sum(const struct sph_scheme *o) {
  return sums(o) && (o->every[SPH_TREATMENT_shepard] || o->every[SPH_TREATMENT_mls_volume] ||
                     o->every[SPH_TREATMENT_mls_mass]);
}

static bool is_fitted(const struct sph_scheme *o) {
  return derivative_is_fit((enum sph_derivative)o->derivative);
}

static bool is_paired_fit(const struct sph_scheme *o) {
  return is_fitted(o) && o->momentum != SPH_MOMENTUM_minus && o->momentum != SPH_MOMENTUM_reference;
}

static bool is_summed_fit(const struct sph_scheme *o) {
  return is_fitted(o) && o->continuity != SPH_CONTINUITY_divergence &&
         o->continuity != SPH_CONTINUITY_reference;
}

static bool has_radius(const struct sph_scheme *o) {
  return derivative_has_radius((enum sph_derivative)o->derivative);
}

static bool is_wide_fit(const struct sph_scheme *o) {
  return has_radius(o) && o->derivative_radius > kernel_support((enum sph_kernel)o->kernel);
}

static bool is_narrow_fit(const struct sph_scheme *o) {
  return has_radius(o) && o->derivative_radius * o->h_over_dx < 1.45;
}

static bool is_relaxed_fit(const struct sph_scheme *o) {
  return is_fitted(o) && o->strength[SPH_CORRECTION_tensile] > 0;
}

static bool is_steep_image(const struct sph_scheme *o) {
  return o->momentum == SPH_MOMENTUM_reference &&
         sph_walls[o->walls] == &sph_wall_mirror_exponential;
}

static bool is_summed_beside_walls(const struct sph_scheme *o) {
  return sums(o) && sph_walls[o->walls] == &sph_wall_dynamic;
}

static bool is_held_by_nothing(const struct sph_scheme *o) {
  return o->slip == SPH_SLIP_no && o->alpha == 0;
}

static const struct {
  bool (*wrong)(const struct sph_scheme *o);
  const char *key, *text; /* what follows "found " */
} refusals[] = {
    {is_light_momentum, "momentum",
     "another form with an eos that takes gravity into the pressure or the density, where water at "
     "rest is balanced with rho0 only (thesis, eqs. (4.19), (4.33)); allowed: reference; write "
     "momentum: reference"},
    {is_mixed_density, "continuity",
     "another form with an eos that takes gravity into the pressure or the density, whose rate is "
     "-rho div u (thesis, eqs. (4.36), (4.59)); allowed: divergence; write continuity: divergence"},
    {is_curved_exponential, "integrator",
     "rk4-split, whose exponential is that of a linear equation of state, with another; allowed: "
     "any other integrator; write integrator: rk4"},
    {is_split_gradient, "integrator",
     "rk4-split with a diffusion that needs the density gradient, in each of its stages; allowed: "
     "any other; write integrator: rk4-frozen"},
    {is_diffused_sum, "diffusion",
     "a diffusion of densities that are sums over the neighbours at each instant, and forget it "
     "(thesis, eqs. (2.16), (3.18)); allowed: none; write diffusion: none"},
    {is_paired_fit, "momentum",
     "a form that is a sum over pairs with a derivative that is a fit of differences (thesis, eqs. "
     "(3.13), (4.13)); allowed: minus, with 1/rho_i, or reference, with 1/rho0; write momentum: "
     "minus"},
    {is_summed_fit, "continuity",
     "a form that is a sum over pairs with a derivative that is a fit of differences (thesis, eqs. "
     "(3.13), (4.14)); allowed: divergence, with rho_i, or reference, with rho0; write "
     "continuity: divergence"},
    {is_wide_fit, "derivative_radius",
     "more than the support of the kernel, within which neighbours are listed; allowed: at most "
     "that; lower it"},
    {is_narrow_fit, "derivative_radius",
     "less than 1.45 particle spacings, within which the neighbours along a diagonal are missing; "
     "allowed: at least that over h_over_dx; raise it"},
    {is_relaxed_fit, "tensile",
     "a correction of the forces of pairs with a derivative that is a fit and has none; allowed: "
     "0; write tensile: 0"},
    {is_steep_image, "walls",
     "mirror-exponential with momentum: reference, with which water rests on a linear pressure, of "
     "slope rho0 g (thesis, eqs. (4.26) to (4.28)); allowed: mirror; write walls: mirror"},
    {is_summed_beside_walls, "walls",
     "dynamic, whose densities follow the continuity equation, beside water whose densities are "
     "sums over the neighbours (thesis, eqs. (2.16), (3.18)); allowed: any other walls; write "
     "walls: mirror"},
    {is_held_by_nothing, "slip",
     "no slip without viscosity, the only force by which walls hold water; allowed: with alpha "
     "above 0; give it or write slip: free"},
    {is_treated_sum, "continuity",
     "densities that are sums over the neighbours at each instant, and forget the "
     "re-initialisation that this run asks for; allowed: divergence, absolute, mass, reference; "
     "take another or leave the re-initialisation out"},
};

void sph_forms_check(const struct case_run *r, struct problems *problems) {
  for (size_t k = 0; k < sizeof refusals / sizeof *refusals; k++)
    if (refusals[k].wrong(r->options))
      problems_add(problems, case_run_line(r, refusals[k].key), "runs.%s.%s: found %s", r->name,
                   refusals[k].key, refusals[k].text);
}

const char *sph_forms_refusal(const struct sph_scheme *o, const char **key) {
  for (size_t k = 0; k < sizeof refusals / sizeof *refusals; k++) {
    *key = refusals[k].key;
    if (refusals[k].wrong(o)) return refusals[k].text;
  }
  return NULL;
}

const char *sph_forms_warning(const struct sph_scheme *o, double g) {
  if (sums(o))
    return "densities that are sums over neighbours are too low beside a free surface, where "
           "the pressure then is -0.1 to -0.2 rho0 c0^2: the surface contracts with some tenths "
           "of the speed of sound (thesis, 2.5.6)";
  if (eos_drives_by_excess((enum sph_eos)o->eos) && g > 0)
    return "eos dynamic has no dynamic pressure at a free surface, instead of no pressure: water "
           "does not fall";
  if (is_fitted(o) && o->free_surface != SPH_FREE_SURFACE_fitted)
    return "a fitted derivative imposes no pressure on a free surface: violent flow is thrown "
           "about; waves want free_surface: fitted";
  if (o->momentum == SPH_MOMENTUM_minus)
    return "momentum minus imposes no pressure on a free surface: violent flow is thrown about";
  return NULL;
}

void sph_forms_advise(const struct sph *s, char advice[SPH_ADVICE]) {
  const struct sph_scheme *o = &s->scheme;
  const char *warning = sph_forms_warning(o, s->g);
  snprintf(advice, SPH_ADVICE, "raise c0%s or alpha, or lower %s%s%s",
           o->diffusion == SPH_DIFFUSION_none ? "" : ", delta", o->dt > 0 ? "dt" : "cfl_acoustic",
           warning ? "; " : "", warning ? warning : "");
}
