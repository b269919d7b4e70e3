/* The formats that are read, a file and a line in the list each. */
#pragma once
#include <stdbool.h>

#include "import/table.h"

/* What is asked of a file. */
struct import_ask {
  const char *path;
  const char *names[IMPORT_N_ROLES]; /* columns as the file has them, or NULL */
  char separator;                    /* between the fields of a line; ' ': any blanks */
  const char *time_after;            /* text that the time follows in a comment, or in VTK and HDF5
                                        the name of what holds it; NULL: none */
  size_t step;                       /* which of the file's own, from 0 */
  bool grid;                         /* a mesh of triangles as well */
  int along, up;                     /* axes (0 to 2) of a grid that become x and y */
  double slice;                      /* place of the plane along the third; NAN: the middle */
};

/* X(name, grids, timed, help): the functions of each are import_NAME_steps and import_NAME_read;
 * whether its files can have grids, and times of their own. */
#define IMPORT_FORMATS(X)                                                                          \
  X(csv, false, false, "text: a line of names, then lines of numbers")                             \
  X(npz, false, false, "arrays of numpy")                                                          \
  X(hdf5, false, false, "datasets of HDF5 by their paths, as PySPH writes them")                   \
  X(vtkhdf, false, true, "points over time in VTKHDF's layout")                                    \
  X(vtk, true, true,                                                                               \
    "by the VTK library: legacy, XML, .pvd, .series, grids of VTKHDF, OpenFOAM's .foam")

/* The times that the file itself has, in its units, for steps that `read` tells apart; *times is
 * the caller's. One time of NAN where it has none. */
#define X(name, grids, timed, help)                                                                \
  enum status import_##name##_steps(const struct import_ask *ask, size_t *n, double **times);      \
  enum status import_##name##_read(const struct import_ask *ask, struct import_table *t);
IMPORT_FORMATS(X)
#undef X

struct import_format {
  const char *name, *help;
  bool grids, timed;
  enum status (*steps)(const struct import_ask *ask, size_t *n, double **times);
  /* ERR_INPUT with one sentence that begins with the path; the table is empty then. */
  enum status (*read)(const struct import_ask *ask, struct import_table *t);
};
enum { /* IMPORT_FORMAT_csv, ... */
#define X(name, grids, timed, help) IMPORT_FORMAT_##name,
       IMPORT_FORMATS(X)
#undef X
           IMPORT_N_FORMATS
};
extern const struct import_format import_formats[IMPORT_N_FORMATS];
extern const char *const import_format_names[IMPORT_N_FORMATS + 1]; /* NULL ends them */
extern const char *const import_format_helps[IMPORT_N_FORMATS];

/* Of a format whose files are one time each, which they do not say. */
enum status import_one_step(size_t *n, double **times);
