/* The walls and the surfaces of a result file. Internal; in the child that reads. */
#pragma once
#include <hdf5.h>

#include "common/result/result.h"

/* Either may be missing, surfaces where there are particles. ERR_INPUT where their datasets do not
 * fit together, a number is not finite, or the water is on the wrong side of a wall or a surface. */
enum status result_lines_read(hid_t file, struct result_file *f);
