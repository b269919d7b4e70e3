#include "bem/integrals.h"

#include <math.h>

/* moment[q] = integral over -1..1 of s^q / (s - sigma) ds: I_q = sigma I_(q-1) + (1 - (-1)^q) / q.
 * `regular` leaves out the logarithm, which the caller knows to be multiplied by zero. */
static void moments(double complex sigma, int regular, double complex moment[BEM_STENCIL]) {
  moment[0] = regular ? 0 : clog((sigma - 1) / (sigma + 1));
  for (int q = 1; q < BEM_STENCIL; q++) moment[q] = sigma * moment[q - 1] + (q % 2 ? 2.0 / q : 0.0);
}

/* The equation of a node while it is summed; what its own psi and phi have is kept apart. */
struct equation {
  double *a, *b, diagonal_a, diagonal_b;
};

/* Adds the exact integral over panel j, seen from tau, less its quadrature, which the loop over all
 * nodes has counted. node: the collocation node if tau is that node itself, else p->n. sign is -1
 * for the mirror image. */
static void correct(const struct bem_panels *p, size_t j, double complex tau, size_t node,
                    double sign, struct equation *e) {
  size_t first = (size_t)bem_stencil_first(p, j, BEM_STENCIL);
  double complex moment[BEM_STENCIL];
  int regular = node >= first && node < first + BEM_STENCIL;
  moments((tau - p->middle[j]) / p->half[j], regular, moment);
  for (size_t m = 0; m < BEM_STENCIL; m++) {
    size_t k = first + m;
    if (k == node) continue; /* beta - beta_k vanishes there */
    double complex c = 0;
    for (int q = 0; q < BEM_STENCIL; q++) c += p->basis[j][m][q] * moment[q];
    c -= p->weight[j][m] / (p->zeta[k] - tau);
    e->a[k] += sign * cimag(c);
    e->b[k] += sign * creal(c);
    e->diagonal_a += cimag(c);
    e->diagonal_b += sign * creal(c);
  }
}

/* Adds the integral over a panel whose stencil is mirrored, which the loop over all nodes has left
 * out. */
static void add_mirrored(const struct bem_panels *p, size_t j, double complex tau, size_t node,
                         double sign, struct equation *e) {
  const ptrdiff_t first = bem_stencil_first(p, j, BEM_STENCIL), at = (ptrdiff_t)node;
  double complex moment[BEM_STENCIL];
  moments((tau - p->middle[j]) / p->half[j], at >= first && at < first + BEM_STENCIL, moment);
  for (int m = 0; m < BEM_STENCIL; m++) {
    int image;
    const size_t k = bem_stencil_node(p, first + m, &image);
    if (k == node && !image) continue;
    double complex c = 0;
    for (int q = 0; q < BEM_STENCIL; q++) c += p->basis[j][m][q] * moment[q];
    e->a[k] += image ? -sign * cimag(c) : sign * cimag(c);
    e->b[k] += sign * creal(c);
    e->diagonal_a += cimag(c);
    e->diagonal_b += sign * creal(c);
  }
}

/* Whether panel j is near x + i y. */
static int panel_is_near(const struct bem_panels *p, size_t j, double x, double y) {
  const double near =
      8; /* half chords; the harmonic function of the tests is as exact with 4 or 24 */
  double dx = x - creal(p->middle[j]), dy = y - cimag(p->middle[j]);
  double a = creal(p->half[j]), b = cimag(p->half[j]);
  return dx * dx + dy * dy < near * near * (a * a + b * b);
}

/* Own contour: real part of W (beta_n - beta_k); mirror image, for W' seen from conj(zeta_k):
 * real part of -W' (beta_n - conj(beta_k)). */
void bem_integrals_row(const struct bem_panels *p, size_t k, double *a, double *b) {
  const size_t n = p->n;
  const double x = p->re[k], y = p->im[k];
  const double *re = p->re, *im = p->im, *wr = p->weight_re, *wi = p->weight_im;
  double diagonal_a = 0, diagonal_b = 0;
#pragma omp simd reduction(+ : diagonal_a, diagonal_b)
  for (size_t m = 0; m < n; m++) {
    double dx = re[m] - x, dy = im[m] - y, ey = im[m] + y;
    double r2 = dx * dx + dy * dy;
    double own = m == k ? 0 : 1 / (m == k ? 1 : r2), mirror = 1 / (dx * dx + ey * ey);
    double own_re = (wr[m] * dx + wi[m] * dy) * own, own_im = (wi[m] * dx - wr[m] * dy) * own;
    double mirror_re = (wr[m] * dx + wi[m] * ey) * mirror;
    double mirror_im = (wi[m] * dx - wr[m] * ey) * mirror;
    a[m] = own_im - mirror_im;
    b[m] = own_re - mirror_re;
    diagonal_a += own_im + mirror_im;
    diagonal_b += own_re - mirror_re;
  }
  struct equation e = {a, b, diagonal_a, diagonal_b};
  for (size_t j = 0; j + 1 < n; j++) {
    if (bem_panel_is_mirrored(p, j)) {
      add_mirrored(p, j, p->zeta[k], k, 1, &e);
      add_mirrored(p, j, conj(p->zeta[k]), n + BEM_STENCIL, -1, &e);
      continue;
    }
    size_t first = (size_t)bem_stencil_first(p, j, BEM_STENCIL);
    if (panel_is_near(p, j, x, y) || (k >= first && k < first + BEM_STENCIL))
      correct(p, j, p->zeta[k], k, 1, &e);
    if (panel_is_near(p, j, x, -y)) correct(p, j, conj(p->zeta[k]), n, -1, &e);
  }
  a[k] -= e.diagonal_a;
  b[k] -= e.diagonal_b;
}

/* Integrals over the surface seen from a point: of f + i h, of its derivative, and of one. */
struct contour {
  double complex value, slope, winding;
};

/* Adds those of panel j. */
static void add_panel(const struct bem_panels *p, size_t j, const double *f, const double *h,
                      double complex tau, struct contour *sum) {
  const ptrdiff_t first = bem_stencil_first(p, j, BEM_STENCIL);
  double complex moment[BEM_STENCIL], c[BEM_STENCIL] = {0};
  moments((tau - p->middle[j]) / p->half[j], 0, moment);
  for (int m = 0; m < BEM_STENCIL; m++) {
    const double complex value = bem_stencil_value(p, first + m, f, h);
    for (int q = 0; q < BEM_STENCIL; q++) c[q] += p->basis[j][m][q] * value;
  }
  for (int q = 0; q < BEM_STENCIL; q++) sum->value += c[q] * moment[q];
  for (int q = 1; q < BEM_STENCIL; q++) sum->slope += q * c[q] * moment[q - 1] / p->half[j];
  sum->winding += moment[0];
}

/* The surface and its mirror image close the contour, so f(tau) is the mean of f weighted with
 * dt / (t - tau), and its derivative the same mean of d f / dt, for f continuous along it. */
void bem_integrals_inside(const struct bem_panels *p, const double *f, const double *h,
                          double complex tau, double complex *value, double complex *slope) {
  struct contour own = {0}, seen = {0}; /* seen: the surface from the mirror image of tau */
  for (size_t j = 0; j + 1 < p->n; j++) {
    add_panel(p, j, f, h, tau, &own);
    add_panel(p, j, f, h, conj(tau), &seen);
  }
  double complex winding = own.winding - conj(seen.winding);
  *value = (own.value - conj(seen.value)) / winding;
  *slope = (own.slope - conj(seen.slope)) / winding;
}
