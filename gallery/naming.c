/* What formulas and figures of an entry name: told while it is read, before anything is run. */
#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "gallery/formula.h"
#include "gallery/reader.h"

/* ---- names ---- */

static bool is_letter(char c) {
  return isalpha((unsigned char)c) || c == '_';
}

static bool is_identifier(const char *name) {
  if (!is_letter(*name) || strlen(name) > 64) return false;
  while (is_letter(*name) || isdigit((unsigned char)*name)) name++;
  return !*name;
}

static bool is_asked_for(void *with, const char *name, double *value) {
  bool *asked = with;
  (void)name;
  *asked = true;
  *value = 0;
  return true;
}

/* Whether it means something in every formula: muParser asks for no such number. */
static bool is_taken(const char *name) {
  bool asked = false;
  double value;
  char call[80];
  const struct gallery_scope scope = {&asked, is_asked_for, NULL};
  snprintf(call, sizeof call, "%s(1)", name);
  (void)gallery_formula(&scope, call, &value);
  return !asked || !strcmp(name, "x");
}

void gallery_check_name(struct gallery_reader *r, int node, const char *path, const char *name,
                        size_t k, size_t n) {
  const struct gallery_entry *e = r->entry;
  char found[100];
  if (!name) return;
  const bool fits = is_identifier(name);
  snprintf(found, sizeof found, "the name '%.60s'", name);
  if (!fits) gallery_complain(r, node, path, found, "a letter, then letters, digits and '_'", "");
  if (fits && is_taken(name))
    gallery_complain(r, node, path, found,
                     "a name that is no function or constant of formulas, nor x", "rename it");
  for (size_t i = 0; i < k; i++)
    if (e->curves[i].name && !strcmp(e->curves[i].name, name))
      gallery_complain(r, node, path, "a name that another curve has", "each name once",
                       "rename one");
  for (size_t i = 0; i < n; i++)
    if (e->numbers[i].name && !strcmp(e->numbers[i].name, name))
      gallery_complain(r, node, path, "a name that another number has", "each name once",
                       "rename one");
}

/* ---- curves ---- */

static bool has_curve(const struct gallery_entry *e, const char *name) {
  for (size_t i = 0; i < e->n_curves; i++)
    if (e->curves[i].name && !strcmp(e->curves[i].name, name)) return true;
  return false;
}

static bool has_number(const struct gallery_entry *e, const char *name) {
  for (size_t i = 0; i < e->n_numbers; i++)
    if (e->numbers[i].name && !strcmp(e->numbers[i].name, name)) return true;
  return false;
}

/* That there is none of the name; which of those with names was perhaps meant. */
static void complain_of_name(struct gallery_reader *r, int node, const char *path,
                             const char *kind, const char *name, const char *allowed, size_t n,
                             const char *const *names) {
  const char *near = param_nearest(name, n, names);
  char found[120], shown[80], todo[100] = "";
  case_quote(name, strlen(name), shown, sizeof shown);
  snprintf(found, sizeof found, "the %s '%s'", kind, shown);
  if (near) snprintf(todo, sizeof todo, "did you mean '%.70s'?", near);
  gallery_complain(r, node, path, found, allowed, todo);
}

enum { MOST_NAMES = 2 * GALLERY_MOST_ITEMS };

static size_t list_curves(const struct gallery_entry *e, const char **names) {
  size_t n = 0;
  for (size_t i = 0; i < e->n_curves; i++)
    if (e->curves[i].name) names[n++] = e->curves[i].name;
  return n;
}

static size_t list_numbers(const struct gallery_entry *e, const char **names) {
  size_t n = 0;
  for (size_t i = 0; i < e->n_numbers; i++)
    if (e->numbers[i].name) names[n++] = e->numbers[i].name;
  return n;
}

void gallery_check_curve(struct gallery_reader *r, int node, const char *path, const char *name) {
  const char *names[MOST_NAMES];
  if (!name || has_curve(r->entry, name)) return;
  complain_of_name(r, node, path, "curve", name, "a curve of the entry",
                   list_curves(r->entry, names), names);
}

/* ---- formulas ---- */

struct dry { /* a formula that is read, of numbers that are all 1 and curves without points */
  const struct gallery_entry *entry;
  bool along;
  char missing[80]; /* the first name that nothing has; "" */
};

static bool give_number(void *with, const char *name, double *value) {
  struct dry *d = with;
  *value = 1;
  if (has_number(d->entry, name) || (d->along && (!strcmp(name, "x") || has_curve(d->entry, name))))
    return true;
  if (!*d->missing) snprintf(d->missing, sizeof d->missing, "%s", name);
  (void)status_raise(ERR_INPUT, "there is no number '%s'", name);
  return false;
}

static bool give_curve(void *with, const char *name, const struct gallery_curve **curve) {
  static const struct gallery_curve nothing = {0};
  (void)with;
  (void)name;
  *curve = &nothing;
  return true;
}

/* Every name in quotes: a formula asks for the curves of the branches alone that it takes. True
 * when all are there. */
static bool check_quoted(struct gallery_reader *r, int node, const char *path,
                         const char *formula) {
  const size_t faults = r->doc.faults;
  const char *end;
  for (const char *p = formula; (p = strchr(p, '"')) && (end = strchr(p + 1, '"')); p = end + 1) {
    char name[80];
    snprintf(name, sizeof name, "%.*s", (int)(end - p - 1 < 79 ? end - p - 1 : 79), p + 1);
    gallery_check_curve(r, node, path, name);
  }
  return r->doc.faults == faults;
}

/* Most formulas of tolerances are numbers, which need no parser. */
static bool is_number(const char *formula) {
  char *end;
  if (strspn(formula, "-.0123456789e") != strlen(formula) || *formula == 'e') return false;
  (void)strtod(formula, &end);
  return end != formula && !*end;
}

void gallery_check_formula(struct gallery_reader *r, int node, const char *path,
                           const char *formula, bool along) {
  struct dry dry = {.entry = r->entry, .along = along};
  const struct gallery_scope scope = {&dry, give_number, give_curve};
  const char *names[MOST_NAMES];
  char found[400], what[320];
  double value;
  if (!formula || is_number(formula) || !check_quoted(r, node, path, formula)) return;
  if (gallery_formula(&scope, formula, &value) == OK) return;
  if (*dry.missing) {
    size_t n = list_numbers(r->entry, names);
    if (along) n += list_curves(r->entry, names + n);
    complain_of_name(r, node, path, "name", dry.missing,
                     along ? "x, a number or a curve of the entry"
                           : "a number of the entry, or a function of a curve",
                     n, names);
    return;
  }
  case_quote(status_message(), strlen(status_message()), what, sizeof what);
  snprintf(found, sizeof found, "a formula that cannot be read: %s", what);
  gallery_complain(r, node, path, found, "a formula of muParser's (docs/gallery-entries.md)", "");
}
