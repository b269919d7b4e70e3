/* Where the energy has gone: what filter and smoothing took, what the water gave to a tank and to
 * sides that move, and what was cut away. rho g H^3, H^2 and sqrt(H/g). */
#pragma once
#include "bem/water/flow.h"
#include "common/result/result.h"

struct bem_budget {
  double removed_volume, removed_energy;
  struct {             /* energy taken out by filter and smoothing */
    double start;      /* of the last step */
    double until;      /* what it was until then */
    double rate, last; /* mean during the step; at its end */
    bool changed;      /* the water, since: `last` is of another shape */
  } damped;
  struct {              /* energy given to the moving tank, and to sides that move */
    double start, dt;   /* of the last step */
    double until[2];    /* what it was at its start */
    double power[2][2]; /* at its two points of Gauss's formula */
  } given;
  double drift; /* of the energy, relative to the initial one */
  double first_energy; /* NaN where the first row was left out, as that of water that touches */
};

/* Counts what filter and smoothing take during the step that ended at `time`. */
void bem_budget_damped(struct bem_budget *b, const struct bem_flow *f, double time, double dt);

/* Of a step: the two points of Gauss's formula. */
static const double BEM_GAUSS[2] = {0.21132486540518713, 0.78867513459481287};

/* A step that ended at `time` was made, in which the water gives powers as in the last one until
 * they are set, at the two points. */
void bem_budget_given(struct bem_budget *b, double time, double dt);

/* The water has lost so much to a cut, and has another shape from now on. */
void bem_budget_cut(struct bem_budget *b, double volume, double energy);

/* The energy and all that was taken out of it until the end of the last step, with psi of it. */
double bem_budget_whole(const struct bem_budget *b, const struct bem_flow *f, double time);

/* Whether that is off by so much that the flow is none any more: psi has been wrong, as where a
 * sheet that the panels do not resolve has crossed itself. */
bool bem_budget_is_lost(const struct bem_budget *b, double whole);

/* A row of the series, J/m, at a time of the last step. */
struct result_energy bem_budget_row(struct bem_budget *b, const struct case_file *c, double seconds,
                                    const struct bem_totals *t);
