#include "sph/fluid/force.h"

#include <math.h>

#include "common/case/case.h"
#include "sph/sph.h"

void sph_force_create(struct sph *s, const struct case_file *c) {
  struct sph_force *f = &s->force;
  *f = (struct sph_force){.up = {0, 1}, .n = c->n_motions, .motion = c->motions};
  for (int d = 0; d < 2; d++) {
    f->g[d] = c->gravity * c->down[d];
    if (c->gravity > 0) f->up[d] = -c->down[d];
  }
  for (size_t k = 0; k < f->n; k++) f->shakes |= !tank_motion_is_of_side(&f->motion[k]);
  sph_force_set(s, 0);
}

void sph_force_set(struct sph *s, double t) {
  struct sph_force *f = &s->force;
  const double left = s->g > 0 ? eos_gravity(&s->eos) / s->g : 1; /* of gravity, to drive */
  struct tank_frame frame = {0};
  if (f->shakes) tank_frame_at(f->motion, f->n, t, &frame);
  const double c = cos(frame.angle), o = sin(frame.angle);
  const double x = f->g[0] - frame.acceleration[0], y = f->g[1] - frame.acceleration[1];
  f->excess[0] = f->shakes ? c * x + o * y - f->g[0] : 0;
  f->excess[1] = f->shakes ? c * y - o * x - f->g[1] : 0;
  f->turning = frame.turning;
  f->rate = frame.rate;
  for (int d = 0; d < 2; d++) f->drive[d] = left * f->g[d] + f->excess[d];
}
