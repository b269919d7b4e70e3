#include "sph/theory/rows.h"

#include <assert.h>
#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "sph/time/rk.h"

enum { R = SPH_ROWS_REACH };

/* Of the particles of one row within the radius: how many, sum cos(k x), sum x sin(k x), sum x^2.
 */
struct row_sums {
  double n, cosines, sines, squares;
};

static struct row_sums row_sums_of(const struct sph_rows *l, double radius, int away) {
  struct row_sums s = {0};
  for (int i = -R; i <= R; i++) {
    if (i * i + away * away > radius * radius) continue;
    const double x = i * l->h;
    s.n += 1;
    s.cosines += cos(l->k * x);
    s.sines += x * sin(l->k * x);
    s.squares += x * x;
  }
  return s;
}

/* The plane's slopes: moments that are odd in x vanish. Row j has no rows above the first. */
static void fit(struct sph_rows *l, double radius, int j) {
  double N = 0, Y = 0, YY = 0, XX = 0;
  for (int d = j < R ? -j : -R; d <= R; d++) {
    const struct row_sums s = row_sums_of(l, radius, d);
    const double y = -d * l->h;
    N += s.n;
    Y += s.n * y;
    YY += s.n * y * y;
    XX += s.squares;
  }
  for (int d = j < R ? -j : -R; d <= R; d++) {
    const struct row_sums s = row_sums_of(l, radius, d);
    l->along[j][d + R] = s.sines / XX;
    l->up[j][d + R] = s.cosines * (N * -d * l->h - Y) / (N * YY - Y * Y);
  }
}

struct sph_rows sph_rows_at_rest(int n, double k, double g, double c2, double radius, bool keep) {
  assert(R <= n && n <= SPH_ROWS_MOST && radius <= R);
  struct sph_rows l = {.n = n, .keep = keep, .h = 1. / n, .k = k, .g = g, .c2 = c2};
  for (int j = 0; j < n; j++) fit(&l, radius + 1e-9, j);
  return l;
}

void sph_rows_airy(struct sph_rows *l) {
  const double omega = sqrt(l->k * l->g);
  for (int j = 0; j < l->n; j++) {
    const double E = exp(-l->k * j * l->h);
    l->w.x[j] = I * E;
    l->w.y[j] = E;
    l->w.u[j] = omega * E;
    l->w.v[j] = -I * omega * E;
    l->w.p[j] = 0;
  }
}

/* The row that has the values of row j + d, and by what they are multiplied: below the last are
 * images. */
static int row_at(const struct sph_rows *l, int j, int d, double image, double *times) {
  const int row = j + d;
  *times = row < l->n ? 1 : image;
  return row < l->n ? row : 2 * l->n - 1 - row;
}

static double complex slope(const struct sph_rows *l, const double *weight, const double complex *f,
                            int j, double image) {
  double complex sum = 0;
  double times;
  for (int d = j < R ? -j : -R; d <= R; d++) {
    if (weight[d + R] == 0) continue;
    const int row = row_at(l, j, d, image, &times);
    sum += times * weight[d + R] * f[row];
  }
  return sum;
}

/* The dynamic pressure p + g y drives. */
void sph_rows_rates(const struct sph_rows *l, const struct sph_rows_state *w,
                    struct sph_rows_state *r) {
  double complex dynamic[SPH_ROWS_MOST];
  for (int j = 0; j < l->n; j++) dynamic[j] = w->p[j] + l->g * w->y[j];
  for (int j = 0; j < l->n; j++) {
    r->x[j] = w->u[j];
    r->y[j] = w->v[j];
    r->u[j] = -I * slope(l, l->along[j], dynamic, j, 1);
    r->v[j] = -slope(l, l->up[j], dynamic, j, 1);
    r->p[j] =
        j == 0 && l->keep
            ? 0
            : -l->c2 * (I * slope(l, l->along[j], w->u, j, 1) + slope(l, l->up[j], w->v, j, -1));
  }
}

static void add(const struct sph_rows *l, struct sph_rows_state *w, double dt,
                const struct sph_rows_state *r) {
  for (int j = 0; j < l->n; j++) {
    w->x[j] += dt * r->x[j];
    w->y[j] += dt * r->y[j];
    w->u[j] += dt * r->u[j];
    w->v[j] += dt * r->v[j];
    w->p[j] += dt * r->p[j];
  }
}

void sph_rows_step(struct sph_rows *l, double dt) {
  const struct rk_table *table = &sph_rk_classic;
  const struct sph_rows_state start = l->w;
  struct sph_rows_state at, r[SPH_MAX_STAGES];
  for (int stage = 0; stage < table->stages; stage++) {
    at = start;
    for (int k = 0; k < stage; k++)
      if (table->a[stage][k] != 0) add(l, &at, table->a[stage][k] * dt, &r[k]);
    sph_rows_rates(l, &at, &r[stage]);
  }
  for (int stage = 0; stage < table->stages; stage++)
    add(l, &l->w, table->b[stage] * dt, &r[stage]);
}

void sph_rows_project(struct sph_rows *l, bool kept, bool first_row) {
  double complex sum = 0;
  double norm = 0;
  for (int j = 0; j < l->n; j++) {
    const double E = exp(-l->k * j * l->h), weight = j > 0 ? 1 : 0.5;
    sum += weight * E * (l->w.v[j] - I * l->w.u[j]);
    norm += 2 * weight * E * E;
  }
  const double complex amplitude = kept ? sum / norm : 0;
  if (first_row && !kept) l->w.y[0] = 0;
  for (int j = 0; j < l->n; j++) {
    const double E = exp(-l->k * j * l->h);
    l->w.u[j] = I * amplitude * E;
    l->w.v[j] = amplitude * E;
    if (j > 0 || !l->keep) l->w.p[j] = sqrt(l->g / l->k) * l->w.u[j] - l->g * l->w.y[j];
  }
}

void sph_rows_off(const struct sph_rows *l, const struct sph_rows_state *rates, double t, int row,
                  double complex off[SPH_ROWS_QUANTITIES]) {
  const double omega = sqrt(l->k * l->g), E = exp(-l->k * row * l->h);
  const double complex turn = cexp(-I * omega * t); /* of cos theta; -I turn of sin theta */
  off[SPH_ROWS_U] = l->w.u[row] / (E * omega) - turn;
  off[SPH_ROWS_V] = l->w.v[row] / (E * omega) + I * turn;
  off[SPH_ROWS_P] = (l->w.p[row] + l->g * l->w.y[row]) / (l->g * E) - turn;
  off[SPH_ROWS_AX] = rates->u[row] / (E * omega * omega) + I * turn;
  off[SPH_ROWS_AY] = rates->v[row] / (E * omega * omega) + turn;
  off[SPH_ROWS_RATE] = (rates->p[row] + l->g * rates->y[row]) / (l->g * E * omega) + I * turn;
}

double complex sph_rows_wave(const struct sph_rows *l) {
  double complex sum = 0;
  for (int j = 0; j < l->n; j++) sum += exp(-l->k * j * l->h) * (l->w.u[j] + I * l->w.v[j]);
  return sum;
}

/* Of i u, v and the dynamic pressure, whose equations are real; displacements follow. */
enum { U, V, P, VARIABLES };

static void set_slope(const struct sph_rows *l, const double *weight, int j, double image,
                      double factor, double *A, int to, int from) {
  const int n = VARIABLES * l->n;
  double times;
  for (int d = j < R ? -j : -R; d <= R; d++) {
    if (weight[d + R] == 0) continue;
    const int row = row_at(l, j, d, image, &times);
    A[(from * l->n + row) * n + to * l->n + j] += factor * times * weight[d + R];
  }
}

enum status sph_rows_growth(const struct sph_rows *l, double *growth) {
  lapack_int n = VARIABLES * l->n, one = 1, size = 16 * n, info;
  double *A = calloc((size_t)(n * n), sizeof *A), *real = calloc((size_t)(2 * n), sizeof *real);
  double *work = calloc((size_t)size, sizeof *work);
  const bool room = A && real && work;
  for (int j = 0; room && j < l->n; j++) {
    set_slope(l, l->along[j], j, 1, 1, A, U, P); /* (i u)' = -i i sum along p */
    set_slope(l, l->up[j], j, 1, -1, A, V, P);
    A[(V * l->n + j) * n + P * l->n + j] += l->g;
    if (j == 0 && l->keep) continue;
    set_slope(l, l->along[j], j, 1, -l->c2, A, P, U); /* -c2 i sum along u */
    set_slope(l, l->up[j], j, -1, -l->c2, A, P, V);
  }
  *growth = -INFINITY;
  if (room)
    LAPACK_dgeev("N", "N", &n, A, &n, real, real + n, NULL, &one, NULL, &one, work, &size, &info);
  for (int i = 0; room && i < n; i++) *growth = fmax(*growth, real[i]);
  free(A);
  free(real);
  free(work);
  CHECK(room, ERR_MEMORY, "not enough memory for %d rows", l->n);
  CHECK(!info, ERR_SOLVER, "the eigenvalues of %d rows did not converge", l->n);
  return OK;
}
