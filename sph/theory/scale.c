#include "sph/theory/scale.h"

#include "sph/theory/lattice.h"

/* Of one scheme: what the ratios are made of. */
static struct sph_scale measure(const struct sph_scheme *o) {
  const enum sph_kernel k = (enum sph_kernel)o->kernel;
  const double h_over_dx = o->h_over_dx;
  struct sph_lattice l;
  struct sph_scale a;
  sph_lattice_of_scheme(o, &l);
  sph_lattice_extremes(&l, (enum sph_diffusion)o->diffusion, &a.acoustic, &a.diffusive);
  a.spread = sph_lattice_moment(&l, 0, 2, SPH_LATTICE_REACH);
  a.inside = sph_lattice_corner(k, h_over_dx, 0);
  a.wall = sph_lattice_corner(k, h_over_dx, 0.5);
  return a;
}

struct sph_scale sph_scale_of(const struct sph_scheme *o) {
  const struct sph_scheme paper = {
      .kernel = SPH_KERNEL_gaussian, .h_over_dx = 4. / 3, .diffusion = o->diffusion};
  if (o->kernel == paper.kernel && o->h_over_dx == paper.h_over_dx &&
      o->derivative == paper.derivative)
    return (struct sph_scale){1, 1, 1, 1, 1};
  const struct sph_scale p = measure(&paper), a = measure(o);
  return (struct sph_scale){
      .acoustic = p.acoustic / a.acoustic,
      .diffusive = o->diffusion == SPH_DIFFUSION_none ? 1 : p.diffusive / a.diffusive,
      .spread = a.spread / p.spread,
      .inside = a.inside / p.inside,
      .wall = a.wall / p.wall,
  };
}
