#include "sph/observe/fraction.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

/* W is cut off at REACH nodes, 3.5 s: what is lost is erfc(3.5) = 7e-7. */
enum { NODES_PER_SPACING = 2, REACH = 8, STENCIL = 2 * REACH };
/* Images are within so many nodes of their particles, along x and along y. */
enum { IMAGE_REACH = 2 * (REACH + 1) };
enum { MARGIN = IMAGE_REACH + REACH + 1 };
enum { BAND = 32 }; /* rows of nodes that one thread fills; a source reaches into two at most */
#define MAX_NODES ((size_t)1 << 31)

struct sph_source {
  double x, y;   /* in nodes */
  double volume; /* m^2 */
};

void sph_fraction_destroy(struct sph_fraction *g) {
  free(g->memory);
  free(g->source);
  free(g->band);
  free(g->listed);
}

/* An array for n things that need not keep what was in it; NULL without memory. */
static void *roomy(void *old, size_t *room, size_t n, size_t size) {
  if (n <= *room) return old;
  free(old);
  *room = n + n / 4;
  void *new = malloc(*room * size);
  if (!new) *room = 0;
  return new;
}

/* ---- the grid ---- */

/* Where particles count: nowhere near infinity, lest one that has escaped asks for a vast grid. */
static struct geo_box catchment(const struct geo_lines *walls) {
  if (!walls->points) return (struct geo_box){{-1e100, -1e100}, {1e100, 1e100}};
  struct geo_box box = geo_lines_box(walls);
  double diagonal = hypot(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  for (int k = 0; k < 2; k++) {
    box.min[k] -= diagonal;
    box.max[k] += diagonal;
  }
  return box;
}

static bool box_has(const struct geo_box *b, double x, double y) {
  return x >= b->min[0] && x <= b->max[0] && y >= b->min[1] && y <= b->max[1];
}

static struct geo_box box_of(const struct sph_cloud *c, const struct geo_box *catch) {
  struct geo_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  for (size_t i = 0; i < c->n; i++) {
    double x = c->x[i], y = c->y[i];
    if (!box_has(catch, x, y)) continue;
    if (x < box.min[0]) box.min[0] = x;
    if (x > box.max[0]) box.max[0] = x;
    if (y < box.min[1]) box.min[1] = y;
    if (y > box.max[1]) box.max[1] = y;
  }
  return box;
}

/* Lays the grid around the particles; of its columns, the ones in the strip. */
static enum status lay(struct sph_fraction *g, const struct geo_box *box, const double strip[2]) {
  g->nx = g->ny = g->first = 0;
  if (box->min[0] > box->max[0]) return OK;
  double nodes[2];
  for (int k = 0; k < 2; k++) {
    double first = floor(box->min[k] / g->spacing) - MARGIN;
    g->origin[k] = first * g->spacing;
    nodes[k] = ceil(box->max[k] / g->spacing) + MARGIN + 1 - first;
  }
  CHECK(
      nodes[0] * nodes[1] < (double)MAX_NODES, ERR_INPUT,
      "the particles are scattered over %.3g m x %.3g m, too far for a free surface with dx = %g m",
      box->max[0] - box->min[0], box->max[1] - box->min[1], g->dx);
  double from = floor((strip[0] - g->origin[0]) / g->spacing);
  double to = ceil((strip[1] - g->origin[0]) / g->spacing) + 1;
  from = fmin(fmax(from, 0), nodes[0]);
  g->first = (size_t)from;
  g->nx = (size_t)fmin(fmax(to - from, 0), nodes[0] - from);
  if (!g->nx) return OK;
  g->ny = (size_t)nodes[1];
  g->stride = g->nx + 2 * STENCIL;
  g->memory = roomy(g->memory, &g->room, g->stride * g->ny, sizeof *g->memory);
  g->f = g->memory + STENCIL;
  CHECK(g->memory, ERR_MEMORY, "no memory for a free-surface grid of %zu x %zu nodes", g->nx,
        g->ny);
  return OK;
}

/* ---- sources ---- */

/* Whether column x (in nodes) is less than `reach` from the strip. */
static bool is_near(const struct sph_fraction *g, double x, double reach) {
  return x > (double)g->first - reach && x < (double)(g->first + g->nx) + reach;
}

static enum status add_source(struct sph_fraction *g, double x, double y, double volume) {
  struct sph_source new = {(x - g->origin[0]) / g->spacing, (y - g->origin[1]) / g->spacing,
                           volume};
  if (!is_near(g, new.x, REACH)) return OK;
  if (g->sources == g->source_room) {
    size_t room = 2 * g->source_room + 1024;
    struct sph_source *source = realloc(g->source, room * sizeof *source);
    CHECK(source, ERR_MEMORY, "no memory for the free surface of %zu particles", room);
    g->source = source;
    g->source_room = room;
  }
  g->source[g->sources++] = new;
  return OK;
}

/* Whether a segment may have an image of what is at (x, y): a cheap look before the exact one. */
static bool is_beside(const double *a, const double *b, double x, double y, double reach) {
  for (int k = 0; k < 2; k++) {
    double at = k ? y : x, low = a[k] < b[k] ? a[k] : b[k], high = a[k] < b[k] ? b[k] : a[k];
    if (at < low - reach || at > high + reach) return false;
  }
  return true;
}

/* Adds the images of a particle: mirrored in every segment on which it has its foot, and
 * point-reflected in every vertex on both of whose segments it has one. At a corner of 90 to 180
 * degrees, straight ones included, water that fills the corner is thereby continued to every side
 * exactly once. */
static enum status add_images(struct sph_fraction *g, const struct geo_lines *walls, double x,
                              double y, double volume) {
  double reach = (REACH + 1) * g->spacing;
  for (size_t k = 0; k < walls->pieces; k++) {
    size_t m = geo_piece_segments(walls, k);
    bool before = false, on_first = false;
    for (size_t i = 0; i < m; i++) {
      const double *a = walls->p[walls->first[k] + i], *b = geo_segment_end(walls, k, i);
      bool here = is_beside(a, b, x, y, 1.001 * reach);
      double d, t = here ? geo_line_foot(a, b, x, y, &d) : 0;
      here = here && t >= 0 && t < 1 && fabs(d) < reach;
      if (here) {
        double fx = a[0] + t * (b[0] - a[0]), fy = a[1] + t * (b[1] - a[1]);
        TRY(add_source(g, 2 * fx - x, 2 * fy - y, volume));
        if (before) TRY(add_source(g, 2 * a[0] - x, 2 * a[1] - y, volume));
        if (i == 0) on_first = true;
        if (i + 1 == m && i > 1 && walls->closed[k] && on_first)
          TRY(add_source(g, 2 * b[0] - x, 2 * b[1] - y, volume));
      }
      before = here;
    }
  }
  return OK;
}

static enum status add_sources(struct sph_fraction *g, const struct sph_cloud *c,
                               const struct geo_lines *walls, const struct geo_box *catch) {
  g->sources = 0;
  for (size_t i = 0; i < c->n; i++) {
    double x = c->x[i], y = c->y[i];
    if (!box_has(catch, x, y) || !is_near(g, (x - g->origin[0]) / g->spacing, MARGIN)) continue;
    double volume = c->volume ? c->volume[i] : c->dx * c->dx;
    TRY(add_source(g, x, y, volume));
    TRY(add_images(g, walls, x, y, volume));
  }
  CHECK(g->sources < UINT32_MAX, ERR_INPUT, "%zu particles and images are too many", g->sources);
  return OK;
}

/* ---- bands ---- */

/* The first row that a source reaches. */
static size_t lowest_row(const struct sph_source *q) {
  return (size_t)floor(q->y) + 1 - REACH;
}

/* Lists, for every band, the sources that reach into it, in order. */
static enum status list_sources(struct sph_fraction *g) {
  size_t bands = (g->ny + BAND - 1) / BAND;
  g->band = roomy(g->band, &g->band_room, bands + 1, sizeof *g->band);
  CHECK(g->band, ERR_MEMORY, "no memory for the free surface");
  memset(g->band, 0, (bands + 1) * sizeof *g->band);
  for (size_t k = 0; k < g->sources; k++) {
    size_t j = lowest_row(&g->source[k]);
    for (size_t b = j / BAND; b <= (j + STENCIL - 1) / BAND; b++) g->band[b + 1]++;
  }
  for (size_t b = 0; b < bands; b++) g->band[b + 1] += g->band[b];
  size_t n = g->band[bands];
  g->listed = roomy(g->listed, &g->list_room, n, sizeof *g->listed);
  CHECK(g->listed || !n, ERR_MEMORY, "no memory for the free surface of %zu particles", n);
  for (size_t k = 0; k < g->sources; k++) {
    size_t j = lowest_row(&g->source[k]);
    for (size_t b = j / BAND; b <= (j + STENCIL - 1) / BAND; b++)
      g->listed[g->band[b]++] = (uint32_t)k;
  }
  memmove(g->band + 1, g->band, bands * sizeof *g->band);
  g->band[0] = 0;
  return OK;
}

/* exp(-(k spacing/s)^2), k = 1 - REACH .. REACH */
static void taper_of(double *taper) {
  for (int k = 0; k < STENCIL; k++) {
    double q = (double)(k + 1 - REACH) / NODES_PER_SPACING;
    taper[k] = exp(-q * q);
  }
}

/* exp(-((k - t) spacing/s)^2) for the nodes k = 1 - REACH .. REACH around a particle at t, 0 <= t <
 * 1: the Gaussian of a sum is a product, so two exponentials do for all of them. */
static inline void gaussian_row(const double *taper, double t, double *w) {
  const double q = 1.0 / (NODES_PER_SPACING * NODES_PER_SPACING);
  double up = exp(2 * q * t), down = 1 / up, power = exp(-q * t * t);
  w[REACH - 1] = power;
  for (int k = REACH; k < STENCIL; k++) w[k] = power *= up;
  power = w[REACH - 1];
  for (int k = REACH - 2; k >= 0; k--) w[k] = power *= down;
  for (int k = 0; k < STENCIL; k++) w[k] *= taper[k];
}

/* Adds what a source gives to the rows [from, to). */
static void deposit(struct sph_fraction *g, const struct sph_source *q, const double *taper,
                    size_t from, size_t to) {
  double i = floor(q->x), wx[STENCIL], wy[STENCIL];
  gaussian_row(taper, q->x - i, wx);
  gaussian_row(taper, q->y - floor(q->y), wy);
  double scale = q->volume / (M_PI * g->dx * g->dx);
  size_t low = lowest_row(q), left = (size_t)i + 1 + REACH - g->first;
  size_t b0 = low < from ? from - low : 0, b1 = low + STENCIL > to ? to - low : STENCIL;
  for (size_t b = b0; b < b1; b++) {
    double w = scale * wy[b], *f = g->memory + (low + b) * g->stride + left;
#pragma omp simd
    for (int a = 0; a < STENCIL; a++) f[a] += w * wx[a];
  }
}

static void fill_band(struct sph_fraction *g, const double *taper, size_t band) {
  size_t from = band * BAND, to = from + BAND < g->ny ? from + BAND : g->ny;
  memset(g->memory + from * g->stride, 0, (to - from) * g->stride * sizeof *g->memory);
  for (size_t k = g->band[band]; k < g->band[band + 1]; k++)
    deposit(g, &g->source[g->listed[k]], taper, from, to);
}

enum status sph_fraction_fill(struct sph_fraction *g, const struct sph_cloud *c,
                              const struct geo_lines *walls, const double strip[2]) {
  struct geo_box catch = catchment(walls), box = box_of(c, &catch);
  double taper[STENCIL];
  taper_of(taper);
  g->dx = c->dx;
  g->spacing = c->dx / NODES_PER_SPACING;
  TRY(lay(g, &box, strip));
  if (!g->nx) return OK;
  TRY(add_sources(g, c, walls, &catch));
  TRY(list_sources(g));
  /* waking another thread takes about as long as a few hundred sources */
#pragma omp parallel for schedule(dynamic, 1) if (g->sources > 4096)
  for (size_t b = 0; b < (g->ny + BAND - 1) / BAND; b++) fill_band(g, taper, b);
  return OK;
}
