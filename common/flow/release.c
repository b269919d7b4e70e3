#include "common/flow/release.h"

#include <cholmod.h>
#include <math.h>
#include <stdlib.h>

double release_head(double x, double y, double L, double H) {
  double head = H - y;
  /* k_n y = (2n+1) theta; cos by the recurrence cos(a + b) = 2 cos a cos b - cos(a - b), with
   * b = 2 theta. cosh(k x)/cosh(k L) written with decaying exponentials only. */
  double theta = M_PI * y / (2 * H), step = 2 * cos(2 * theta);
  double now = cos(theta), before = now; /* cos(-theta) */
  for (int n = 0; n < 1000000; n++) {
    double odd = 2 * n + 1, k = odd * M_PI / (2 * H);
    double ratio = exp(-k * (L - x)) * (1 + exp(-2 * k * x)) / (1 + exp(-2 * k * L));
    double size = 8 * H / (odd * odd * M_PI * M_PI) * ratio;
    head -= size * now;
    if (size < 1e-13 * H) break;
    double next = step * now - before;
    before = now;
    now = next;
  }
  return head;
}

enum way { DOWN, UP, LEFT, RIGHT, WAYS };

/* What a node sees on its way along the lattice. */
enum end { NODE, SURFACE, WALL };

struct node {
  int unknown; /* its row of the matrix; -1 in the air */
  unsigned char wet, end[WAYS];
  double reach[WAYS]; /* m, to what it sees; of a wall, to the mirror image */
};

struct release {
  struct tank tank;
  struct release_drive drive;
  double near, h[2]; /* m: spacing of the lattice in x and y */
  int n[2];          /* nodes in x and y, half a spacing inside the tank */
  int n_unknowns;
  struct node *node; /* [n[0] * n[1]], column by column, owned */
  double *head;      /* m, [n_unknowns], owned */
};

/* More nodes than this do not make the start better: the pressure is smooth at that scale. */
static const double MOST_NODES = 4e5;

static struct node *node_at(const struct release *r, int i, int j) {
  return &r->node[(size_t)i * (size_t)r->n[1] + (size_t)j];
}

static double place(const struct release *r, int axis, int i) {
  return r->tank.box.min[axis] + (i + 0.5) * r->h[axis];
}

static struct node *neighbour(const struct release *r, int i, int j, enum way way) {
  int di = (way == RIGHT) - (way == LEFT), dj = (way == UP) - (way == DOWN);
  return node_at(r, i + di, j + dj);
}

/* ---- what the nodes see ---- */

/* One way of a node in the span of a cut: the next node, the tank's wall, or the span's end. */
static void see(const struct release *r, struct node *p, enum way way, double at, double end,
                double wall, bool walled) {
  double h = r->h[way == DOWN || way == UP], away = fabs(end - at);
  if (walled && fabs(end - wall) <= r->near && fabs(wall - at) < h) {
    p->end[way] = WALL;
    p->reach[way] = h;
  } else if (away < h) {
    p->end[way] = SURFACE;
    p->reach[way] = fmax(away, 1e-6 * h);
  } else {
    p->end[way] = NODE;
    p->reach[way] = h;
  }
}

/* The nodes on one line of the lattice: on a column (axis 0) they look down and up, on a row (axis
 * 1) left and right. */
static enum status see_along(struct release *r, const struct geo_lines *water, int axis, int line,
                             struct geo_cut *cut) {
  const struct geo_box *box = &r->tank.box;
  double at = place(r, axis, line);
  bool low_wall = axis == 0 || at <= r->tank.top[0];
  bool high_wall = axis == 1 && at <= r->tank.top[1];
  TRY(geo_lines_cut(water, axis, at, r->near, cut));
  for (int k = 0; k < r->n[!axis]; k++) {
    struct node *p = axis == 0 ? node_at(r, line, k) : node_at(r, k, line);
    double along = place(r, !axis, k);
    const double *span = geo_cut_span(cut, along);
    if (!span || along < span[0] || along > span[1]) continue;
    p->wet++;
    see(r, p, axis == 0 ? DOWN : LEFT, along, span[0], box->min[!axis], low_wall);
    see(r, p, axis == 0 ? UP : RIGHT, along, span[1], box->max[!axis], high_wall);
  }
  return OK;
}

/* Wet are the nodes that both cuts say are; a way that leads to another ends at a surface. */
static void number_nodes(struct release *r) {
  for (int i = 0; i < r->n[0]; i++)
    for (int j = 0; j < r->n[1]; j++) {
      struct node *p = node_at(r, i, j);
      p->unknown = p->wet == 2 ? r->n_unknowns++ : -1;
    }
  for (int i = 0; i < r->n[0]; i++)
    for (int j = 0; j < r->n[1]; j++)
      for (enum way way = 0; way < WAYS; way++) {
        struct node *p = node_at(r, i, j);
        bool outside = (way == DOWN && j == 0) || (way == UP && j + 1 == r->n[1]) ||
                       (way == LEFT && i == 0) || (way == RIGHT && i + 1 == r->n[0]);
        if (p->unknown >= 0 && p->end[way] == NODE &&
            (outside || neighbour(r, i, j, way)->unknown < 0))
          p->end[way] = SURFACE;
      }
}

static enum status lay_lattice(struct release *r, const struct geo_lines *water, double spacing) {
  struct geo_box box = geo_lines_box(water);
  double width = r->tank.box.max[0] - r->tank.box.min[0], height = box.max[1] - r->tank.box.min[1];
  double h = fmax(spacing, sqrt(width * height / MOST_NODES));
  r->n[0] = (int)geo_intervals(width, h);
  r->n[1] = (int)geo_intervals(height, h);
  r->h[0] = width / r->n[0];
  r->h[1] = height / r->n[1];
  r->node = calloc((size_t)r->n[0] * (size_t)r->n[1], sizeof *r->node);
  CHECK(r->node, ERR_MEMORY, "no memory for the released pressure at %d x %d nodes", r->n[0],
        r->n[1]);
  struct geo_cut cut = {0};
  enum status status = OK;
  for (int axis = 0; axis < 2; axis++)
    for (int line = 0; line < r->n[axis]; line++) ATTEMPT(see_along(r, water, axis, line, &cut));
  number_nodes(r);
done:
  geo_cut_destroy(&cut);
  return status;
}

/* ---- the solve ---- */

/* The lower half of the matrix, a row for each node: the flux into its cell, m. */
static void fill_row(const struct release *r, int i, int j, cholmod_triplet *t, double *flux) {
  const struct node *p = node_at(r, i, j);
  double diagonal = 0;
  int *row = t->i, *column = t->j;
  double *value = t->x;
  flux[p->unknown] = r->drive.source * r->h[0] * r->h[1];
  for (enum way way = 0; way < WAYS; way++) {
    bool upright = way == DOWN || way == UP;
    double across = r->h[!upright], weight = across / p->reach[way];
    if (p->end[way] == WALL) {
      if (way == DOWN) flux[p->unknown] += r->drive.weight * across; /* the bed carries the water */
      continue;
    }
    diagonal += weight;
    if (p->end[way] == SURFACE) continue;
    int other = neighbour(r, i, j, way)->unknown;
    if (other > p->unknown) continue;
    row[t->nnz] = p->unknown;
    column[t->nnz] = other;
    value[t->nnz++] = -weight;
  }
  row[t->nnz] = column[t->nnz] = p->unknown;
  value[t->nnz++] = diagonal;
}

static cholmod_dense *solve(const struct release *r, cholmod_common *common) {
  size_t n = (size_t)r->n_unknowns;
  cholmod_triplet *t = cholmod_allocate_triplet(n, n, 3 * n, -1, CHOLMOD_REAL, common);
  cholmod_dense *flux = cholmod_zeros(n, 1, CHOLMOD_REAL, common), *head = NULL;
  if (t && flux)
    for (int i = 0; i < r->n[0]; i++)
      for (int j = 0; j < r->n[1]; j++)
        if (node_at(r, i, j)->unknown >= 0) fill_row(r, i, j, t, flux->x);
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

static enum status solve_heads(struct release *r) {
  if (!r->n_unknowns) return OK;
  r->head = calloc((size_t)r->n_unknowns, sizeof *r->head);
  CHECK(r->head, ERR_MEMORY, "no memory for the released pressure at %d nodes", r->n_unknowns);
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  common.supernodal = CHOLMOD_SIMPLICIAL; /* no BLAS, whose threads would change the last bits */
  cholmod_dense *head = solve(r, &common);
  bool no_memory = common.status == CHOLMOD_OUT_OF_MEMORY;
  for (int k = 0; head && k < r->n_unknowns; k++) r->head[k] = ((const double *)head->x)[k];
  bool solved = head != NULL;
  cholmod_free_dense(&head, &common);
  cholmod_finish(&common);
  CHECK(!no_memory, ERR_MEMORY, "no memory for the released pressure at %d nodes", r->n_unknowns);
  CHECK(solved, ERR_SOLVER, "CHOLMOD cannot solve for the released pressure at %d nodes",
        r->n_unknowns);
  return OK;
}

enum status release_create(const struct geo_lines *water, const struct tank *tank, double spacing,
                           double near, const struct release_drive *drive, struct release **out) {
  enum status status = OK;
  struct release *r = calloc(1, sizeof *r);
  *out = NULL;
  CHECK(r, ERR_MEMORY, "no memory for the released pressure");
  r->tank = *tank;
  r->drive = *drive;
  r->near = near;
  ATTEMPT(lay_lattice(r, water, spacing));
  ATTEMPT(solve_heads(r));
done:
  if (status != OK) {
    release_destroy(r);
    r = NULL;
  }
  *out = r;
  return status;
}

void release_destroy(struct release *r) {
  if (!r) return;
  free(r->node);
  free(r->head);
  free(r);
}

/* ---- between the nodes ---- */

/* The wet node nearest to a point, among that of its cell and those around it; NULL: none. */
static const struct node *nearest_node(const struct release *r, double x, double y, int at[2]) {
  const struct node *best = NULL;
  double nearest = INFINITY;
  int i0 = (int)floor((x - r->tank.box.min[0]) / r->h[0]);
  int j0 = (int)floor((y - r->tank.box.min[1]) / r->h[1]);
  for (int i = i0 - 1; i <= i0 + 1; i++)
    for (int j = j0 - 1; j <= j0 + 1; j++) {
      if (i < 0 || j < 0 || i >= r->n[0] || j >= r->n[1]) continue;
      const struct node *p = node_at(r, i, j);
      double away = hypot(x - place(r, 0, i), y - place(r, 1, j));
      if (p->unknown < 0 || away >= nearest) continue;
      nearest = away;
      best = p;
      at[0] = i;
      at[1] = j;
    }
  return best;
}

static double seen(const struct release *r, const struct node *p, const int at[2], enum way way) {
  if (p->end[way] == SURFACE) return 0;
  if (p->end[way] == NODE) return r->head[neighbour(r, at[0], at[1], way)->unknown];
  const double weight = way == DOWN ? r->drive.weight * r->h[1] : 0;
  return r->head[p->unknown] + weight; /* the mirror image in the wall */
}

/* Change of the head along one axis from the node to a distance s: the parabola through the node
 * and what it sees both ways. */
static double change(const struct release *r, const struct node *p, const int at[2], enum way low,
                     enum way high, double s) {
  double a = p->reach[low], b = p->reach[high], here = r->head[p->unknown];
  double below = (seen(r, p, at, low) - here) / -a, above = (seen(r, p, at, high) - here) / b;
  double curvature = (above - below) / (a + b);
  return s * (below + curvature * (s + a));
}

double release_at(const struct release *r, double x, double y) {
  int at[2] = {0, 0};
  const struct node *p = nearest_node(r, x, y, at);
  if (!p) return 0;
  double head = r->head[p->unknown] + change(r, p, at, LEFT, RIGHT, x - place(r, 0, at[0])) +
                change(r, p, at, DOWN, UP, y - place(r, 1, at[1]));
  return r->drive.source < 0 ? head : fmax(head, 0); /* no suction in water that is let go */
}
