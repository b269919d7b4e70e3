#include "common/cloud/fraction.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

/* W is cut off at REACH nodes, 3.5 s: what is lost is erfc(3.5) = 7e-7. */
enum { NODES_PER_SPACING = 2, REACH = 8, STENCIL = 2 * REACH };
/* Images are within so many nodes of their particles, along x and along y. */
enum { IMAGE_REACH = 2 * (REACH + 1) };
enum { MARGIN = IMAGE_REACH + REACH + 1 };
#define MAX_NODES ((size_t)1 << 31)

struct cloud_source {
  double x, y;   /* in nodes */
  double volume; /* m^2 */
};

void cloud_fraction_destroy(struct cloud_fraction *g) {
  free(g->memory);
  images_destroy(&g->images);
  images_destroy(&g->beyond);
  geo_lines_destroy(&g->walls);
  free(g->source);
  free(g->band);
  free(g->listed);
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

static struct geo_box box_of(const struct cloud *c, const struct geo_box *catch) {
  double left = INFINITY, right = -INFINITY, low = INFINITY, high = -INFINITY;
#pragma omp simd reduction(min : left, low) reduction(max : right, high)
  for (size_t i = 0; i < c->n; i++) {
    bool in = geo_box_contains(catch, c->x[i], c->y[i]);
    double x0 = in ? c->x[i] : INFINITY, x1 = in ? c->x[i] : -INFINITY;
    double y0 = in ? c->y[i] : INFINITY, y1 = in ? c->y[i] : -INFINITY;
    left = x0 < left ? x0 : left;
    right = x1 > right ? x1 : right;
    low = y0 < low ? y0 : low;
    high = y1 > high ? y1 : high;
  }
  struct geo_box box = {{left, low}, {right, high}};
  for (int axis = 0; axis < 2; axis++)
    if (c->tank && c->tank->periodic[axis] && left <= right) {
      box.min[axis] = c->tank->box.min[axis];
      box.max[axis] = c->tank->box.max[axis];
    }
  return box;
}

/* Lays the grid around the particles; of its columns, the ones in the strip. */
static enum status lay(struct cloud_fraction *g, const struct geo_box *box, const double strip[2]) {
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
  TRY(array_grow(&g->memory, &g->room, g->stride * g->ny, "the nodes of a free surface"));
  g->f = g->memory + STENCIL;
  return OK;
}

/* ---- sources ---- */

/* Whether column x (in nodes) is less than `reach` from the strip. */
static bool is_near(const struct cloud_fraction *g, double x, double reach) {
  return x > (double)g->first - reach && x < (double)(g->first + g->nx) + reach;
}

static enum status add_source(struct cloud_fraction *g, double x, double y, double volume) {
  struct cloud_source new = {(x - g->origin[0]) / g->spacing, (y - g->origin[1]) / g->spacing,
                             volume};
  if (!is_near(g, new.x, REACH)) return OK;
  TRY(array_grow(&g->source, &g->source_room, g->sources + 1, "particles near a free surface"));
  g->source[g->sources++] = new;
  return OK;
}

/* Adds the images of a particle. */
static enum status add_images(struct cloud_fraction *g, double x, double y, double volume) {
  size_t n = images_of(&g->images, x, y);
  for (size_t k = 0; k < n; k++)
    TRY(add_source(g, g->images.found[k].x, g->images.found[k].y, volume));
  return OK;
}

static enum status add_particle(struct cloud_fraction *g, double x, double y, double volume) {
  TRY(add_source(g, x, y, volume));
  TRY(add_images(g, x, y, volume));
  size_t n = images_beyond(&g->beyond, x, y);
  for (size_t k = 0; k < n; k++) {
    const struct image *at = &g->beyond.found[k];
    TRY(add_source(g, at->x, at->y, volume));
    TRY(add_images(g, at->x, at->y, volume));
  }
  return OK;
}

/* The particles that may matter to the strip, in order; all that have images round the tank. */
static size_t choose(const struct cloud_fraction *g, const struct cloud *c, struct geo_box box,
                     uint32_t *chosen) {
  double left = g->origin[0] + ((double)g->first - MARGIN - 1) * g->spacing;
  double right = g->origin[0] + ((double)(g->first + g->nx) + MARGIN + 1) * g->spacing;
  size_t n = 0;
  if (!g->beyond.n_shifts) {
    box.min[0] = fmax(box.min[0], left);
    box.max[0] = fmin(box.max[0], right);
  }
  for (size_t i = 0; i < c->n; i++) {
    chosen[n] = (uint32_t)i;
    n += geo_box_contains(&box, c->x[i], c->y[i]);
  }
  return n;
}

/* Of what has images: the walls, and the periods of the tank. */
static enum status set_images(struct cloud_fraction *g, const struct cloud *c,
                              const struct geo_lines *walls) {
  const double reach = (REACH + 1) * g->spacing;
  if (c->tank && tank_is_periodic(c->tank)) {
    TRY(tank_walls(c->tank, walls, 2 * reach, &g->walls));
    TRY(images_set_walls(&g->images, &g->walls, 0));
    TRY(images_set_periods(&g->beyond, c->tank, reach));
  } else {
    TRY(images_set_walls(&g->images, walls, 0));
    g->beyond.n_shifts = 0;
  }
  images_set_reach(&g->images, reach, 0);
  return OK;
}

static enum status add_sources(struct cloud_fraction *g, const struct cloud *c,
                               const struct geo_lines *walls, const struct geo_box *catch) {
  TRY(set_images(g, c, walls));
  TRY(array_grow(&g->listed, &g->list_room, c->n + 1, "particles near a free surface"));
  size_t n = choose(g, c, *catch, g->listed);
  g->sources = 0;
  for (size_t k = 0; k < n; k++) {
    size_t i = g->listed[k];
    double volume = c->volume ? c->volume[i] : c->dx * c->dx;
    TRY(add_particle(g, c->x[i], c->y[i], volume));
  }
  CHECK(g->sources < UINT32_MAX, ERR_INPUT, "%zu particles and images are too many", g->sources);
  return OK;
}

/* ---- bands ---- */

/* The first row that a source reaches. */
static size_t lowest_row(const struct cloud_source *q) {
  return (size_t)floor(q->y) + 1 - REACH;
}

/* Lists, for every band, the sources that reach into it, in order. */
static enum status list_sources(struct cloud_fraction *g) {
  size_t bands = (g->ny + CLOUD_BAND - 1) / CLOUD_BAND;
  TRY(array_grow(&g->band, &g->band_room, bands + 1, "the rows of a free surface"));
  memset(g->band, 0, (bands + 1) * sizeof *g->band);
  for (size_t k = 0; k < g->sources; k++) {
    size_t j = lowest_row(&g->source[k]);
    for (size_t b = j / CLOUD_BAND; b <= (j + STENCIL - 1) / CLOUD_BAND; b++) g->band[b + 1]++;
  }
  for (size_t b = 0; b < bands; b++) g->band[b + 1] += g->band[b];
  TRY(array_grow(&g->listed, &g->list_room, g->band[bands], "particles near a free surface"));
  for (size_t k = 0; k < g->sources; k++) {
    size_t j = lowest_row(&g->source[k]);
    for (size_t b = j / CLOUD_BAND; b <= (j + STENCIL - 1) / CLOUD_BAND; b++)
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
static void deposit(struct cloud_fraction *g, const struct cloud_source *q, const double *taper,
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

static void fill_band(struct cloud_fraction *g, const double *taper, size_t band) {
  size_t from = band * CLOUD_BAND, to = from + CLOUD_BAND < g->ny ? from + CLOUD_BAND : g->ny;
  memset(g->memory + from * g->stride, 0, (to - from) * g->stride * sizeof *g->memory);
  for (size_t k = g->band[band]; k < g->band[band + 1]; k++)
    deposit(g, &g->source[g->listed[k]], taper, from, to);
}

enum status cloud_fraction_fill(struct cloud_fraction *g, const struct cloud *c,
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
  for (size_t b = 0; b < (g->ny + CLOUD_BAND - 1) / CLOUD_BAND; b++) fill_band(g, taper, b);
  return OK;
}
