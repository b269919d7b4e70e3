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
  return OK;
}

size_t record_sensor(const struct case_file *c, const struct case_probe *probe,
                     double p[RECORD_PARTS][2]) {
  double near = 1e-6 * (c->tank.max[0] - c->tank.min[0]);
  bool upright = fabs(probe->x - c->tank.min[0]) < near || fabs(probe->x - c->tank.max[0]) < near;
  size_t parts = probe->size > 0 ? RECORD_PARTS : 1;
  for (size_t i = 0; i < parts; i++) {
    double s = probe->size * (((double)i + 0.5) / (double)parts - 0.5);
    p[i][0] = upright ? probe->x : probe->x + s;
    p[i][1] = upright ? probe->y + s : probe->y;
  }
  return parts;
}
