/* Error bars: what a run writes, held against a coarser run of the same case. By Richardson's
 * extrapolation the standard error of a value that the spacing's power `order` takes away is what
 * the two runs differ by, over ratio^order - 1. NaN where the coarser run has no such value.
 * Internal. */
#pragma once
#include <hdf5.h>

#include "common/result/result_column.h"
#include "common/result/result_twin.h"

struct result_errors;

/* Makes /errors. The twin must outlive *out. */
enum status result_errors_create(hid_t file, struct hdf_columns *all,
                                 const struct result_about *about, struct result_twin *twin,
                                 const struct result_coarser *how, struct result_errors **out);
void result_errors_destroy(struct result_errors *e); /* NULL is fine */

/* Rows as they were written. */
enum status result_errors_energy(struct result_errors *e, const double *row);
enum status result_errors_probe(struct result_errors *e, size_t probe, const double row[2]);
enum status result_errors_gauge(struct result_errors *e, size_t gauge, const double row[2]);
enum status result_errors_surface(struct result_errors *e, double time,
                                  const struct geo_lines *surface);

/* Of an event that was put into `group`. at: time, x, y. */
enum status result_errors_event(struct result_errors *e, hid_t group, const char *name,
                                const double at[3]);
