/* The measures that a case's tolerances may name, in the order of report.json. One is a function
 * cmp_measure_NAME (compare/measures/look.h) in a file of this folder, and a line here:
 * X(name, units, when, noise, section, of, help).
 * when: ONCE over the whole run, AT every comparison time, or ALWAYS: there and at every output
 * that the run has in common with the reference (against_time in report.json; a panel of the chart
 * of distances when it is of that section). noise: its floor, half a particle spacing (LENGTH,
 * AREA) or the error bars of both instants. section: the one of the report that has a row for it;
 * CHECKS where the numbers are shown sensor by sensor. of: a DIFFERENCE from the reference; a
 * DEFECT of the run, which is 0 when all is right; something of its OWN; a difference from what was
 * MEASURED. */
#pragma once

#define CMP_MEASURES(X)                                                                            \
  X(mean_distance, "H", ALWAYS, LENGTH, DISTANCE, DIFFERENCE,                                      \
    "mean distance between the main surfaces away from walls, average of both directions")         \
  X(relative_distance, "1", AT, NONE, DISTANCE, DIFFERENCE,                                        \
    "mean distance over the largest that the reference's surface moves by, on average")            \
  X(largest_distance, "H", ALWAYS, LENGTH, DISTANCE, DIFFERENCE,                                   \
    "largest distance between the main surfaces away from walls, either direction")                \
  X(hausdorff, "H", AT, LENGTH, DISTANCE, DIFFERENCE,                                              \
    "Hausdorff distance of all pieces, spray and bubbles included")                                \
  X(frechet, "H", AT, LENGTH, DISTANCE, DIFFERENCE,                                                \
    "discrete Frechet distance of the longest pieces: respects the order along the surface")       \
  X(area, "H^2", ALWAYS, AREA, DISTANCE, DIFFERENCE,                                               \
    "area that is water in one and air in the other")                                              \
  X(front, "H", ONCE, LENGTH, FRONT, DIFFERENCE,                                                   \
    "largest difference of front position until the reference reaches the wall it runs to")        \
  X(jet_tip, "H", AT, LENGTH, JET, DIFFERENCE, "distance between the tips of the plunging jets")   \
  X(jet_direction, "degrees", AT, NONE, JET, DIFFERENCE,                                           \
    "angle between the directions of the plunging jets")                                           \
  X(jet_thickness, "H", AT, LENGTH, JET, DIFFERENCE,                                               \
    "largest difference of jet thickness at 0.05, 0.1 and 0.2 H behind the tip")                   \
  X(jet_cavity, "H^2", AT, NONE, JET, DIFFERENCE, "difference of the area of air under the jet")   \
  X(overturning_time, "sqrt(H/g)", ONCE, OVERTURNING, JET, DIFFERENCE,                             \
    "difference of the instant of the first vertical tangent")                                     \
  X(touchdown_time, "sqrt(H/g)", ONCE, TOUCHDOWN, JET, DIFFERENCE,                                 \
    "difference of the instant at which the jet reaches the water below")                          \
  X(kinetic, "E0", AT, NONE, ENERGY, DIFFERENCE, "difference of kinetic energy")                   \
  X(potential, "E0", AT, NONE, ENERGY, DIFFERENCE, "difference of potential energy")               \
  X(mechanical, "E0", AT, NONE, ENERGY, DIFFERENCE, "difference of kinetic + potential energy")    \
  X(decay, "E0", AT, NONE, ENERGY, OWN,                                                            \
    "kinetic + potential energy lost since the start but for what a tank or sides that move gave " \
    "or "                                                                                          \
    "took (not a difference)")                                                                     \
  X(budget, "E0", ONCE, NONE, ENERGY, DEFECT,                                                      \
    "largest error of closure of the run's energy budget")                                         \
  X(budget_before_impact, "E0", ONCE, NONE, ENERGY, DEFECT,                                        \
    "the same until the reference reaches the wall")                                               \
  X(volume, "1", ONCE, NONE, ENERGY, DEFECT, "largest relative change of the run's volume")        \
  X(probe_rms, "rho g H", ONCE, NONE, CHECKS, DIFFERENCE,                                          \
    "rms difference of pressure, worst probe")                                                     \
  X(probe_peak, "rho g H", ONCE, NONE, CHECKS, DIFFERENCE,                                         \
    "difference of peak pressure, worst probe")                                                    \
  X(probe_peak_time, "sqrt(H/g)", ONCE, NONE, CHECKS, DIFFERENCE,                                  \
    "difference of the time of the peak, worst probe")                                             \
  X(probe_onset, "sqrt(H/g)", ONCE, NONE, CHECKS, DIFFERENCE,                                      \
    "difference of the time at which pressure first reaches 0.05 rho g H, worst probe")            \
  X(probe_impulse, "rho g H sqrt(H/g)", ONCE, NONE, CHECKS, DIFFERENCE,                            \
    "difference of the time integral of pressure, worst probe")                                    \
  X(probe_shift, "sqrt(H/g)", ONCE, NONE, CHECKS, DIFFERENCE,                                      \
    "time shift that would bring pressures closest (never applied), worst probe")                  \
  X(gauge_rms, "H", ONCE, NONE, CHECKS, DIFFERENCE, "rms difference of water height, worst gauge") \
  X(experiment_probe_rms, "rho g H", ONCE, NONE, CHECKS, MEASURED,                                 \
    "rms difference from measured pressures, worst experiment")                                    \
  X(experiment_gauge_rms, "H", ONCE, NONE, CHECKS, MEASURED,                                       \
    "rms difference from measured water heights or fronts, worst experiment")                      \
  X(profile_distance, "H", AT, LENGTH, CHECKS, MEASURED,                                           \
    "mean distance of the measured surface's points from the run's surface, worst profile")

enum {
#define X(name, units, when, noise, section, of, help) CMP_MEASURE_##name,
  CMP_MEASURES(X)
#undef X
      CMP_N_MEASURES
};
