/* What a result file says before the run: attributes, case, parameters, walls, experiments.
 * Internal. */
#pragma once
#include <hdf5.h>

#include "common/result/result.h"

enum status result_header_write(hid_t file, const struct result_about *about);
