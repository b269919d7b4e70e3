/* Datasets that grow by rows: chunked, shuffled, deflated, so that every HDF5 can read them.
 *
 * Rows wait in memory until a flush. HDF5 would deflate one chunk after the other, on one thread,
 * with a slower library; here all threads deflate the chunks of all columns, and HDF5 gets them one
 * by one, in the order of the columns: a file has the same bytes for any number of threads. */
#pragma once
#include <hdf5.h>
#include <stddef.h>

#include "common/base/status.h"

struct hdf_columns; /* those of one file */
struct hdf_column;

enum status hdf_columns_create(struct hdf_columns **out);
enum status hdf_columns_flush(struct hdf_columns *c); /* into HDF5; ERR_IO, ERR_MEMORY */
void hdf_columns_destroy(struct hdf_columns *c);      /* and every column; NULL is fine */

struct hdf_rows {
  hid_t type;        /* native, in memory and in the file */
  size_t width;      /* numbers in a row, 0: a vector */
  size_t chunk_rows; /* that are deflated together */
};

/* A new dataset, with `units` and `description`; the columns keep *column. ERR_IO, ERR_MEMORY. */
enum status hdf_column_create(struct hdf_columns *c, hid_t group, const char *name,
                              const struct hdf_rows *rows, const char *units, const char *help,
                              struct hdf_column **column);
enum status hdf_column_append(struct hdf_column *column, size_t n, const void *rows);
size_t hdf_column_length(const struct hdf_column *column); /* rows so far */
