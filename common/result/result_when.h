/* When and where the rows of a dataset are, by the datasets beside it (in a process that reads
 * HDF5). */
#pragma once
#include <hdf5.h>
#include <stddef.h>

/* The rows of a dataset in parts, each of one time: an output of points or a surface, or a row of a
 * series. */
struct result_when {
  size_t n;
  size_t *first; /* row at which each begins, [n], owned */
  double *time;  /* s, [n], owned */
};

/* Of `rows` rows; n = 0 when they have no times. To be freed in any case. */
void result_when_read(hid_t file, const char *name, size_t rows, struct result_when *w);
void result_when_free(struct result_when *w);

/* The part that a row is in. */
size_t result_when_part(const struct result_when *w, size_t row);
double result_when_at(const struct result_when *w, size_t row); /* s; NaN: it has no time */

/* The point, probe, gauge, event that a row is of, m; NaN what is not known. */
void result_place_read(hid_t file, const char *name, size_t row, double place[2]);
