/* How fast a run gets on: when it no longer does, and how many of its steps were unusually short.
 */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

struct bem_pace {
  size_t steps, settled, room; /* settled: steps that an integrator long started took */
  double *dt;                  /* of the settled ones, sqrt(H/g), [settled], owned */
  size_t since;                /* steps since the integrator was last started */
  size_t tiny;                 /* steps in a row that lead nowhere */
  double mark;                 /* time at the start of the current stretch, sqrt(H/g) */
  struct {
    bool set;
    double time, energy;
  } watch; /* what the energy was a short time ago */
};

void bem_pace_destroy(struct bem_pace *p);

/* Counts a step to `time`. */
enum status bem_pace_add(struct bem_pace *p, double time, double dt);
void bem_pace_restarted(struct bem_pace *p);

/* Whether so many steps have been made that the end is out of reach. */
bool bem_pace_is_spent(const struct bem_pace *p);

/* Whether the last steps lead nowhere; or that, or so slowly that the end is out of reach. */
bool bem_pace_leads_nowhere(const struct bem_pace *p);
bool bem_pace_is_lost(const struct bem_pace *p, double time);

/* Whether the energy, rho g H^3, has changed in a short time by more than any flow changes its
 * budget: the surface is winding up where it cannot be followed. whole: the energy at the start. */
bool bem_pace_runs_away(struct bem_pace *p, double time, double energy, double whole);

/* Settled steps that were more than ten times shorter than the median of the 15 before them. Where
 * the flow itself becomes fast, as in a jet, or before a contact, they shrink by and by. */
double bem_pace_cut(const struct bem_pace *p);
