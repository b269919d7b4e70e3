/* The gallery as data: every figure and table of both documents is an entry of a file in entries/,
 * which says what is run or evaluated, what is drawn, and which numbers must come out. The format is
 * described in docs/gallery-entries.md. Lengths are in H, times in sqrt(H/g), pressures in rho g H
 * throughout, unless a help says otherwise. */
#pragma once
#include "common/base/params.h"
#include "common/case/case.h"

struct gallery_desk;
struct cmp_figures;

/* X(name, help) */
#define GALLERY_KINDS(X)                                                                           \
  X(theory, "formulas, evaluated")                                                                 \
  X(lattice, "sums over a lattice of particles")                                                   \
  X(run, "runs of a solver")                                                                       \
  X(experiment, "runs of a solver beside measurements")                                            \
  X(sketch, "a set-up, drawn from the water at t = 0")                                             \
  X(text, "words alone: there is nothing to compute")
enum gallery_kind {
#define X(name, help) GALLERY_KIND_##name,
  GALLERY_KINDS(X)
#undef X
};

extern const char *const gallery_kind_names[]; /* NULL at the end */

/* What a check holds its number against. X(name, help) */
#define GALLERY_ORIGINS(X)                                                                         \
  X(document, "what the document prints or says")                                                  \
  X(corrected, "what follows from its equations where it is wrong in print, or silent")            \
  X(measured, "what a convergence study or an independent program has found")
enum gallery_origin {
#define X(name, help) GALLERY_ORIGIN_##name,
  GALLERY_ORIGINS(X)
#undef X
};

extern const char *const gallery_origin_names[]; /* NULL at the end */

/* A curve of an entry: a source (gallery/source.h) with its parameters. */
struct gallery_curve_spec {
  char *name;
  const struct gallery_source *source;
  void *params; /* the source's struct, owned */
  int line;
};

struct gallery_number { /* a formula with a name */
  char *name, *is;
};

struct gallery_check {
  char *says;          /* what is checked, one sentence */
  char *value;         /* formula */
  char *equals;        /* formula, with one of within and percent; or one of below and above */
  char *below, *above; /* formulas; both: between them */
  char *within, *percent;
  int of; /* enum gallery_origin */
  char *source;   /* where the expected value comes from: equation, line, derivation */
  char *because;  /* why it is not met: the best explanation found; NULL: it is expected to hold */
  char *scatter;  /* formula: by how much the value differs between runs that differ by rounding
                     alone; NULL: it does not */
  bool quick;     /* held in --quick, too */
};

struct gallery_figure {
  const struct gallery_drawer *drawer; /* gallery/drawer.h */
  void *spec;                          /* the drawer's, owned */
  char *caption;                       /* or NULL */
  int line;
};

struct gallery_entry {
  char *id;    /* "P 1", "T 2-13", "T Tab 2.1" */
  char *key;   /* the same in names of files: "P-1", "T-Tab-2.1" */
  char *title; /* what the figure shows, one line */
  char *where; /* its place: section, equations */
  int kind;    /* enum gallery_kind */
  char *setup; /* what is computed, and the choices made where the document is silent */
  bool corrected; /* what is drawn and checked is not what is printed; remarks say why */
  bool quick;     /* made in --quick, too */
  size_t n_remarks, n_curves, n_numbers, n_checks, n_figures;
  char **remarks; /* misprints and traps, a sentence or two each */
  struct gallery_curve_spec *curves;
  struct gallery_number *numbers;
  struct gallery_check *checks;
  struct gallery_figure *figures;
  char *text; /* of the entry, as its file has it */
  char *file; /* its name */
};

/* A case file with overrides, whose runs entries share: a run is "CASE/RUN". */
struct gallery_case {
  char *name, *file;
  size_t n_set, n_quick;
  char **set, **quick; /* PATH=VALUE; those of --quick come behind the others */
  char *from;          /* the file of entries that has it */
  int line;
};

struct gallery_book {
  size_t n_cases, n_entries;
  struct gallery_case *cases;
  struct gallery_entry *entries; /* in the order of the documents */
};

/* Reads the entries of `n` files of that text, names of which are for messages. ERR_INPUT with
 * *problems, every one found, as case_load has it. */
struct gallery_file {
  const char *name, *text;
  size_t size;
};
enum status gallery_book_read(size_t n, const struct gallery_file *file, struct problems *problems,
                              struct gallery_book **out);
void gallery_book_destroy(struct gallery_book *book);

/* NULL: there is none. The id may be written as in the documents or as in names of files, in any
 * case of letters. */
const struct gallery_entry *gallery_book_find(const struct gallery_book *book, const char *id);
const struct gallery_case *gallery_book_case(const struct gallery_book *book, const char *name);

/* Where an id, "P 1", "T 2-13", "T Tab 2.1", stands in the order of the documents: P, then T by
 * chapters, figures before tables. 0: it is none. */
int gallery_id_place(const char *id);

/* A run "CASE/RUN" that an entry needs, and where its file says so. */
struct gallery_need {
  const char *run;
  int line;
  char path[160]; /* of the key, or of the figure */
};
/* Calls `take` for every one, once or more; its failure ends it. */
enum status gallery_entry_needs(const struct gallery_entry *e,
                                enum status (*take)(void *data, const struct gallery_need *need),
                                void *data);
/* The same with their names alone. */
enum status gallery_entry_runs(const struct gallery_entry *e,
                               enum status (*take)(void *data, const char *run), void *data);
