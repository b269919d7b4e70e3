#include "sph/phase.h"

#include "common/base/progress.h"
#include "sph/sph.h"

enum sph_phase sph_enter(struct sph *s, enum sph_phase phase) {
  struct sph_clock *c = &s->clock;
  const enum sph_phase was = c->in;
  const double now = progress_wall_clock();
  if (c->since > 0) c->seconds[was] += now - c->since;
  c->since = now;
  c->in = phase;
  return was;
}
