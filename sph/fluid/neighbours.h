/* Who is near whom. Points are sorted by the cells of a grid of narrow bins stacked in columns that
 * are walked up and down in turn, so that any SPH_LANES points in a row, a cluster, are close
 * together. A list holds, for each cluster of targets, every source within reach of at least one of
 * them: the pair loops take one source against a whole cluster, without gathering. */
#pragma once
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "common/base/geometry.h"
#include "common/base/status.h"

struct sph_grid {
  double x0, y0;       /* m, lower left corner; points outside count to the nearest cell */
  double per_x, per_y; /* cells a metre */
  size_t columns, bins;
  uint32_t *start; /* first point of each cell in sorted order, [columns * bins + 1], owned */
};

enum { SPH_CHUNK = 16 }; /* clusters that share one growing array, built by one thread */

struct sph_chunk {
  uint32_t *j; /* sources, [room], owned */
  size_t room;
  uint32_t first[SPH_CHUNK + 1]; /* cluster c of the chunk: j[first[c]] .. j[first[c+1]-1] */
  /* Where walls hide sources (domain/sight.h): a bit for each lane of the cluster that does not see
   * j, [hidden_room], owned. */
  unsigned char *hidden;
  size_t hidden_room;
  bool hides[SPH_CHUNK]; /* cluster c has such sources */
};

struct sph_lists {
  size_t n_clusters, n_chunks, chunk_room;
  struct sph_chunk *chunks; /* [n_chunks], owned */
};

/* A grid over the box for points about dx apart. ERR_INPUT when it has more cells than can be
 * numbered; ERR_MEMORY. */
enum status sph_grid_create(struct sph_grid *g, const struct geo_box *box, double dx);
void sph_grid_destroy(struct sph_grid *g);

/* Sorts points: fills order [n] (place -> point) and g->start. key is scratch [n]. Points
 * marked in drop (NULL: none) are left out; returns how many are in. */
size_t sph_grid_sort(struct sph_grid *g, size_t n, const double *x, const double *y,
                     const unsigned char *drop, uint32_t *key, uint32_t *order);

/* Sources that a grid has sorted, and that have moved by up to `drift` (m) since then. */
struct sph_points {
  const struct sph_grid *grid;
  const double *x, *y; /* m */
  double drift;
  uint32_t first; /* the number by which lists know the first of them */
};

/* All that one list holds: those of one kind, or the water and its images beyond a periodic tank's
 * ends. */
struct sph_sources {
  size_t n;
  struct sph_points of[2];
};

/* Lists of the sources within `reach` of the clusters of the n targets. */
enum status sph_lists_build(struct sph_lists *l, size_t n, const double *x, const double *y,
                            const struct sph_sources *sources, double reach);
void sph_lists_destroy(struct sph_lists *l);

/* The sources of one cluster. */
static inline const uint32_t *sph_lists_of(const struct sph_lists *l, size_t cluster, size_t *n) {
  const struct sph_chunk *k = &l->chunks[cluster / SPH_CHUNK];
  size_t c = cluster % SPH_CHUNK;
  *n = k->first[c + 1] - k->first[c];
  return k->j + k->first[c];
}

/* What hides them, as many; or NULL. */
static inline const unsigned char *sph_lists_hidden(const struct sph_lists *l, size_t cluster) {
  const struct sph_chunk *k = &l->chunks[cluster / SPH_CHUNK];
  const size_t c = cluster % SPH_CHUNK;
  return k->hides[c] ? k->hidden + k->first[c] : NULL;
}
