/* Reading result files, which nobody vouches for: the bytes of a file can crash HDF5, keep it busy
 * for ever or make it ask for all memory, and a checksum tells only damage, not who wrote it. So
 * HDF5 never reads in this process. A child reads, with limits on its memory and time, and hands
 * over what it found (carry.h). */
#pragma once
#include <hdf5.h>

#include "common/base/status.h"
#include "common/result/carry.h"

struct result_request {
  size_t n;            /* of files, 1 or 2 */
  const char *path[2]; /* [n] */
  bool any;            /* they need not be results */
  void *data;
  enum status (*read)(const hid_t *file, void *data);  /* in the child; [n] */
  enum status (*carry)(struct carrier *c, void *data); /* in both, see carry.h */
};

/* Checks the files without HDF5, opens them once and runs the request. ERR_INPUT with one sentence
 * that names the file at fault; ERR_MEMORY; INTERRUPTED when a signal ended the child. */
enum status result_read_safely(const struct result_request *request);

/* In `read`: from here on, a crash or an error is the fault of this file of two. */
void result_blame(size_t file);
