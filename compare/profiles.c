#include "compare/profiles.h"

#include <math.h>

#include "common/base/geometry_check.h"

bool cmp_profile_is_at(const struct comparison *c, size_t k, size_t time) {
  const double t = c->ref.data.file->profiles[k].time / c->scales.T;
  return fabs(t - c->times[time]) <= 1e-6 * fmax(1, t);
}

struct cmp_value cmp_profile_distance(const struct comparison *c, const struct cmp_run *run,
                                      size_t k, size_t time) {
  const struct case_profile *p = &c->ref.data.file->profiles[k];
  const size_t output = run->at[time].output;
  double sum = 0, nearest[2];
  size_t n = 0, piece;
  if (output == SIZE_MAX) return cmp_unknown("no output at this time");
  const struct geo_lines *surface = &run->data.surface[output];
  for (size_t i = 0; i < p->n; i++) {
    const double x = p->x[i] / c->scales.H, y = p->y[i] / c->scales.H;
    if (!geo_box_contains(&c->window, x, y)) continue;
    sum += geo_lines_distance(surface, x, y, nearest, &piece);
    n++;
  }
  if (!n) return cmp_unknown("none of the profile is in the window");
  return isfinite(sum) ? cmp_number(sum / (double)n) : cmp_unknown("the run has no surface then");
}
