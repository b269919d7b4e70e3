/* Distances between the free surfaces. */
#include "compare/measures/look.h"
#include "compare/profiles.h"

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

/* The worst over those of the profiles of this time that can be measured. */
struct cmp_value cmp_measure_profile_distance(struct cmp_look *l) {
  const struct comparison *c = l->c;
  const struct result_file *f = c->ref.data.file;
  struct cmp_value worst = cmp_unknown("no surface measured at this time");
  const size_t time = (size_t)(l->at - l->run->at);
  l->absent = f->n_profiles > 0;
  for (size_t k = 0; k < f->n_profiles; k++) {
    if (!cmp_profile_is_at(c, k, time)) continue;
    const struct cmp_value v = cmp_profile_distance(c, l->run, k, time);
    l->absent = false;
    l->left_out += !cmp_known(&v);
    if (cmp_known(&worst) && !(v.value > worst.value)) continue;
    worst = v;
    snprintf(l->detail, l->detail_room, "%.60s", f->profiles[k].label);
  }
  return worst;
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
