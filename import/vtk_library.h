/* What is done with the VTK library, in a module of its own (vtk_library.cpp), which is loaded when
 * a file of VTK is read: the program starts without it, and runs where it is not installed. */
#pragma once
#include "import/formats.h"

enum { IMPORT_VTK_MESSAGE = 400 };

#ifdef __cplusplus
extern "C" {
#endif
/* Both fill what they are given with memory of malloc, and return 0, or 1 with a message that does
 * not name the file. */
int import_vtk_library_steps(const struct import_ask *ask, size_t *n, double **times,
                             char message[IMPORT_VTK_MESSAGE]);
int import_vtk_library_read(const struct import_ask *ask, struct import_table *t,
                            char message[IMPORT_VTK_MESSAGE]);
#ifdef __cplusplus
}
#endif
