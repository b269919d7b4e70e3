/* Clouds of particles, and their surfaces, for tests. */
#pragma once
#include <stdint.h>
#include <stdlib.h>

#include "common/cloud/surface.h"
#include "tests/test.h"

static const double dx = 0.0123;

struct swarm {
  size_t n, room;
  double *x, *y;
};

static inline void swarm_add(struct swarm *c, double x, double y) {
  if (c->n == c->room) {
    c->room = c->room ? 2 * c->room : 1024;
    c->x = realloc(c->x, c->room * sizeof *c->x);
    c->y = realloc(c->y, c->room * sizeof *c->y);
    if (!c->x || !c->y) abort();
  }
  c->x[c->n] = x;
  c->y[c->n++] = y;
}

static inline void swarm_destroy(struct swarm *c) {
  free(c->x);
  free(c->y);
  *c = (struct swarm){0};
}

/* A square lattice of particles in the cells of [x0, x1] x [y0, y1]. */
static inline void swarm_block(struct swarm *c, double x0, double y0, double x1, double y1,
                               double d) {
  for (long j = 0; j < lround((y1 - y0) / d); j++)
    for (long i = 0; i < lround((x1 - x0) / d); i++)
      swarm_add(c, x0 + ((double)i + 0.5) * d, y0 + ((double)j + 0.5) * d);
}

/* Reproducible uniform numbers in (-1, 1). */
static inline double noise(void) {
  static uint64_t state = 88172645463325252u;
  state ^= state << 13;
  state ^= state >> 7;
  state ^= state << 17;
  return (double)(state >> 11) / 4503599627370496.0 - 1;
}

static inline void swarm_jitter(struct swarm *c, double amplitude) {
  for (size_t i = 0; i < c->n; i++) {
    c->x[i] += amplitude * noise();
    c->y[i] += amplitude * noise();
  }
}

/* Rings of particles that fill the disc or annulus evenly right up to its edges: its surface is
 * known exactly, unlike that of a lattice cut by a circle. */
static inline void swarm_disc(struct swarm *c, double x, double y, double inner, double outer,
                              double spacing, double *volume) {
  int rings = (int)lround((outer - inner) / spacing);
  double width = (outer - inner) / rings;
  for (int k = 0; k < rings; k++) {
    double r = inner + (k + 0.5) * width;
    int m = (int)lround(2 * M_PI * r / width);
    for (int i = 0; i < m; i++) {
      double angle = 2 * M_PI * (i + 0.3 * k) / m;
      swarm_add(c, x + r * cos(angle), y + r * sin(angle));
      volume[c->n - 1] = 2 * M_PI * r * width / m;
    }
  }
}

/* Walls of a tank [0, width] x [0, height], open at the top. */
static inline void tank(struct geo_lines *l, double width, double height) {
  EXPECT_OK(geo_lines_begin(l, false));
  EXPECT_OK(geo_lines_add(l, 0, height));
  EXPECT_OK(geo_lines_add(l, 0, 0));
  EXPECT_OK(geo_lines_add(l, width, 0));
  EXPECT_OK(geo_lines_add(l, width, height));
}

static inline void extract(const struct swarm *c, const double *volume, double spacing,
                           const struct geo_lines *walls, struct geo_lines *out) {
  struct cloud_surface *s = NULL;
  EXPECT_OK(cloud_surface_create(&s));
  EXPECT_OK(cloud_surface_extract(s, &(struct cloud){c->n, c->x, c->y, volume, spacing, NULL},
                                  walls, out));
  cloud_surface_destroy(s);
}

/* The ripple of the lattice, 2.1e-4 in F at most, over its slope 1/(sqrt(pi) dx). */
#define LATTICE_NOISE (3.7e-4 * dx)
