/* Wave theory: standing waves in a rectangular tank.
 *
 * The initial condition that every solver starts from: at t = 0 the water is at rest (phi = 0, all
 * velocities zero) and its surface is, for x in the tank, which starts at x = left and is a whole
 * number of half wavelengths wide, y = bed + depth + amplitude cos(k (x - left)),  k = 2
 * pi/wavelength. wave_standing_elevation at t = 0 returns exactly that, at either order.
 *
 * Order 1 is linear theory. Order 2 is the exact solution of the second-order equations from this
 * initial condition: to the first harmonic it adds bound waves of wavenumber 2k and the free wave
 * of wavenumber 2k that makes them vanish at t = 0; and the frequency is the one of third order
 * (Tadjbakhsh & Keller, J. Fluid Mech. 8, 1960), so that the error does not grow before 1/(omega
 * (ka)^4): it stays of order (ka)^3 relative to the wavelength. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

struct wave_standing {
  double amplitude, wavelength, depth; /* a, 2 pi/k, d, m */
  double gravity;                      /* g, m s^-2 */
  double left, bed;                    /* x and y of the tank's lower left corner, m */
  int order;                           /* 1 or 2 */
  double k, omega;                     /* rad/m, rad/s */
  double bound_mean, bound;            /* m: 2k mode of the surface, constant and cos(2 omega t) */
  double bound_potential; /* m^2/s: 2k mode of phi at y = bed + depth, sin(2 omega t) */
  double free_omega;      /* rad/s, of the free wave of wavenumber 2k */
  bool bound_alone;       /* no free wave: see wave_standing_bind */
};

/* omega of linear theory, rad/s: omega^2 = g k tanh(k d). */
double wave_frequency_linear(double k, double depth, double gravity);

/* The (relative) change of frequency of a standing wave over (k a)^2: Tadjbakhsh & Keller (1960);
 * -1/8 in deep water, positive where k d < 1.058. */
double wave_frequency_shift(double k, double depth);

struct wave_standing wave_standing_create(double amplitude, double wavelength, double depth,
                                          double gravity, double left, double bed, int order);

/* Takes the free wave away from one of order 2: it then starts, at rest, with the crest of a
 * standing wave that repeats itself, amplitude cos kx + (bound_mean + bound) cos 2kx. */
void wave_standing_bind(struct wave_standing *w);

double wave_standing_elevation(const struct wave_standing *w, double x, double t); /* y, m */
/* Slope in x, and velocity in t, of the elevation. */
double wave_standing_slope(const struct wave_standing *w, double x, double t);
double wave_standing_rise(const struct wave_standing *w, double x, double t); /* m/s */

/* In the water, and in its analytic continuation above it. phi (m^2/s) has phi = 0 at t = 0. */
double wave_standing_potential(const struct wave_standing *w, double x, double y, double t);
void wave_standing_velocity(const struct wave_standing *w, double x, double y, double t,
                            double velocity[2]);
/* Pressure over density, m^2 s^-2, by Bernoulli's equation; zero above the water. */
double wave_standing_pressure(const struct wave_standing *w, double x, double y, double t);

/* Energies over density of the water between the tank's left wall and `width` (m; a whole number of
 * half wavelengths) farther, m^4 s^-2 : kinetic, and potential from y = 0. */
double wave_standing_kinetic(const struct wave_standing *w, double width, double t);
double wave_standing_potential_energy(const struct wave_standing *w, double width, double t);

/* What the theory leaves out, relative to what it keeps: an estimate, the larger of two.
 * - The energy that it gains or loses between 0 and `end` (s), over that of the wave. Water that
 *   starts at rest keeps its energy; at t = 0 the theory's is exact, and later its error is of the
 *   order that it neglects (for order 2: the products of the first order with the third).
 * - The next term of a series that falls by the ratio of the second order's elevation to the first:
 *   its square at order 2, the ratio itself at order 1. In shallow water the ratio grows like the
 *   Ursell number, a/(k^2 d^3), and the series fails before the energy tells. */
double wave_standing_error(const struct wave_standing *w, double end);
