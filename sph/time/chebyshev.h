/* The Runge-Kutta-Chebyshev method of order 2 for dy/dt = f(y) with decaying y (Sommeijer, Shampine
 * & Verwer, J. Comput. Appl. Math. 88, 1998, section 2): stable for -z <= 0.65 (stages^2 - 1) or
 * so, where z is dt times an eigenvalue, for the price of one f a stage.
 *
 *   y_1 = y_0 + mu1_1 dt f_0
 *   y_j = (1 - mu - nu) y_0 + mu y_(j-1) + nu y_(j-2) + dt (mu1 f_(j-1) + gamma1 f_0) */
#pragma once

enum { SPH_CHEBYSHEV_MOST = 32 }; /* stages */

struct sph_chebyshev {
  int stages;
  double mu[SPH_CHEBYSHEV_MOST + 1], nu[SPH_CHEBYSHEV_MOST + 1];
  double mu1[SPH_CHEBYSHEV_MOST + 1], gamma1[SPH_CHEBYSHEV_MOST + 1];
};

/* How many are stable where no mode decays faster than z/dt; at least 2. */
int sph_chebyshev_stages(double z);

/* The method with 2 to SPH_CHEBYSHEV_MOST stages. */
struct sph_chebyshev sph_chebyshev_of(int stages);
