#include "common/result/record.h"

#include <math.h>

enum status record_row(struct result *w, const struct case_file *c, const struct record *r) {
  double t = r->step.time, value;
  TRY(result_energy(w, &r->energy));
  TRY(result_step(w, &r->step));
  for (size_t k = 0; k < c->n_probes; k++) {
    TRY(r->pressure(r->solver, &c->probes[k], &value));
    TRY(result_probe(w, k, t, value));
  }
  for (size_t k = 0; k < c->n_gauges; k++) {
    TRY(r->elevation(r->solver, &c->gauges[k], &value));
    TRY(result_gauge(w, k, t, value));
  }
  for (size_t k = 0; r->point && k < c->n_points; k++) {
    double at[CASE_POINT_FIELDS];
    if (c->points[k].follow) continue; /* there are no particles */
    TRY(r->point(r->solver, &c->points[k], at));
    TRY(result_point(w, k, t, at));
  }
  return OK;
}

/* Unit vector along the wall nearest to a probe: exactly along an axis in a rectangular tank. */
static void sensor_direction(const struct case_file *c, const struct case_probe *probe,
                             double along[2]) {
  const double at[2] = {probe->x, probe->y}, near = 1e-6 * (c->tank.max[0] - c->tank.min[0]);
  const bool upright = fabs(at[0] - c->tank.min[0]) < near || fabs(at[0] - c->tank.max[0]) < near;
  double least = INFINITY;
  along[0] = !upright;
  along[1] = upright;
  if (c->rectangular) return;
  for (size_t k = 0; k < c->walls.pieces; k++)
    for (size_t i = 0; i < geo_piece_segments(&c->walls, k); i++) {
      const double *a = c->walls.p[c->walls.first[k] + i], *b = geo_segment_end(&c->walls, k, i);
      double foot[2];
      geo_segment_foot(a, b, at, foot);
      const double way = hypot(foot[0] - at[0], foot[1] - at[1]),
                   l = hypot(b[0] - a[0], b[1] - a[1]);
      if (way >= least) continue;
      least = way;
      along[0] = (b[0] - a[0]) / l;
      along[1] = (b[1] - a[1]) / l;
    }
}

size_t record_sensor(const struct case_file *c, const struct case_probe *probe,
                     double p[RECORD_PARTS][2]) {
  double along[2];
  sensor_direction(c, probe, along);
  size_t parts = probe->size > 0 ? RECORD_PARTS : 1;
  for (size_t i = 0; i < parts; i++) {
    double part = ((double)i + 0.5) / (double)parts - 0.5;
    p[i][0] = probe->x + probe->size * along[0] * part;
    p[i][1] = probe->y + probe->size * along[1] * part;
  }
  return parts;
}
