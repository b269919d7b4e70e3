/* Two result files side by side, dataset by dataset (`plunge diff`), and one at a glance
 * (`plunge info`). */
#pragma once
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"
#include "common/result/result_tolerance.h"

/* Writes to `out` one line for each dataset and attribute that differs by more than its tolerance,
 * with the worst difference and where it is (time, row), then one line of summary. With `draft` it
 * writes instead a tolerance file under which the two results count as the same. ERR_INPUT when
 * either file is missing, damaged or not a result. */
enum status result_diff(const char *a, const char *b, const struct result_tolerances *tolerances,
                        bool draft, FILE *out, bool *same);

/* What is in the file, in lines of at most 100 columns. ERR_INPUT. */
enum status result_info(const char *path, FILE *out);
