#include "bem/kernel/integrals.h"

#include <math.h>

#include "bem/shape/smooth.h"

/* log((sigma - 1) / (sigma + 1)), without what clog does to be exact to the last bit. */
static double complex log_ratio(double complex sigma) {
  const double x = creal(sigma), y = cimag(sigma);
  const double above = (x - 1) * (x - 1) + y * y, below = (x + 1) * (x + 1) + y * y;
  const double off = -4 * x / below; /* above / below - 1 */
  return CMPLX(0.5 * (fabs(off) < 0.5 ? log1p(off) : log(above / below)),
               atan2(2 * y, x * x + y * y - 1));
}

/* moment[q] = integral over -1..1 of s^q / (s - sigma) ds: I_q = sigma I_(q-1) + (1 - (-1)^q) / q.
 * `regular` leaves out the logarithm, which the caller knows to be multiplied by zero. */
static void moments(double complex sigma, int regular, double complex moment[BEM_STENCIL]) {
  moment[0] = regular ? 0 : log_ratio(sigma);
  for (int q = 1; q < BEM_STENCIL; q++) moment[q] = sigma * moment[q - 1] + (q % 2 ? 2.0 / q : 0.0);
}

/* The equation of a node while it is summed; what its own psi and phi have is kept apart. */
struct equation {
  double *a, *b, diagonal_a, diagonal_b;
};

static int carries(const struct bem_panels *p, ptrdiff_t first, size_t node) {
  const ptrdiff_t at = bem_stencil_place(p, first, node);
  return at >= 0 && at < BEM_STENCIL;
}

/* Adds the exact integral over panel j, seen from tau, less its quadrature, which the loop over all
 * nodes has counted. node: the collocation node if tau is that node itself, else none
 * (bem_stencil_place). sign is -1 for the mirror image. */
static void correct(const struct bem_panels *p, size_t j, double complex tau, size_t node,
                    double sign, struct equation *e) {
  const ptrdiff_t first = bem_stencil_first(p, j, BEM_STENCIL);
  double complex moment[BEM_STENCIL];
  moments((tau - p->middle[j]) / p->half[j], carries(p, first, node), moment);
  for (int m = 0, image; m < BEM_STENCIL; m++) {
    const size_t k = bem_stencil_node(p, first + m, &image);
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

static double distance(double complex a, double complex b) {
  const double x = creal(a) - creal(b), y = cimag(a) - cimag(b);
  return sqrt(x * x + y * y);
}

/* The first panel after j that may be near a point whose distance from being near panel j is `gap`:
 * the way to those in between is shorter. */
static size_t next_panel(const struct bem_panels *p, size_t j, double gap) {
  const double *way = p->way, until = way[j] + gap;
  const size_t panels = bem_panels_count(p);
  size_t low = j, step = 1; /* way[low] < until */
  while (low + step < panels && way[low + step] < until) low += step, step *= 2;
  for (; step > 0; step /= 2)
    if (low + step < panels && way[low + step] < until) low += step;
  return low + 1;
}

/* The first panel from j on that is near tau; bem_panels_count: there is none. */
static size_t find_near(const struct bem_panels *p, double complex tau, size_t j) {
  while (j < bem_panels_count(p)) {
    const double gap = distance(tau, p->middle[j]) - p->reach[j];
    if (gap < 0) return j;
    j = next_panel(p, j, gap);
  }
  return bem_panels_count(p);
}

/* Panels whose polynomials node k carries are integrated exactly even where they are not near. */
static void correct_carried(const struct bem_panels *p, size_t k, struct equation *e) {
  const ptrdiff_t panels = (ptrdiff_t)bem_panels_count(p);
  for (ptrdiff_t i = (ptrdiff_t)k - BEM_STENCIL; i < (ptrdiff_t)k + BEM_STENCIL; i++) {
    if (!bem_panels_closed(p) && (i < 0 || i >= panels)) continue;
    const size_t j = (size_t)((i + panels) % panels);
    if (bem_panel_is_mirrored(p, j) || !carries(p, bem_stencil_first(p, j, BEM_STENCIL), k) ||
        distance(p->zeta[k], p->middle[j]) < p->reach[j])
      continue;
    correct(p, j, p->zeta[k], k, 1, e);
  }
}

/* Between walls no panel is nearer to the mirror image of node k than to the node itself. */
static void correct_panels(const struct bem_panels *p, size_t k, struct equation *e) {
  const size_t panels = bem_panels_count(p), none = bem_stencil_none(p);
  const double complex tau = p->zeta[k], mirrored = bem_panels_mirror(p, tau);
  for (size_t j = find_near(p, tau, 0); j < panels; j = find_near(p, tau, j + 1)) {
    if (bem_panel_is_mirrored(p, j)) continue;
    correct(p, j, tau, k, 1, e);
    if (!bem_panels_closed(p) && distance(mirrored, p->middle[j]) < p->reach[j])
      correct(p, j, mirrored, none, -1, e);
  }
  correct_carried(p, k, e);
  if (!bem_panels_closed(p)) return;
  for (size_t j = find_near(p, mirrored, 0); j < panels; j = find_near(p, mirrored, j + 1))
    correct(p, j, mirrored, none, -1, e);
}

/* A closed chain: the mirror image of its integral is that seen from the mirror image of the node
 * less that from zero, which leaves 2 pi psi_k and c = Re of the integral of beta dt/t. But beta
 * between surface and bed has no source there, hence c = 0, of which half is taken away: a constant
 * psi, which all of that does not see, then has pi on the diagonal as all others have. */
static void close_chain(const struct bem_panels *p, size_t k, double *a, double *b) {
  const double *re = p->re, *im = p->im, *wr = p->weight_re, *wi = p->weight_im;
#pragma omp simd
  for (size_t m = 0; m < p->n; m++) {
    double r2 = 1 / (re[m] * re[m] + im[m] * im[m]);
    a[m] += 0.5 * (wi[m] * re[m] - wr[m] * im[m]) * r2;
    b[m] += 0.5 * (wr[m] * re[m] + wi[m] * im[m]) * r2;
  }
  a[k] -= 2 * M_PI;
}

/* Own contour: real part of W (beta_n - beta_k); mirror image, for W' seen from the mirror image of
 * zeta_k: real part of -W' (beta_n - conj(beta_k)). */
static void sum_round(const struct bem_panels *p, size_t k, struct equation *e) {
  const double complex mirrored = bem_panels_mirror(p, p->zeta[k]);
  const double x = p->re[k], y = p->im[k], mx = creal(mirrored), my = cimag(mirrored);
  const double *re = p->re, *im = p->im, *wr = p->weight_re, *wi = p->weight_im;
  double *a = e->a, *b = e->b, diagonal_a = 0, diagonal_b = 0;
#pragma omp simd reduction(+ : diagonal_a, diagonal_b)
  for (size_t m = 0; m < p->n; m++) {
    double dx = re[m] - x, dy = im[m] - y, ex = re[m] - mx, ey = im[m] - my;
    double r2 = dx * dx + dy * dy;
    double own = m == k ? 0 : 1 / (m == k ? 1 : r2), mirror = 1 / (ex * ex + ey * ey);
    double own_re = (wr[m] * dx + wi[m] * dy) * own, own_im = (wi[m] * dx - wr[m] * dy) * own;
    double mirror_re = (wr[m] * ex + wi[m] * ey) * mirror;
    double mirror_im = (wi[m] * ex - wr[m] * ey) * mirror;
    a[m] = own_im - mirror_im;
    b[m] = own_re - mirror_re;
    diagonal_a += own_im + mirror_im;
    diagonal_b += own_re - mirror_re;
  }
  e->diagonal_a = diagonal_a;
  e->diagonal_b = diagonal_b;
}

/* The same between walls, for nodes [from, to). There the denominators of both together are
 * P + i Q = (zeta_n - x)^2 + y^2, zeta_k = x + i y; their reciprocals differ by 2 i y / (P + i Q)
 * and add up to 2 (zeta_n - x) / (P + i Q). */
static void sum_between_walls(const struct bem_panels *p, size_t k, size_t from, size_t to,
                              struct equation *e) {
  const double x = p->re[k], y = p->im[k], twice = 2 * y;
  const double *re = p->re, *im = p->im, *wr = p->weight_re, *wi = p->weight_im;
  double *a = e->a, *b = e->b, sum_a = 0, sum_b = 0;
#pragma omp simd reduction(+ : sum_a, sum_b)
  for (size_t m = from; m < to; m++) {
    double dx = re[m] - x, up = im[m];
    double P = dx * dx + (y - up) * (y + up), Q = 2 * dx * up, inverse = 1 / (P * P + Q * Q);
    P *= inverse, Q *= inverse;
    double real = wr[m] * P + wi[m] * Q, imaginary = wi[m] * P - wr[m] * Q; /* of W / (P + i Q) */
    a[m] = twice * real;
    b[m] = -twice * imaginary;
    sum_a += imaginary * dx + real * up;
    sum_b += imaginary;
  }
  e->diagonal_a += 2 * sum_a;
  e->diagonal_b -= twice * sum_b;
}

/* Of its own node there is the mirror image only: W / (2 i y). */
static void sum_nodes(const struct bem_panels *p, size_t k, struct equation *e) {
  e->diagonal_a = -0.5 * p->weight_re[k] / p->im[k];
  e->diagonal_b = -0.5 * p->weight_im[k] / p->im[k];
  e->a[k] = -e->diagonal_a;
  e->b[k] = e->diagonal_b;
  sum_between_walls(p, k, 0, k, e);
  sum_between_walls(p, k, k + 1, p->n, e);
}

/* Panels at the edges of the surface whose stencils are mirrored there. */
static void add_edges(const struct bem_panels *p, size_t k, struct equation *e) {
  const size_t edge[2] = {0, p->n - 2};
  for (int i = 0; i < 2; i++) {
    if (!bem_panel_is_mirrored(p, edge[i])) continue;
    add_mirrored(p, edge[i], p->zeta[k], k, 1, e);
    add_mirrored(p, edge[i], conj(p->zeta[k]), bem_stencil_none(p), -1, e);
  }
}

/* At node k itself (beta - beta_k) / (zeta - zeta_k) dzeta/di is d beta/di, whose real part is that
 * of phi, in mirror images as well. */
static void add_slope(const struct bem_panels *p, size_t k, double *b) {
  for (ptrdiff_t j = 1, at = (ptrdiff_t)k; j <= BEM_SMOOTH; j++) {
    int image;
    b[bem_stencil_node(p, at + j, &image)] += bem_smooth_weight[j];
    b[bem_stencil_node(p, at - j, &image)] -= bem_smooth_weight[j];
  }
}

void bem_integrals_row(const struct bem_panels *p, size_t k, double *a, double *b) {
  struct equation e = {a, b, 0, 0};
  (bem_panels_closed(p) ? sum_round : sum_nodes)(p, k, &e);
  if (p->smooth) {
    add_slope(p, k, b);
  } else {
    if (!bem_panels_closed(p)) add_edges(p, k, &e);
    correct_panels(p, k, &e);
  }
  a[k] -= e.diagonal_a;
  b[k] -= e.diagonal_b;
  if (bem_panels_closed(p)) close_chain(p, k, a, b);
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

/* Takes from the view of the mirror image of tau, on a closed chain, that from zero, and turns its
 * derivative by the mirror image into one by conj(tau). */
static void see_closed(const struct bem_panels *p, const double *f, const double *h,
                       double complex tau, struct contour *seen) {
  struct contour zero = {0};
  for (size_t j = 0; j < p->n; j++) add_panel(p, j, f, h, 0, &zero);
  seen->value -= zero.value;
  seen->winding -= zero.winding;
  seen->slope *= -p->period.bed / (conj(tau) * conj(tau));
}

/* The surface and its mirror image close the contour, so f(tau) is the mean of f weighted with
 * dt / (t - tau), and its derivative the same mean of d f / dt, for f continuous along it. */
void bem_integrals_inside(const struct bem_panels *p, const double *f, const double *h,
                          double complex tau, double complex *value, double complex *slope) {
  struct contour own = {0}, seen = {0}; /* seen: the surface from the mirror image of tau */
  for (size_t j = 0; j < bem_panels_count(p); j++) {
    add_panel(p, j, f, h, tau, &own);
    add_panel(p, j, f, h, bem_panels_mirror(p, tau), &seen);
  }
  if (bem_panels_closed(p)) see_closed(p, f, h, tau, &seen);
  double complex winding = own.winding - conj(seen.winding);
  *value = (own.value - conj(seen.value)) / winding;
  *slope = (own.slope - conj(seen.slope)) / winding;
}

/* Integrals of several functions, and of one, over the surface seen from a point. */
struct view {
  size_t count;
  const double *const *f, *const *h;
  double complex value[BEM_VALUES], winding;
};

/* Adds `times` those of panel j. */
static void view_panel(const struct bem_panels *p, size_t j, double complex tau, double times,
                       struct view *v) {
  const ptrdiff_t first = bem_stencil_first(p, j, BEM_STENCIL);
  const int near = bem_panel_is_mirrored(p, j) || distance(tau, p->middle[j]) < p->reach[j];
  double complex moment[BEM_STENCIL];
  if (near) moments((tau - p->middle[j]) / p->half[j], 0, moment);
  for (int m = 0, image; m < BEM_STENCIL; m++) {
    double complex c = 0;
    if (near)
      for (int q = 0; q < BEM_STENCIL; q++) c += p->basis[j][m][q] * moment[q];
    else
      c = p->weight[j][m] / (p->zeta[bem_stencil_node(p, first + m, &image)] - tau);
    c *= times;
    for (size_t i = 0; i < v->count; i++)
      v->value[i] += c * bem_stencil_value(p, first + m, v->f[i], v->h[i]);
    v->winding += c;
  }
}

/* The polynomials of the nearest panel themselves: for a point between its chord and the surface.
 */
static void continue_nearest(const struct bem_panels *p, double complex tau, struct view *v) {
  size_t at = 0;
  double least = HUGE_VAL;
  for (size_t j = 0; j < bem_panels_count(p); j++) {
    const double way = distance(tau, p->middle[j]) / cabs(p->half[j]);
    if (way < least) least = way, at = j;
  }
  const ptrdiff_t first = bem_stencil_first(p, at, BEM_STENCIL);
  const double complex t = (tau - p->middle[at]) / p->half[at];
  for (size_t i = 0; i < v->count; i++) v->value[i] = 0;
  for (int m = 0; m < BEM_STENCIL; m++) {
    const double complex *b = p->basis[at][m];
    const double complex c = b[0] + t * (b[1] + t * (b[2] + t * b[3]));
    for (size_t i = 0; i < v->count; i++)
      v->value[i] += c * bem_stencil_value(p, first + m, v->f[i], v->h[i]);
  }
}

void bem_integrals_values(const struct bem_panels *p, size_t count, const double *const *f,
                          const double *const *h, double complex tau, double complex *value) {
  const double complex mirrored = bem_panels_mirror(p, tau);
  struct view own = {.count = count, .f = f, .h = h}, seen = own;
  for (size_t j = 0; j < bem_panels_count(p); j++) {
    view_panel(p, j, tau, 1, &own);
    view_panel(p, j, mirrored, 1, &seen);
    if (bem_panels_closed(p)) view_panel(p, j, 0, -1, &seen);
  }
  const double complex winding = own.winding - conj(seen.winding);
  for (size_t i = 0; i < count; i++) own.value[i] = (own.value[i] - conj(seen.value[i])) / winding;
  if (cabs(winding) < M_PI) continue_nearest(p, tau, &own); /* outside the chords: it is 0 there */
  for (size_t i = 0; i < count; i++) value[i] = own.value[i];
}
