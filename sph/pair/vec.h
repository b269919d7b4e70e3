/* Short vectors for the pair loops, through the compiler's vector extensions: one register of
 * whatever width the processor has, of floats (SPH_SINGLE) or doubles. A file that includes this
 * may be compiled for both (loops.c).
 *
 * A cluster of SPH_LANES targets fills one register, or a part of the cluster does where registers
 * are narrower; where they are wider, each target has SPH_SOURCES neighbouring elements, for as
 * many sources at a time. So the same loop serves every width:
 *
 *              floats               doubles
 *   AVX-512    8 targets, 2 sources 8 targets
 *   AVX2       8 targets            4 targets, 2 parts
 *   SSE2       4 targets, 2 parts   2 targets, 4 parts */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#ifdef __AVX2__
#include <immintrin.h>
#endif

#include "sph/family.h"
#include "sph/fluid/particles.h"

#ifdef SPH_SINGLE
typedef float real;
typedef int32_t real_bits;
#else
typedef double real;
typedef int64_t real_bits;
#endif

/* PLUNGE_WIDE_VECTORS takes the widest ones on any processor, in pieces, so that two sources at a
 * time are tested everywhere (tests/matrix.sh). */
#if defined __AVX512F__
#define SPH_AVX512
enum { SPH_VEC_BYTES = 64 };
#elif defined PLUNGE_WIDE_VECTORS
enum { SPH_VEC_BYTES = 64 };
#elif defined __AVX2__
#define SPH_AVX2
enum { SPH_VEC_BYTES = 32 };
#else
enum { SPH_VEC_BYTES = 16 };
#endif
typedef real vec __attribute__((vector_size(SPH_VEC_BYTES), may_alias));
typedef real_bits vec_bits __attribute__((vector_size(SPH_VEC_BYTES), may_alias));

enum {
  SPH_REALS = SPH_VEC_BYTES / (int)sizeof(real),
  SPH_SOURCES = SPH_REALS > SPH_LANES ? SPH_REALS / SPH_LANES : 1, /* taken at a time */
  SPH_TARGETS = SPH_REALS / SPH_SOURCES,
  SPH_PARTS = SPH_LANES / SPH_TARGETS /* registers that hold a cluster */
};
_Static_assert(SPH_SOURCES <= 2, "vec_sources has no more");

/* The same number in every element. */
SPECIALISE vec vec_of(real a) {
  return a - (vec){0};
}

/* a[0 .. SPH_SOURCES-1], over and over. */
SPECIALISE vec vec_sources(const real *a) {
  if (SPH_SOURCES == 1) return vec_of(a[0]);
  int64_t two; /* floats, as one: that is one instruction */
  memcpy(&two, a, sizeof two);
  typedef int64_t twos __attribute__((vector_size(SPH_VEC_BYTES), may_alias));
  return (vec)((twos){0} + two);
}

/* Eight numbers a and eight b, aligned to 64 bytes, in turn: out[2 k] = a[k], out[2 k + 1] = b[k].
 */
SPECIALISE void vec_interleave(const real *a, const real *b, real *out) {
#if defined SPH_AVX512 && defined SPH_SINGLE
  const __m512i place = _mm512_set_epi32(23, 7, 22, 6, 21, 5, 20, 4, 19, 3, 18, 2, 17, 1, 16, 0);
  _mm512_storeu_ps(out, _mm512_permutex2var_ps(_mm512_castps256_ps512(_mm256_load_ps(a)), place,
                                               _mm512_castps256_ps512(_mm256_load_ps(b))));
#else
  for (int k = 0; k < 8; k++) {
    out[2 * k] = a[k];
    out[2 * k + 1] = b[k];
  }
#endif
}

/* a where x < limit, else 0. */
SPECIALISE vec vec_where_less(vec a, vec x, vec limit) {
#if defined SPH_AVX512 && defined SPH_SINGLE
  return (vec)_mm512_maskz_mov_ps(_mm512_cmp_ps_mask((__m512)x, (__m512)limit, _CMP_LT_OQ),
                                  (__m512)a);
#elif defined SPH_AVX512
  return (vec)_mm512_maskz_mov_pd(_mm512_cmp_pd_mask((__m512d)x, (__m512d)limit, _CMP_LT_OQ),
                                  (__m512d)a);
#else
  return (vec)((vec_bits)a & (x < limit));
#endif
}

/* Whether x < limit in any element. */
SPECIALISE bool vec_any_less(vec x, vec limit) {
#if defined SPH_AVX512 && defined SPH_SINGLE
  return _mm512_cmp_ps_mask((__m512)x, (__m512)limit, _CMP_LT_OQ) != 0;
#elif defined SPH_AVX512
  return _mm512_cmp_pd_mask((__m512d)x, (__m512d)limit, _CMP_LT_OQ) != 0;
#elif defined SPH_AVX2 && defined SPH_SINGLE
  return _mm256_movemask_ps((__m256)(x < limit)) != 0;
#elif defined SPH_AVX2
  return _mm256_movemask_pd((__m256d)(x < limit)) != 0;
#else
  vec_bits m = x < limit;
  real_bits any = 0;
  for (int k = 0; k < SPH_REALS; k++) any |= m[k];
  return any != 0;
#endif
}

SPECIALISE vec vec_max(vec a, vec b) {
#if defined SPH_AVX512 && defined SPH_SINGLE
  return (vec)_mm512_max_ps((__m512)a, (__m512)b);
#elif defined SPH_AVX512
  return (vec)_mm512_max_pd((__m512d)a, (__m512d)b);
#else
  vec_bits m = a < b;
  return (vec)((m & (vec_bits)b) | (~m & (vec_bits)a));
#endif
}

SPECIALISE vec vec_abs(vec a) {
  const vec_bits sign = (vec_bits)-vec_of(0);
  return (vec)((vec_bits)a & ~sign);
}

/* |a| with the sign of b. */
SPECIALISE vec vec_with_sign(vec a, vec b) {
  const vec_bits sign = (vec_bits)-vec_of(0);
  return (vec)(((vec_bits)a & ~sign) | ((vec_bits)b & sign));
}

SPECIALISE vec vec_sqrt(vec a) {
#if defined SPH_AVX512 && defined SPH_SINGLE
  return (vec)_mm512_sqrt_ps((__m512)a);
#elif defined SPH_AVX512
  return (vec)_mm512_sqrt_pd((__m512d)a);
#elif defined SPH_AVX2 && defined SPH_SINGLE
  return (vec)_mm256_sqrt_ps((__m256)a);
#elif defined SPH_AVX2
  return (vec)_mm256_sqrt_pd((__m256d)a);
#else
  for (int k = 0; k < SPH_REALS; k++) a[k] = (real)sqrt((double)a[k]);
  return a;
#endif
}

/* exp(-s) for s >= 0: 2^(n+f) with n whole and |f| <= 1/2, and for 2^f a polynomial that
 * interpolates at Chebyshev points, of degree 5 (relative error 1.0e-7) or 10 (3e-16); the rounding
 * of s/ln 2 adds up to s times that of a number. Beyond s = 80 the power of two leaves the
 * exponent, and anything may come: the caller throws it away. The build that traps overflows keeps
 * it finite. */
SPECIALISE vec vec_exp_minus(vec s) {
#ifdef PLUNGE_TRAP_FLOATS
  for (int k = 0; k < SPH_REALS; k++) s[k] = s[k] < 80 ? s[k] : 80;
#endif
  const vec t = s * (real)-1.4426950408889634074;
#ifdef SPH_SINGLE
  const vec round = vec_of(0x1.8p23f); /* added, it leaves the whole number in the last bits */
  const vec n = t + round, f = t - (n - round);
  vec e = f * 1.33908633646712343e-3f + 9.67603191832205407e-3f;
  e = e * f + 5.550357114219077818e-2f;
  e = e * f + 0.24022107485308337545f;
  e = e * f + 0.69314718802622878105f;
  e = e * f + 1.00000007545489719297f;
  return (vec)((vec_bits)e + ((vec_bits)n << 23));
#else
  const vec round = vec_of(0x1.8p52);
  const vec n = t + round, f = t - (n - round);
  vec e = f * 7.07258594926922369985e-9 + 1.02086902999583058346e-7;
  e = e * f + 1.32154425879216e-6;
  e = e * f + 1.525265726020083e-5;
  e = e * f + 1.5403530441736050e-4;
  e = e * f + 1.33335582301649738e-3;
  e = e * f + 9.61812910760688852e-3;
  e = e * f + 5.550410866444771916e-2;
  e = e * f + 0.24022650695910098220;
  e = e * f + 0.69314718055994998285;
  e = e * f + 1.0;
  return (vec)((vec_bits)e + ((vec_bits)n << 52));
#endif
}
