/* Reading the series of a result file; and what reading its other tables shares with that.
 * Internal. */
#pragma once
#include <hdf5.h>

#include "common/result/result.h"

/* Times that are finite and do not decrease; ERR_INPUT with `what` they are of. */
enum status result_check_times(const char *what, size_t n, const double *t);

/* The attribute `name` of a group, or what the group is called where it has none. */
enum status result_read_name(hid_t group, const char *link, char **name);

/* Two columns of the same length, the first of times. */
enum status result_read_columns(hid_t group, const char *link, const char *name, size_t *n,
                                double **t, double **value);

/* Reads every member of the group at `path`, where there is one, into one zeroed element of `size`
 * bytes. */
enum status result_read_members(hid_t file, const char *path, size_t size,
                                enum status (*read)(hid_t group, const char *link, void *element),
                                size_t *n, void **array);

/* Probes, gauges, points and diagnostics. */
enum status result_read_series(hid_t file, struct result_file *f);
void result_series_destroy(struct result_file *f);
