#include "sph/theory/scale.h"

#include "sph/theory/lattice.h"

/* Of one kernel: what the ratios are made of. */
static struct sph_scale measure(enum sph_kernel k, double h_over_dx, enum sph_diffusion d) {
  struct sph_lattice l;
  struct sph_scale a;
  sph_lattice_of(k, h_over_dx, &l);
  sph_lattice_extremes(&l, d, &a.acoustic, &a.diffusive);
  a.spread = sph_lattice_moment(&l, 0, 2, SPH_LATTICE_REACH);
  a.inside = sph_lattice_corner(k, h_over_dx, 0);
  a.wall = sph_lattice_corner(k, h_over_dx, 0.5);
  return a;
}

struct sph_scale sph_scale_of(const struct sph_scheme *o) {
  const enum sph_kernel k = (enum sph_kernel)o->kernel;
  const enum sph_diffusion d = (enum sph_diffusion)o->diffusion;
  if (k == SPH_KERNEL_gaussian && o->h_over_dx == 4. / 3) return (struct sph_scale){1, 1, 1, 1, 1};
  const struct sph_scale p = measure(SPH_KERNEL_gaussian, 4. / 3, d);
  const struct sph_scale a = measure(k, o->h_over_dx, d);
  return (struct sph_scale){
      .acoustic = p.acoustic / a.acoustic,
      .diffusive = d == SPH_DIFFUSION_none ? 1 : p.diffusive / a.diffusive,
      .spread = a.spread / p.spread,
      .inside = a.inside / p.inside,
      .wall = a.wall / p.wall,
  };
}
