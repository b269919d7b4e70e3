/* Linear waves of compressible water at rest under gravity, on a flat bed: the modes of the thesis
 * (Kiara, MIT 2010), eqs. (2.25) to (2.65).
 *
 * The water's density at rest is rho0 exp(-2 delta y) with delta = g/(2 c^2), y from the surface
 * (0) down to the bed (-H). A wave of wavenumber kappa has the potential Re[C psi(y) exp i(kappa x
 * - omega t)], where psi'' - 2 delta psi' + (omega^2/c^2 - kappa^2) psi = 0, psi'(0) = (omega^2/g)
 * psi(0),  psi'(-H) = 0, and its pressure, over the density at rest, is i omega times the
 * potential. There is one mode that decays downwards, the gravity wave (almost that of
 * incompressible water), and one that oscillates for every n = 0, 1, 2 ..., an acoustic one, with
 * n + 1 zeros between surface and bed, the first of which is close to the surface. */
#pragma once
#include <stdbool.h>

struct wave_column {
  double gravity, sound, depth; /* g, m s^-2; c, m/s; H, m */
  double wavenumber;            /* kappa, rad/m */
};

struct wave_mode {
  struct wave_column in;
  bool decays;
  double delta; /* 1/m */
  double root;  /* mu of the mode that decays, nu of one that oscillates, 1/m */
  double omega; /* rad/s */
  double s;     /* psi = exp(delta y) (sin nu y + s cos nu y), s = psi(0) */
};

/* The root of mu H coth mu H = delta H (kappa^2 - delta^2 + mu^2)/(kappa^2 + delta^2 - mu^2),
 * (2.39), which there is where delta H (kappa^2 - delta^2) < kappa^2 + delta^2: always in water
 * whose density changes by less than e^2. */
struct wave_mode wave_mode_gravity(const struct wave_column *in);

/* The root of nu H cot nu H = delta H (kappa^2 - delta^2 - nu^2)/(kappa^2 + delta^2 + nu^2),
 * (2.57), between n pi and (n+1) pi. */
struct wave_mode wave_mode_acoustic(const struct wave_column *in, int n);

/* psi and its derivative at y <= 0 (m from the surface). The mode that decays is 1 at the surface;
 * of the others see above. */
double wave_mode_psi(const struct wave_mode *m, double y);
double wave_mode_slope(const struct wave_mode *m, double y); /* 1/m */

/* The wave of a mode that goes to the right, whose surface is A cos(kappa x - omega t): */
struct wave_motion {
  double u, v;            /* m/s */
  double xi, zeta;        /* ways of the particles from where they rest, m */
  double potential, push; /* m^2/s; pressure over density at rest, m^2 s^-2 */
};
struct wave_motion wave_mode_motion(const struct wave_mode *m, double amplitude, double x, double y,
                                    double t);
