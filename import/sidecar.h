/* The sidecar: what a result needs that other programs' files do not say (docs/import.md). */
#pragma once
#include <stdbool.h>

#include "common/case/case.h"
#include "common/case/case_draft.h"
#include "import/formats.h"

enum { IMPORT_MOST_FILES = 100000 };

struct import_item { /* one file */
  char *file;        /* its path, that of the sidecar before it; owned */
  double time;       /* s, before the offset; NAN: the file has it */
  char *where;       /* "FILE:LINE: particles.files[3]", for messages; owned */
};

enum import_kind { /* of a series */
                   IMPORT_ENERGY,
                   IMPORT_PROBE,
                   IMPORT_GAUGE,
                   IMPORT_RUN,
};

struct import_section { /* one of profiles, grid, particles, or a series */
  bool given;
  int format, separator, kind;
  size_t n_items;
  struct import_item *items;    /* [n_items], owned */
  char *column[IMPORT_N_ROLES]; /* owned; NULL: not asked for */
  char *time_after;             /* owned, or NULL */
  double gap;                   /* between walls and where water ends, m */
  double is;                    /* of the column `only` */
  int along, up, water;         /* axes 0 to 2; 1: water is where the field is below */
  double level, slice;          /* of a grid; slice NAN: the middle; m */
  char *name;                   /* of a probe or a gauge; owned */
  double x, y, size;            /* of one, m */
  double rest;                  /* of energies, in the unit of energy; NAN: the case has it */
  int line;                     /* in the sidecar */
};

struct import_sidecar {
  char *path; /* owned, as all texts */
  char *run, *solver, *source, *title;
  struct case_file *scales; /* of the case, or with H, g, density and walls alone; owned */
  bool has_case;
  double spacing, offset; /* m, s */
  double origin[2];       /* m, in the files' own coordinates */
  struct {                /* of the numbers in the files, SI; NAN: not told */
    double length, time, velocity, density, pressure, mass, energy;
  } unit;
  struct import_section profiles, grid, particles;
  size_t n_series;
  struct import_section *series; /* [n_series], owned */
};

/* ERR_INPUT with *problems, which lists every one found, as case_load has it; those of a case file
 * that it names are problems of its key `case`. */
enum status import_sidecar_load(const char *path, const struct registry *registry,
                                struct problems *problems, struct import_sidecar **out);
void import_sidecar_destroy(struct import_sidecar *s);

/* The factor to SI of what a role is given in; NAN: the sidecar does not say. */
double import_unit(const struct import_sidecar *s, enum import_role role);

/* Tables of keys, for import_print_keys. */
extern const struct case_table import_tables[];
