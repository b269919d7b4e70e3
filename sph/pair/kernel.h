/* The smoothing kernels: one list, and a few small functions.
 *
 * The gradient at i is grad_i W_ij = slope(q^2) (r_j - r_i), q = |r_ij|/h, slope > 0: it points
 * from i to j, and a kernel that is a function of q^2 needs no square root. Lengths are in units of
 * h here. slope() and value() leave out constant factors, which the *_scale() give: they are
 * applied once for each particle. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

/* The renormalised Gaussian, W = (exp(-q^2) - C0) / (pi h^2 C1) within 3h with C0 = exp(-9), C1 = 1
 * - 10 C0: C0 makes W vanish at the edge; C1 is 2 int_0^3 (exp(-q^2) - C0) q dq, so that W
 * integrates to one over the plane. slope = 2 exp(-q^2) / (pi h^4 C1). */
#define SPH_GAUSSIAN_C0 1.2340980408667956e-4 /* exp(-9) */
#define SPH_GAUSSIAN_C1 (1 - 10 * SPH_GAUSSIAN_C0)

#define SPH_KERNELS(X, ...)                                                                        \
  X(gaussian, "renormalised Gaussian, support 3h (P, section V; Landrini et al. 2007)",            \
    ##__VA_ARGS__)
SPH_FAMILY(sph_kernel, SPH_KERNEL, SPH_KERNELS);

/* Radius of the support, in h. */
SPECIALISE double kernel_support(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 3;
  }
  __builtin_unreachable();
}

/* Slope and value inside the support, without their constant factors; the caller cuts them off. */
SPECIALISE vec kernel_slope(enum sph_kernel k, vec q2) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return vec_exp_minus(q2);
  }
  __builtin_unreachable();
}

SPECIALISE vec kernel_value(enum sph_kernel k, vec q2) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return vec_exp_minus(q2) - (real)SPH_GAUSSIAN_C0;
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_slope_scale(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 2 / (M_PI * SPH_GAUSSIAN_C1);
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_value_scale(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 1 / (M_PI * SPH_GAUSSIAN_C1);
  }
  __builtin_unreachable();
}

/* Whether the slope, as a function of the distance, has a Fourier transform without negative
 * values, but for what the cut at the edge of the support leaves out: sum_ij c_i c_j slope_ij >= 0
 * then, wherever the particles are (Bochner). */
SPECIALISE bool kernel_is_definite(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return true;
  }
  __builtin_unreachable();
}

/* Pairs count below this q^2. A square lattice with h/dx = 4/3 has neighbours exactly on the edge
 * of a support of 3h; the last factor keeps them out whatever the rounding. */
SPECIALISE real kernel_cutoff2(enum sph_kernel k) {
  const double margin = sizeof(real) == sizeof(double) ? 1e-10 : 4e-6;
  return (real)(kernel_support(k) * kernel_support(k) * (1 - margin));
}
