/* What the health of a run is judged by: looked at after every step, written when the run ends,
 * however it ends. */
#pragma once
#include "common/result/result.h"
#include "sph/sph.h"

/* Largest values of the state; ERR_DIVERGED, naming the worst particle, for values that are not
 * finite, a density that is not positive, or a speed above c0, of which health.h says that the run
 * has failed. */
enum status sph_watch_state(struct sph *s);

/* Counts a step that was cut; ERR_DIVERGED when steps shrink to nothing. `left` (s): to where the
 * step must end. */
enum status sph_watch_step(struct sph *s, double dt, double left);

/* All statistics of the run so far. */
enum status sph_watch_write(const struct sph *s, struct result *result);
