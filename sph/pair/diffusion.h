/* The diffusive terms of the continuity equation, P eqs. (5), (7), (9), (10): one list, and psi_ji.
 *
 *   D_i = 2 sum_j psi_ji  r_ji . grad_i W_ij / |r_ji|^2  V_j
 *
 * Since r_ji . grad_i W = slope |r|^2 with slope > 0 (kernel.h), D_i is a sum of psi_ji with
 * positive weights: density flows from dense to thin. Density differences are taken as those of the
 * pressure that drives over c0^2, which they are while the equation of state is linear; with Tait's
 * they differ by (rho/rho0)^6, and with the dynamic one they are of what exceeds the hydrostatic
 * density, as Fourtakas, Dominguez, Vacondio & Rogers have it (Comput. Fluids 190, 2019). psi here
 * is c0^2 times that of the paper, and G the renormalised pressure gradient. */
#pragma once
#include "sph/family.h"
#include "sph/pair/kernel.h"
#include "sph/pair/vec.h"

#define SPH_DIFFUSIONS(X, ...)                                                                     \
  X(none, "no diffusion", ##__VA_ARGS__)                                                           \
  X(molteni,                                                                                       \
    "Molteni & Colagrossi 2009, P eq. (7), usually with delta = 0.5; takes 0.72 of cfl_diffusive " \
    "in rk4-frozen",                                                                               \
    ##__VA_ARGS__)                                                                                 \
  X(ferrari,                                                                                       \
    "Ferrari et al. 2009, P eq. (10), usually with delta = 1; takes 0.72 of cfl_diffusive in "     \
    "rk4-frozen",                                                                                  \
    ##__VA_ARGS__)                                                                                 \
  X(antuono, "Antuono et al. 2010, P eq. (9), usually with delta = 0.2", ##__VA_ARGS__)
SPH_FAMILY(sph_diffusion, SPH_DIFFUSION, SPH_DIFFUSIONS);

/* The usual delta of the paper. */
SPECIALISE double diffusion_delta(enum sph_diffusion d) {
  switch (d) {
  case SPH_DIFFUSION_none:
    return 0;
  case SPH_DIFFUSION_molteni:
    return 0.5;
  case SPH_DIFFUSION_ferrari:
    return 1;
  case SPH_DIFFUSION_antuono:
    return 0.2;
  }
  __builtin_unreachable();
}

/* The largest decay rate of the term relative to Molteni's with the same delta, from the integral
 * of its kernel: int q W dV = sqrt(pi)/2 in Ferrari's, halved by its 1/2h. It scales the time step
 * bound (27). */
SPECIALISE double diffusion_strength(enum sph_diffusion d) {
  switch (d) {
  case SPH_DIFFUSION_none:
    return 0;
  case SPH_DIFFUSION_molteni:
  case SPH_DIFFUSION_antuono:
    return 1;
  case SPH_DIFFUSION_ferrari:
    return 0.4431;
  }
  __builtin_unreachable();
}

/* The factor of (27) in an integrator that evaluates the term once a step. On a lattice sound and
 * diffusion together are stable up to delta c0 dt/h = 0.698 in classic RK4 and 0.500 when frozen
 * (Ferrari's: 1.42 and 1.02): 0.72 leaves the same room to disordered particles, for which P's 0.44
 * alone is too little (Ferrari's runs broke down). Antuono's needs none: with its usual delta the
 * acoustic bound is shorter than (27). */
SPECIALISE double diffusion_frozen(enum sph_diffusion d) {
  switch (d) {
  case SPH_DIFFUSION_none:
  case SPH_DIFFUSION_antuono:
    return 1;
  case SPH_DIFFUSION_molteni:
  case SPH_DIFFUSION_ferrari:
    return 0.72;
  }
  __builtin_unreachable();
}

/* c0^2 psi_ji of a pair: dp = p_j - p_i, (x, y) = (r_j - r_i)/h, q2 = |r_ji|^2/h^2, G = h times the
 * sum of both renormalised pressure gradients. */
SPECIALISE vec diffusion_psi(enum sph_diffusion d, vec dp, vec x, vec y, vec q2, vec Gx, vec Gy) {
  switch (d) {
  case SPH_DIFFUSION_molteni:
    return dp;
  case SPH_DIFFUSION_ferrari:
    return dp * vec_sqrt(q2) * (real)0.5;
  case SPH_DIFFUSION_antuono:
    return dp - (real)0.5 * (Gx * x + Gy * y);
  case SPH_DIFFUSION_none:
    return (vec){0};
  }
  __builtin_unreachable();
}

/* What a pair counts for in a bound on decay, where no gradient is needed: no density field decays
 * faster than twice the largest sum of these times V_j over a particle's neighbours, itself
 * included, in delta c0/h, up to what the cut at the edge of the support makes of it.
 *
 * The term is B - S for the matrix B of the weights times V_j off its diagonal and S of their sums
 * on it; with C such that B + C is positive definite, S - B is at most S + C, and that at most its
 * largest sum of a row (Gershgorin). For Molteni's term C is the slope on the diagonal, for
 * Ferrari's the lift (kernel.h); for any C = |B| would do. */
SPECIALISE vec diffusion_weight(enum sph_diffusion d, enum sph_kernel k, vec slope, vec q2) {
  const vec psi = diffusion_psi(d, vec_of(1), (vec){0}, (vec){0}, q2, (vec){0}, (vec){0}) * slope;
  if (!kernel_is_definite(k)) return psi * (real)2;
  switch (d) {
  case SPH_DIFFUSION_none:
  case SPH_DIFFUSION_molteni:
  case SPH_DIFFUSION_antuono:
    return psi;
  case SPH_DIFFUSION_ferrari: {
    const vec c = vec_max(vec_of(1) - vec_sqrt(q2), (vec){0});
    return psi + c * c * c * (real)kernel_lift(k);
  }
  }
  __builtin_unreachable();
}

SPECIALISE bool diffusion_needs_gradient(enum sph_diffusion d) {
  switch (d) {
  case SPH_DIFFUSION_none:
  case SPH_DIFFUSION_molteni:
  case SPH_DIFFUSION_ferrari:
    return false;
  case SPH_DIFFUSION_antuono:
    return true;
  }
  __builtin_unreachable();
}

/* What wall particles take part in. In still water they carry the density gradient on through the
 * bed (ghost.c): Antuono's psi is zero then, but Molteni's and Ferrari's would let density flow in
 * through the bed, against the conservation that P asks of the term, sum D_i V_i = 0 (eq. (6)). */
SPECIALISE enum sph_diffusion diffusion_at_walls(enum sph_diffusion d) {
  return diffusion_needs_gradient(d) ? d : SPH_DIFFUSION_none;
}
