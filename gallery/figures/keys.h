/* How the mappings of figures are read. */
#pragma once
#include "gallery/reader.h"

/* Reads the mapping of a figure with the rows of its drawer, beside which it has `kind` and
 * `caption`, which the entry reads. True when there was no problem. */
bool gallery_figure_read(struct gallery_reader *r, int node, const char *path,
                         const struct param *rows, size_t n, void *into);

/* A list of the mapping `path` of 1 to GALLERY_MOST_ITEMS: its items are read one by one. */
struct gallery_list {
  int node;
  char path[CASE_PATH];
  size_t n; /* 0 after a complaint */
};
struct gallery_list gallery_list_of(struct gallery_reader *r, int node, const char *path,
                                    const char *key);
int gallery_list_item(struct gallery_reader *r, const struct gallery_list *list, size_t i,
                      char path[CASE_PATH]);
