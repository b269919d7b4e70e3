/* Opening result files that nobody vouches for. */
#pragma once
#include <hdf5.h>

#include "common/status.h"

/* Runs `read(request)` after the checks that make it safe. A file whose seal is right is what a run
 * wrote, bit for bit, and is read at once. One without a seal (other programs drop it when they
 * change the file, and a truncated file has lost it) could hold bytes that crash or hang HDF5
 * itself: `read` is rehearsed in a child process first, and only a file that survives that is read
 * here. ERR_INPUT with one sentence otherwise. `read` must depend on nothing but the file and
 * `request`. */
enum status result_read_safely(const char *path, enum status (*read)(void *request), void *request);

/* To be called by `read`: opens a file of our format. ERR_INPUT. */
enum status result_open(const char *path, hid_t *file);
