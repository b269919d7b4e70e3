/* The measures that a case's tolerances may name, their values, and the verdict. */
#pragma once
#include "common/solver.h"
#include "compare/comparison.h"

/* X(name, units, when, noise, help): `when` AT is measured at every comparison time, ONCE over the
 * whole run; `noise` names what its noise floor is: of half a particle spacing (LENGTH, AREA), or
 * the error bars of both instants. */
#define CMP_MEASURES(X)                                                                            \
  X(mean_distance, "H", AT, LENGTH,                                                                \
    "mean distance between the main surfaces away from walls, average of both directions")         \
  X(largest_distance, "H", AT, LENGTH,                                                             \
    "largest distance between the main surfaces away from walls, either direction")                \
  X(relative_distance, "1", AT, NONE,                                                              \
    "mean distance over the largest that the reference's surface moves by, on average")            \
  X(hausdorff, "H", AT, LENGTH, "Hausdorff distance of all pieces, spray and bubbles included")    \
  X(frechet, "H", AT, LENGTH,                                                                      \
    "discrete Frechet distance of the longest pieces: respects the order along the surface")       \
  X(area, "H^2", AT, AREA, "area that is water in one and air in the other")                       \
  X(front, "H", ONCE, LENGTH,                                                                      \
    "largest difference of front position until the reference reaches the wall it runs to")        \
  X(jet_tip, "H", AT, LENGTH, "distance between the tips of the plunging jets")                    \
  X(jet_direction, "degrees", AT, NONE, "angle between the directions of the plunging jets")       \
  X(jet_thickness, "H", AT, LENGTH,                                                                \
    "largest difference of jet thickness at 0.05, 0.1 and 0.2 H behind the tip")                   \
  X(jet_cavity, "H^2", AT, NONE, "difference of the area of air under the jet")                    \
  X(overturning_time, "sqrt(H/g)", ONCE, OVERTURNING,                                              \
    "difference of the instant of the first vertical tangent")                                     \
  X(touchdown_time, "sqrt(H/g)", ONCE, TOUCHDOWN,                                                  \
    "difference of the instant at which the jet reaches the water below")                          \
  X(kinetic, "E0", AT, NONE, "difference of kinetic energy")                                       \
  X(potential, "E0", AT, NONE, "difference of potential energy")                                   \
  X(mechanical, "E0", AT, NONE, "difference of kinetic + potential energy")                        \
  X(decay, "E0", AT, NONE, "kinetic + potential energy lost since the start (not a difference)")   \
  X(budget, "E0", ONCE, NONE, "largest error of closure of the run's energy budget")               \
  X(budget_before_impact, "E0", ONCE, NONE, "the same until the reference reaches the wall")       \
  X(volume, "1", ONCE, NONE, "largest relative change of the run's volume")                        \
  X(probe_rms, "rho g H", ONCE, NONE, "rms difference of pressure, worst probe")                   \
  X(probe_peak, "rho g H", ONCE, NONE, "difference of peak pressure, worst probe")                 \
  X(probe_peak_time, "sqrt(H/g)", ONCE, NONE, "difference of the time of the peak, worst probe")   \
  X(probe_onset, "sqrt(H/g)", ONCE, NONE,                                                          \
    "difference of the time at which pressure first reaches 0.05 rho g H, worst probe")            \
  X(probe_impulse, "rho g H sqrt(H/g)", ONCE, NONE,                                                \
    "difference of the time integral of pressure, worst probe")                                    \
  X(probe_shift, "sqrt(H/g)", ONCE, NONE,                                                          \
    "time shift that would bring pressures closest (never applied), worst probe")                  \
  X(gauge_rms, "H", ONCE, NONE, "rms difference of water height, worst gauge")                     \
  X(experiment_probe_rms, "rho g H", ONCE, NONE,                                                   \
    "rms difference from measured pressures, worst experiment")                                    \
  X(experiment_gauge_rms, "H", ONCE, NONE,                                                         \
    "rms difference from measured water heights or fronts, worst experiment")

#define X(name, units, when, noise, help) +1
enum { CMP_N_MEASURES = 0 CMP_MEASURES(X) };
#undef X
extern const struct measure cmp_measures[CMP_N_MEASURES];

enum cmp_outcome { CMP_NO_LIMIT, CMP_PASS, CMP_FAIL };

struct cmp_row {
  const struct measure *measure;
  size_t run;  /* index in comparison.run */
  size_t time; /* index in comparison.times; SIZE_MAX: over the whole run */
  struct cmp_value value;
  char detail[192];         /* where the worst value was found, and without what, or "" */
  size_t left_out;          /* sensors that have no such number, where others have */
  double noise;             /* noise floor in the measure's units; NaN: none */
  double limit;             /* the strictest tolerance that applies; NaN: none */
  enum cmp_outcome outcome; /* a value that is not available fails where there is a limit */
};

struct cmp_rows {
  size_t n, passed, failed;
  size_t partial;      /* of those passed: without every sensor */
  struct cmp_row *row; /* by measure, run and time */
  size_t first[CMP_N_MEASURES + 1], n_times;
  size_t unused; /* tolerances that applied to nothing that was compared */
};

enum status cmp_rows_create(const struct comparison *c, struct cmp_rows *rows);
void cmp_rows_destroy(struct cmp_rows *rows);
const struct cmp_row *cmp_rows_find(const struct cmp_rows *rows, const char *measure, size_t run,
                                    size_t time); /* NULL: none */
