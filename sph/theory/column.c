#include "sph/theory/column.h"

#include <lapack.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "sph/pair/continuity.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/rates.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"

#define COUNT(...) +1
enum { FIELDS = 0 SPH_EVOLVING(COUNT) };
#undef COUNT

/* The fields and their rates by number, whether a mirror turns their sign, and by how much they are
 * moved, in units of dx, c0 and rho0: rates are linear in velocities and all but linear in
 * densities, and the slopes of a spline's second derivative jump where neighbours are. */
enum { X, Y, U, V, RHO };
static const bool odd[FIELDS] = {[X] = true, [U] = true};
static const double moved[FIELDS] = {1e-5, 1e-5, 1e-3, 1e-3, 1e-5};

struct sph_column {
  size_t rows, size; /* size: FIELDS rows */
  size_t columns;
  size_t reach; /* sph_column_reach */
  double unrest;
  size_t *at;     /* [columns][rows], particles; owned */
  double *block;  /* [2 reach + 1][size][size], of rates m - reach columns to the right of the field
                     that is moved; field after field, of a field from the bed up; owned */
  double *matrix; /* [size][size], owned */
  double *modes;  /* [size][size], owned */
};

static double *field_of(const struct sph_state *w, int field) {
  double *const all[FIELDS] = {w->x, w->y, w->u, w->v, w->rho};
  return all[field];
}

/* ---- which particle is where ---- */

struct place {
  size_t column, particle;
  double y;
};

static int by_column_and_height(const void *a, const void *b) {
  const struct place *p = a, *q = b;
  if (p->column != q->column) return p->column < q->column ? -1 : 1;
  return (p->y > q->y) - (p->y < q->y);
}

/* Columns are particles whose places along x lie in the same spacing; their rows are alike, to
 * `near` of one. */
static enum status find_places(const struct sph *s, struct sph_column *c, double near) {
  const double left = s->tank.box.min[0], width = tank_size(&s->tank, 0);
  struct place *place = NULL;
  c->columns = geo_intervals(width, s->dx);
  c->rows = s->f.n / c->columns;
  c->size = FIELDS * c->rows;
  enum status status = array_create(&place, s->f.n, "particles of columns");
  TRY(status);
  for (size_t i = 0; i < s->f.n; i++) {
    const double along = (s->f.w.x[i] - left) / width * (double)c->columns;
    const bool inside = along >= 0 && along < (double)c->columns; /* false of NaN */
    place[i] = (struct place){inside ? (size_t)along : SIZE_MAX, i, s->f.w.y[i]};
  }
  qsort(place, s->f.n, sizeof *place, by_column_and_height);
  bool alike = c->rows * c->columns == s->f.n;
  for (size_t k = 0; alike && k < s->f.n; k++)
    alike =
        place[k].column == k / c->rows && fabs(place[k].y - place[k % c->rows].y) < near * s->dx;
  if (alike) status = array_create(&c->at, s->f.n, "particles of columns");
  for (size_t k = 0; alike && status == OK && k < s->f.n; k++) c->at[k] = place[k].particle;
  free(place);
  CHECK(alike, ERR_INPUT, "the columns of particles are not alike");
  return status;
}

/* ---- rest ---- */

/* NaN if any is, which is no rest. */
static double largest_acceleration(const struct sph *s) {
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double a = hypot(s->f.k[0].u[i], s->f.k[0].v[i]);
    if (isnan(a) || a > most) most = a;
  }
  return most;
}

/* Each row at the mean height, velocity and density of all columns: what varies along the tank
 * would grow. Rows do not move along it. */
static void make_alike(struct sph *s, const struct sph_column *c, double slower) {
  double *const field[] = {s->f.w.y, s->f.w.v, s->f.w.rho};
  for (int q = 0; q < 3; q++)
    for (size_t row = 0; row < c->rows; row++) {
      double sum = 0;
      for (size_t k = 0; k < c->columns; k++) sum += field[q][c->at[k * c->rows + row]];
      for (size_t k = 0; k < c->columns; k++)
        field[q][c->at[k * c->rows + row]] =
            (field[q] == s->f.w.v ? slower : 1) * sum / (double)c->columns;
    }
  memset(s->f.w.u, 0, s->f.n * sizeof *s->f.w.u);
  sph_particles_pad(&s->f);
}

static enum status step_to_rest(struct sph *s, double dt, double slower) {
  struct sph_column c = {0};
  TRY(sph_step(s, dt));
  TRY(find_places(s, &c, 1e-3));
  make_alike(s, &c, slower);
  free(c.at);
  return OK;
}

enum status sph_column_settle(struct sph *s, double least) {
  const size_t columns = geo_intervals(tank_size(&s->tank, 0), s->dx);
  const double height = (double)s->f.n / (double)columns * s->dx, start = s->t;
  const double sound = height / s->c0, end = start + 30 * sound;
  const double rate = 3 / sound; /* all but critical damping */
  for (;;) {
    TRY(sph_rates(s, 0, true, true));
    const double most = largest_acceleration(s), dt = sph_timestep(s, end) / 2;
    if (most <= least) return OK;
    CHECK(isfinite(most) && s->t < end * (1 - 1e-6) && !sph_timestep_is_cut(s), ERR_SOLVER,
          "the rows do not come to rest: accelerations of %.2g g after %.3g times that sound takes "
          "from bed to surface",
          most / s->g, (s->t - start) / sound);
    TRY(step_to_rest(s, dt, exp(-rate * dt)));
  }
}

/* ---- the blocks ---- */

/* Gradients that diffusion takes, densities that are sums, and quotients of such sums bring what
 * lies a support farther each. */
static size_t reach_of(const struct sph *s) {
  const enum sph_continuity c = (enum sph_continuity)s->scheme.continuity;
  const int supports = 1 + diffusion_needs_gradient(s->scheme.diffusion) + continuity_sums(c) +
                       continuity_divides(c);
  return (size_t)supports * (size_t)ceil(s->support / s->dx * (1 - 1e-9));
}

struct differences {
  struct sph *s;
  struct sph_column *c;
  double unit[FIELDS];
  double *rest[FIELDS]; /* the fields at rest, [n], owned */
  double *high;         /* the rates of all particles to one side, [FIELDS][n], owned */
};

static void bring_back(const struct differences *d) {
  for (int q = 0; q < FIELDS; q++)
    memcpy(field_of(&d->s->f.w, q), d->rest[q], d->s->f.n * sizeof(double));
  sph_particles_pad(&d->s->f);
}

/* Moves a field of every so many rows of the middle column, so many that no two are seen by one. */
static enum status rates_of(const struct differences *d, int field, size_t first, double by) {
  const struct sph_column *c = d->c;
  const size_t *middle = c->at + c->columns / 2 * c->rows;
  bring_back(d);
  for (size_t j = first; j < c->rows; j += 2 * c->reach + 1)
    field_of(&d->s->f.w, field)[middle[j]] += by;
  sph_particles_pad(&d->s->f);
  return sph_rates(d->s, 1, true, false); /* by the lists that there are */
}

/* The row of those moved that is within reach, or SIZE_MAX. */
static size_t moved_near(const struct sph_column *c, size_t first, size_t row) {
  for (size_t j = first; j < c->rows; j += 2 * c->reach + 1)
    if (j <= row + c->reach && row <= j + c->reach) return j;
  return SIZE_MAX;
}

static void take_differences(const struct differences *d, int field, size_t first, double by) {
  const struct sph_column *c = d->c;
  const size_t n = d->s->f.n;
  for (size_t m = 0; m <= 2 * c->reach; m++) {
    const size_t *there = c->at + (c->columns / 2 + m - c->reach) * c->rows;
    double *block = c->block + m * c->size * c->size;
    for (size_t row = 0; row < c->rows; row++) {
      const size_t from = moved_near(c, first, row);
      for (int q = 0; from != SIZE_MAX && q < FIELDS; q++) {
        const double low = field_of(&d->s->f.k[1], q)[there[row]];
        block[((size_t)q * c->rows + row) * c->size + (size_t)field * c->rows + from] =
            (d->high[(size_t)q * n + there[row]] - low) / (2 * by);
      }
    }
  }
}

static enum status find_blocks(const struct differences *d) {
  const size_t n = d->s->f.n;
  for (int field = 0; field < FIELDS; field++)
    for (size_t first = 0; first <= 2 * d->c->reach && first < d->c->rows; first++) {
      const double by = moved[field] * d->unit[field];
      TRY(rates_of(d, field, first, by));
      for (int q = 0; q < FIELDS; q++)
        memcpy(d->high + (size_t)q * n, field_of(&d->s->f.k[1], q), n * sizeof(double));
      TRY(rates_of(d, field, first, -by));
      take_differences(d, field, first, by);
    }
  return OK;
}

/* LAPACK may not return from what is not. */
static enum status expect_finite(const struct sph_column *c) {
  for (size_t k = 0; k < (2 * c->reach + 1) * c->size * c->size; k++)
    CHECK(isfinite(c->block[k]), ERR_SOLVER, "the rates of the columns are not finite");
  return OK;
}

static enum status linearise(struct sph *s, struct sph_column *c) {
  struct differences d = {s, c, {s->dx, s->dx, s->c0, s->c0, s->rho0}, {0}, NULL};
  enum status status = OK;
  ATTEMPT(array_create(&d.high, FIELDS * s->f.n, "rates of a column"));
  for (int q = 0; q < FIELDS; q++) {
    ATTEMPT(array_create(&d.rest[q], s->f.n, "fields of a column"));
    memcpy(d.rest[q], field_of(&s->f.w, q), s->f.n * sizeof(double));
  }
  c->unrest = largest_acceleration(s);
  status = find_blocks(&d);
  bring_back(&d);
  if (status == OK) status = expect_finite(c);
done:
  for (int q = 0; q < FIELDS; q++) free(d.rest[q]);
  free(d.high);
  return status;
}

enum status sph_column_create(struct sph *s, struct sph_column **out) {
  struct sph_column *c;
  enum status status = OK;
  *out = NULL;
  TRY(sph_allocate(1, sizeof *c, &c));
  ATTEMPT(sph_rates(s, 0, true, false)); /* sorts, which what follows must not */
  ATTEMPT(find_places(s, c, 1e-9));
  c->reach = reach_of(s);
  if (c->columns < 2 * c->reach + 2)
    ATTEMPT(status_raise(ERR_INPUT,
                         "%zu columns of particles; allowed: at least %zu, of which none "
                         "sees the same from both sides",
                         c->columns, 2 * c->reach + 2));
  ATTEMPT(array_create(&c->block, (2 * c->reach + 1) * c->size * c->size, "blocks of a column"));
  ATTEMPT(array_create(&c->matrix, c->size * c->size, "the matrix of a column"));
  ATTEMPT(array_create(&c->modes, c->size * c->size, "the modes of a column"));
  ATTEMPT(linearise(s, c));
  *out = c;
done:
  if (status != OK) sph_column_destroy(c);
  return status;
}

void sph_column_destroy(struct sph_column *c) {
  if (!c) return;
  free(c->at);
  free(c->block);
  free(c->matrix);
  free(c->modes);
  free(c);
}

size_t sph_column_rows(const struct sph_column *c) {
  return c->rows;
}

size_t sph_column_reach(const struct sph_column *c) {
  return c->reach;
}

double sph_column_unrest(const struct sph_column *c) {
  return c->unrest;
}

/* ---- their eigenvalues ---- */

/* Of waves whose odd fields are taken a quarter of a wave ahead, i times the others: since rest is
 * its own mirror image along x, the matrix is then real. By columns, as LAPACK has it. */
static void fill_matrix(const struct sph_column *c, double turn) {
  memset(c->matrix, 0, c->size * c->size * sizeof *c->matrix);
  for (size_t m = 0; m <= 2 * c->reach; m++) {
    const double *block = c->block + m * c->size * c->size;
    const double phase = turn * ((double)m - (double)c->reach);
    const double even = cos(phase), across = sin(phase);
    for (size_t a = 0; a < c->size; a++)
      for (size_t b = 0; b < c->size; b++) {
        const bool left = odd[a / c->rows], right = odd[b / c->rows];
        const double part = left == right ? even : left ? -across : across;
        c->matrix[b * c->size + a] += part * block[a * c->size + b];
      }
  }
}

static void copy_mode(const struct sph_column *c, const double *im, size_t k, double *v) {
  const bool pair = im[k] != 0;
  const size_t first = pair && im[k] < 0 ? k - 1 : k; /* of a pair: real and imaginary part */
  for (size_t row = 0; row < c->rows; row++) {
    const double *at = c->modes + first * c->size + V * c->rows + row;
    v[row] = pair ? hypot(at[0], at[c->size]) : fabs(at[0]);
  }
}

enum status sph_column_spectrum(const struct sph_column *c, double turn, double *re, double *im,
                                double *v) {
  const lapack_int n = (lapack_int)c->size, one = 1, query = -1;
  lapack_int info, room;
  double wanted, *work;
  fill_matrix(c, turn);
  LAPACK_dgeev("N", v ? "V" : "N", &n, c->matrix, &n, re, im, NULL, &one, c->modes, &n, &wanted,
               &query, &info);
  room = (lapack_int)wanted;
  TRY(array_create(&work, (size_t)room, "eigenvalues of a column"));
  LAPACK_dgeev("N", v ? "V" : "N", &n, c->matrix, &n, re, im, NULL, &one, c->modes, &n, work, &room,
               &info);
  free(work);
  CHECK(!info, ERR_SOLVER, "the eigenvalues of a column of %zu particles did not converge",
        c->rows);
  size_t most = 0;
  for (size_t k = 0; k < c->size; k++)
    if (re[k] > re[most]) most = k;
  if (v) copy_mode(c, im, most, v);
  return OK;
}
