/* The particles of a run, or other points that fill its water, at the comparison times, as tables
 * that pictures are drawn from. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

/* What points are coloured by: a name, the field in the file, whether that is a vector, of which
 * the length counts, the head of its column, the label of its colours. */
#define CMP_FIELD_LIST(X)                                                                          \
  X(pressure, "pressure", false, "pressure [rho g H]", "p / (ρ g H)")                              \
  X(speed, "velocity", true, "speed [sqrt(g H)]", "|u| / √(g H)")                                  \
  X(density, "density", false, "density [rho0]", "ρ / ρ_0")
enum cmp_field {
#define X(name, ...) CMP_FIELD_##name,
  CMP_FIELD_LIST(X)
#undef X
      CMP_FIELDS
};
struct cmp_field_about {
  const char *name, *stored;
  bool vector;
  const char *head, *label;
};
extern const struct cmp_field_about cmp_fields[CMP_FIELDS];

struct cmp_cloud {
  size_t n;        /* 0: there are none then, or none that fill the water (boundary nodes do not) */
  double low, top; /* what all but one in a hundred are above, and below */
  double spacing;  /* H */
};

/* Of run r at every comparison time, for which its file is opened once; `figure` [n_times] are the
 * indices in `f` of those that they belong to, SIZE_MAX for none. Fills cloud [n_times]. */
enum status cmp_clouds_write(const struct comparison *c, size_t r, enum cmp_field field,
                             struct cmp_figures *f, const size_t *figure, struct cmp_cloud *cloud);

/* The same for n of these times without writing anything; fills cloud [n]. */
enum status cmp_clouds_look(const struct comparison *c, size_t r, enum cmp_field field, size_t n,
                            const size_t *time, struct cmp_cloud *cloud);

/* The output of points at t, SIZE_MAX for none. */
size_t cmp_cloud_output(const struct comparison *c, const struct result_file *f, double t);

/* Whether the points of a file have a field of that name, scalar or vector. */
bool cmp_cloud_has_field(const struct result_file *f, const char *name);

/* Of n points that fill the water, particles of the run's spacing or others that say which volume
 * they stand for: their spacing, m; 0 of boundary nodes. */
double cmp_cloud_spacing(const struct result_file *f, size_t n);
