/* A file of entries while it is being read. Internal. */
#pragma once
#include "common/case/case_draft.h"
#include "gallery/book.h"

enum { GALLERY_MOST_ITEMS = 1000 }; /* in one list */

struct gallery_reader {
  struct case_doc doc;
  struct gallery_book *book;
  const struct gallery_file *file;
};

/* Adds "path: found ...; allowed: ...". */
void gallery_complain(struct gallery_reader *r, int node, const char *path, const char *found,
                      const char *allowed, const char *todo);

/* The texts of a list of 0 (an absent one) to GALLERY_MOST_ITEMS, owned by the caller. ERR_MEMORY. */
enum status gallery_read_texts(struct gallery_reader *r, int node, const char *path,
                               const char *what, size_t *n, char ***texts);
void gallery_texts_free(size_t n, char **texts);

/* Adds the entry that the mapping `node` is. ERR_MEMORY. */
enum status gallery_entry_read(struct gallery_reader *r, int node, const char *path,
                               struct gallery_entry *e);
void gallery_entry_free(struct gallery_entry *e);
