/* What an entry is computed from: the results of its runs, its curves, and formulas over them. */
#pragma once
#include "common/result/result.h"
#include "gallery/book.h"
#include "gallery/source.h"
#include "theory/theory.h"

struct gallery_desk;

/* `folder`: where results are, FOLDER/CASE/RUN.h5. */
enum status gallery_desk_create(const struct gallery_book *book, const char *folder, bool quick,
                                struct gallery_desk **out);
void gallery_desk_destroy(struct gallery_desk *desk);

/* From now on curves and numbers are those of this entry. ERR_MEMORY. */
enum status gallery_desk_begin(struct gallery_desk *desk, const struct gallery_entry *e);
const struct gallery_entry *gallery_desk_entry(const struct gallery_desk *desk);

bool gallery_desk_is_quick(const struct gallery_desk *desk);

/* A run, "CASE/RUN", read once and kept, whether it reached its end or broke off: some entries show
 * how runs break off. ERR_INPUT when it is not there. */
enum status gallery_desk_result(struct gallery_desk *desk, const char *run,
                                const struct result_file **file);

/* A topic of theory with settings as in "zeta=1 points=200" (NULL: none), texts of the entry:
 * evaluated once for it and kept; good until the next is asked for. ERR_INPUT. */
enum status gallery_desk_theory(struct gallery_desk *desk, const char *topic, const char *set,
                                const struct theory_result **result);

/* A curve of the entry by its name, evaluated once and kept. ERR_INPUT: there is none, it needs
 * itself, or its source failed. */
enum status gallery_desk_curve(struct gallery_desk *desk, const char *name,
                               const struct gallery_curve **curve);

/* The value of a formula (docs/gallery-entries.md) over the entry's numbers and curves; NaN is a
 * value. ERR_INPUT with what is wrong with it. */
enum status gallery_desk_formula(struct gallery_desk *desk, const char *formula, double *value);

/* The same at `n` points of x for variables that are arrays: names[k] stands for column[k][i]. */
enum status gallery_desk_formula_rows(struct gallery_desk *desk, const char *formula,
                                      size_t n_names, const char *const *names,
                                      const double *const *column, size_t n, double *value);
