/* The particles of a run, or other points that fill its water, at the comparison times, as tables
 * that pictures are drawn from. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

struct cmp_cloud {
  size_t n;       /* 0: there are none then, or none that fill the water (boundary nodes do not) */
  double top;     /* the pressure that all but one in a hundred stay below */
  double spacing; /* H */
};

/* Of run r at every comparison time, read at once; `figure` [n_times] are the indices in `f` of
 * those that they belong to, SIZE_MAX for none. Fills cloud [n_times]. */
enum status cmp_clouds_write(const struct comparison *c, size_t r, struct cmp_figures *f,
                             const size_t *figure, struct cmp_cloud *cloud);

/* The output of points at t, SIZE_MAX for none. */
size_t cmp_cloud_output(const struct comparison *c, const struct result_file *f, double t);

/* Whether the points of a file have a field of that name, scalar or vector. */
bool cmp_cloud_has_field(const struct result_file *f, const char *name);

/* Of n points that fill the water, particles of the run's spacing or others that say which volume
 * they stand for: their spacing, H; 0 of boundary nodes. */
double cmp_cloud_spacing(const struct cmp_data *d, size_t n);
