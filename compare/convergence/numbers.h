/* What a row of a group can be of: a name, and a value of each run, at a time or of the whole run.
 */
#pragma once
#include "compare/convergence/convergence.h"

/* Numbers of a run itself at a comparison time. X(name, units, section, help) */
#define CMP_INSTANT_NUMBERS(X)                                                                     \
  X(kinetic_energy, "E0", ENERGY, "kinetic energy")                                                \
  X(potential_energy, "E0", ENERGY, "potential energy above the water at rest")                    \
  X(mechanical_energy, "E0", ENERGY, "kinetic + potential + removed energy")                       \
  X(front_position, "H", FRONT, "where the front is, before it reaches the wall")                  \
  X(jet_tip_x, "H", JET, "place of the tip of the plunging jet")                                   \
  X(jet_tip_y, "H", JET, "height of the tip of the plunging jet")                                  \
  X(jet_overhang, "H", JET, "how far the jet overhangs")                                           \
  X(jet_cavity_area, "H^2", JET, "air under the jet")

struct cmp_number {
  const char *name, *units;
  enum cmp_section section;
  struct cmp_value (*value)(const struct comparison *c, size_t member, size_t time);
};
enum {
#define X(name, units, section, help) CMP_NUMBER_##name,
  CMP_INSTANT_NUMBERS(X)
#undef X
      CMP_N_NUMBERS
};
extern const struct cmp_number cmp_numbers[CMP_N_NUMBERS];

/* Time, x or y of the first event of that kind. */
struct cmp_value cmp_event_number(const struct comparison *c, size_t member, int event, int part);

/* How far an instant may be off that was read off surfaces, or by the standard error that a solver
 * states; of a measure that is a difference of instants, of the run's own. 0 of all else. */
double cmp_event_known_to(const struct comparison *c, size_t member, int event, int part);
double cmp_measure_known_to(const struct comparison *c, size_t member, size_t measure);
