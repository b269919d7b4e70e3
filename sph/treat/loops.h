/* The pair loops of treatments, made like those of pair/loops.h. */
#pragma once
#include "sph/pair/loops.h"

/* Vectors, with V_ij = V_j 2 rho_j/(rho_i + rho_j), so that rho_i V_i V_ij is the same from both
 * sides; units h, c0, rho0. */
struct sph_vector_sums {
  double x[SPH_LANES], y[SPH_LANES];
};

struct sph_treat_loops {
  /* sum (u_j - u_i) value V_ij */
  void (*mix)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
              struct sph_vector_sums *sums);
  /* sum (1 + crowding f^4) (r_j - r_i) slope V_ij, f = W/W(dx) */
  void (*crowd)(const struct sph *s, double crowding, const struct sph_targets *i,
                const struct sph_near *near, struct sph_vector_sums *sums);
  /* the sums px, py of the rates (loops.h), each pair with two negative pressures times f^n */
  void (*tension)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                  struct sph_vector_sums *sums);
};
extern const struct sph_treat_loops sph_treat_loops_single[SPH_KERNEL_COUNT],
    sph_treat_loops_double[SPH_KERNEL_COUNT];

static inline const struct sph_treat_loops *sph_treat_loops_for(const struct sph *s,
                                                                const struct sph_targets *i) {
  return (sph_takes_doubles(s, i) ? sph_treat_loops_double : sph_treat_loops_single) +
         s->scheme.kernel;
}
