/* What a run writes: particles and surfaces at the multiples of time.every, series after each
 * multiple of time.sample, events. */
#pragma once
#include "common/case/case.h"
#include "common/result/result.h"
#include "sph/sph.h"

struct sph_output;

enum status sph_output_create(const struct case_file *c, const struct sph *s, struct result *result,
                              struct sph_output **out);
void sph_output_destroy(struct sph_output *o);

/* After every step (and at t = 0): whatever is due at s->t. Outputs with accelerations wait for the
 * rates. */
enum status sph_output_step(struct sph_output *o, struct sph *s, double dt);

/* After the evaluation that a step begins with: the points whose turn it is, the diagnostics of a
 * sample that has been taken, and an output with the accelerations in it. */
enum status sph_output_rates(struct sph_output *o, struct sph *s);

/* At the end of the run: the rates of the last state, where its output waits for them. */
enum status sph_output_finish(struct sph_output *o, struct sph *s);

/* The next multiple of time.every, or the end (s): steps must end on it. */
double sph_output_next(const struct sph_output *o);

/* Particles and surface now, due or not: for a run that ends early. Accelerations are NaN. */
enum status sph_output_last(struct sph_output *o, struct sph *s);

/* Loss or gain of the whole budget since t = 0, relative to the mechanical energy above rest; of
 * water that starts at rest, to the budget itself. */
double sph_output_drift(const struct sph_output *o);
