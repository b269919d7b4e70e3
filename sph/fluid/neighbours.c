#include "sph/fluid/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sph/pair/vec.h"

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
  return (size_t)fmin(fmax(at, 0), (double)(n - 1)); /* fmax(NaN, 0) is 0 */
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

/* Appends the sources of cells [from, to) that are near one of the cluster's points. */
static enum status append(struct sph_chunk *k, size_t *n, size_t from, size_t to, vec x, vec y,
                          const double *xs, const double *ys, double reach) {
  if (*n + (to - from) > k->room) {
    size_t room = 2 * (*n + (to - from));
    uint32_t *j = realloc(k->j, room * sizeof *j);
    CHECK(j, ERR_MEMORY, "no memory for the neighbour lists");
    k->j = j;
    k->room = room;
  }
  vec limit = (vec){0} + reach * reach;
  uint32_t *out = k->j;
  size_t at = *n;
  for (size_t j = from; j < to; j++) {
    vec dx = xs[j] - x, dy = ys[j] - y;
    out[at] = (uint32_t)j;
    at += vec_any_less(dx * dx + dy * dy, limit);
  }
  *n = at;
  return OK;
}

static enum status build_cluster(struct sph_chunk *k, size_t *n, vec x, vec y,
                                 const struct sph_grid *g, const double *xs, const double *ys,
                                 double reach) {
  double left = -vec_largest(-x) - reach, right = vec_largest(x) + reach;
  double low = -vec_largest(-y) - reach, high = vec_largest(y) + reach;
  size_t bin0 = bin_of(g, low), bin1 = bin_of(g, high), last = column_of(g, right);
  for (size_t c = column_of(g, left); c <= last; c++) {
    size_t a = cell_of(g, c, bin0), b = cell_of(g, c, bin1);
    size_t from = g->start[a < b ? a : b], to = g->start[(a < b ? b : a) + 1];
    if (from < to) TRY(append(k, n, from, to, x, y, xs, ys, reach));
  }
  return OK;
}

/* The last cluster's missing lanes repeat its first point. */
static vec cluster_points(const double *x, size_t i, size_t n) {
  vec v;
  for (size_t l = 0; l < SPH_LANES; l++) v[l] = x[i + l < n ? i + l : i];
  return v;
}

static enum status build_chunk(struct sph_lists *l, size_t chunk, size_t n, const double *x,
                               const double *y, const struct sph_grid *g, const double *xs,
                               const double *ys, double reach) {
  struct sph_chunk *k = &l->chunks[chunk];
  size_t at = 0;
  for (size_t c = 0; c < SPH_CHUNK; c++) {
    size_t i = (chunk * SPH_CHUNK + c) * SPH_LANES;
    k->first[c] = (uint32_t)at;
    if (i < n)
      TRY(build_cluster(k, &at, cluster_points(x, i, n), cluster_points(y, i, n), g, xs, ys,
                        reach));
  }
  k->first[SPH_CHUNK] = (uint32_t)at;
  return OK;
}

enum status sph_lists_build(struct sph_lists *l, size_t n, const double *x, const double *y,
                            const struct sph_grid *g, const double *xs, const double *ys,
                            double reach) {
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
    failed |= build_chunk(l, c, n, x, y, g, xs, ys, reach) != OK;
  CHECK(!failed, ERR_MEMORY, "no memory for the neighbour lists");
  return OK;
}

void sph_lists_destroy(struct sph_lists *l) {
  for (size_t c = 0; c < l->chunk_room; c++) free(l->chunks[c].j);
  free(l->chunks);
  *l = (struct sph_lists){0};
}
