/* The health of a run: whether its numbers can be believed at all, judged by what it wrote about
 * itself. A run may end without an error and still be nonsense. */
#pragma once
#include <math.h>
#include <stdbool.h>

#include "common/result/result.h"

enum health_verdict { HEALTH_SOUND, HEALTH_DOUBTFUL, HEALTH_FAILED };
extern const char *const health_verdicts[]; /* "sound", ... */

/* X(name, doubtful, failed, percent, label, before, after, why): the value makes a run doubtful, or
 * fail, above its limits; `label` with the number is a fact, `before` number `after` a reason.
 *
 * Energies are relative to E0 (health_energy_scale), volumes to that at t = 0. The limits:
 * - A weakly compressible fluid stands for water while v << c0. Its density then changes by about
 *   (v/c0)^2/2 in a smooth flow and by v/c0 in an impact: c0 = 10 v for a change of a hundredth
 *   (Monaghan, J. Comput. Phys. 110, 1994) is meant for the flow as a whole. These facts are of the
 *   one worst particle at any step, in spray too: three times that speed; and no fluid flies faster
 *   than its own sound. A density off by a tenth is what an impact at that v leaves; it is a
 * pressure of 40 rho g H at the usual c0, which is noise wherever nothing strikes.
 * - Nothing adds energy or volume to water but what moves its tank, and that, like what leaves, is
 *   booked.
 *   A hundredth is as much as the finest differences that a report speaks of; with a tenth of the
 *   energy or the volume unaccounted for, nothing else is right.
 * - Water over the top of a wall is physics, but no reference has the same water afterwards. Water
 *   that leaves through a wall is an error, however little; BEM cuts films and jets away that it
 *   cannot follow, a hundredth in a dam break.
 * - Steps are cut for a particle in trouble: a matter of a few, never of one in twenty. */
#define HEALTH_MEASURES(X)                                                                         \
  X(mach, 0.3, 1, false, "Mach", "speeds reach", " of the speed of sound",                         \
    "largest speed of a particle over the speed of sound, at any step")                            \
  X(density_change, 0.1, 0.5, true, "density", "the density changes by", " %",                     \
    "largest change of density of a particle, at any step")                                        \
  X(energy_gained, 0.01, 0.1, false, "energy gained", "energy rises by", " E0",                    \
    "largest rise of kinetic + potential + elastic + removed energy above its first value, less "  \
    "what was given from outside")                                                                 \
  X(budget, 0.01, 0.1, false, "budget", "the budget of energy is off by", " E0",                   \
    "largest error of closure of the energy budget")                                               \
  X(volume_change, 0.01, 0.1, true, "volume", "the volume changes by", " %",                       \
    "largest change of volume, what was removed added back")                                       \
  X(spilled, 0.001, HEALTH_NO_LIMIT, true, "spilled", "over the walls spilled", " % of the water", \
    "water that left over the top of a wall")                                                      \
  X(lost, 1e-9, 0.01, true, "lost", "through the walls went", " % of the water",                   \
    "water that left in any other way than over a wall")                                           \
  X(cut_away, 0.05, 0.25, true, "cut away", "the solver cut away", " % of the water",              \
    "water taken out of the computation, neither spilled nor lost")                                \
  X(steps_cut, 0.05, HEALTH_NO_LIMIT, true, "steps cut", "cut short were", " % of the time steps", \
    "time steps that something in trouble made far shorter than others")                           \
  X(theory_error, 0.02, 0.5, true, "theory", "the theory leaves out", " % of the wave",            \
    "estimate of what the theory leaves out, relative to the wave")

#define HEALTH_NO_LIMIT INFINITY

enum health_index {
#define X(name, ...) HEALTH_##name,
  HEALTH_MEASURES(X)
#undef X
      HEALTH_N
};

struct health_measure {
  const char *name;
  double doubtful, failed; /* limits: above them */
  bool percent;
  const char *label, *before, *after, *help;
};
extern const struct health_measure health_measures[HEALTH_N];

/* J/m: the run's mechanical energy above rest at first; where it starts at rest, and so has none
 * to divide by, rho g H^3 = `column`. `first` may be NULL: nothing is known. */
double health_energy_scale(const struct result_energy *first, double rest, double column,
                           bool *at_rest);

/* What is gathered from a run as it writes its rows, or afterwards from its file. */
struct health_watch {
  double rest, column; /* J/m */
  struct result_energy first;
  bool outside[RESULT_TERMS];            /* the terms by which a tank that moves gives and takes */
  double gained, worst_budget, elastic;  /* largest so far, J/m */
  double volume, volume_change, removed; /* at first, and the largest so far, m^2 */
  size_t n_energy, n_steps;
  bool numbers;                                                       /* all of them are finite */
  double mach, lightest, heaviest, spilled, lost, cut, steps, theory; /* NaN: not told */
};
void health_watch_begin(struct health_watch *w, double rest, double column);
void health_watch_energy(struct health_watch *w, const struct result_energy *row);
void health_watch_step(struct health_watch *w, const struct result_step *row);
void health_watch_statistic(struct health_watch *w, const char *name, double value);

struct health {
  enum health_verdict verdict;
  double value[HEALTH_N]; /* NaN: not told */
  char facts[256];        /* "Mach 0.12, density 1.1 %, ..." */
  char reasons[1024];     /* why it is not sound, in plain words; "" when it is */
  size_t broke_off;       /* bytes of them that say why it broke off; 0: it did not */
  char missing[256];      /* what could not be judged, "" when all could */
};

/* `broke_off`: why the run failed before its end; "" when it did not. */
void health_judge(const struct health_watch *w, const char *broke_off, struct health *h);

/* The verdict as a word: "not known" where the file tells nothing to judge a sound one by. */
const char *health_word(const struct health *h);

/* The reasons without why it broke off. */
const char *health_other_reasons(const struct health *h);

/* Of a whole file, also of one that an earlier version wrote. */
void health_of_file(const struct result_file *f, struct health *h);

/* The time (s) at which the series of a file first show this verdict or worse; INFINITY: never. */
double health_since(const struct result_file *f, enum health_verdict verdict);
