/* The smoothing kernels: one list, and two small functions for each.
 *
 * The renormalised Gaussian (P, section V; after Landrini et al. 2007): with q = |r|/h and support
 * 3h W = (exp(-q^2) - C0) / (pi h^2 C1),   C0 = exp(-9),  C1 = 1 - 10 C0. C0 makes W vanish at the
 * edge; C1 is 2 int_0^3 (exp(-q^2) - C0) q dq, so that W integrates to one over the plane. Its
 * gradient at i is grad_i W_ij = slope(q^2) (r_j - r_i),   slope = 2 exp(-q^2) / (pi h^4 C1) > 0:
 * it points from i to j, and needs no square root. slope() leaves out the constant factor, which
 * kernel_slope_scale() gives: the pair loops apply it once for each particle. */
#pragma once
#include "sph/pair/vec.h"

#define SPH_KERNELS(X, ...) X(gaussian, ##__VA_ARGS__)

enum sph_kernel {
#define X(k) SPH_KERNEL_##k,
  SPH_KERNELS(X)
#undef X
};

enum {
  SPH_N_KERNELS = 0
#define X(k) +1
  SPH_KERNELS(X)
#undef X
};

#define SPH_KERNEL_SUPPORT 3.0                   /* radius of the support, in h */
#define SPH_GAUSSIAN_C0    1.2340980408667956e-4 /* exp(-9) */
#define SPH_GAUSSIAN_C1    (1 - 10 * SPH_GAUSSIAN_C0)

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
    return vec_exp_minus(q2) - SPH_GAUSSIAN_C0;
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_slope_scale(enum sph_kernel k, double h) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 2 / (M_PI * h * h * h * h * SPH_GAUSSIAN_C1);
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_value_scale(enum sph_kernel k, double h) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 1 / (M_PI * h * h * SPH_GAUSSIAN_C1);
  }
  __builtin_unreachable();
}

/* Pairs count below this squared distance. A square lattice with h/dx = 4/3 has neighbours exactly
 * on the edge; the last factor keeps them out whatever the rounding. */
SPECIALISE double kernel_cutoff2(double h) {
  return SPH_KERNEL_SUPPORT * SPH_KERNEL_SUPPORT * h * h * (1 - 1e-10);
}
