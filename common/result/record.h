/* The one loop over what is recorded at an instant: a row of energies and of /series/run, one of
 * every probe, gauge and point of the case. A solver only measures. */
#pragma once
#include "common/case/case.h"
#include "common/result/result.h"

struct record {
  struct result_energy energy; /* their times are the row's */
  struct result_step step;
  void *solver; /* handed to: */
  enum status (*pressure)(void *solver, const struct case_probe *probe, double *pressure); /* Pa */
  enum status (*elevation)(void *solver, const struct case_gauge *gauge,
                           double *elevation); /* m; NaN where dry */
  enum status (*point)(void *solver, const struct case_point *point,
                       double value[CASE_POINT_FIELDS]); /* NULL: no rows of points here */
};

enum status record_row(struct result *w, const struct case_file *c, const struct record *r);

/* The points at which a sensor's pressure is taken, evenly spread along its wall (upright at the
 * sides of the tank, else level), each standing for an equal part. One point when it has no size.
 */
enum { RECORD_PARTS = 16 };
size_t record_sensor(const struct case_file *c, const struct case_probe *probe,
                     double p[RECORD_PARTS][2]);
