/* Rows of datasets as we write them (chunks of doubles, shuffled and deflated), several times as
 * fast as by HDF5's own filters. */
#pragma once
#include <hdf5.h>
#include <stdbool.h>
#include <stddef.h>

/* The rows [first, first + n) of `width` numbers (0: a vector) of a dataset whose shape has been
 * checked, into `values`. False, with nothing promised of `values`, when it is not stored like that
 * or anything is strange: HDF5 itself then reads it, or says what is wrong. */
bool hdf_chunks_read(hid_t set, size_t width, hsize_t first, hsize_t n, double *values);
