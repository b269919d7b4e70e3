/* Distances between the free surfaces. */
#include "compare/measures/look.h"

struct cmp_value cmp_measure_mean_distance(struct cmp_look *l) {
  return l->at->mean;
}

struct cmp_value cmp_measure_relative_distance(struct cmp_look *l) {
  if (!cmp_known(&l->at->mean)) return l->at->mean;
  if (!cmp_known(&l->c->motion)) return l->c->motion;
  return cmp_number(l->at->mean.value / l->c->motion.value);
}

struct cmp_value cmp_measure_largest_distance(struct cmp_look *l) {
  if (cmp_known(&l->at->largest))
    snprintf(l->detail, l->detail_room, "at x = %.3g, y = %.3g", l->at->where[0], l->at->where[1]);
  return l->at->largest;
}

struct cmp_value cmp_measure_hausdorff(struct cmp_look *l) {
  return l->at->hausdorff;
}

struct cmp_value cmp_measure_frechet(struct cmp_look *l) {
  return l->at->frechet;
}

struct cmp_value cmp_measure_area(struct cmp_look *l) {
  return l->at->area;
}
