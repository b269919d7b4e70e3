/* The free surface and the water below it at one instant, ready to be measured against another,
 * through the reentrant C interface of GEOS. Lengths in m, areas in m^2. */
#pragma once
#include "common/base/geometry.h"
#include "compare/value.h"

/* Pieces shorter than this fraction of the longest one are spray and bubbles: they count in the
 * Hausdorff distance and in the area, not in the mean, largest and Frechet distances. */
#define CMP_MAIN_FRACTION 0.1

struct cmp_geos;                        /* one a thread */
struct cmp_geos *cmp_geos_create(void); /* NULL: no memory */
void cmp_geos_destroy(struct cmp_geos *g);

struct cmp_outline;

/* `window` is the part that is compared; `spacing` the distance between sample points (m). The mean
 * and largest distances are taken from points at least `film` (m) away from every wall. */
enum status cmp_outline_create(struct cmp_geos *g, const struct geo_lines *surface,
                               const struct geo_lines *walls, const struct geo_box *window,
                               double spacing, double film, struct cmp_outline **out);
void cmp_outline_destroy(struct cmp_outline *o);

double cmp_outline_length(const struct cmp_outline *o);   /* of the main surface in the window */
double cmp_outline_enclosed(const struct cmp_outline *o); /* water in the whole tank, m^2 */

struct cmp_distance {
  double mean, largest; /* of both directions: mean of the two means, larger of the two */
  double at[2];         /* where the largest is found, on the surface it was measured from */
};

/* Each returns ERR_SOLVER only when GEOS itself fails; what cannot be measured is a cmp_value with
 * a reason. Symmetric in a and b. */
enum status cmp_outline_distance(const struct cmp_outline *a, const struct cmp_outline *b,
                                 struct cmp_distance *d, struct cmp_value *mean,
                                 struct cmp_value *largest);
enum status cmp_outline_hausdorff(const struct cmp_outline *a, const struct cmp_outline *b,
                                  struct cmp_value *v);
/* Discrete Frechet distance of the longest connected parts in the window, points every `spacing`;
 * closed ones may begin anywhere. */
enum status cmp_outline_frechet(const struct cmp_outline *a, const struct cmp_outline *b,
                                struct cmp_value *v);
/* Area of water that is in one and not in the other, within the window. */
enum status cmp_outline_area(const struct cmp_outline *a, const struct cmp_outline *b,
                             struct cmp_value *v);
