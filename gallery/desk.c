#include "gallery/desk.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/output.h"
#include "gallery/formula.h"
#include "gallery/sources/settings.h"

enum stage { UNTOUCHED, AT_WORK, THERE, FAILED };

struct kept_result {
  char *run;
  struct result_file *file; /* NULL: it failed */
  char failure[600];
};

struct kept_theory {
  const char *topic, *set; /* the entry's; set NULL: none */
  struct theory_result result;
  char failure[600]; /* "" */
};

struct kept_curve {
  enum stage stage;
  struct gallery_curve curve;
  char failure[600];
};

struct kept_number {
  enum stage stage;
  double value;
  char failure[600];
};

struct gallery_desk {
  const struct gallery_book *book;
  const struct gallery_entry *entry;
  char folder[PATH_MAX];
  bool quick;
  size_t n_results, results_room;
  struct kept_result *results;
  size_t n_theories, theories_room;
  struct kept_theory *theories; /* of the entry */
  struct kept_curve *curves;   /* [entry->n_curves] */
  struct kept_number *numbers; /* [entry->n_numbers] */
};

enum status gallery_desk_create(const struct gallery_book *book, const char *folder, bool quick,
                                struct gallery_desk **out) {
  *out = calloc(1, sizeof **out);
  CHECK(*out, ERR_MEMORY, "no memory for the gallery");
  (*out)->book = book;
  (*out)->quick = quick;
  snprintf((*out)->folder, sizeof(*out)->folder, "%s", folder);
  return OK;
}

static void clear(struct gallery_desk *d) {
  for (size_t i = 0; d->entry && i < d->entry->n_curves; i++)
    gallery_curve_free(&d->curves[i].curve);
  for (size_t i = 0; i < d->n_theories; i++) theory_result_destroy(&d->theories[i].result);
  free(d->theories);
  free(d->curves);
  free(d->numbers);
  d->theories = NULL;
  d->n_theories = d->theories_room = 0;
  d->curves = NULL;
  d->numbers = NULL;
  d->entry = NULL;
}

void gallery_desk_destroy(struct gallery_desk *d) {
  if (!d) return;
  clear(d);
  for (size_t i = 0; i < d->n_results; i++) {
    free(d->results[i].run);
    result_file_destroy(d->results[i].file);
  }
  free(d->results);
  free(d);
}

enum status gallery_desk_begin(struct gallery_desk *d, const struct gallery_entry *e) {
  clear(d);
  TRY(array_create(&d->curves, e->n_curves, "curves"));
  TRY(array_create(&d->numbers, e->n_numbers, "numbers"));
  d->entry = e;
  return OK;
}

const struct gallery_entry *gallery_desk_entry(const struct gallery_desk *d) {
  return d->entry;
}

bool gallery_desk_is_quick(const struct gallery_desk *d) {
  return d->quick;
}

/* ---- results ---- */

static enum status read_result(struct gallery_desk *d, const char *run,
                               struct result_file **file) {
  char name[300], path[PATH_MAX];
  const int n = snprintf(name, sizeof name, "%s.h5", run);
  CHECK(n > 0 && n < (int)sizeof name, ERR_INPUT, "run %s: the name is too long", run);
  TRY(cmp_path_join(d->folder, name, path));
  TRY(result_read(path, file));
  if ((*file)->complete || *(*file)->ended) return OK;
  result_file_destroy(*file);
  *file = NULL;
  return status_raise(ERR_INPUT, "run %s has not been finished", run);
}

enum status gallery_desk_result(struct gallery_desk *d, const char *run,
                                const struct result_file **file) {
  struct kept_result *kept = NULL;
  for (size_t i = 0; i < d->n_results && !kept; i++)
    if (!strcmp(d->results[i].run, run)) kept = &d->results[i];
  if (!kept) {
    TRY(array_grow(&d->results, &d->results_room, d->n_results + 1, "results"));
    kept = &d->results[d->n_results];
    *kept = (struct kept_result){.run = strdup(run)};
    CHECK(kept->run, ERR_MEMORY, "no memory for results");
    d->n_results++;
    if (read_result(d, run, &kept->file) != OK)
      snprintf(kept->failure, sizeof kept->failure, "%s", status_message());
  }
  CHECK(kept->file, ERR_INPUT, "%s", kept->failure);
  *file = kept->file;
  return OK;
}

/* ---- theory ---- */

static bool is_of(const struct kept_theory *t, const char *topic, const char *set) {
  return !strcmp(t->topic, topic) && !strcmp(t->set ? t->set : "", set ? set : "");
}

enum status gallery_desk_theory(struct gallery_desk *d, const char *topic, const char *set,
                                const struct theory_result **result) {
  size_t i = 0;
  while (i < d->n_theories && !is_of(&d->theories[i], topic, set)) i++;
  if (i == d->n_theories) {
    TRY(array_grow(&d->theories, &d->theories_room, i + 1, "theory"));
    struct kept_theory *kept = &d->theories[d->n_theories++];
    *kept = (struct kept_theory){.topic = topic, .set = set};
    if (gallery_theory(topic, set, &kept->result) != OK)
      snprintf(kept->failure, sizeof kept->failure, "%s", status_message());
  }
  CHECK(!*d->theories[i].failure, ERR_INPUT, "%s", d->theories[i].failure);
  *result = &d->theories[i].result;
  return OK;
}

/* ---- curves ---- */

static size_t find_curve(const struct gallery_desk *d, const char *name) {
  size_t i = 0;
  while (d->entry && i < d->entry->n_curves && strcmp(d->entry->curves[i].name, name)) i++;
  return d->entry ? i : 0;
}

enum status gallery_desk_curve(struct gallery_desk *d, const char *name,
                               const struct gallery_curve **curve) {
  const size_t i = find_curve(d, name);
  CHECK(d->entry && i < d->entry->n_curves, ERR_INPUT, "there is no curve '%s'", name);
  struct kept_curve *kept = &d->curves[i];
  const struct gallery_curve_spec *spec = &d->entry->curves[i];
  CHECK(kept->stage != AT_WORK, ERR_INPUT, "curve '%s' needs itself", name);
  if (kept->stage == UNTOUCHED) {
    kept->stage = AT_WORK;
    const enum status status = spec->source->evaluate(d, spec->params, &kept->curve);
    kept->stage = status == OK ? THERE : FAILED;
    if (status != OK)
      snprintf(kept->failure, sizeof kept->failure, "curve '%s': %s", name, status_message());
  }
  CHECK(kept->stage == THERE, ERR_INPUT, "%s", kept->failure);
  *curve = &kept->curve;
  return OK;
}

enum status gallery_curve_add(struct gallery_curve *c, double x, double y) {
  if (c->n == c->room) {
    const size_t room = array_room(c->room, c->n + 1);
    TRY(array_resize(&c->x, room, "a curve"));
    TRY(array_resize(&c->y, room, "a curve"));
    c->room = room;
  }
  c->x[c->n] = x;
  c->y[c->n++] = y;
  return OK;
}

void gallery_curve_free(struct gallery_curve *c) {
  free(c->x);
  free(c->y);
  *c = (struct gallery_curve){0};
}

/* ---- formulas ---- */

static bool know_number(void *with, const char *name, double *value) {
  struct gallery_desk *d = with;
  size_t i = 0;
  while (d->entry && i < d->entry->n_numbers && strcmp(d->entry->numbers[i].name, name)) i++;
  if (!d->entry || i == d->entry->n_numbers) {
    (void)status_raise(ERR_INPUT, "there is no number '%s'", name);
    return false;
  }
  struct kept_number *kept = &d->numbers[i];
  if (kept->stage == AT_WORK) {
    (void)status_raise(ERR_INPUT, "number '%s' needs itself", name);
    return false;
  }
  if (kept->stage == UNTOUCHED) {
    kept->stage = AT_WORK;
    const enum status status = gallery_desk_formula(d, d->entry->numbers[i].is, &kept->value);
    kept->stage = status == OK ? THERE : FAILED;
    if (status != OK)
      snprintf(kept->failure, sizeof kept->failure, "number '%s': %s", name, status_message());
  }
  *value = kept->value;
  if (kept->stage == FAILED) (void)status_raise(ERR_INPUT, "%s", kept->failure);
  return kept->stage == THERE;
}

static bool know_curve(void *with, const char *name, const struct gallery_curve **curve) {
  return gallery_desk_curve(with, name, curve) == OK;
}

enum status gallery_desk_formula(struct gallery_desk *d, const char *formula, double *value) {
  const struct gallery_scope scope = {d, know_number, know_curve};
  return gallery_formula(&scope, formula, value);
}

enum status gallery_desk_formula_rows(struct gallery_desk *d, const char *formula, size_t n_names,
                                      const char *const *names, const double *const *column,
                                      size_t n, double *value) {
  const struct gallery_scope scope = {d, know_number, know_curve};
  return gallery_formula_rows(&scope, formula, n_names, names, column, n, value);
}
