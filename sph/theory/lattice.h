/* A kernel on an undisturbed square lattice that fills the plane, of volumes dx^2: its sums over
 * neighbours, and what they make of a plane wave exp(i k . r). Lengths in h, wave numbers in 1/h.
 *
 * Odd sums vanish, so that each symbol is real, up to a factor i of the gradient:
 *
 *   sum W V f                        ->  W f
 *   sum grad W V (f_j +- f_i)        ->  i (Gx, Gy) f     or the gradient by a fit (derivative.h)
 *   D of a density diffusion         -> -D f       h^2 D of pair/diffusion.h, without delta
 *   sum pi_ij grad W V (h^2 of it)   -> -[xx xy; xy yy] (u, v)
 *
 * D of Antuono's term holds the smoothing of the renormalised gradient. It is D_M - s . L^-1 s, D_M
 * being Molteni's, s = sum r slope V sin k.r and L = sum r (x) r slope V; at long waves B k^4 with
 * B = sum x^4 slope V / 4, three times what the paper's (13) has for an exact gradient. */
#pragma once
#include <stddef.h>

#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/kernel.h"
#include "sph/scheme.h"

enum { SPH_LATTICE_REACH = 12 }; /* rows on either side that there is room for */

struct sph_neighbour {
  int i, j;        /* columns and rows away */
  double x, y, q2; /* away, h; squared distance */
  double W, e;     /* value V, slope V (kernel.h) */
  double gx, gy;   /* grad_i W V */
};

struct sph_lattice {
  enum sph_kernel kernel;
  enum sph_derivative derivative; /* what Gx and Gy are of */
  double h_over_dx;
  double radius; /* h: of the neighbours in mls and mueller */
  size_t n;      /* of neighbours, the particle itself included */
  struct sph_neighbour near[(2 * SPH_LATTICE_REACH + 1) * (2 * SPH_LATTICE_REACH + 1)];
};

/* For kernel_support times h_over_dx of SPH_LATTICE_REACH at most: a case asks for 9. By the
 * kernel's sums, or as a scheme takes derivatives. */
void sph_lattice_of(enum sph_kernel k, double h_over_dx, struct sph_lattice *l);
void sph_lattice_of_scheme(const struct sph_scheme *o, struct sph_lattice *l);

/* sum x^m y^n W V, sum x^m y^n gx, sum x^m y^n e over the neighbours that are at most `above` rows
 * higher: SPH_LATTICE_REACH is all of them, n the particle n rows below a surface. */
double sph_lattice_moment(const struct sph_lattice *l, int m, int n, int above);
double sph_lattice_gradient_moment(const struct sph_lattice *l, int m, int n, int above);
double sph_lattice_slope_moment(const struct sph_lattice *l, int m, int n, int above);

/* How far a point `away` spacings beyond the outermost row and column of a lattice that fills a
 * quarter of the plane is from the centre of its neighbours, squared, over their variance that way
 * (Mahalanobis). */
double sph_lattice_corner(enum sph_kernel k, double h_over_dx, double away);

struct sph_symbols {
  double W, Gx, Gy, D;
  double xx, xy, yy;
};
void sph_lattice_symbols(const struct sph_lattice *l, enum sph_diffusion d, double kx, double ky,
                         struct sph_symbols *out);

/* The largest |G| and D of any wave that the lattice carries, up to the 1e-3 of a search. */
void sph_lattice_extremes(const struct sph_lattice *l, enum sph_diffusion d, double *sound,
                          double *decay);

/* The same in the continuum: int x^m y^n W, int x^m y^n slope, and the transform of W, by the
 * midpoint rule; to 1e-6. The paper's B, (13) with an exact gradient, is slope_moment(4, 0)/12. */
double sph_kernel_moment(enum sph_kernel k, int m, int n);
double sph_kernel_slope_moment(enum sph_kernel k, int m, int n);
double sph_kernel_transform(enum sph_kernel k, double kx, double ky);
