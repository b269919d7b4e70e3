#include "gallery/reader.h"

#include <stdlib.h>

#include "common/base/array.h"

/* ---- complaints ---- */

void gallery_complain(struct gallery_reader *r, int node, const char *path, const char *found,
                      const char *allowed, const char *todo) {
  case_doc_problem(&r->doc, case_doc_line(&r->doc, node), path, found, allowed, todo);
}

void gallery_complain_of_word(struct gallery_reader *r, int node, const char *path, const char *key,
                              size_t n, const char *const *names) {
  char full[CASE_PATH + 8], found[64];
  const int at = case_doc_member(&r->doc, node, key);
  const struct case_offer offer = case_offer("one of ", n, names, case_doc_text(&r->doc, at));
  snprintf(full, sizeof full, "%s.%s", path, key);
  case_doc_found(&r->doc, at, found);
  gallery_complain(r, at ? at : node, full, found, offer.allowed, offer.todo);
}

/* ---- lists ---- */

enum status gallery_read_texts(struct gallery_reader *r, int node, const char *path,
                               const char *what, size_t *n, char ***texts) {
  const struct param row = {.key = what, .type = PARAM_TEXT, .max = 4000, .help = what};
  *n = 0;
  *texts = NULL;
  if (!node || !case_doc_expect_list(&r->doc, node, path, 0, GALLERY_MOST_ITEMS, what)) return OK;
  const size_t size = case_doc_size(&r->doc, node);
  TRY(array_create(texts, size, what));
  *n = size;
  for (size_t i = 0; i < size; i++) {
    char item[CASE_PATH];
    snprintf(item, sizeof item, "%s[%zu]", path, i);
    case_doc_value(&r->doc, case_doc_item(&r->doc, node, i), item, &row, &(*texts)[i]);
  }
  return OK;
}

void gallery_texts_free(size_t n, char **texts) {
  for (size_t i = 0; texts && i < n; i++) free(texts[i]);
  free(texts);
}

struct gallery_list gallery_list_of(struct gallery_reader *r, int node, const char *path,
                                    const char *key, size_t least) {
  struct gallery_list list = {.node = node};
  snprintf(list.path, sizeof list.path, "%s.%s", path, key);
  if (!node && !least) return list;
  if (case_doc_expect_list(&r->doc, node, list.path, least, GALLERY_MOST_ITEMS, key))
    list.n = case_doc_size(&r->doc, node);
  return list;
}

int gallery_list_item(struct gallery_reader *r, const struct gallery_list *list, size_t i,
                      char path[CASE_PATH]) {
  const int item = case_doc_item(&r->doc, list->node, i);
  case_doc_item_path(&r->doc, list->path, item, i, path);
  return item;
}
