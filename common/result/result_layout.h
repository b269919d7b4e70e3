/* Names and units that writer, reader, diff and the documentation of the result file share. */
#pragma once
#include "common/result/result.h"

#define RESULT_FORMAT         "plunge"
#define RESULT_FORMAT_VERSION 1

/* The columns of /series/run, in the order of struct result_step. */
#define RESULT_STEP(X)                                                                             \
  X(time, "s", "physical time")                                                                    \
  X(dt, "s", "time step")                                                                          \
  X(evaluations, "1", "evaluations of the right-hand side so far")                                 \
  X(wall_time, "s", "clock on the wall since the run began")                                       \
  X(volume, "m^2", "volume of the water per metre of width")                                       \
  X(removed_volume, "m^2", "volume of the water taken out of the computation so far")

/* Both structs are rows of doubles: `time` first, then their columns; of energies the terms last.
 */
enum {
  RESULT_ENERGY_COLUMNS = offsetof(struct result_energy, term) / sizeof(double),
  RESULT_STEP_COLUMNS = sizeof(struct result_step) / sizeof(double)
};

struct result_column {
  const char *name, *units, *help;
};
extern const struct result_column result_energy_columns[RESULT_ENERGY_COLUMNS];
extern const struct result_column result_step_columns[RESULT_STEP_COLUMNS];

/* The columns of /series/points/NAME: the time, then CASE_POINT. */
extern const struct result_column result_point_columns[1 + CASE_POINT_FIELDS];

/* The numbers among the root's attributes: offsets in struct result_file. */
struct result_scale {
  const char *name, *units, *help;
  size_t offset;
  bool any; /* zero and below, too */
};
enum { RESULT_SCALES = 5 };
extern const struct result_scale result_scales[RESULT_SCALES];
