/* Eight doubles at a time, through the compiler's vector extensions: one register with AVX-512, two
 * with AVX2, four with SSE2. Only what those extensions cannot say well is written by hand. */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#ifdef __AVX512F__
#include <immintrin.h>
#endif

#define SPECIALISE static inline __attribute__((always_inline))

enum { SPH_LANES = 8 };
typedef double vec __attribute__((vector_size(64), may_alias));
typedef int64_t vec_bits __attribute__((vector_size(64), may_alias));

/* Elements i .. i+7 of an array that is aligned to 64 bytes, i a multiple of 8. */
SPECIALISE vec vec_load(const double *a) {
  return *(const vec *)__builtin_assume_aligned(a, 64);
}

SPECIALISE void vec_store(double *a, vec v) {
  *(vec *)__builtin_assume_aligned(a, 64) = v;
}

/* a where x < limit, else 0. */
SPECIALISE vec vec_where_less(vec a, vec x, vec limit) {
#ifdef __AVX512F__
  return _mm512_maskz_mov_pd(_mm512_cmp_pd_mask(x, limit, _CMP_LT_OQ), a);
#else
  return (vec)((vec_bits)a & (x < limit));
#endif
}

SPECIALISE bool vec_any_less(vec x, vec limit) {
#ifdef __AVX512F__
  return _mm512_cmp_pd_mask(x, limit, _CMP_LT_OQ) != 0;
#else
  vec_bits m = x < limit;
  int64_t any = 0;
  for (int l = 0; l < SPH_LANES; l++) any |= m[l];
  return any != 0;
#endif
}

SPECIALISE vec vec_max(vec a, vec b) {
#ifdef __AVX512F__
  return _mm512_max_pd(a, b);
#else
  vec_bits m = a < b;
  return (vec)((m & (vec_bits)b) | (~m & (vec_bits)a));
#endif
}

SPECIALISE vec vec_abs(vec a) {
  return (vec)((vec_bits)a & INT64_MAX);
}

SPECIALISE vec vec_sqrt(vec a) {
#ifdef __AVX512F__
  return _mm512_sqrt_pd(a);
#else
  for (int l = 0; l < SPH_LANES; l++) a[l] = sqrt(a[l]);
  return a;
#endif
}

/* Lane by lane in a fixed order. */
SPECIALISE double vec_sum(vec a) {
  return ((a[0] + a[1]) + (a[2] + a[3])) + ((a[4] + a[5]) + (a[6] + a[7]));
}

SPECIALISE double vec_largest(vec a) {
  double m = a[0];
  for (int l = 1; l < SPH_LANES; l++) m = a[l] > m ? a[l] : m;
  return m;
}

/* exp(-s) for 0 <= s <= 9, relative error below 4e-14: a polynomial of degree 9 in s/16 that
 * interpolates at Chebyshev points of [0, 9/16], raised to the 16th power. Finite for s < 100.
 * Water that is far apart may share a cluster; beyond 100 the caller throws away whatever comes, so
 * only the build that traps overflows spends time (4 % of an evaluation) on keeping it finite. */
SPECIALISE vec vec_exp_minus(vec s) {
#ifdef PLUNGE_TRAP_FLOATS
  for (int l = 0; l < SPH_LANES; l++) s[l] = fmin(s[l], 100);
#endif
  vec z = s * 0.0625;
  vec e = z * -2.0838782607272764e-6 + 2.4037212709390439e-5;
  e = e * z + -0.00019791906282923116;
  e = e * z + 0.0013886942682746905;
  e = e * z + -0.0083332855970618849;
  e = e * z + 0.041666659517014696;
  e = e * z + -0.16666666605038913;
  e = e * z + 0.49999999997298501;
  e = e * z + -0.99999999999954013;
  e = e * z + 0.99999999999999871;
  e *= e;
  e *= e;
  e *= e;
  return e * e;
}
