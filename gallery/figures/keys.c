#include "gallery/figures/keys.h"

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
