/* What files of any format hold: columns of numbers, at one or several times. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"
#include "import/component.h"

/* What a column is to a result. X(name, units' member, help) */
#define IMPORT_ROLES(X)                                                                            \
  X(time, time, "time of the row, which does not fall")                                            \
  X(x, length, "place along the tank")                                                             \
  X(y, length, "height")                                                                           \
  X(piece, number, "which piece of the surface the point is of")                                   \
  X(u, velocity, "velocity along x")                                                               \
  X(v, velocity, "velocity along y")                                                               \
  X(pressure, pressure, "pressure above that of the air")                                          \
  X(density, density, "density")                                                                   \
  X(mass, mass, "mass of a particle")                                                              \
  X(volume, area, "area of a particle, or of all the water")                                       \
  X(only, number, "kind of the particle, see the key `is`")                                        \
  X(field, number, "scalar whose contour the surface is")                                          \
  X(kinetic, energy, "kinetic energy")                                                             \
  X(potential, energy, "potential energy, heights from y = 0")                                     \
  X(internal, energy, "elastic energy")                                                            \
  X(removed, energy, "energy of water taken out so far")                                           \
  X(elevation, length, "height of the surface")                                                    \
  X(evaluations, number, "evaluations of the rates so far")                                        \
  X(wall_time, clock, "seconds of the clock so far")

enum import_role { /* IMPORT_time, IMPORT_x, ... */
#define X(name, unit, help) IMPORT_##name,
                   IMPORT_ROLES(X)
#undef X
                       IMPORT_N_ROLES
};
extern const char *const import_roles[IMPORT_N_ROLES]; /* names */

/* Triangles, for a contour: corners by number of the rows, [3 n]. */
struct import_mesh {
  size_t n;
  size_t *corner; /* [3 n], owned */
};

/* Rows at one time, in the units of the file. */
struct import_table {
  size_t n;
  double *column[IMPORT_N_ROLES]; /* [n] each that was asked for, else NULL; owned */
  double time;                    /* of all rows, as the file has it; NAN: it has none */
  struct import_mesh mesh;        /* of a grid */
};
void import_table_destroy(struct import_table *t); /* frees the arrays and zeroes *t */

/* Room for n rows of every column that `names` asks for. ERR_MEMORY. */
enum status import_table_make(struct import_table *t, const char *const names[IMPORT_N_ROLES],
                              size_t n);

/* "FILE has no column 'a'; it has b, c; did you mean 'b'?" */
enum status import_no_column(const char *path, const char *column, size_t n,
                             const char *const *names);
