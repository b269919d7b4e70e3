/* The rows of a section's files, one time after the other, in SI units and the axes of the tank. */
#pragma once
#include "import/sidecar.h"

struct import_rows {
  double time; /* s, with the offset; NAN: each row has its own */
  size_t n;
  const double *column[IMPORT_N_ROLES]; /* [n], or NULL; those of the table, at these rows */
  const struct import_mesh *mesh;       /* of a grid */
  const char *path;                     /* of the file */
};

/* Reads all files of a section and gives the rows of each time to `take`, in order; of a series all
 * at once. Rows whose `only` differs are left out. ERR_INPUT: times that fall, or are not there. */
enum status import_each(const struct import_sidecar *s, const struct import_section *section,
                        bool series,
                        enum status (*take)(void *data, const struct import_rows *rows),
                        void *data);
