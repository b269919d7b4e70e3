#include "gallery/figures/keys.h"

#include <stdlib.h>

struct head {
  char *kind;
  int caption;
};
static const struct param head_rows[] = {
    TEXT(struct head, kind, 64, NULL, "the kind of figure"),
    NODE(struct head, caption, "", "what it shows"),
};

bool gallery_figure_read(struct gallery_reader *r, int node, const char *path,
                         const struct param *rows, size_t n, void *into) {
  struct head head = {0};
  const struct case_block blocks[] = {{head_rows, ROWS(head_rows), &head, NULL},
                                      {rows, n, into, NULL}};
  const bool fine = case_doc_read(&r->doc, node, path, 0, 2, blocks);
  params_release(head_rows, ROWS(head_rows), &head);
  return fine;
}

struct gallery_list gallery_list_of(struct gallery_reader *r, int node, const char *path,
                                    const char *key) {
  struct gallery_list list = {.node = node};
  snprintf(list.path, sizeof list.path, "%s.%s", path, key);
  if (case_doc_expect_list(&r->doc, node, list.path, 1, GALLERY_MOST_ITEMS, key))
    list.n = case_doc_size(&r->doc, node);
  return list;
}

int gallery_list_item(struct gallery_reader *r, const struct gallery_list *list, size_t i,
                      char path[CASE_PATH]) {
  const int item = case_doc_item(&r->doc, list->node, i);
  case_doc_item_path(&r->doc, list->path, item, i, path);
  return item;
}
