#include "sph/theory/lattice.h"

#include <assert.h>
#include <math.h>

/* A kernel at one point; the loops' vectors hold it in each element. */
static bool kernel_at(enum sph_kernel k, double x, double y, struct sph_neighbour *out) {
  const vec X = vec_of(x), Y = vec_of(y), q2 = X * X + Y * Y;
  const double F = kernel_slope_scale(k);
  *out = (struct sph_neighbour){.x = x, .y = y, .q2 = q2[0]};
  out->W = kernel_value_scale(k) * kernel_value(k, X, Y, q2)[0];
  out->e = F * kernel_slope(k, X, Y, q2)[0];
  vec gx = out->e / F * X, gy = out->e / F * Y;
  if (!kernel_is_radial(k)) kernel_gradient(k, X, Y, &gx, &gy);
  out->gx = F * gx[0];
  out->gy = F * gy[0];
  return kernel_reach2(k, X, Y, q2)[0] < kernel_cutoff2(k);
}

void sph_lattice_of(enum sph_kernel k, double h_over_dx, struct sph_lattice *l) {
  const int rows = (int)ceil(kernel_support(k) * h_over_dx * (1 - 1e-9));
  const double dx = 1 / h_over_dx, V = dx * dx;
  assert(rows <= SPH_LATTICE_REACH);
  l->kernel = k;
  l->derivative = SPH_DERIVATIVE_kernel;
  l->radius = 0;
  l->h_over_dx = h_over_dx;
  l->n = 0;
  for (int i = -rows; i <= rows; i++)
    for (int j = -rows; j <= rows; j++) {
      struct sph_neighbour *a = &l->near[l->n];
      if (!kernel_at(k, i * dx, j * dx, a)) continue;
      a->i = i;
      a->j = j;
      a->W *= V;
      a->e *= V;
      a->gx *= V;
      a->gy *= V;
      l->n++;
    }
}

void sph_lattice_of_scheme(const struct sph_scheme *o, struct sph_lattice *l) {
  sph_lattice_of((enum sph_kernel)o->kernel, o->h_over_dx, l);
  l->derivative = (enum sph_derivative)o->derivative;
  l->radius = o->derivative_radius * (1 + 1e-5); /* as the pair loop has it */
}

/* ---- moments ---- */

static double power(double x, int n) {
  double p = 1;
  while (n-- > 0) p *= x;
  return p;
}

double sph_lattice_moment(const struct sph_lattice *l, int m, int n, int above) {
  double sum = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++)
    if (a->j <= above) sum += power(a->x, m) * power(a->y, n) * a->W;
  return sum;
}

double sph_lattice_gradient_moment(const struct sph_lattice *l, int m, int n, int above) {
  double sum = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++)
    if (a->j <= above) sum += power(a->x, m) * power(a->y, n) * a->gx;
  return sum;
}

double sph_lattice_slope_moment(const struct sph_lattice *l, int m, int n, int above) {
  double sum = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++)
    if (a->j <= above) sum += power(a->x, m) * power(a->y, n) * a->e;
  return sum;
}

double sph_lattice_corner(enum sph_kernel k, double h_over_dx, double away) {
  const int rows = (int)ceil(kernel_support(k) * h_over_dx);
  double w = 0, x = 0, along2 = 0; /* along the diagonal: that of x + y, by symmetry */
  for (int i = -rows; i <= 0; i++)
    for (int j = -rows; j <= 0; j++) {
      struct sph_neighbour a;
      if (!kernel_at(k, (i - away) / h_over_dx, (j - away) / h_over_dx, &a)) continue;
      w += a.W;
      x += a.x * a.W;
      along2 += (a.x + a.y) * (a.x + a.y) * a.W;
    }
  const double mean = 2 * x / w;
  return mean * mean / (along2 / w - mean * mean);
}

/* ---- plane waves ---- */

struct tables {
  double cos[2 * SPH_LATTICE_REACH + 1], sin[2 * SPH_LATTICE_REACH + 1];
};

static void tabulate(double phase, struct tables *t) {
  for (int i = 0; i <= SPH_LATTICE_REACH; i++) {
    const double c = cos(i * phase), s = sin(i * phase);
    t->cos[SPH_LATTICE_REACH + i] = t->cos[SPH_LATTICE_REACH - i] = c;
    t->sin[SPH_LATTICE_REACH + i] = s;
    t->sin[SPH_LATTICE_REACH - i] = -s;
  }
}

static double wave_sin(const struct tables *x, const struct tables *y,
                       const struct sph_neighbour *a) {
  const int i = a->i + SPH_LATTICE_REACH, j = a->j + SPH_LATTICE_REACH;
  return x->sin[i] * y->cos[j] + x->cos[i] * y->sin[j];
}

static double wave_cos(const struct tables *x, const struct tables *y,
                       const struct sph_neighbour *a) {
  const int i = a->i + SPH_LATTICE_REACH, j = a->j + SPH_LATTICE_REACH;
  return x->cos[i] * y->cos[j] - x->sin[i] * y->sin[j];
}

/* The gradient of the wave by a fit, over i, with weights of slope V, or of 1 within a radius. On a
 * square lattice the matrix of the fit is a multiple of one, and means vanish. */
static void fitted(const struct sph_lattice *l, bool hat, const struct tables *tx,
                   const struct tables *ty, double g[2]) {
  double xx = 0;
  g[0] = g[1] = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++) {
    const double weight = !hat ? a->e : a->q2 < l->radius * l->radius ? 1 : 0;
    const double s = weight * wave_sin(tx, ty, a);
    xx += weight * a->x * a->x;
    g[0] += s * a->x;
    g[1] += s * a->y;
  }
  if (xx == 0) return; /* nobody within the radius */
  g[0] /= xx;
  g[1] /= xx;
}

/* What drives the wave and what it compresses by; g: the renormalised gradient. */
static void set_gradient(const struct sph_lattice *l, const struct tables *tx,
                         const struct tables *ty, const double g[2], struct sph_symbols *out) {
  double own[2] = {g[0], g[1]};
  if (l->derivative == SPH_DERIVATIVE_kernel) return;
  if (l->derivative != SPH_DERIVATIVE_renormalised) fitted(l, true, tx, ty, own);
  out->Gx = own[0];
  out->Gy = own[1];
}

void sph_lattice_symbols(const struct sph_lattice *l, enum sph_diffusion d, double kx, double ky,
                         struct sph_symbols *out) {
  struct tables tx, ty;
  double g[2];
  tabulate(kx / l->h_over_dx, &tx);
  tabulate(ky / l->h_over_dx, &ty);
  fitted(l, false, &tx, &ty, g);
  *out = (struct sph_symbols){0};
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++) {
    const double c = wave_cos(&tx, &ty, a), s = wave_sin(&tx, &ty, a);
    out->W += a->W * c;
    out->Gx += a->gx * s;
    out->Gy += a->gy * s;
    if (a->q2 == 0) continue;
    /* the real part of psi: gradients are i g times the wave, here and there */
    const vec psi = diffusion_psi(d, vec_of(c - 1), vec_of(a->x), vec_of(a->y), vec_of(a->q2),
                                  vec_of(-g[0] * s), vec_of(-g[1] * s));
    out->D -= 2 * a->e * psi[0];
    const double drag = a->e * (1 - c) / a->q2;
    out->xx += drag * a->x * a->x;
    out->xy += drag * a->x * a->y;
    out->yy += drag * a->y * a->y;
  }
  set_gradient(l, &tx, &ty, g, out);
}

void sph_lattice_extremes(const struct sph_lattice *l, enum sph_diffusion d, double *sound,
                          double *decay) {
  const int n = 40;
  const double step = M_PI * l->h_over_dx / n;
  *sound = *decay = 0;
  for (int i = 1; i <= n; i++)
    for (int j = 0; j <= i; j++) {
      struct sph_symbols a;
      sph_lattice_symbols(l, d, i * step, j * step, &a);
      *sound = fmax(*sound, hypot(a.Gx, a.Gy));
      *decay = fmax(*decay, a.D);
    }
}

/* ---- the continuum ---- */

enum { POINTS = 400 }; /* along each half axis */

/* int f over the plane, f even in x and y. */
static double integral(enum sph_kernel k, double (*f)(const struct sph_neighbour *, const void *),
                       const void *with) {
  const double d = kernel_support(k) / POINTS;
  double sum = 0;
  for (int i = 0; i < POINTS; i++)
    for (int j = 0; j < POINTS; j++) {
      struct sph_neighbour a;
      if (kernel_at(k, (i + 0.5) * d, (j + 0.5) * d, &a)) sum += f(&a, with);
    }
  return 4 * sum * d * d;
}

static double value_moment(const struct sph_neighbour *a, const void *with) {
  const int *n = with;
  return power(a->x, n[0]) * power(a->y, n[1]) * a->W;
}

static double slope_moment(const struct sph_neighbour *a, const void *with) {
  const int *n = with;
  return power(a->x, n[0]) * power(a->y, n[1]) * a->e;
}

static double value_wave(const struct sph_neighbour *a, const void *with) {
  const double *k = with;
  return cos(k[0] * a->x) * cos(k[1] * a->y) * a->W;
}

double sph_kernel_moment(enum sph_kernel k, int m, int n) {
  return m % 2 || n % 2 ? 0 : integral(k, value_moment, (int[2]){m, n});
}

double sph_kernel_slope_moment(enum sph_kernel k, int m, int n) {
  return m % 2 || n % 2 ? 0 : integral(k, slope_moment, (int[2]){m, n});
}

double sph_kernel_transform(enum sph_kernel k, double kx, double ky) {
  return integral(k, value_wave, (double[2]){kx, ky});
}
