/* How long neighbour lists hold. A pair that is not listed was at least the support and the skin
 * apart, so that it can meet only after the two have moved by the skin against each other: water
 * that flows together needs no new lists.
 *
 * The tank is divided into blocks, a few cells of the grid each. What any two particles of blocks
 * that touch have moved against each other is at most the diagonal of the box around all their
 * displacements; so for blocks with one between; and for all others twice the longest way. The
 * boxes are taken where the water is, and where it will be after some time at its present velocity:
 * in between, on a straight way, a pair has moved by no more than the larger of the two. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

struct sph;
struct sph_grid;

struct sph_drift_box {
  double low[4], high[4]; /* x, y of displacements now; and after `ahead`, m */
};

struct sph_drift {
  size_t columns, bins, nx, ny; /* cells of the grid in a block; blocks */
  double size;                  /* m: blocks that do not touch are at least so far apart */
  struct sph_drift_box *box;    /* [nx * ny], owned */
  /* Of the last measure: */
  double ahead;                /* s */
  double touching, near, most; /* m, the largest displacements against one another: of particles in
                                  blocks that touch, that have one between them, of any */
  double walls;                /* m, sph_drift_at_walls(ahead) */
};

/* For pairs that meet at `support` (m). ERR_MEMORY. */
enum status sph_drift_create(struct sph_drift *d, const struct sph_grid *g, double support);
void sph_drift_destroy(struct sph_drift *d);

/* Of the water now, and `ahead` (s) later. */
void sph_drift_measure(struct sph *s, double ahead);

/* How much farther any two particles may move against each other, m, before the lists of the water,
 * with s->skin, miss a pair; negative when they may already. */
double sph_drift_left(const struct sph *s);

/* Remembers where the water is as the walls are listed, and how far from them. */
void sph_drift_list_walls(struct sph *s);

/* The longest way, m, since the walls were listed, or up to `ahead` later, of water that the walls'
 * lists may concern. */
double sph_drift_at_walls(const struct sph *s, double ahead);

/* The longest way of any particle since the water was sorted, m. */
double sph_drift_since_sorted(const struct sph *s);
