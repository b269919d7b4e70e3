#include "common/flow/harmonic.h"

#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/case/case.h"

struct flow_harmonic {
  double left, bed, deep; /* m; D */
  double k;               /* of the first term, rad/m */
  size_t terms, each;     /* each: 1, or 2 with sines */
  double *a; /* [1 + terms each]: the constant, then cosines and sines in turn, owned */
};

static size_t unknowns(const struct flow_harmonic *h) {
  return 1 + h->terms * h->each;
}

/* cosh q Y/cosh q D and sinh q Y/cosh q D, in exponentials that do not overflow. */
static void profile(const struct flow_harmonic *h, double q, double Y, double *ch, double *sh) {
  const double up = exp(q * (Y - h->deep)), down = exp(-q * (Y + h->deep)),
               part = 1 / (1 + exp(-2 * q * h->deep));
  *ch = (up + down) * part;
  *sh = (up - down) * part;
}

/* Adds all terms with the weights a at a point, or only lists them. */
static double add_terms(const struct flow_harmonic *h, double x, double y, double *terms,
                        double *gradient) {
  const double X = x - h->left, Y = y - h->bed;
  double sum = h->a[0];
  if (terms) terms[0] = 1;
  for (size_t n = 1; n <= h->terms; n++) {
    const double q = (double)n * h->k, c = cos(q * X), s = sin(q * X);
    const size_t i = 1 + (n - 1) * h->each;
    double ch, sh;
    profile(h, q, Y, &ch, &sh);
    const double even = h->a[i], odd = h->each > 1 ? h->a[i + 1] : 0;
    if (terms) terms[i] = c * ch;
    if (terms && h->each > 1) terms[i + 1] = s * ch;
    sum += (even * c + odd * s) * ch;
    if (!gradient) continue;
    gradient[0] += q * (odd * c - even * s) * ch;
    gradient[1] += q * (even * c + odd * s) * sh;
  }
  return sum;
}

double flow_harmonic_at(const struct flow_harmonic *h, double x, double y, double *gradient) {
  if (gradient) gradient[0] = gradient[1] = 0;
  return add_terms(h, x, y, NULL, gradient);
}

/* Arrays of the least squares, matrix by columns. */
struct fit {
  double *matrix, *value, *row, *work; /* [n m], [n], [m], [room] */
  lapack_int *pivot;                   /* [m] */
};

static void fit_close(struct fit *f) {
  free(f->matrix);
  free(f->value);
  free(f->row);
  free(f->work);
  free(f->pivot);
}

static enum status fit_open(struct fit *f, size_t n, size_t m, lapack_int room) {
  TRY(array_create(&f->matrix, n * m, "a harmonic function"));
  TRY(array_create(&f->value, n, "a harmonic function"));
  TRY(array_create(&f->row, m, "a harmonic function"));
  TRY(array_create(&f->work, (size_t)room, "a harmonic function"));
  return array_create(&f->pivot, m, "a harmonic function");
}

static enum status solve(struct flow_harmonic *h, size_t n, const struct flow_harmonic_value *at,
                         struct fit *f) {
  const size_t m = unknowns(h);
  lapack_int rows = (lapack_int)n, columns = (lapack_int)m, one = 1, rank, info;
  lapack_int room = 4 * columns * 64; /* as LAPACK asks for blocks of 64 */
  double least = 1e-13;
  TRY(fit_open(f, n, m, room));
  for (size_t i = 0; i < n; i++) {
    add_terms(h, at[i].x, at[i].y, f->row, NULL);
    f->value[i] = at[i].value;
    for (size_t j = 0; j < m; j++) f->matrix[i + n * j] = f->row[j];
  }
  LAPACK_dgelsy(&rows, &columns, &one, f->matrix, &rows, f->value, &rows, f->pivot, &least, &rank,
                f->work, &room, &info);
  CHECK(info == 0, ERR_SOLVER, "LAPACK cannot fit a harmonic function to the surface");
  for (size_t j = 0; j < m; j++) h->a[j] = f->value[j];
  return OK;
}

static enum status fit(struct flow_harmonic *h, size_t n, const struct flow_harmonic_value *at) {
  struct fit f = {0};
  const enum status status = solve(h, n, at, &f);
  fit_close(&f);
  return status;
}

enum status flow_harmonic_create(const struct case_file *c, size_t terms, size_t n,
                                 const struct flow_harmonic_value *at, struct flow_harmonic **out) {
  enum status status = OK;
  struct flow_harmonic *h = *out = NULL;
  ATTEMPT(array_create(&h, 1, "a harmonic function"));
  const double width = c->tank.max[0] - c->tank.min[0];
  *h = (struct flow_harmonic){.left = c->tank.min[0], .bed = c->tank.min[1], .terms = terms};
  h->each = c->periodic[0] ? 2 : 1;
  h->k = (double)h->each * M_PI / width;
  for (size_t i = 0; i < n; i++) h->deep = fmax(h->deep, at[i].y - h->bed);
  ATTEMPT(array_create(&h->a, unknowns(h), "a harmonic function"));
  ATTEMPT(fit(h, n, at));
done:
  if (status != OK) {
    flow_harmonic_destroy(h);
    h = NULL;
  }
  *out = h;
  return status;
}

void flow_harmonic_destroy(struct flow_harmonic *h) {
  if (h) free(h->a);
  free(h);
}

enum status flow_harmonic_of_surface(const struct flow_water *w, size_t terms,
                                     struct flow_harmonic **out) {
  const size_t n = 4 * (1 + (w->c->periodic[0] ? 2 : 1) * terms);
  const double width = w->c->tank.max[0] - w->c->tank.min[0];
  struct flow_harmonic_value *at = NULL;
  *out = NULL;
  TRY(array_create(&at, n, "points of the surface"));
  for (size_t i = 0; i < n; i++) {
    const double x = w->c->tank.min[0] + width * ((double)i + 0.5) / (double)n;
    const double y = flow_elevation(w, x, 0);
    at[i] = (struct flow_harmonic_value){x, y, y};
  }
  const enum status status = flow_harmonic_create(w->c, terms, n, at, out);
  free(at);
  return status;
}
