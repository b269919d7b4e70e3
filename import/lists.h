/* Files that name others: with their times ParaView's .pvd, and .series of JSON; as parts of one
 * VTK's .pvtu, .vtm and the like. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/status.h"

struct import_list {
  size_t n;
  struct import_listed {
    char *file; /* its path; owned */
    double time;
  } * item; /* [n], owned */
};

bool import_is_list(const char *path); /* by its ending */

/* Files are in its folder or below. ERR_INPUT with a sentence that begins with the path. */
enum status import_list_read(const char *path, struct import_list *list);
void import_list_destroy(struct import_list *list);

/* Bytes of all files that are named as parts by one of VTK's (.pvtu, .vtm and the like), each
 * counted once; 0 of a file of another ending. For limits: what cannot be read counts nothing. */
size_t import_parts_size(const char *path);
