/* dy/dt = f(y), f linear and decaying, over a step: the exponential of the operator by Chebyshev
 * polynomials (Tal-Ezer & Kosloff 1984; of decay: Tal-Ezer 1989), for the price of one f a degree.
 * Where no mode decays faster than at Z/dt,
 *
 *   exp(z) = sum_k c_k T_k(1 + 2 z/Z),  c_k = (2 - [k = 0]) exp(-Z/2) I_k(Z/2),  -Z <= z <= 0
 *
 * whose terms fall faster than any power beyond k = sqrt(Z). So every mode decays about as it
 * should, the fastest ones too, which methods of Runge and Kutta with as many stages hold up. */
#pragma once

enum { SPH_CHEBYSHEV_MOST = 64 }; /* degree */

struct sph_chebyshev {
  int degree;
  double Z;
  double c[SPH_CHEBYSHEV_MOST + 1]; /* from c[1]; c_0 is what makes the sum one */
};

/* As many terms as leave out less than 0.2 % in sum; those that stay are scaled so that slow modes
 * decay exactly at their rate, as polynomials of the degree can. Whatever is constant stays to
 * rounding. For Z beyond what the largest degree serves, degree is SPH_CHEBYSHEV_MOST + 1. */
struct sph_chebyshev sph_chebyshev_of(double Z);

/* What is left of a mode that decays by exp(z). */
double sph_chebyshev_value(const struct sph_chebyshev *p, double z);
