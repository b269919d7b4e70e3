/* Removal of the instability of mSPH and hSPH in a periodic tank (thesis, 4.2.3): the horizontal
 * mean, at each depth, of the velocity and of what the pressure is above the hydrostatic one, is
 * taken away. It is the harmonic m = 0, which no wave has.
 *
 * The thesis interpolates to a grid. Here the mean is taken over the particles themselves: rows are
 * hat functions a spacing apart, which sum to one, weighted with the volumes, and what is taken
 * away is the hat functions' sum, so that on undisturbed rows it is the mean to rounding. */
#include <math.h>
#include <stdlib.h>

#include "sph/treat/treat.h"
#include "sph/treat/waves.h"

/* Sums over the particles of a row; then means. */
struct row {
  double V, u, v, p;
};

/* The rows on either side of a particle, `first` and the next, and how much of it is the latter's.
 */
static size_t rows_of(const struct sph *s, size_t i, size_t n, double *next) {
  const double at = fmax((s->f.w.y[i] - s->tank.box.min[1]) / s->dx - 0.5, 0);
  const double first = fmin(floor(at), (double)(n - 2));
  *next = fmin(at - first, 1);
  return (size_t)first;
}

static void add(struct row *r, double V, double u, double v, double p) {
  r->V += V;
  r->u += V * u;
  r->v += V * v;
  r->p += V * p;
}

static void find_means(const struct sph *s, size_t n, double level, struct row *row) {
  for (size_t k = 0; k < n; k++) row[k] = (struct row){0};
  for (size_t i = 0; i < s->f.n; i++) {
    double next;
    const size_t k = rows_of(s, i, n, &next);
    const double V = s->f.m[i] / s->f.w.rho[i], u = s->f.w.u[i], v = s->f.w.v[i];
    const double p = sph_treat_dynamic(s, i, level);
    add(&row[k], (1 - next) * V, u, v, p);
    add(&row[k + 1], next * V, u, v, p);
  }
  for (size_t k = 0; k < n; k++) {
    const double per_V = row[k].V > 0 ? 1 / row[k].V : 0;
    row[k] = (struct row){row[k].V, row[k].u * per_V, row[k].v * per_V, row[k].p * per_V};
  }
}

/* Enough for water that fills the tank. */
static size_t rows(const struct sph *s) {
  return (size_t)ceil(tank_size(&s->tank, 1) / s->dx) + 2;
}

static enum status removal_create(struct sph *s, void **own) {
  struct row *row;
  TRY(sph_allocate(rows(s), sizeof *row, &row));
  *own = row;
  return OK;
}

static enum status remove_means(struct sph *s) {
  struct row *row = s->treated[SPH_TREATMENT_removal];
  const size_t n = rows(s);
  const double level = sph_treat_level(s);
  find_means(s, n, level, row);
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < s->f.n; i++) {
    double next;
    const struct row *a = &row[rows_of(s, i, n, &next)], *b = a + 1;
    const double p = sph_treat_dynamic(s, i, level);
    s->f.w.u[i] -= (1 - next) * a->u + next * b->u;
    s->f.w.v[i] -= (1 - next) * a->v + next * b->v;
    sph_treat_set_dynamic(s, i, level, p - ((1 - next) * a->p + next * b->p));
  }
  return OK;
}

const struct sph_treatment sph_treatment_removal = {.create = removal_create,
                                                    .destroy = free,
                                                    .due = sph_treat_has_grown,
                                                    .apply = remove_means,
                                                    .periodic = true,
                                                    .weighs = true};
