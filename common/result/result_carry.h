/* A result that was read, on its way from the process that reads it to the one that uses it. */
#pragma once
#include <hdf5.h>

#include "common/result/carry.h"
#include "common/result/result.h"

/* Everything of a struct result_file but its path. */
enum status result_carry(struct carrier *c, void *file);

/* What `result_read` does in the child. ERR_INPUT. */
enum status result_read_all(hid_t file, struct result_file *f);
