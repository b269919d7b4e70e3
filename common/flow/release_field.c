#include "common/flow/release_field.h"

#include <cholmod.h>
#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/base/triangles.h"
#include "common/flow/release_mesh.h"

/* Unknowns of a triangle: its corners, then the middles of the sides across from them. */
enum { CORNERS = 3, SHAPES = 6 };

struct release_field {
  struct release_drive drive;
  struct release_mesh *mesh; /* owned */
  double *head;              /* m, at corners, then at middles of edges, owned */
  int *unknown;              /* of the same: its row of the matrix, -1 on the surface, owned */
  int n_unknowns;
  /* Squares that a point's triangle is looked for in: those of square k are
   * list[first[k]] .. list[first[k + 1] - 1]. */
  struct geo_box box;
  double width; /* of a square, m */
  int n[2];
  size_t *first, *list; /* owned */
};

/* ---- elements ---- */

/* Gradients of the three barycentric coordinates of a triangle, 1/m; returns twice its area. */
static double gradients(const struct release_mesh *m, size_t t, double g[CORNERS][2]) {
  const double *p[CORNERS];
  for (int k = 0; k < CORNERS; k++) p[k] = m->p[m->corner[t][k]];
  const double cross = geo_triangle_cross(p[0], p[1], p[2]);
  for (int k = 0; k < CORNERS; k++) {
    const double *a = p[(k + 1) % 3], *b = p[(k + 2) % 3];
    g[k][0] = (a[1] - b[1]) / cross;
    g[k][1] = (b[0] - a[0]) / cross;
  }
  return cross;
}

/* Gradients of the six parabolas at barycentric coordinates l. */
static void shape_gradients(const double g[CORNERS][2], const double l[CORNERS],
                            double out[SHAPES][2]) {
  for (int k = 0; k < CORNERS; k++) {
    const int a = (k + 1) % 3, b = (k + 2) % 3;
    for (int axis = 0; axis < 2; axis++) {
      out[k][axis] = (4 * l[k] - 1) * g[k][axis];
      out[k + CORNERS][axis] = 4 * (l[a] * g[b][axis] + l[b] * g[a][axis]);
    }
  }
}

static void shapes(const double l[CORNERS], double out[SHAPES]) {
  for (int k = 0; k < CORNERS; k++) {
    out[k] = l[k] * (2 * l[k] - 1);
    out[k + CORNERS] = 4 * l[(k + 1) % 3] * l[(k + 2) % 3];
  }
}

/* Where a triangle's six values stand. */
static void places(const struct release_mesh *m, size_t t, size_t at[SHAPES]) {
  for (int k = 0; k < CORNERS; k++) {
    at[k] = m->corner[t][k];
    at[k + CORNERS] = m->nodes + m->across[t][k];
  }
}

/* ---- the solve ---- */

static enum status number_unknowns(struct release_field *r) {
  const struct release_mesh *m = r->mesh;
  const size_t all = m->nodes + m->edges;
  size_t surface = 0;
  TRY(array_create(&r->head, all, "the released pressure"));
  TRY(array_create(&r->unknown, all, "the released pressure"));
  for (size_t i = 0; i < m->edges; i++)
    if (m->edge[i].kind == RELEASE_SURFACE) {
      surface++;
      r->unknown[m->edge[i].end[0]] = r->unknown[m->edge[i].end[1]] = -1;
      r->unknown[m->nodes + i] = -1;
    }
  CHECK(surface > 0, ERR_INPUT,
        "water.pressure: 'released' for water that touches walls all round has no surface at which "
        "its pressure is zero; write hydrostatic, or leave air above it");
  for (size_t i = 0; i < all; i++)
    if (r->unknown[i] >= 0) r->unknown[i] = r->n_unknowns++;
  return OK;
}

/* Adds a triangle to the lower half of the matrix. Products of gradients are parabolas, whose mean
 * is that of the middles of the sides. */
static void add_triangle(const struct release_field *r, size_t t, cholmod_triplet *matrix,
                         double *flux) {
  double g[CORNERS][2], slope[CORNERS][SHAPES][2];
  size_t at[SHAPES];
  int *row = matrix->i, *column = matrix->j;
  double *value = matrix->x;
  const double area = gradients(r->mesh, t, g) / 2;
  places(r->mesh, t, at);
  for (int q = 0; q < CORNERS; q++)
    shape_gradients(g, (double[3]){q == 0 ? 0 : 0.5, q == 1 ? 0 : 0.5, q == 2 ? 0 : 0.5}, slope[q]);
  for (int i = 0; i < SHAPES; i++) {
    const int a = r->unknown[at[i]];
    if (a < 0) continue;
    if (i >= CORNERS) flux[a] += r->drive.source * area / 3; /* those of corners have no mean */
    for (int j = 0; j < SHAPES; j++) {
      const int b = r->unknown[at[j]];
      if (b < 0 || b > a) continue;
      double sum = 0;
      for (int q = 0; q < CORNERS; q++)
        sum += slope[q][i][0] * slope[q][j][0] + slope[q][i][1] * slope[q][j][1];
      row[matrix->nnz] = a;
      column[matrix->nnz] = b;
      value[matrix->nnz++] = sum * area / 3;
    }
  }
}

/* The weight on a wall, by Simpson's rule. */
static void add_wall(const struct release_field *r, size_t edge, double *flux) {
  const struct release_mesh *m = r->mesh;
  const struct release_edge *e = &m->edge[edge];
  const double *a = m->p[e->end[0]], *b = m->p[e->end[1]];
  const double load = r->drive.weight[0] * (b[1] - a[1]) - r->drive.weight[1] * (b[0] - a[0]);
  const size_t at[3] = {e->end[0], e->end[1], m->nodes + edge};
  for (int k = 0; k < 3; k++)
    if (r->unknown[at[k]] >= 0) flux[r->unknown[at[k]]] += load * (k == 2 ? 4 : 1) / 6;
}

static void fill(const struct release_field *r, cholmod_triplet *matrix, double *flux) {
  const struct release_mesh *m = r->mesh;
  for (size_t t = 0; t < m->triangles; t++) add_triangle(r, t, matrix, flux);
  for (size_t i = 0; i < m->edges; i++)
    if (m->edge[i].kind == RELEASE_WALL || m->edge[i].kind == RELEASE_SLIT) add_wall(r, i, flux);
}

static cholmod_dense *solve(const struct release_field *r, cholmod_common *common) {
  const size_t n = (size_t)r->n_unknowns, most = r->mesh->triangles * SHAPES * (SHAPES + 1) / 2;
  cholmod_triplet *t = cholmod_allocate_triplet(n, n, most, -1, CHOLMOD_REAL, common);
  cholmod_dense *flux = cholmod_zeros(n, 1, CHOLMOD_REAL, common), *head = NULL;
  if (t && flux) fill(r, t, flux->x);
  cholmod_sparse *matrix = t && flux ? cholmod_triplet_to_sparse(t, t->nnz, common) : NULL;
  cholmod_factor *factor = matrix ? cholmod_analyze(matrix, common) : NULL;
  if (factor && cholmod_factorize(matrix, factor, common) && common->status == CHOLMOD_OK)
    head = cholmod_solve(CHOLMOD_A, factor, flux, common);
  cholmod_free_factor(&factor, common);
  cholmod_free_sparse(&matrix, common);
  cholmod_free_dense(&flux, common);
  cholmod_free_triplet(&t, common);
  return head;
}

static enum status solve_heads(struct release_field *r) {
  if (!r->n_unknowns) return OK;
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SIMPLICIAL; /* no BLAS, whose threads would change the last bits */
  cholmod_dense *head = solve(r, &common);
  bool no_memory = common.status == CHOLMOD_OUT_OF_MEMORY, solved = head != NULL;
  for (size_t i = 0; solved && i < r->mesh->nodes + r->mesh->edges; i++)
    r->head[i] = r->unknown[i] < 0 ? 0 : ((const double *)head->x)[r->unknown[i]];
  cholmod_free_dense(&head, &common);
  cholmod_finish(&common);
  CHECK(!no_memory, ERR_MEMORY, "no memory for the released pressure at %d nodes", r->n_unknowns);
  CHECK(solved, ERR_SOLVER, "CHOLMOD cannot solve for the released pressure at %d nodes",
        r->n_unknowns);
  return OK;
}

/* ---- where a point is ---- */

static int square_of(const struct release_field *r, int axis, double at) {
  const double i = floor((at - r->box.min[axis]) / r->width);
  return (int)fmin(fmax(i, 0), r->n[axis] - 1);
}

/* The squares that a triangle's box touches. */
static void squares_of(const struct release_field *r, size_t t, int from[2], int to[2]) {
  for (int axis = 0; axis < 2; axis++) {
    const struct release_mesh *m = r->mesh;
    const double a = m->p[m->corner[t][0]][axis], b = m->p[m->corner[t][1]][axis],
                 c = m->p[m->corner[t][2]][axis];
    from[axis] = square_of(r, axis, fmin(a, fmin(b, c)));
    to[axis] = square_of(r, axis, fmax(a, fmax(b, c)));
  }
}

/* Counts the triangles of each square, then lists them. */
static void sort_into_squares(struct release_field *r, bool list) {
  const size_t squares = (size_t)r->n[0] * (size_t)r->n[1];
  for (size_t t = r->mesh->triangles; t-- > 0;) {
    int from[2], to[2];
    squares_of(r, t, from, to);
    for (int i = from[0]; i <= to[0]; i++)
      for (int j = from[1]; j <= to[1]; j++) {
        size_t *last = &r->first[(size_t)i * (size_t)r->n[1] + (size_t)j];
        if (list)
          r->list[--*last] = t;
        else
          ++*last;
      }
  }
  for (size_t k = 0; !list && k < squares; k++) r->first[k + 1] += r->first[k];
}

static enum status lay_squares(struct release_field *r, double width) {
  const struct geo_box *b = &r->box;
  r->width = width;
  for (int axis = 0; axis < 2; axis++)
    r->n[axis] = (int)fmax(ceil((b->max[axis] - b->min[axis]) / width), 1);
  const size_t squares = (size_t)r->n[0] * (size_t)r->n[1];
  TRY(array_create(&r->first, squares + 1, "the triangles of the released pressure"));
  sort_into_squares(r, false);
  TRY(array_create(&r->list, r->first[squares], "the triangles of the released pressure"));
  sort_into_squares(r, true);
  return OK;
}

/* Barycentric coordinates of a point; the least of them, negative outside. */
static double coordinates(const struct release_mesh *m, size_t t, const double at[2],
                          double l[CORNERS]) {
  const double *p[CORNERS];
  for (int k = 0; k < CORNERS; k++) p[k] = m->p[m->corner[t][k]];
  const double cross = geo_triangle_cross(p[0], p[1], p[2]);
  for (int k = 0; k < CORNERS; k++)
    l[k] = geo_triangle_cross(at, p[(k + 1) % 3], p[(k + 2) % 3]) / cross;
  return fmin(l[0], fmin(l[1], l[2]));
}

/* The triangle around a point, or nearest to it, by its own size, in the squares up to `around`
 * away; false: none. */
static bool find_triangle(const struct release_field *r, const double at[2], int around,
                          size_t *best) {
  const int x = square_of(r, 0, at[0]), y = square_of(r, 1, at[1]);
  double inmost = -INFINITY;
  for (int i = x - around; i <= x + around; i++)
    for (int j = y - around; j <= y + around; j++) {
      if (i < 0 || j < 0 || i >= r->n[0] || j >= r->n[1]) continue;
      const size_t square = (size_t)i * (size_t)r->n[1] + (size_t)j;
      for (size_t k = r->first[square]; k < r->first[square + 1] && inmost < 0; k++) {
        double l[CORNERS], least = coordinates(r->mesh, r->list[k], at, l);
        if (least <= inmost) continue;
        inmost = least;
        *best = r->list[k];
      }
    }
  return inmost >= 0 || (around && inmost > -INFINITY);
}

double release_field_at(const struct release_field *r, const double at[2]) {
  double l[CORNERS], shape[SHAPES], head = 0;
  size_t t, place[SHAPES];
  if (!find_triangle(r, at, 0, &t) && !find_triangle(r, at, 1, &t)) return 0;
  coordinates(r->mesh, t, at, l);
  shapes(l, shape);
  places(r->mesh, t, place);
  for (int k = 0; k < SHAPES; k++) head += shape[k] * r->head[place[k]];
  return head;
}

enum status release_field_create(const struct geo_lines *water, const struct geo_lines *walls,
                                 double size, double near, const struct release_drive *drive,
                                 struct release_field **out) {
  enum status status = OK;
  struct release_field *r = NULL;
  *out = NULL;
  ATTEMPT(array_create(&r, 1, "the released pressure"));
  r->drive = *drive;
  r->box = geo_lines_box(water);
  ATTEMPT(release_mesh_create(water, walls, size, near, &r->mesh));
  ATTEMPT(number_unknowns(r));
  ATTEMPT(solve_heads(r));
  ATTEMPT(lay_squares(r, size));
done:
  if (status == OK)
    *out = r;
  else
    release_field_destroy(r);
  return status;
}

void release_field_destroy(struct release_field *r) {
  if (!r) return;
  release_mesh_destroy(r->mesh);
  free(r->head);
  free(r->unknown);
  free(r->first);
  free(r->list);
  free(r);
}
