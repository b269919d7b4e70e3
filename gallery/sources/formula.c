/* An expression in x and in other curves of the entry. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "gallery/desk.h"
#include "gallery/reader.h"
#include "gallery/reduce.h"
#include "gallery/source.h"

enum { MOST_CURVES = 32 };

struct formula_source {
  char *y, *on, *at;
  double start, to;
  int points;
};

static const struct param params[] = {
    SOURCE_TEXT(formula_source, y, NULL,
                "a formula in x, in other curves by their names, and in numbers"),
    SOURCE_TEXT(formula_source, on, "", "the curve whose abscissas it has"),
    SOURCE_TEXT(formula_source, at, "", "a formula in the same that replaces x"),
    SOURCE_REAL(formula_source, start, -1e9, 1e9, "0", "else: the first abscissa"),
    SOURCE_REAL(formula_source, to, -1e9, 1e9, "1", "the last"),
    SOURCE_INT(formula_source, points, 1, 100000, "401", "and how many"),
};

static void check(struct gallery_reader *r, int node, const char *path, const void *params_of) {
  const struct formula_source *s = params_of;
  char full[CASE_PATH + 8];
  snprintf(full, sizeof full, "%s.on", path);
  gallery_check_curve(r, case_doc_member(&r->doc, node, "on"), full, s->on);
  snprintf(full, sizeof full, "%s.y", path);
  gallery_check_formula(r, case_doc_member(&r->doc, node, "y"), full, s->y, true);
  snprintf(full, sizeof full, "%s.at", path);
  gallery_check_formula(r, case_doc_member(&r->doc, node, "at"), full, s->at, true);
}

struct columns { /* x, and curves that the formula names, at every abscissa */
  size_t n, n_names;
  const char *name[MOST_CURVES + 1];
  double *column[MOST_CURVES + 1]; /* owned */
};

static void release(struct columns *c) {
  for (size_t k = 0; k < c->n_names; k++) free(c->column[k]);
}

/* Whether a formula has the identifier, not in quotes. */
static bool mentions(const char *formula, const char *name) {
  const size_t n = strlen(name);
  bool quoted = false;
  for (const char *p = formula; p && *p; p++) {
    if (*p == '"') quoted = !quoted;
    if (quoted || !(isalpha((unsigned char)*p) || *p == '_')) continue;
    const char *end = p;
    while (isalnum((unsigned char)*end) || *end == '_') end++;
    if ((size_t)(end - p) == n && !strncmp(p, name, n)) return true;
    p = end - 1;
    if (*end == '"') quoted = true, p++;
  }
  return false;
}

static enum status add_column(struct columns *c, const char *name) {
  CHECK(c->n_names <= MOST_CURVES, ERR_INPUT, "a formula over more than %d curves", MOST_CURVES);
  TRY(array_create(&c->column[c->n_names], c->n, "a formula"));
  c->name[c->n_names++] = name;
  return OK;
}

static enum status take_abscissas(struct gallery_desk *desk, const struct formula_source *s,
                                  struct columns *c) {
  const struct gallery_curve *on = NULL;
  if (s->on) TRY(gallery_desk_curve(desk, s->on, &on));
  c->n = on ? on->n : (size_t)s->points;
  TRY(add_column(c, "x"));
  for (size_t i = 0; i < c->n; i++)
    c->column[0][i] = on          ? on->x[i]
                      : c->n == 1 ? s->start
                                  : s->start + (s->to - s->start) * (double)i / (double)(c->n - 1);
  return OK;
}

static enum status take_curve(struct gallery_desk *desk, const char *name, struct columns *c) {
  const struct gallery_curve *curve;
  TRY(gallery_desk_curve(desk, name, &curve));
  TRY(add_column(c, name));
  const double *x = c->column[0];
  double *y = c->column[c->n_names - 1];
  const bool same = curve->n == c->n && !memcmp(curve->x, x, c->n * sizeof *x);
  for (size_t i = 0; i < c->n; i++) y[i] = same ? curve->y[i] : gallery_reduce_at(curve, &x[i]);
  return OK;
}

static enum status fill(struct gallery_desk *desk, const struct formula_source *s,
                        struct columns *c, struct gallery_curve *out) {
  const struct gallery_entry *e = gallery_desk_entry(desk);
  TRY(take_abscissas(desk, s, c));
  for (size_t k = 0; k < e->n_curves; k++) {
    const char *name = e->curves[k].name;
    if (mentions(s->y, name) || (s->at && mentions(s->at, name))) TRY(take_curve(desk, name, c));
  }
  out->room = c->n;
  TRY(array_create(&out->x, c->n, "a formula"));
  TRY(array_create(&out->y, c->n, "a formula"));
  const double *const *column = (const double *const *)c->column;
  if (s->at)
    TRY(gallery_desk_formula_rows(desk, s->at, c->n_names, c->name, column, c->n, out->x));
  else
    memcpy(out->x, c->column[0], c->n * sizeof *out->x);
  TRY(gallery_desk_formula_rows(desk, s->y, c->n_names, c->name, column, c->n, out->y));
  out->n = c->n;
  return OK;
}

static enum status evaluate(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  struct columns c = {0};
  const enum status status = fill(desk, with, &c, curve);
  release(&c);
  return status;
}

const struct gallery_source gallery_source_formula = {
    .name = "formula",
    .help = "an expression in x and in other curves, interpolated where their abscissas differ",
    SOURCE_TABLE,
    .params_size = sizeof(struct formula_source),
    .check = check,
    .evaluate = evaluate,
};
