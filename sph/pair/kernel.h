/* The smoothing kernels: one list, and a few small functions.
 *
 * Lengths are in units of h, and (x, y) = (r_j - r_i)/h, q = |(x, y)|. The gradient at i of a
 * radial kernel is grad_i W_ij = slope (x, y) with slope = -W'(q)/q > 0: it points from i to j. A
 * product of kernels along x and y has a gradient in another direction; `slope` is then that of the
 * radial kernel with the same part along the pair, slope = (x, y) . grad_i W / q^2, with which
 * diffusion, viscosity and renormalisation work. A kernel that is a function of q^2 needs no square
 * root. value() and the two others leave out constant factors, which the *_scale() give: they are
 * applied once for each particle.
 *
 * Splines are written with c = max(1 - q, 0) and m = max(q, 1), so that every piece comes out of
 * one expression. */
#pragma once
#include "sph/family.h"
#include "sph/pair/vec.h"

/* The renormalised Gaussian, W = (exp(-q^2) - C0) / (pi h^2 C1) within 3h with C0 = exp(-9), C1 = 1
 * - 10 C0: C0 makes W vanish at the edge; C1 is 2 int_0^3 (exp(-q^2) - C0) q dq, so that W
 * integrates to one over the plane. slope = 2 exp(-q^2) / (pi h^4 C1). */
#define SPH_GAUSSIAN_C0 1.2340980408667956e-4 /* exp(-9) */
#define SPH_GAUSSIAN_C1 (1 - 10 * SPH_GAUSSIAN_C0)

#define SPH_KERNELS(X, ...)                                                                        \
  X(gaussian,                                                                                      \
    "renormalised Gaussian, support 3h: W ~ exp(-q^2) - exp(-9) (P, section V; Landrini et al. "   \
    "2007)",                                                                                       \
    ##__VA_ARGS__)                                                                                 \
  X(cubic,                                                                                         \
    "cubic B-spline of the distance, support 2h: W ~ (2-q)^3 - 4 (1-q)^3 (Monaghan & Lattanzio "   \
    "1985)",                                                                                       \
    ##__VA_ARGS__)                                                                                 \
  X(tensor,                                                                                        \
    "product of cubic B-splines w(x) w(y), support |x|, |y| < 2h (thesis, eqs. 2.110, 2.111); "    \
    "forces are not along pairs: keeps momentum, not angular momentum",                            \
    ##__VA_ARGS__)                                                                                 \
  X(wendland_c2, "Wendland C2, support 2h: W ~ (1 - q/2)^4 (1 + 2q) (Wendland 1995)",              \
    ##__VA_ARGS__)                                                                                 \
  X(wendland_c4, "Wendland C4, support 2h: W ~ (1 - q/2)^6 (1 + 3q + 35/12 q^2) (Wendland 1995)",  \
    ##__VA_ARGS__)                                                                                 \
  X(quintic,                                                                                       \
    "quintic B-spline of the distance, support 3h: W ~ (3-q)^5 - 6 (2-q)^5 + 15 (1-q)^5 (Morris "  \
    "et al. 1997)",                                                                                \
    ##__VA_ARGS__)
SPH_FAMILY(sph_kernel, SPH_KERNEL, SPH_KERNELS);

/* Whether W is a function of the distance alone. */
SPECIALISE bool kernel_is_radial(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
  case SPH_KERNEL_cubic:
  case SPH_KERNEL_wendland_c2:
  case SPH_KERNEL_wendland_c4:
  case SPH_KERNEL_quintic:
    return true;
  case SPH_KERNEL_tensor:
    return false;
  }
  __builtin_unreachable();
}

/* Radius of the support, in h: of the circle round it. */
SPECIALISE double kernel_support(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
  case SPH_KERNEL_quintic:
    return 3;
  case SPH_KERNEL_tensor:
    return 2 * M_SQRT2;
  case SPH_KERNEL_cubic:
  case SPH_KERNEL_wendland_c2:
  case SPH_KERNEL_wendland_c4:
    return 2;
  }
  __builtin_unreachable();
}

/* Of a cubic B-spline along one axis, a = |x|: 6 w and -2 w'. */
SPECIALISE vec kernel_spline(vec a) {
  const vec b = (real)2 - a, c = vec_max((real)1 - a, (vec){0});
  return b * b * b - c * c * c * (real)4;
}

SPECIALISE vec kernel_spline_fall(vec a) {
  const vec b = (real)2 - a, c = vec_max((real)1 - a, (vec){0});
  return b * b - c * c * (real)4;
}

/* The three that follow hold inside the support, without their constant factors; the caller cuts
 * them off. The gradient has the factor of the slope, and is for kernels that are not radial. */
SPECIALISE void kernel_gradient(enum sph_kernel k, vec x, vec y, vec *gx, vec *gy) {
  (void)k; /* there is one such kernel */
  const vec ax = vec_abs(x), ay = vec_abs(y);
  *gx = vec_with_sign(kernel_spline_fall(ax), x) * kernel_spline(ay);
  *gy = vec_with_sign(kernel_spline_fall(ay), y) * kernel_spline(ax);
}

SPECIALISE vec kernel_slope(enum sph_kernel k, vec x, vec y, vec q2) {
  const vec one = vec_of(1), zero = {0};
  switch (k) {
  case SPH_KERNEL_gaussian:
    return vec_exp_minus(q2);
  case SPH_KERNEL_cubic: {
    const vec q = vec_sqrt(q2), m = vec_max(q, one), b = (real)2 - m;
    return b * b / m + (m - q) * (real)3;
  }
  case SPH_KERNEL_tensor: { /* 16 where they meet */
    const real tiny = (real)1e-24;
    vec gx, gy;
    kernel_gradient(k, x, y, &gx, &gy);
    return (gx * x + gy * y + 16 * tiny) / (q2 + tiny);
  }
  case SPH_KERNEL_wendland_c2: {
    const vec b = one - vec_sqrt(q2) * (real)0.5;
    return b * b * b;
  }
  case SPH_KERNEL_wendland_c4: {
    const vec q = vec_sqrt(q2), b = one - q * (real)0.5, b2 = b * b;
    return b2 * b2 * b * (one + q * (real)2.5);
  }
  case SPH_KERNEL_quintic: {
    const vec q = vec_sqrt(q2), m = vec_max(q, one), c = m - q;
    const vec a = (real)3 - m, b = vec_max((real)2 - m, zero), a2 = a * a, b2 = b * b;
    return (a2 * a2 - b2 * b2 * (real)6) / m + c * ((real)18 + c * ((real)6 - c * (real)10));
  }
  }
  __builtin_unreachable();
}

SPECIALISE vec kernel_value(enum sph_kernel k, vec x, vec y, vec q2) {
  const vec one = vec_of(1), zero = {0};
  switch (k) {
  case SPH_KERNEL_gaussian:
    return vec_exp_minus(q2) - (real)SPH_GAUSSIAN_C0;
  case SPH_KERNEL_cubic:
    return kernel_spline(vec_sqrt(q2));
  case SPH_KERNEL_tensor:
    return kernel_spline(vec_abs(x)) * kernel_spline(vec_abs(y));
  case SPH_KERNEL_wendland_c2: {
    const vec q = vec_sqrt(q2), b = one - q * (real)0.5, b2 = b * b;
    return b2 * b2 * (one + q + q);
  }
  case SPH_KERNEL_wendland_c4: {
    const vec q = vec_sqrt(q2), b = one - q * (real)0.5, b2 = b * b;
    return b2 * b2 * b2 * (one + q * ((real)3 + q * (real)(35. / 12)));
  }
  case SPH_KERNEL_quintic: {
    const vec q = vec_sqrt(q2), a = (real)3 - q, b = vec_max((real)2 - q, zero);
    const vec c = vec_max(one - q, zero), a2 = a * a, b2 = b * b, c2 = c * c;
    return a2 * a2 * a - b2 * b2 * b * (real)6 + c2 * c2 * c * (real)15;
  }
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_slope_scale(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 2 / (M_PI * SPH_GAUSSIAN_C1);
  case SPH_KERNEL_cubic:
    return 15 / (14 * M_PI);
  case SPH_KERNEL_tensor:
    return 1. / 12;
  case SPH_KERNEL_wendland_c2:
    return 35 / (4 * M_PI);
  case SPH_KERNEL_wendland_c4:
    return 21 / (2 * M_PI);
  case SPH_KERNEL_quintic:
    return 35 / (478 * M_PI);
  }
  __builtin_unreachable();
}

SPECIALISE double kernel_value_scale(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 1 / (M_PI * SPH_GAUSSIAN_C1);
  case SPH_KERNEL_cubic:
    return 5 / (14 * M_PI);
  case SPH_KERNEL_tensor:
    return 1. / 36;
  case SPH_KERNEL_wendland_c2:
    return 7 / (4 * M_PI);
  case SPH_KERNEL_wendland_c4:
    return 9 / (4 * M_PI);
  case SPH_KERNEL_quintic:
    return 7 / (478 * M_PI);
  }
  __builtin_unreachable();
}

/* Whether the slope, as a function of the distance, has a Fourier transform in the plane without
 * negative values, but for what the cut at the edge of the support leaves out: sum_ij c_i c_j
 * slope_ij >= 0 then, wherever the particles are (Bochner). That of -W'/q in three dimensions is
 * that of W in one (Wendland 1995), for B-splines a power of a sinc; and what is so in space is so
 * in a plane. Wendland's slopes, (1 - q/2)^3 and (1 - q/2)^5 (1 + 5 q/2), are functions of Askey
 * and of Wendland by themselves. */
SPECIALISE bool kernel_is_definite(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
  case SPH_KERNEL_cubic:
  case SPH_KERNEL_wendland_c2:
  case SPH_KERNEL_wendland_c4:
  case SPH_KERNEL_quintic:
    return true;
  case SPH_KERNEL_tensor:
    return false;
  }
  __builtin_unreachable();
}

/* q slope/2, with which Ferrari's diffusion weighs a pair, is not so; but with as much of (1 - q)^3
 * within q < 1, a function of Askey, added to it, for radial kernels (tests/sph/test_diffuse.c). */
SPECIALISE double kernel_lift(enum sph_kernel k) {
  switch (k) {
  case SPH_KERNEL_gaussian:
    return 0.537;
  case SPH_KERNEL_cubic:
    return 1.763;
  case SPH_KERNEL_wendland_c2:
    return 0.19;
  case SPH_KERNEL_wendland_c4:
    return 0.272;
  case SPH_KERNEL_quintic:
    return 16.23;
  case SPH_KERNEL_tensor:
    return INFINITY;
  }
  __builtin_unreachable();
}

/* Pairs count while this, q^2 or what stands for it, is below kernel_cutoff2. */
SPECIALISE vec kernel_reach2(enum sph_kernel k, vec x, vec y, vec q2) {
  return kernel_is_radial(k) ? q2 : vec_max(x * x, y * y);
}

/* A square lattice with h/dx = 4/3 has neighbours exactly on the edge of a support of 3h; the last
 * factor keeps them out whatever the rounding. */
SPECIALISE real kernel_cutoff2(enum sph_kernel k) {
  const double margin = sizeof(real) == sizeof(double) ? 1e-10 : 4e-6;
  const double half_width = kernel_is_radial(k) ? kernel_support(k) : kernel_support(k) / M_SQRT2;
  return (real)(half_width * half_width * (1 - margin));
}
