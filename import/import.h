/* Other programs' files become a result file (docs/import.md). */
#pragma once
#include "common/case/case.h"

struct import_summary {
  size_t surfaces, clouds, rows; /* of series */
  double first, last;            /* s, of surfaces and particles */
  bool walls, particles;         /* it has walls; its surface is that of particles */
};

/* Reads the files that the sidecar names and writes the result `out` (NULL: RUN.h5 in the working
 * directory; *written is its name, the caller's to free). All files are read and checked before
 * anything is written. ERR_INPUT with *problems of the sidecar, or with one sentence that names the
 * file at fault; ERR_IO. */
enum status import_run(const char *sidecar, const char *out, const struct registry *registry,
                       struct problems *problems, char **written, struct import_summary *summary);

/* Every section of a sidecar with its keys, and the formats. */
void import_print_keys(FILE *out);
