#include "sph/owners.h"

#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/scheme.h"

static bool diffuses(const struct sph_scheme *o) {
  return o->diffusion != SPH_DIFFUSION_none;
}

static bool is_viscous(const struct sph_scheme *o) {
  return o->alpha > 0;
}

static bool fits_within(const struct sph_scheme *o) {
  return o->derivative == SPH_DERIVATIVE_mls || o->derivative == SPH_DERIVATIVE_mueller;
}

static bool corrects(const struct sph_scheme *o) {
  return o->strength[SPH_CORRECTION_tensile] > 0;
}

static bool smooths(const struct sph_scheme *o) {
  return o->every[SPH_TREATMENT_smoothing] != 0;
}

static bool projects(const struct sph_scheme *o) {
  return o->every[SPH_TREATMENT_projection] != 0;
}

static bool waits(const struct sph_scheme *o) {
  return o->every[SPH_TREATMENT_removal] < 0 || o->every[SPH_TREATMENT_projection] < 0;
}

static bool damps(const struct sph_scheme *o) {
  return o->damping > 0;
}

static const struct {
  const char *key;
  bool (*acts)(const struct sph_scheme *o);
  const char *of, *owner; /* what it is of, and what makes it act */
} owned[] = {
    {"delta", diffuses, "diffusion", "diffusion other than none"},
    {"cfl_diffusive", diffuses, "diffusion", "diffusion other than none"},
    {"viscosity", is_viscous, "a viscous force", "alpha above 0"},
    {"cfl_viscous", is_viscous, "a viscous force", "alpha above 0"},
    {"derivative_radius", fits_within, "a fit within a radius", "derivative: mls or mueller"},
    {"tensile_power", corrects, "a tensile correction", "tensile above 0"},
    {"smoothing_of", smooths, "smoothing", "smoothing"},
    {"projection_modes", projects, "a projection", "projection"},
    {"projection_profile", projects, "a projection", "projection"},
    {"growth_limit", waits, "anything due by growth", "removal: growth or projection: growth"},
    {"damping_end", damps, "damping", "damping above 0"},
};

void sph_owners_check(const struct case_run *r, struct problems *problems) {
  for (size_t k = 0; k < sizeof owned / sizeof *owned; k++)
    if (case_run_gives(r, owned[k].key) && !owned[k].acts(r->options))
      problems_add(problems, case_run_line(r, owned[k].key),
                   "runs.%s.%s: found in a run without %s, where it does nothing; allowed: with "
                   "%s; leave the line out",
                   r->name, owned[k].key, owned[k].of, owned[k].owner);
}
