#include "bem/run/budget.h"

#include <math.h>

/* Of the first energy, that of the water at rest with it: no run that gets on comes near it, and
 * one in deep water is far gone before it does. */
static const double LOST = 0.1;

void bem_budget_damped(struct bem_budget *b, const struct bem_flow *f, double time, double dt) {
  double start = time - dt,
         loss = -bem_surface_power(&f->surface, f->level, f->psi, f->u, f->v,
                                   (struct bem_spinning){f->motion.turn, f->motion.origin},
                                   f->damping);
  b->damped.until += b->damped.rate * (start - b->damped.start);
  b->damped.rate = b->damped.changed ? loss : 0.5 * (b->damped.last + loss);
  b->damped.changed = false;
  b->damped.last = loss;
  b->damped.start = start;
}

static double damped_until(const struct bem_budget *b, double time) {
  return b->damped.until + b->damped.rate * (time - b->damped.start);
}

/* Until a part of the last step: the integral of the line through the powers at its two points. */
static double given_until(const struct bem_budget *b, int by, double time) {
  const double dt = b->given.dt, part = dt > 0 ? (time - b->given.start) / dt : 0;
  const double *power = b->given.power[by],
               slope = (power[1] - power[0]) / (BEM_GAUSS[1] - BEM_GAUSS[0]);
  return b->given.until[by] + dt * part * (power[0] + slope * (part / 2 - BEM_GAUSS[0]));
}

void bem_budget_given(struct bem_budget *b, double time, double dt) {
  for (int by = 0; by < 2; by++) b->given.until[by] = given_until(b, by, time - dt);
  for (int by = 0; by < 2; by++) b->given.power[by][0] = b->given.power[by][1];
  b->given.start = time - dt;
  b->given.dt = dt;
}

void bem_budget_cut(struct bem_budget *b, double volume, double energy) {
  b->damped.changed = true;
  b->removed_volume += volume;
  b->removed_energy += energy;
}

double bem_budget_whole(const struct bem_budget *b, const struct bem_flow *f, double time) {
  const struct bem_totals t = bem_surface_totals(&f->surface, f->psi);
  return t.kinetic + t.potential + damped_until(b, time) + given_until(b, 0, time) +
         given_until(b, 1, time) + b->removed_energy;
}

bool bem_budget_is_lost(const struct bem_budget *b, double whole) {
  return fabs(whole - b->first_energy) > LOST * fabs(b->first_energy);
}

struct result_energy bem_budget_row(struct bem_budget *b, const struct case_file *c, double seconds,
                                    const struct bem_totals *t) {
  const double time = seconds / sqrt(c->H / c->gravity), damped = damped_until(b, time),
               frame = given_until(b, 0, time), sides = given_until(b, 1, time);
  double energy = t->kinetic + t->potential + damped + frame + sides + b->removed_energy;
  if (seconds == 0) b->first_energy = energy;
  b->drift = isfinite(b->first_energy) && b->first_energy != 0 ? energy / b->first_energy - 1 : 0;
  double joule = c->density * c->gravity * c->H * c->H * c->H;
  double lift = c->density * c->gravity * c->H * c->H *
                c->tank.min[1]; /* of the bed above y = 0, by volume */
  struct result_energy e = {.time = seconds,
                            .kinetic = joule * t->kinetic,
                            .potential = joule * t->potential + lift * t->volume,
                            .term = {joule * damped, joule * frame, joule * sides},
                            .removed = joule * b->removed_energy + lift * b->removed_volume};
  e.total = e.kinetic + e.potential;
  return e;
}
