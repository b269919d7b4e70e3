#include "sph/fluid/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SPH_SINGLE    /* is enough for a search: distances are counted from the cluster, and rounded \
                         up */
#include "sph/pair/vec.h"

static const double rounding = 1 + 1e-5; /* of squares in single precision, and more */

/* In reaches: a cluster that is wider is searched for in doubles, and not in all of its box. */
static const double wide = 4;

/* In particle spacings: wide enough for a cluster of eight to be about square. */
static const double column_width = 2.83, bin_height = 1;

enum status sph_grid_create(struct sph_grid *g, const struct geo_box *box, double dx) {
  g->x0 = box->min[0];
  g->y0 = box->min[1];
  double columns = fmax(1, ceil((box->max[0] - box->min[0]) / (column_width * dx)));
  double bins = fmax(1, ceil((box->max[1] - box->min[1]) / (bin_height * dx)));
  CHECK(columns * bins < (double)UINT32_MAX, ERR_INPUT,
        "the tank is %.3g by %.3g particle spacings, too many cells to number: lower the "
        "resolution or the walls",
        columns * column_width, bins * bin_height);
  g->columns = (size_t)columns;
  g->bins = (size_t)bins;
  g->per_x = 1 / (column_width * dx);
  g->per_y = 1 / (bin_height * dx);
  g->start = calloc(g->columns * g->bins + 1, sizeof *g->start);
  CHECK(g->start, ERR_MEMORY, "no memory for %zu x %zu cells", g->columns, g->bins);
  return OK;
}

void sph_grid_destroy(struct sph_grid *g) {
  free(g->start);
  *g = (struct sph_grid){0};
}

static size_t clamp_cell(double at, size_t n) {
  return (size_t)smaller(larger(at, 0), (double)(n - 1)); /* larger(NaN, 0) is 0 */
}

static size_t column_of(const struct sph_grid *g, double x) {
  return clamp_cell((x - g->x0) * g->per_x, g->columns);
}

static size_t bin_of(const struct sph_grid *g, double y) {
  return clamp_cell((y - g->y0) * g->per_y, g->bins);
}

/* Up the even columns, down the odd ones. */
static size_t cell_of(const struct sph_grid *g, size_t column, size_t bin) {
  return column * g->bins + (column % 2 ? g->bins - 1 - bin : bin);
}

size_t sph_grid_sort(struct sph_grid *g, size_t n, const double *x, const double *y,
                     const unsigned char *drop, uint32_t *key, uint32_t *order) {
  size_t cells = g->columns * g->bins;
  memset(g->start, 0, (cells + 1) * sizeof *g->start);
  for (size_t i = 0; i < n; i++) {
    if (drop && drop[i]) continue;
    key[i] = (uint32_t)cell_of(g, column_of(g, x[i]), bin_of(g, y[i]));
    g->start[key[i] + 1]++;
  }
  for (size_t c = 0; c < cells; c++) g->start[c + 1] += g->start[c];
  size_t kept = g->start[cells];
  for (size_t i = 0; i < n; i++)
    if (!drop || !drop[i]) order[g->start[key[i]]++] = (uint32_t)i;
  memmove(g->start + 1, g->start, cells * sizeof *g->start);
  g->start[0] = 0;
  return kept;
}

/* Targets of a cluster, counted from the first; missing ones repeat it. */
struct cluster {
  double x0, y0, left, right, low, high; /* m; the box around it */
  vec x[SPH_PARTS], y[SPH_PARTS];
  double all_x[SPH_LANES], all_y[SPH_LANES]; /* m, as they are */
};

static struct cluster cluster_of(const double *x, const double *y, size_t i, size_t n) {
  struct cluster c = {x[i], y[i], x[i], x[i], y[i], y[i], {{0}}, {{0}}, {0}, {0}};
  for (size_t l = 0; l < SPH_LANES; l++) {
    const size_t at = i + l < n ? i + l : i;
    c.all_x[l] = x[at];
    c.all_y[l] = y[at];
    c.left = smaller(x[at], c.left);
    c.right = larger(x[at], c.right);
    c.low = smaller(y[at], c.low);
    c.high = larger(y[at], c.high);
    for (size_t k = 0; k < SPH_SOURCES; k++) {
      const size_t element = l % SPH_TARGETS * SPH_SOURCES + k;
      c.x[l / SPH_TARGETS][element] = (real)(x[at] - c.x0);
      c.y[l / SPH_TARGETS][element] = (real)(y[at] - c.y0);
    }
  }
  return c;
}

SPECIALISE bool is_near(const struct cluster *c, double x, double y, vec limit) {
  const vec xj = vec_of((real)(x - c->x0)), yj = vec_of((real)(y - c->y0));
  bool any = false;
  for (int part = 0; part < SPH_PARTS; part++) {
    const vec dx = xj - c->x[part], dy = yj - c->y[part];
    any |= vec_any_less(dx * dx + dy * dy, limit);
  }
  return any;
}

static enum status make_room(struct sph_chunk *k, size_t n) {
  if (n <= k->room) return OK;
  const size_t room = 2 * n;
  uint32_t *j = realloc(k->j, room * sizeof *j);
  CHECK(j, ERR_MEMORY, "no memory for the neighbour lists");
  k->j = j;
  k->room = room;
  return OK;
}

/* Appends the sources of cells [from, to) that are near one of the cluster's points. By itself, so
 * that the cluster stays in registers: lists take a third of the time that way. */
__attribute__((noinline)) static enum status append(struct sph_chunk *k, size_t *n, size_t from,
                                                    size_t to, const struct cluster *c,
                                                    const struct sph_points *s, double reach) {
  TRY(make_room(k, *n + (to - from)));
  const struct cluster t = *c; /* out of the reach of what is written */
  const double *x = s->x, *y = s->y;
  const vec limit = vec_of((real)(reach * reach * rounding));
  const uint32_t first = s->first;
  uint32_t *out = k->j;
  size_t at = *n;
  for (size_t j = from; j < to; j++) {
    out[at] = first + (uint32_t)j;
    at += is_near(&t, x[j], y[j], limit);
  }
  *n = at;
  return OK;
}

/* The same for a wide cluster. */
static enum status append_to_wide(struct sph_chunk *k, size_t *n, size_t from, size_t to,
                                  const struct cluster *c, const struct sph_points *s,
                                  double reach) {
  TRY(make_room(k, *n + (to - from)));
  for (size_t j = from; j < to; j++) {
    bool near = false;
    for (size_t l = 0; l < SPH_LANES; l++) {
      const double x = s->x[j] - c->all_x[l], y = s->y[j] - c->all_y[l];
      near |= x * x + y * y < reach * reach;
    }
    k->j[*n] = s->first + (uint32_t)j;
    *n += near;
  }
  return OK;
}

/* Between which heights a column may hold sources near a cluster's points. */
struct heights {
  double low, high;
};

static struct heights heights_in(const struct sph_grid *g, size_t column, const struct cluster *c,
                                 double far) {
  struct heights h = {INFINITY, -INFINITY};
  for (size_t l = 0; l < SPH_LANES; l++) {
    if (column < column_of(g, c->all_x[l] - far) || column > column_of(g, c->all_x[l] + far))
      continue;
    h.low = smaller(c->all_y[l] - far, h.low);
    h.high = larger(c->all_y[l] + far, h.high);
  }
  return h;
}

static enum status build_wide(struct sph_chunk *k, size_t *n, const struct cluster *t,
                              const struct sph_points *s, double reach) {
  const struct sph_grid *g = s->grid;
  const double far = reach + s->drift;
  const size_t last = column_of(g, t->right + far);
  for (size_t c = column_of(g, t->left - far); c <= last; c++) {
    const struct heights h = heights_in(g, c, t, far);
    if (h.low > h.high) continue;
    size_t a = cell_of(g, c, bin_of(g, h.low)), b = cell_of(g, c, bin_of(g, h.high));
    size_t from = g->start[a < b ? a : b], to = g->start[(a < b ? b : a) + 1];
    if (from < to) TRY(append_to_wide(k, n, from, to, t, s, reach));
  }
  return OK;
}

static enum status build_cluster(struct sph_chunk *k, size_t *n, const struct cluster *t,
                                 const struct sph_points *s, double reach) {
  const struct sph_grid *g = s->grid;
  const double far = reach + s->drift;
  if (larger(t->right - t->left, t->high - t->low) > wide * reach)
    return build_wide(k, n, t, s, reach);
  const size_t bin0 = bin_of(g, t->low - far), bin1 = bin_of(g, t->high + far);
  const size_t last = column_of(g, t->right + far);
  for (size_t c = column_of(g, t->left - far); c <= last; c++) {
    size_t a = cell_of(g, c, bin0), b = cell_of(g, c, bin1);
    size_t from = g->start[a < b ? a : b], to = g->start[(a < b ? b : a) + 1];
    if (from < to) TRY(append(k, n, from, to, t, s, reach));
  }
  return OK;
}

static enum status build_chunk(struct sph_lists *l, size_t chunk, size_t n, const double *x,
                               const double *y, const struct sph_sources *s, double reach) {
  struct sph_chunk *k = &l->chunks[chunk];
  size_t at = 0;
  for (size_t c = 0; c < SPH_CHUNK; c++) {
    size_t i = (chunk * SPH_CHUNK + c) * SPH_LANES;
    k->first[c] = (uint32_t)at;
    k->hides[c] = false;
    if (i >= n) continue;
    const struct cluster t = cluster_of(x, y, i, n);
    for (size_t kind = 0; kind < s->n; kind++) TRY(build_cluster(k, &at, &t, &s->of[kind], reach));
  }
  k->first[SPH_CHUNK] = (uint32_t)at;
  return OK;
}

enum status sph_lists_build(struct sph_lists *l, size_t n, const double *x, const double *y,
                            const struct sph_sources *sources, double reach) {
  l->n_clusters = (n + SPH_LANES - 1) / SPH_LANES;
  l->n_chunks = (l->n_clusters + SPH_CHUNK - 1) / SPH_CHUNK;
  if (l->n_chunks > l->chunk_room) {
    struct sph_chunk *chunks = realloc(l->chunks, l->n_chunks * sizeof *chunks);
    CHECK(chunks, ERR_MEMORY, "no memory for the neighbour lists");
    memset(chunks + l->chunk_room, 0, (l->n_chunks - l->chunk_room) * sizeof *chunks);
    l->chunks = chunks;
    l->chunk_room = l->n_chunks;
  }
  int failed = 0;
#pragma omp parallel for schedule(dynamic) reduction(| : failed)
  for (size_t c = 0; c < l->n_chunks; c++)
    failed |= build_chunk(l, c, n, x, y, sources, reach) != OK;
  CHECK(!failed, ERR_MEMORY, "no memory for the neighbour lists");
  return OK;
}

void sph_lists_destroy(struct sph_lists *l) {
  for (size_t c = 0; c < l->chunk_room; c++) {
    free(l->chunks[c].j);
    free(l->chunks[c].hidden);
  }
  free(l->chunks);
  *l = (struct sph_lists){0};
}
