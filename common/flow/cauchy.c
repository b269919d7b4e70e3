#include "common/flow/cauchy.h"

#include <complex.h>
#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/flow/edges.h"

enum kind { EDGE, SURFACE, WALL }; /* of a node: f, phi, psi are known there */

static const double MOST_NODES = 500; /* of the surface where it is straight, and of the wall */
static const double MOST_TURN = 0.1;  /* rad: of the surface along a panel */

struct node {
  double complex z; /* in the plane of the panels */
  enum kind kind;
  double y, phi; /* m; of the surface */
};

struct flow_cauchy {
  size_t n, room, loops, first[3]; /* nodes; closed lines of them: from first[k] to first[k + 1] */
  struct node *node;               /* [n], owned */
  double complex *phi, *lift;      /* [n]: f of either, owned */
  double k;                        /* rad/m; 0: between walls, and the plane is that of the water */
  double complex origin;           /* m */
  double gravity;                  /* m/s^2 */
};

static size_t loop_of(const struct flow_cauchy *a, size_t j) {
  return a->loops > 1 && j >= a->first[1];
}

static size_t after(const struct flow_cauchy *a, size_t j) {
  const size_t k = loop_of(a, j);
  return j + 1 < a->first[k + 1] ? j + 1 : a->first[k];
}

static size_t before(const struct flow_cauchy *a, size_t j) {
  const size_t k = loop_of(a, j);
  return (j > a->first[k] ? j : a->first[k + 1]) - 1;
}

/* ---- the rim ---- */

static double complex plane(const struct flow_cauchy *a, double complex z) {
  return a->k > 0 ? cexp(-I * a->k * (z - a->origin)) : z;
}

/* d(plane)/dz. */
static double complex stretch(const struct flow_cauchy *a, double complex at) {
  return a->k > 0 ? -I * a->k * at : 1;
}

static enum status add(struct flow_cauchy *a, enum kind kind, const double p[2], double phi) {
  TRY(array_grow(&a->node, &a->room, a->n + 1, "a harmonic function"));
  a->node[a->n++] = (struct node){plane(a, CMPLX(p[0], p[1])), kind, p[1], phi};
  return OK;
}

/* The way from a to b without b. */
static enum status add_wall(struct flow_cauchy *a, const double from[2], const double to[2],
                            double spacing, enum kind first) {
  const double length = hypot(to[0] - from[0], to[1] - from[1]);
  const size_t parts = geo_intervals(length, spacing);
  for (size_t i = 0; i < parts && length > 0; i++) {
    const double part = (double)i / (double)parts;
    const double p[2] = {from[0] + part * (to[0] - from[0]), from[1] + part * (to[1] - from[1])};
    TRY(add(a, i ? WALL : first, p, 0));
  }
  return OK;
}

/* How long a panel behind `way` may be: as the line bends. */
static double panel_at(const struct flow_line *line, double way, double spacing) {
  double x[3], y[3];
  tank_record_at(&line->x, way, x);
  tank_record_at(&line->y, way, y);
  const double bend = fabs(x[1] * y[2] - y[1] * x[2]) / pow(hypot(x[1], y[1]), 3);
  return fmax(spacing, MOST_TURN / fmax(bend, 1e-300));
}

/* One stretch of the surface from way b back to a, which is left out. */
static enum status add_stretch(struct flow_cauchy *a, const struct flow_line *line, double from,
                               double to, double spacing, enum kind first) {
  const double least = fmin(fmin(panel_at(line, from, spacing), panel_at(line, to, spacing)),
                            panel_at(line, (from + to) / 2, spacing));
  const size_t parts = (size_t)ceil((to - from) / least);
  for (size_t i = 0; i < parts; i++) {
    const struct flow_line_point at =
        flow_line_at(line, to + (from - to) * (double)i / (double)parts);
    TRY(add(a, i ? SURFACE : first, at.p, at.phi));
  }
  return OK;
}

/* From the right to the left, so that the water is on its left hand; the left end is left out. */
static enum status add_surface(struct flow_cauchy *a, const struct flow_line *line, double spacing,
                               enum kind first) {
  size_t n;
  double *way;
  const double longest = fmax(spacing, (line->to - line->from) / MOST_NODES);
  enum status status = flow_line_sample(line, spacing / 4, longest, &n, &way);
  for (size_t i = n - 1; status == OK && i-- > 0;)
    status = add_stretch(a, line, way[i], way[i + 1], spacing, i + 2 < n ? SURFACE : first);
  free(way);
  return status;
}

static double wall_length(const struct geo_lines *walls, size_t from, size_t to) {
  double length = 0;
  for (size_t i = from; i < to; i++)
    length += hypot(walls->p[i + 1][0] - walls->p[i][0], walls->p[i + 1][1] - walls->p[i][1]);
  return length;
}

static enum status go_between_walls(struct flow_cauchy *a, const struct geo_lines *walls,
                                    const struct flow_line *line, double spacing) {
  struct flow_edges e;
  const char *problem = flow_line_edges(walls, line, INFINITY, &e);
  CHECK(!problem, ERR_SOLVER, "%s", problem);
  const double most = wall_length(walls, e.side[0], e.side[1] + 1) / MOST_NODES;
  const double *from = e.at[0];
  for (size_t i = e.side[0]; i <= e.side[1]; i++) {
    const double *to = i < e.side[1] ? walls->p[i + 1] : e.at[1];
    TRY(add_wall(a, from, to, fmax(spacing, most), i > e.side[0] ? WALL : EDGE));
    from = to;
  }
  TRY(add_surface(a, line, spacing, EDGE));
  const struct flow_line_point left = flow_line_at(line, line->from);
  a->node[0].y = left.p[1];
  a->node[0].phi = left.phi;
  a->loops = 1;
  a->first[1] = a->n;
  return OK;
}

static enum status go_round(struct flow_cauchy *a, const struct geo_lines *walls,
                            const struct flow_line *line, double spacing) {
  const size_t last = walls->points - 2;
  const double most = wall_length(walls, 1, last) / MOST_NODES;
  TRY(add_surface(a, line, spacing, SURFACE));
  a->first[1] = a->n;
  for (size_t i = 1; i < last; i++)
    TRY(add_wall(a, walls->p[i], walls->p[i + 1], fmax(spacing, most), WALL));
  a->loops = 2;
  a->first[2] = a->n;
  return OK;
}

/* ---- the equations ---- */

/* What f at each node adds to the integral at node j. */
static void find_row(const struct flow_cauchy *a, size_t j, double complex *row) {
  const double complex at = a->node[j].z;
  for (size_t i = 0; i < a->n; i++) row[i] = 0;
  for (size_t k = 0; k < a->n; k++) {
    const size_t next = after(a, k);
    if (k == j || next == j) continue;
    const double complex p = a->node[k].z, q = a->node[next].z, turn = clog((q - at) / (p - at));
    row[k] += turn * (q - at) / (q - p);
    row[next] += turn * (at - p) / (q - p);
    row[j] -= turn;
  }
}

static double part_of(const struct flow_cauchy *a, size_t j, double complex value) {
  return a->node[j].kind == SURFACE ? creal(value) : cimag(value);
}

/* The matrix by columns, of psi on the surface and phi on the wall. */
static enum status find_matrix(const struct flow_cauchy *a, double *matrix) {
  double complex *row;
  const size_t n = a->n;
  TRY(array_create(&row, n, "a harmonic function"));
  for (size_t j = 0; j < n; j++) {
    find_row(a, j, row);
    for (size_t i = 0; i < n; i++)
      matrix[j + n * i] = a->node[j].kind == EDGE || a->node[i].kind == EDGE
                              ? i == j
                              : part_of(a, j, a->node[i].kind == SURFACE ? I * row[i] : row[i]);
  }
  free(row);
  return OK;
}

/* What is known of f, on the other side. */
static enum status find_right(const struct flow_cauchy *a, const double complex *f, double *right) {
  double complex *row;
  TRY(array_create(&row, a->n, "a harmonic function"));
  for (size_t j = 0; j < a->n; j++) {
    right[j] = 0;
    if (a->node[j].kind == EDGE) continue;
    find_row(a, j, row);
    for (size_t i = 0; i < a->n; i++)
      if (a->node[i].kind != WALL) right[j] -= part_of(a, j, row[i] * creal(f[i]));
  }
  free(row);
  return OK;
}

struct system {
  double *matrix, *right; /* [n n], [n] */
  lapack_int *pivot;      /* [n] */
};

static enum status factorise(const struct flow_cauchy *a, struct system *s) {
  const lapack_int n = (lapack_int)a->n;
  lapack_int info = 0;
  TRY(array_create(&s->matrix, a->n * a->n, "a harmonic function"));
  TRY(array_create(&s->right, a->n, "a harmonic function"));
  TRY(array_create(&s->pivot, a->n, "a harmonic function"));
  TRY(find_matrix(a, s->matrix));
  LAPACK_dgetrf(&n, &n, s->matrix, &n, s->pivot, &info);
  CHECK(info == 0, ERR_SOLVER, "the flow below the surface cannot be found");
  return OK;
}

/* f where it is real on the surface: the rest of it. */
static enum status complete(const struct flow_cauchy *a, const struct system *s,
                            double complex *f) {
  const lapack_int n = (lapack_int)a->n, one = 1;
  lapack_int info = 0;
  TRY(find_right(a, f, s->right));
  LAPACK_dgetrs("N", &n, &one, s->matrix, &n, s->pivot, s->right, &n, &info);
  CHECK(info == 0, ERR_SOLVER, "the flow below the surface cannot be found");
  for (size_t j = 0; j < a->n; j++) {
    if (a->node[j].kind == SURFACE) f[j] = CMPLX(creal(f[j]), s->right[j]);
    if (a->node[j].kind == WALL) f[j] = s->right[j];
  }
  return OK;
}

/* ---- velocities on the surface ---- */

static double complex slope_behind(const struct flow_cauchy *a, size_t j) {
  const size_t next = after(a, j);
  return (a->phi[next] - a->phi[j]) / (a->node[next].z - a->node[j].z);
}

/* Between panels p and q, of which node `at` is the end, or beyond it. */
static double complex between(const struct flow_cauchy *a, size_t p, size_t q, size_t at) {
  const double complex z[2] = {(a->node[p].z + a->node[after(a, p)].z) / 2,
                               (a->node[q].z + a->node[after(a, q)].z) / 2};
  const double complex f[2] = {slope_behind(a, p), slope_behind(a, q)};
  return f[0] + (f[1] - f[0]) * (a->node[at].z - z[0]) / (z[1] - z[0]);
}

/* The slope of f at a node of the surface: between the panels on either side, at an edge from the
 * two next to it, since behind it is the wall. */
static double complex surface_slope(const struct flow_cauchy *a, size_t j) {
  const size_t last = before(a, j), next = after(a, j);
  if (a->node[j].kind != EDGE) return between(a, last, j, j);
  return a->node[next].kind == SURFACE ? between(a, j, next, j)
                                       : between(a, before(a, last), last, j);
}

static enum status set_phi(struct flow_cauchy *a) {
  TRY(array_create(&a->phi, a->n, "a harmonic function"));
  for (size_t j = 0; j < a->n; j++) a->phi[j] = a->node[j].phi;
  return OK;
}

static enum status set_lift(struct flow_cauchy *a) {
  TRY(array_create(&a->lift, a->n, "a harmonic function"));
  for (size_t j = 0; j < a->n; j++) {
    if (a->node[j].kind == WALL) continue;
    const double speed = cabs(surface_slope(a, j) * stretch(a, a->node[j].z));
    a->lift[j] = a->node[j].y + speed * speed / (2 * a->gravity);
  }
  return OK;
}

static enum status solve(struct flow_cauchy *a) {
  struct system s = {0};
  enum status status = OK;
  ATTEMPT(factorise(a, &s));
  ATTEMPT(set_phi(a));
  ATTEMPT(complete(a, &s, a->phi));
  ATTEMPT(set_lift(a));
  ATTEMPT(complete(a, &s, a->lift));
done:
  free(s.matrix);
  free(s.right);
  free(s.pivot);
  return status;
}

enum status flow_cauchy_create(const struct case_file *c, const struct flow_line *line,
                               double spacing, struct flow_cauchy **out) {
  enum status status = OK;
  struct flow_cauchy *a = *out = NULL;
  ATTEMPT(array_create(&a, 1, "a harmonic function"));
  *a = (struct flow_cauchy){.gravity = c->g,
                            .origin = CMPLX(c->tank.min[0], flow_line_at(line, line->from).p[1])};
  if (c->periodic[0]) a->k = 2 * M_PI / (c->tank.max[0] - c->tank.min[0]);
  ATTEMPT(c->periodic[0] ? go_round(a, &c->walls, line, spacing)
                         : go_between_walls(a, &c->walls, line, spacing));
  ATTEMPT(solve(a));
done:
  if (status != OK) {
    flow_cauchy_destroy(a);
    a = NULL;
  }
  *out = a;
  return status;
}

void flow_cauchy_destroy(struct flow_cauchy *a) {
  if (!a) return;
  free(a->node);
  free(a->phi);
  free(a->lift);
  free(a);
}

/* ---- inside ---- */

struct flow_inside flow_cauchy_at(const struct flow_cauchy *a, double x, double y) {
  const double complex at = plane(a, CMPLX(x, y));
  double complex phi = 0, lift = 0, slope = 0;
  double turns = 0;
  for (size_t k = 0; k < a->n; k++) {
    const size_t next = after(a, k);
    const double complex p = a->node[k].z, q = a->node[next].z;
    if (at == p || at == q) continue;
    const double complex turn = clog((q - at) / (p - at)), part = (at - p) / (q - p);
    const double complex rise = a->phi[next] - a->phi[k];
    turns += cimag(turn);
    slope += turn * rise / (q - p);
    phi += turn * (a->phi[k] + part * rise);
    lift += turn * (a->lift[k] + part * (a->lift[next] - a->lift[k]));
  }
  if (!(turns > M_PI)) return (struct flow_inside){0};
  const double complex velocity = slope / (2 * M_PI * I) * stretch(a, at);
  return (struct flow_inside){
      true, cimag(phi) / (2 * M_PI), cimag(lift) / (2 * M_PI), {creal(velocity), -cimag(velocity)}};
}
