#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "gallery/drawer.h"
#include "gallery/reader.h"
#include "gallery/source.h"

/* ---- tables ---- */

#define X(name, help) #name,
const char *const gallery_kind_names[] = {GALLERY_KINDS(X) NULL};
const char *const gallery_origin_names[] = {GALLERY_ORIGINS(X) NULL};
#undef X

enum { LONG = 4000 };

static const struct param entry_rows[] = {
    TEXT(struct gallery_entry, id, 32, NULL, "as in P 1, T 2-13, T Tab 2.1"),
    TEXT(struct gallery_entry, title, 200, NULL, "what it shows"),
    TEXT(struct gallery_entry, where, 200, NULL, "its place in the document"),
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct gallery_entry, kind),
     .choices = gallery_kind_names,
     .help = "what it is made by"},
    TEXT(struct gallery_entry, setup, LONG, NULL, "what is computed, and the choices made"),
    {.key = "corrected",
     .type = PARAM_BOOL,
     .offset = offsetof(struct gallery_entry, corrected),
     .value = "false",
     .help = "whether it is not what is printed"},
    {.key = "quick",
     .type = PARAM_BOOL,
     .offset = offsetof(struct gallery_entry, quick),
     .value = "true",
     .help = "whether it is made in --quick"},
};

struct lists {
  int remarks, curves, numbers, checks, figures;
};
static const struct param list_rows[] = {
    NODE(struct lists, remarks, "", "a list of texts"),
    NODE(struct lists, curves, "", "a list of curves"),
    NODE(struct lists, numbers, "", "a list of numbers"),
    NODE(struct lists, checks, "", "a list of checks"),
    NODE(struct lists, figures, "", "a list of figures"),
};

static const struct param number_rows[] = {
    TEXT(struct gallery_number, name, 64, NULL, "name in formulas"),
    TEXT(struct gallery_number, is, LONG, NULL, "a formula"),
};

static const struct param check_rows[] = {
    TEXT(struct gallery_check, says, 300, NULL, "what is checked"),
    TEXT(struct gallery_check, value, LONG, NULL, "a formula"),
    TEXT(struct gallery_check, equals, LONG, "", "a formula"),
    TEXT(struct gallery_check, within, LONG, "", "a formula: the largest difference"),
    TEXT(struct gallery_check, percent, LONG, "", "a formula: the same of the expected value"),
    TEXT(struct gallery_check, below, LONG, "", "a formula"),
    TEXT(struct gallery_check, above, LONG, "", "a formula"),
    {.key = "of",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct gallery_check, of),
     .choices = gallery_origin_names,
     .help = "whose the expected value is"},
    TEXT(struct gallery_check, source, 400, NULL, "where the expected value comes from"),
    TEXT(struct gallery_check, because, LONG, "", "why it does not hold"),
    TEXT(struct gallery_check, scatter, LONG, "", "a formula: how far values of chaos lie apart"),
    {.key = "quick",
     .type = PARAM_BOOL,
     .offset = offsetof(struct gallery_check, quick),
     .value = "true",
     .help = "whether it is held in --quick"},
};

/* ---- ids ---- */

int gallery_id_place(const char *id) {
  char again[48] = "";
  int chapter = 0, number = 0, place = 0;
  if (sscanf(id, "P %4d", &number) == 1) {
    snprintf(again, sizeof again, "P %d", number);
    place = number;
  } else if (sscanf(id, "T Tab %2d.%4d", &chapter, &number) == 2) {
    snprintf(again, sizeof again, "T Tab %d.%d", chapter, number);
    place = chapter * 100000 + 50000 + number;
  } else if (sscanf(id, "T %2d-%4d", &chapter, &number) == 2) {
    snprintf(again, sizeof again, "T %d-%d", chapter, number);
    place = chapter * 100000 + number;
  }
  return chapter >= 0 && number > 0 && !strcmp(id, again) ? place : 0;
}

static char *key_of(const char *id) {
  char *key = strdup(id);
  for (char *p = key; p && *p; p++)
    if (*p == ' ') *p = '-';
  return key;
}

/* ---- the lists ---- */

struct curve_head {
  char *name, *from;
};
static const struct param curve_rows[] = {
    TEXT(struct curve_head, name, 64, NULL, "name in formulas and figures"),
    TEXT(struct curve_head, from, 64, NULL, "where it comes from: plunge list"),
};

static const struct gallery_source *source_of(struct gallery_reader *r, int node,
                                              const char *path) {
  const char *names[256], *text = case_doc_text(&r->doc, case_doc_member(&r->doc, node, "from"));
  const struct gallery_source *source = text ? gallery_source_find(text) : NULL;
  size_t n = 0;
  if (source) return source;
  for (size_t k = 0; gallery_sources[k] && n < 256; k++) names[n++] = gallery_sources[k]->name;
  gallery_complain_of_word(r, node, path, "from", n, names);
  return NULL;
}

/* The keys of a mapping are of its source, or of its kind: which that is must be known first. */
static bool is_mapping(struct gallery_reader *r, int node, const char *path, const char *what) {
  char found[64];
  if (case_doc_is_mapping(&r->doc, node)) return true;
  case_doc_found(&r->doc, node, found);
  gallery_complain(r, node, path, found, what, "");
  return false;
}

static enum status read_curve(struct gallery_reader *r, int node, const char *path,
                              struct gallery_curve_spec *c) {
  struct curve_head head = {0};
  c->line = case_doc_line(&r->doc, node);
  if (!is_mapping(r, node, path, "a mapping with name, from and the keys of its source")) return OK;
  c->source = source_of(r, node, path);
  if (!c->source) { /* its other keys mean nothing, but formulas may name it */
    const int name = case_doc_member(&r->doc, node, "name");
    if (name) case_doc_value(&r->doc, name, path, &curve_rows[0], &head);
    c->name = head.name;
    return OK;
  }
  c->params = calloc(1, c->source->params_size);
  CHECK(c->params, ERR_MEMORY, "no memory for a curve");
  const struct case_block blocks[] = {
      {curve_rows, ROWS(curve_rows), &head, NULL},
      {c->source->params, c->source->n_params, c->params, NULL}};
  case_doc_read(&r->doc, node, path, 0, 2, blocks);
  free(head.from);
  c->name = head.name;
  return OK;
}

static enum status read_curves(struct gallery_reader *r, const struct gallery_list *list,
                               struct gallery_entry *e) {
  TRY(array_create(&e->curves, list->n, "curves"));
  e->n_curves = list->n;
  for (size_t i = 0; i < list->n; i++) {
    char full[CASE_PATH];
    const int item = gallery_list_item(r, list, i, full);
    TRY(read_curve(r, item, full, &e->curves[i]));
    gallery_check_name(r, item, full, e->curves[i].name, i, 0);
  }
  return OK;
}

static enum status read_numbers(struct gallery_reader *r, const struct gallery_list *list,
                                struct gallery_entry *e) {
  TRY(array_create(&e->numbers, list->n, "numbers"));
  e->n_numbers = list->n;
  for (size_t i = 0; i < list->n; i++) {
    char full[CASE_PATH];
    const int item = gallery_list_item(r, list, i, full);
    const struct case_block block = {number_rows, ROWS(number_rows), &e->numbers[i], NULL};
    case_doc_read(&r->doc, item, full, 0, 1, &block);
    gallery_check_name(r, item, full, e->numbers[i].name, e->n_curves, i);
  }
  return OK;
}

/* ---- what curves, numbers and checks name, once all of them are known ---- */

/* Of a key whose text is a formula. */
static void check_formula_of(struct gallery_reader *r, int node, const char *path, const char *key,
                             const char *formula) {
  char full[CASE_PATH + 16];
  const int at = case_doc_member(&r->doc, node, key);
  snprintf(full, sizeof full, "%s.%s", path, key);
  gallery_check_formula(r, at ? at : node, full, formula, false);
}

static void check_curves(struct gallery_reader *r, const struct gallery_list *list) {
  for (size_t i = 0; i < list->n; i++) {
    const struct gallery_curve_spec *c = &r->entry->curves[i];
    char path[CASE_PATH], full[CASE_PATH + 32];
    const int item = gallery_list_item(r, list, i, path);
    for (size_t k = 0; c->source && k < c->source->n_params; k++) {
      const struct param *p = &c->source->params[k];
      if (p->type != PARAM_TEXT || strcmp(p->key, "curve") != 0) continue;
      snprintf(full, sizeof full, "%s.%s", path, p->key);
      gallery_check_curve(r, case_doc_member(&r->doc, item, p->key), full,
                          *(char **)((char *)c->params + p->offset));
    }
    if (c->source && c->source->check) c->source->check(r, item, path, c->params);
  }
}

static void check_numbers(struct gallery_reader *r, const struct gallery_list *list) {
  for (size_t i = 0; i < list->n; i++) {
    char path[CASE_PATH];
    const int item = gallery_list_item(r, list, i, path);
    check_formula_of(r, item, path, "is", r->entry->numbers[i].is);
  }
}

static void check_formulas(struct gallery_reader *r, int node, const char *path,
                           const struct gallery_check *c) {
  check_formula_of(r, node, path, "value", c->value);
  check_formula_of(r, node, path, "equals", c->equals);
  check_formula_of(r, node, path, "within", c->within);
  check_formula_of(r, node, path, "percent", c->percent);
  check_formula_of(r, node, path, "below", c->below);
  check_formula_of(r, node, path, "above", c->above);
  check_formula_of(r, node, path, "scatter", c->scatter);
}

static void check_bounds(struct gallery_reader *r, int node, const char *path,
                         const struct gallery_check *c) {
  const bool equals = c->equals, bound = c->below || c->above;
  const int tolerances = (c->within != NULL) + (c->percent != NULL);
  if (equals == bound)
    gallery_complain(r, node, path, equals ? "both equals and a bound" : "no expected value",
                     "equals, or below, above or both", "");
  else if (tolerances != (equals ? 1 : 0))
    gallery_complain(r, node, path,
                     tolerances == 2 ? "both within and percent"
                     : tolerances    ? "a tolerance of a bound"
                                     : "equals without a tolerance",
                     "equals with one of within and percent", "");
}

static enum status read_checks(struct gallery_reader *r, int node, const char *path,
                               struct gallery_entry *e) {
  const struct gallery_list list = gallery_list_of(r, node, path, "checks", 0);
  TRY(array_create(&e->checks, list.n, "checks"));
  e->n_checks = list.n;
  for (size_t i = 0; i < list.n; i++) {
    struct gallery_check *c = &e->checks[i];
    char full[CASE_PATH];
    const int item = gallery_list_item(r, &list, i, full);
    const struct case_block block = {check_rows, ROWS(check_rows), c, NULL};
    if (case_doc_read(&r->doc, item, full, 0, 1, &block)) check_bounds(r, item, full, c);
    check_formulas(r, item, full, c);
  }
  return OK;
}

/* ---- figures ---- */

static const struct gallery_drawer *drawer_of(struct gallery_reader *r, int node,
                                              const char *path) {
  const char *names[64], *text = case_doc_text(&r->doc, case_doc_member(&r->doc, node, "kind"));
  const struct gallery_drawer *drawer = text ? gallery_drawer_find(text) : NULL;
  size_t n = 0;
  if (drawer) return drawer;
  for (size_t k = 0; gallery_drawers[k] && n < 64; k++) names[n++] = gallery_drawers[k]->name;
  gallery_complain_of_word(r, node, path, "kind", n, names);
  return NULL;
}

static enum status read_figures(struct gallery_reader *r, int node, const char *path,
                                struct gallery_entry *e) {
  const struct gallery_list list = gallery_list_of(r, node, path, "figures", 0);
  const struct param caption = {.key = "caption", .type = PARAM_TEXT, .max = 500, .help = ""};
  TRY(array_create(&e->figures, list.n, "figures"));
  e->n_figures = list.n;
  for (size_t i = 0; i < list.n; i++) {
    struct gallery_figure *f = &e->figures[i];
    char full[CASE_PATH], key[CASE_PATH + 16];
    const int item = gallery_list_item(r, &list, i, full);
    const int text = case_doc_member(&r->doc, item, "caption");
    f->line = case_doc_line(&r->doc, item);
    if (!is_mapping(r, item, full, "a mapping with kind, caption and the keys of its kind"))
      continue;
    f->drawer = drawer_of(r, item, full);
    if (!f->drawer) continue;
    snprintf(key, sizeof key, "%s.caption", full);
    if (text) case_doc_value(&r->doc, text, key, &caption, &f->caption);
    TRY(f->drawer->read(r, item, full, &f->spec));
  }
  return OK;
}

/* ---- the entry ---- */

/* The lines of the file from that of the node to its end. */
static char *text_of(struct gallery_reader *r, int node) {
  const yaml_node_t *n = yaml_document_get_node(&r->doc.yaml, node);
  const char *from = r->file->text, *end = from + r->file->size;
  for (size_t k = 0; k < n->start_mark.line && from < end; k++) {
    const char *line = memchr(from, '\n', (size_t)(end - from));
    from = line ? line + 1 : end;
  }
  const char *to = from;
  for (size_t k = n->start_mark.line; k <= n->end_mark.line && to < end; k++) {
    if (k == n->end_mark.line && !n->end_mark.column) break;
    const char *line = memchr(to, '\n', (size_t)(end - to));
    to = line ? line + 1 : end;
  }
  return strndup(from, (size_t)(to - from));
}

static void check_id(struct gallery_reader *r, int node, const char *path) {
  char full[CASE_PATH + 8], found[64];
  const int at = case_doc_member(&r->doc, node, "id");
  snprintf(full, sizeof full, "%s.id", path);
  case_doc_found(&r->doc, at, found);
  gallery_complain(r, at, full, found, "an id as in P 1, T 2-13, T Tab 2.1", "");
}

enum status gallery_entry_read(struct gallery_reader *r, int node, const char *path,
                               struct gallery_entry *e) {
  struct lists lists = {0};
  const struct case_block blocks[] = {{entry_rows, ROWS(entry_rows), e, NULL},
                                      {list_rows, ROWS(list_rows), &lists, NULL}};
  char full[CASE_PATH + 16];
  e->text = text_of(r, node);
  e->file = strdup(r->file->name);
  CHECK(e->text && e->file, ERR_MEMORY, "no memory for an entry");
  case_doc_read(&r->doc, node, path, 0, 2, blocks);
  if (e->id) {
    e->key = key_of(e->id);
    CHECK(e->key, ERR_MEMORY, "no memory for an entry");
    if (!gallery_id_place(e->id)) check_id(r, node, path);
  }
  r->entry = e;
  snprintf(full, sizeof full, "%s.remarks", path);
  TRY(gallery_read_texts(r, lists.remarks, full, "remarks", &e->n_remarks, &e->remarks));
  const struct gallery_list curves = gallery_list_of(r, lists.curves, path, "curves", 0);
  const struct gallery_list numbers = gallery_list_of(r, lists.numbers, path, "numbers", 0);
  TRY(read_curves(r, &curves, e));
  TRY(read_numbers(r, &numbers, e));
  check_curves(r, &curves);
  check_numbers(r, &numbers);
  TRY(read_checks(r, lists.checks, path, e));
  return read_figures(r, lists.figures, path, e);
}

void gallery_entry_free(struct gallery_entry *e) {
  params_release(entry_rows, ROWS(entry_rows), e);
  free(e->key);
  free(e->text);
  free(e->file);
  gallery_texts_free(e->n_remarks, e->remarks);
  for (size_t i = 0; i < e->n_curves; i++) {
    const struct gallery_curve_spec *c = &e->curves[i];
    free(c->name);
    if (c->source) params_release(c->source->params, c->source->n_params, c->params);
    free(c->params);
  }
  for (size_t i = 0; i < e->n_numbers; i++)
    params_release(number_rows, ROWS(number_rows), &e->numbers[i]);
  for (size_t i = 0; i < e->n_checks; i++)
    params_release(check_rows, ROWS(check_rows), &e->checks[i]);
  for (size_t i = 0; i < e->n_figures; i++) {
    free(e->figures[i].caption);
    if (e->figures[i].drawer) e->figures[i].drawer->destroy(e->figures[i].spec);
  }
  free(e->curves);
  free(e->numbers);
  free(e->checks);
  free(e->figures);
}

/* ---- its runs ---- */

struct taking {
  enum status (*take)(void *data, const struct gallery_need *need);
  void *data;
  struct gallery_need need;
};

static enum status take_one(void *data, const char *run) {
  struct taking *t = data;
  t->need.run = run;
  return t->take(t->data, &t->need);
}

enum status gallery_entry_needs(const struct gallery_entry *e,
                                enum status (*take)(void *data, const struct gallery_need *need),
                                void *data) {
  struct taking t = {.take = take, .data = data};
  for (size_t i = 0; i < e->n_curves; i++) {
    const struct gallery_curve_spec *c = &e->curves[i];
    t.need.line = c->line;
    for (size_t k = 0; c->source && k < c->source->n_params; k++) {
      const struct param *p = &c->source->params[k];
      if (p->type != PARAM_TEXT || (strcmp(p->key, "run") && strcmp(p->key, "against"))) continue;
      const char *run = *(char **)((char *)c->params + p->offset);
      snprintf(t.need.path, sizeof t.need.path, "%s.curves.%s.%s", e->id, c->name, p->key);
      if (run && *run) TRY(take_one(&t, run));
    }
  }
  for (size_t i = 0; i < e->n_figures; i++) {
    const struct gallery_figure *f = &e->figures[i];
    t.need.line = f->line;
    snprintf(t.need.path, sizeof t.need.path, "%s.figures[%zu]", e->id, i);
    if (f->drawer && f->drawer->runs) TRY(f->drawer->runs(f->spec, take_one, &t));
  }
  return OK;
}

struct naming {
  enum status (*take)(void *data, const char *run);
  void *data;
};

static enum status take_name(void *data, const struct gallery_need *need) {
  const struct naming *n = data;
  return n->take(n->data, need->run);
}

enum status gallery_entry_runs(const struct gallery_entry *e,
                               enum status (*take)(void *data, const char *run), void *data) {
  return gallery_entry_needs(e, take_name, &(struct naming){take, data});
}
