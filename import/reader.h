/* A sidecar while it is being read: what its two files share. Internal. */
#pragma once
#include "import/sidecar.h"

struct import_top { /* nodes of the sections; 0: absent */
  char *case_path;
  int scales, tank, units, origin, profiles, grid, particles, series;
};

struct import_reader {
  struct case_draft d; /* its case gets walls and scales */
  struct import_sidecar *s;
  struct import_top top;
  bool units_bad; /* which has been said */
};

void import_complain(struct import_reader *r, int node, const char *path, const char *found,
                     const char *allowed, const char *todo);

/* The path of a file that the sidecar names; the caller's. ERR_MEMORY. */
enum status import_join_path(const struct import_sidecar *s, const char *file, char **out);

/* profiles, grid, particles and series, once scales and units are known. */
enum status import_read_sections(struct import_reader *r);

/* Tables of keys, for import_print_keys. */
extern const struct case_table import_section_tables[];
