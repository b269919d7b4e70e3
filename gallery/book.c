#include "gallery/book.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "common/base/array.h"
#include "gallery/reader.h"
#include "gallery/shelf.h"

/* ---- reading ---- */

struct case_form {
  int set, quick;
};
static const struct param case_rows[] = {
    TEXT(struct gallery_case, name, 64, NULL, "name of the case in CASE/RUN"),
    TEXT(struct gallery_case, file, 200, NULL, "a case file of gallery/cases or cases"),
};
static const struct param case_lists[] = {
    NODE(struct case_form, set, "", "a list of PATH=VALUE"),
    NODE(struct case_form, quick, "", "a list of PATH=VALUE, of --quick"),
};

/* A list of PATH=VALUE. */
static enum status read_overrides(struct gallery_reader *r, int node, const char *path,
                                  const char *key, size_t *n, char ***texts) {
  char full[CASE_PATH + 16], item[CASE_PATH + 48], found[64];
  snprintf(full, sizeof full, "%s.%s", path, key);
  TRY(gallery_read_texts(r, node, full, "overrides", n, texts));
  for (size_t i = 0; i < *n; i++) {
    if (!(*texts)[i] || strchr((*texts)[i], '=')) continue;
    const int at = case_doc_item(&r->doc, node, i);
    snprintf(item, sizeof item, "%s[%zu]", full, i);
    case_doc_found(&r->doc, at, found);
    gallery_complain(r, at, item, found, "PATH=VALUE, as in runs.NAME.alpha=0", "");
  }
  return OK;
}

static void check_file(struct gallery_reader *r, int node, const char *path, const char *file) {
  char full[CASE_PATH + 16], found[64];
  if (!file || gallery_shelf_find_case(file)) return;
  const int at = case_doc_member(&r->doc, node, "file");
  snprintf(full, sizeof full, "%s.file", path);
  case_doc_found(&r->doc, at, found);
  gallery_complain(r, at, full, found, "a case file of gallery/cases or cases", "");
}

static enum status read_case(struct gallery_reader *r, int node, const char *path,
                             struct gallery_case *c) {
  struct case_form form = {0};
  const struct case_block blocks[] = {{case_rows, ROWS(case_rows), c, NULL},
                                      {case_lists, ROWS(case_lists), &form, NULL}};
  c->line = case_doc_line(&r->doc, node);
  c->from = strdup(r->file->name);
  CHECK(c->from, ERR_MEMORY, "no memory for a case");
  if (!case_doc_read(&r->doc, node, path, 0, 2, blocks)) return OK;
  if (!case_name_fits(c->name)) {
    char found[64];
    case_doc_found(&r->doc, case_doc_member(&r->doc, node, "name"), found);
    gallery_complain(r, node, path, found,
                     "letters, digits, '.', '_' and '-', with no '.' first, at most 64", "");
  }
  check_file(r, node, path, c->file);
  TRY(read_overrides(r, form.set, path, "set", &c->n_set, &c->set));
  return read_overrides(r, form.quick, path, "quick", &c->n_quick, &c->quick);
}

static enum status read_cases(struct gallery_reader *r, int node) {
  if (!node || !case_doc_expect_list(&r->doc, node, "cases", 0, GALLERY_MOST_ITEMS, "cases"))
    return OK;
  for (size_t i = 0; i < case_doc_size(&r->doc, node); i++) {
    struct gallery_book *b = r->book;
    const int item = case_doc_item(&r->doc, node, i);
    char path[CASE_PATH];
    TRY(array_resize(&b->cases, b->n_cases + 1, "cases"));
    b->cases[b->n_cases] = (struct gallery_case){0};
    case_doc_item_path(&r->doc, "cases", item, i, path);
    TRY(read_case(r, item, path, &b->cases[b->n_cases++]));
    const struct gallery_case *c = &b->cases[b->n_cases - 1];
    if (c->name && gallery_book_case(b, c->name) != c)
      gallery_complain(r, item, path, "a name that another case has", "each name once",
                       "rename one");
  }
  return OK;
}

static enum status read_entries(struct gallery_reader *r, int node) {
  if (!case_doc_expect_list(&r->doc, node, "entries", 1, GALLERY_MOST_ITEMS, "entries")) return OK;
  for (size_t i = 0; i < case_doc_size(&r->doc, node); i++) {
    struct gallery_book *b = r->book;
    const int item = case_doc_item(&r->doc, node, i);
    const char *id = case_doc_text(&r->doc, case_doc_member(&r->doc, item, "id"));
    char path[CASE_PATH], shown[48];
    TRY(array_resize(&b->entries, b->n_entries + 1, "entries"));
    b->entries[b->n_entries] = (struct gallery_entry){0};
    if (id) {
      case_quote(id, strlen(id), shown, sizeof shown);
      snprintf(path, sizeof path, "%s", shown);
    } else
      snprintf(path, sizeof path, "entries[%zu]", i);
    TRY(gallery_entry_read(r, item, path, &b->entries[b->n_entries++]));
    const struct gallery_entry *e = &b->entries[b->n_entries - 1];
    if (e->id && gallery_book_find(b, e->id) != e)
      gallery_complain(r, item, path, "an id that another entry has", "each id once", "rename one");
  }
  return OK;
}

static enum status read_file(struct gallery_book *book, const struct gallery_file *file,
                             struct problems *problems) {
  struct gallery_reader r = {.book = book, .file = file};
  struct {
    int cases, entries;
  } top = {0, 0};
  static const struct param rows[] = {
      {.key = "cases", .type = PARAM_NODE, .offset = 0, .value = "", .help = "a list of cases"},
      {.key = "entries",
       .type = PARAM_NODE,
       .offset = sizeof(int),
       .value = NULL,
       .help = "a list of entries"}};
  enum status status = OK;
  if (case_doc_load_other(&r.doc, file->text, file->size, "a mapping with entries, and cases",
                          problems)) {
    const struct case_block block = {rows, ROWS(rows), &top, NULL};
    r.doc.scales = (struct param_scales){1, 1};
    if (case_doc_read(&r.doc, case_doc_root(&r.doc), "", 1, 1, &block)) {
      status = read_cases(&r, top.cases);
      if (status == OK) status = read_entries(&r, top.entries);
    }
  }
  case_doc_destroy(&r.doc);
  return status;
}

/* ---- what entries name, once all files are read ---- */

struct naming {
  const struct gallery_book *book;
  const struct gallery_entry *entry;
  struct problems *problems;
};

static enum status check_run(void *data, const struct gallery_need *need) {
  const struct naming *n = data;
  const char *slash = strchr(need->run, '/');
  char name[CASE_LONGEST_NAME + 1];
  snprintf(name, sizeof name, "%.*s", slash ? (int)(slash - need->run) : 0, need->run);
  if (slash && slash[1] && !strchr(slash + 1, '/') && gallery_book_case(n->book, name)) return OK;
  problems_add(n->problems, 0,
               "%s:%d: %s: found run '%.900s'; allowed: CASE/RUN with a case of `cases`",
               n->entry->file, need->line, need->path, need->run);
  return OK;
}

static int by_place(const void *a, const void *b) {
  const struct gallery_entry *p = a, *q = b;
  const int s = gallery_id_place(p->id), t = gallery_id_place(q->id);
  return (s > t) - (s < t);
}

static enum status append(struct problems *to, const struct problems *from) {
  for (size_t i = 0; i < from->n; i++) problems_add(to, 0, "%s", from->text[i]);
  to->unlisted += from->unlisted;
  to->out_of_memory |= from->out_of_memory;
  CHECK(!to->out_of_memory, ERR_MEMORY, "no memory for the gallery");
  return OK;
}

static enum status read_all(struct gallery_book *book, size_t n, const struct gallery_file *file,
                            struct problems *problems) {
  for (size_t i = 0; i < n; i++) {
    struct problems own = {0};
    enum status status = read_file(book, &file[i], &own);
    problems_finish(&own, file[i].name, 0, NULL);
    if (status == OK) status = append(problems, &own);
    problems_destroy(&own);
    TRY(status);
  }
  if (problems->n) return OK;
  qsort(book->entries, book->n_entries, sizeof *book->entries, by_place);
  for (size_t i = 0; i < book->n_entries; i++) {
    struct naming naming = {book, &book->entries[i], problems};
    TRY(gallery_entry_needs(naming.entry, check_run, &naming));
  }
  return OK;
}

enum status gallery_book_read(size_t n, const struct gallery_file *file, struct problems *problems,
                              struct gallery_book **out) {
  *problems = (struct problems){0};
  *out = NULL;
  struct gallery_book *book = calloc(1, sizeof *book);
  CHECK(book, ERR_MEMORY, "no memory for the gallery");
  enum status status = read_all(book, n, file, problems);
  if (status == OK && problems->n + problems->unlisted)
    status = status_raise(ERR_INPUT, "the gallery's entries have %zu problem%s",
                          problems->n + problems->unlisted,
                          problems->n + problems->unlisted == 1 ? "" : "s");
  if (status == OK)
    *out = book;
  else
    gallery_book_destroy(book);
  return status;
}

void gallery_book_destroy(struct gallery_book *book) {
  if (!book) return;
  for (size_t i = 0; i < book->n_cases; i++) {
    struct gallery_case *c = &book->cases[i];
    free(c->name);
    free(c->file);
    free(c->from);
    gallery_texts_free(c->n_set, c->set);
    gallery_texts_free(c->n_quick, c->quick);
  }
  for (size_t i = 0; i < book->n_entries; i++) gallery_entry_free(&book->entries[i]);
  free(book->cases);
  free(book->entries);
  free(book);
}

/* ---- finding ---- */

const struct gallery_entry *gallery_book_find(const struct gallery_book *book, const char *id) {
  for (size_t i = 0; i < book->n_entries; i++) {
    const struct gallery_entry *e = &book->entries[i];
    if (e->id && e->key && (!strcasecmp(e->id, id) || !strcasecmp(e->key, id))) return e;
  }
  return NULL;
}

const struct gallery_case *gallery_book_case(const struct gallery_book *book, const char *name) {
  for (size_t i = 0; i < book->n_cases; i++)
    if (book->cases[i].name && !strcmp(book->cases[i].name, name)) return &book->cases[i];
  return NULL;
}
