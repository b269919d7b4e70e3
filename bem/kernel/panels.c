#include "bem/kernel/panels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/shape/smooth.h"
#include "common/base/array.h"

enum status bem_panels_reserve(struct bem_panels *p, size_t n) {
  if (n <= p->room) return OK;
  TRY(array_resize(&p->zeta, n, "boundary nodes"));
  TRY(array_resize(&p->dzeta, n, "boundary nodes"));
  TRY(array_resize(&p->re, n, "boundary nodes"));
  TRY(array_resize(&p->im, n, "boundary nodes"));
  TRY(array_resize(&p->middle, n, "boundary nodes"));
  TRY(array_resize(&p->half, n, "boundary nodes"));
  TRY(array_resize(&p->reach, n, "boundary nodes"));
  TRY(array_resize(&p->way, n, "boundary nodes"));
  TRY(array_resize(&p->basis, n, "boundary nodes"));
  TRY(array_resize(&p->weight, n, "boundary nodes"));
  TRY(array_resize(&p->weight_re, n, "boundary nodes"));
  TRY(array_resize(&p->weight_im, n, "boundary nodes"));
  TRY(array_resize(&p->slope, n, "boundary nodes"));
  p->room = n;
  return OK;
}

void bem_panels_destroy(struct bem_panels *p) {
  if (!p) return;
  free(p->zeta);
  free(p->dzeta);
  free(p->re);
  free(p->im);
  free(p->middle);
  free(p->half);
  free(p->reach);
  free(p->way);
  free(p->basis);
  free(p->weight);
  free(p->weight_re);
  free(p->weight_im);
  free(p->slope);
  free(p->chart);
  *p = (struct bem_panels){0};
}

double complex bem_map(double length, double complex z) {
  double complex s = csin(0.5 * M_PI / length * (length - z));
  return s * s;
}

double complex bem_map_slope(double length, double complex z) {
  return -0.5 * M_PI / length * csin(M_PI / length * (length - z));
}

/* Coefficients of the Lagrange polynomials through s[0..3], by powers of s: each is the product of
 * (s - s_q) over the other nodes, scaled to one at its own. */
static void lagrange(const double complex s[BEM_STENCIL],
                     double complex basis[BEM_STENCIL][BEM_STENCIL]) {
  for (int m = 0; m < BEM_STENCIL; m++) {
    double complex c[BEM_STENCIL] = {1}, scale = 1;
    int degree = 0;
    for (int q = 0; q < BEM_STENCIL; q++) {
      if (q == m) continue;
      degree++;
      for (int p = degree; p > 0; p--) c[p] = c[p - 1] - s[q] * c[p];
      c[0] *= -s[q];
      scale *= s[m] - s[q];
    }
    scale = 1 / scale;
    for (int p = 0; p < BEM_STENCIL; p++) basis[m][p] = c[p] * scale;
  }
}

/* d/dzeta of the polynomial through the nodes t[0..4] at t[at]. */
static void derivative(const double complex t[BEM_DERIVATIVE], size_t at,
                       double complex slope[BEM_DERIVATIVE]) {
  slope[at] = 0;
  for (size_t m = 0; m < BEM_DERIVATIVE; m++) {
    if (m == at) continue;
    double complex above = 1, below = t[m] - t[at];
    for (size_t j = 0; j < BEM_DERIVATIVE; j++) {
      if (j == m || j == at) continue;
      above *= t[at] - t[j];
      below *= t[m] - t[j];
    }
    slope[m] = above / below;
    slope[at] -= slope[m];
  }
}

/* Places of the nodes of a stencil. */
static void gather(const struct bem_panels *p, ptrdiff_t first, size_t count, double complex *t) {
  for (size_t m = 0; m < count; m++) {
    int image;
    const double complex zeta = p->zeta[bem_stencil_node(p, first + (ptrdiff_t)m, &image)];
    t[m] = image ? conj(zeta) : zeta;
  }
}

static void set_slope(struct bem_panels *p, size_t k) {
  const ptrdiff_t first = bem_stencil_first(p, k, BEM_DERIVATIVE);
  double complex t[BEM_DERIVATIVE];
  gather(p, first, BEM_DERIVATIVE, t);
  derivative(t, (size_t)((ptrdiff_t)k - first), p->slope[k]);
}

static void set_panel(struct bem_panels *p, size_t j) {
  double complex s[BEM_STENCIL];
  const double complex next = p->zeta[j + 1 < p->n ? j + 1 : 0];
  p->middle[j] = 0.5 * (p->zeta[j] + next);
  p->half[j] = 0.5 * (next - p->zeta[j]);
  const double complex inverse = 1 / p->half[j];
  gather(p, bem_stencil_first(p, j, BEM_STENCIL), BEM_STENCIL, s);
  for (size_t m = 0; m < BEM_STENCIL; m++) s[m] = (s[m] - p->middle[j]) * inverse;
  lagrange(s, p->basis[j]);
  for (int m = 0; m < BEM_STENCIL; m++) { /* odd powers integrate to zero over -1..1 */
    double complex sum = 0;
    for (int q = 0; q < BEM_STENCIL; q += 2) sum += p->basis[j][m][q] * (2.0 / (q + 1));
    p->weight[j][m] = sum * p->half[j];
  }
}

/* Half chords: panels nearer than so many are integrated exactly. The harmonic functions of the
 * tests are as exact with 4 or 24, but a rate jumps where a panel comes near: with 5, the steps of
 * a thin jet fall to 1e-7 sqrt(H/g) before it touches down. */
static const double NEAR = 8;

/* So that whoever looks for near panels can pass over the others. */
static void measure_way(struct bem_panels *p) {
  for (size_t j = 0; j < bem_panels_count(p); j++) {
    p->reach[j] = NEAR * cabs(p->half[j]);
    p->way[j] = j ? p->way[j - 1] + cabs(p->middle[j] - p->middle[j - 1]) +
                        fabs(p->reach[j] - p->reach[j - 1])
                  : 0;
  }
}

/* d/di, by the symmetric difference of a smooth surface, of what is f + i h at the nodes. */
static double complex smooth_slope(const struct bem_panels *p, size_t k, const double *f,
                                   const double *h) {
  double complex sum = 0;
  for (ptrdiff_t j = BEM_SMOOTH, at = (ptrdiff_t)k; j > 0; j--)
    sum += bem_smooth_weight[j] *
           (bem_stencil_value(p, at + j, f, h) - bem_stencil_value(p, at - j, f, h));
  return sum;
}

/* A node on a wall is its own mirror image: each has half of its weight. */
static double share(const struct bem_panels *p, size_t k) {
  return !bem_panels_closed(p) && (k == 0 || k + 1 == p->n) ? 0.5 : 1;
}

static void weigh_smooth(struct bem_panels *p) {
  for (size_t k = 0; k < p->n; k++) {
    const double complex weight = share(p, k) * smooth_slope(p, k, p->re, p->im);
    p->weight_re[k] = creal(weight);
    p->weight_im[k] = cimag(weight);
  }
}

/* What follows from the nodes in the mapped plane. */
static void interpolate(struct bem_panels *p) {
  const size_t n = p->n, panels = bem_panels_count(p);
#pragma omp parallel for schedule(static) if (n >= BEM_PARALLEL)
  for (size_t j = 0; j < n; j++) {
    p->re[j] = creal(p->zeta[j]);
    p->im[j] = cimag(p->zeta[j]);
    set_slope(p, j);
    if (j < panels) set_panel(p, j);
  }
  measure_way(p);
  if (p->smooth) {
    weigh_smooth(p);
    return;
  }
  for (size_t k = 0; k < n; k++) p->weight_re[k] = p->weight_im[k] = 0;
  for (size_t j = 0; j < panels; j++) {
    if (bem_panel_is_mirrored(p, j)) continue; /* always integrated exactly */
    const ptrdiff_t first = bem_stencil_first(p, j, BEM_STENCIL);
    for (int m = 0, image; m < BEM_STENCIL; m++) {
      const size_t k = bem_stencil_node(p, first + m, &image);
      p->weight_re[k] += creal(p->weight[j][m]);
      p->weight_im[k] += cimag(p->weight[j][m]);
    }
  }
}

void bem_panels_set(struct bem_panels *p, size_t n, const double *x, const double *y, double left,
                    double length) {
  p->n = n;
  p->period = (struct bem_period){0};
  p->left = left;
  p->length = length;
  p->mirrored[0] = p->mirrored[1] = p->smooth;
#pragma omp parallel for schedule(static) if (n >= BEM_PARALLEL)
  for (size_t k = 0; k < n; k++) {
    double complex z = CMPLX(x[k] - left, y[k]);
    if (k == 0 && p->held[0]) z = CMPLX(0, y[k]);
    if (k + 1 == n && p->held[1]) z = CMPLX(length, y[k]);
    p->zeta[k] = bem_map(length, z);
    p->dzeta[k] = bem_map_slope(length, z);
  }
  interpolate(p);
}

void bem_panels_set_round(struct bem_panels *p, size_t n, const double *x, const double *y,
                          const struct bem_period *period) {
  p->n = n;
  p->period = *period;
  p->mirrored[0] = p->mirrored[1] = 0;
#pragma omp parallel for schedule(static) if (n >= BEM_PARALLEL)
  for (size_t k = 0; k < n; k++) {
    double complex z = CMPLX(x[k], y[k]);
    p->zeta[k] = bem_period_map(period, z);
    p->dzeta[k] = bem_period_slope(period, z);
  }
  interpolate(p);
}

/* Charts for n nodes; those that there were stay. */
static enum status reserve_charts(struct bem_panels *p, size_t n) {
  if (n <= p->charts) return OK;
  TRY(array_resize(&p->chart, n, "charts of a map"));
  memset(p->chart + p->charts, 0, (n - p->charts) * sizeof *p->chart);
  p->charts = n;
  return OK;
}

/* A node is looked up in the chart that it had, else in one that comes from its neighbour's, along
 * the surface. */
static enum status look_up(struct bem_panels *p, size_t k, double complex z,
                           const struct bem_conformal *walls, size_t side) {
  struct bem_chart *c = p->chart + k;
  if (bem_chart_find(c, z, p->zeta + k, p->dzeta + k)) return OK;
  if (k == 0) {
    TRY(bem_conformal_start(walls, side, z, c));
  } else {
    *c = c[-1];
    TRY(bem_chart_walk(walls, c, z));
  }
  bem_chart_find(c, z, p->zeta + k, p->dzeta + k);
  return OK;
}

/* Sides are followed with the water on their left. */
static int leans_over(const struct bem_conformal *walls, size_t side) {
  const double ROUNDING = 1e-9;
  return creal(bem_conformal_along(walls, side)) < -ROUNDING;
}

/* Walls that move go on exactly, edges of the water as the time integrator has them. */
static double complex on_side(const struct bem_conformal *walls, size_t side, double complex z) {
  const double complex a = walls->point[side], along = bem_conformal_along(walls, side);
  return a + creal((z - a) * conj(along)) * along;
}

enum status bem_panels_set_walls(struct bem_panels *p, size_t n, const double *x, const double *y,
                                 const struct bem_conformal *walls, const size_t side[2]) {
  p->n = n;
  p->period = (struct bem_period){0};
  if (p->walls != walls || p->changes != walls->changes)
    for (size_t k = 0; k < p->charts; k++) p->chart[k].radius = 0;
  p->walls = walls;
  p->changes = walls->changes;
  for (int end = 0; end < 2; end++)
    p->mirrored[end] = !p->kinked[end] && !leans_over(walls, side[end]);
  TRY(reserve_charts(p, n));
  for (size_t k = 0; k < n; k++) {
    double complex z = CMPLX(x[k], y[k]);
    if (walls->changes && (k == 0 || k + 1 == n)) z = on_side(walls, side[k > 0], z);
    TRY(look_up(p, k, z, walls, side[0]));
  }
  p->zeta[0] = creal(p->zeta[0]); /* walls are on the real axis */
  p->zeta[n - 1] = creal(p->zeta[n - 1]);
  interpolate(p);
  return OK;
}

static void smooth_velocity(const struct bem_panels *p, const double *phi, const double *psi,
                            double complex *w) {
  for (size_t k = 0; k < p->n; k++)
    w[k] = smooth_slope(p, k, phi, psi) * share(p, k) / CMPLX(p->weight_re[k], p->weight_im[k]) *
           p->dzeta[k];
}

void bem_panels_velocity(const struct bem_panels *p, const double *phi, const double *psi,
                         double complex *w) {
  if (p->smooth) {
    smooth_velocity(p, phi, psi, w);
    return;
  }
  for (size_t k = 0; k < p->n; k++) {
    const ptrdiff_t first = bem_stencil_first(p, k, BEM_DERIVATIVE);
    double complex sum = 0;
    for (int m = 0; m < BEM_DERIVATIVE; m++)
      sum += p->slope[k][m] * bem_stencil_value(p, first + m, phi, psi);
    w[k] = sum * p->dzeta[k];
  }
}
