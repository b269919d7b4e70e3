/* Formulas, by muParser: numbers and curves of an entry in them are asked of whoever knows. */
#pragma once
#include "gallery/source.h"

struct gallery_scope {
  void *with;
  /* Each returns false, and leaves the message in status_message(), when there is none. */
  bool (*number)(void *with, const char *name, double *value);
  bool (*curve)(void *with, const char *name, const struct gallery_curve **curve);
};

/* The value of a formula; NaN is one. ERR_INPUT with what is wrong with it. */
enum status gallery_formula(const struct gallery_scope *scope, const char *formula, double *value);

/* The same at n rows of `column[k]`, which `names[k]` stands for; numbers and curves of the scope
 * are looked up once. */
enum status gallery_formula_rows(const struct gallery_scope *scope, const char *formula,
                                 size_t n_names, const char *const *names,
                                 const double *const *column, size_t n, double *value);
