/* A file of entries while it is being read. Internal. */
#pragma once
#include "common/case/case_draft.h"
#include "gallery/book.h"

enum { GALLERY_MOST_ITEMS = 1000 }; /* in one list */

struct gallery_reader {
  struct case_doc doc;
  struct gallery_book *book;
  const struct gallery_file *file;
  const struct gallery_entry *entry; /* the one at hand */
};

/* Adds "path: found ...; allowed: ...". */
void gallery_complain(struct gallery_reader *r, int node, const char *path, const char *found,
                      const char *allowed, const char *todo);

/* Says of the value of a key, in the mapping `node`, that it is none of these names. */
void gallery_complain_of_word(struct gallery_reader *r, int node, const char *path, const char *key,
                              size_t n, const char *const *names);

/* The texts of a list of 0 (an absent one) to GALLERY_MOST_ITEMS, owned by the caller. ERR_MEMORY. */
enum status gallery_read_texts(struct gallery_reader *r, int node, const char *path,
                               const char *what, size_t *n, char ***texts);
void gallery_texts_free(size_t n, char **texts);

/* A list, the value of a key of the mapping `path`, of `least` to GALLERY_MOST_ITEMS: its items are
 * read one by one. One of least 0 may be absent. */
struct gallery_list {
  int node;
  char path[CASE_PATH];
  size_t n; /* 0 after a complaint */
};
struct gallery_list gallery_list_of(struct gallery_reader *r, int node, const char *path,
                                    const char *key, size_t least);
int gallery_list_item(struct gallery_reader *r, const struct gallery_list *list, size_t i,
                      char path[CASE_PATH]);

/* ---- naming.c: what formulas and figures name, told before anything is computed. `node` is the
 * value, called `path` in messages ---- */

/* That a curve or number can have the name, and that none of the k curves and n numbers before it
 * has. */
void gallery_check_name(struct gallery_reader *r, int node, const char *path, const char *name,
                        size_t k, size_t n);

/* That the entry has a curve of the name. */
void gallery_check_curve(struct gallery_reader *r, int node, const char *path, const char *name);

/* That a formula can be computed; NULL: there is none. `along`: of a curve, which knows x and the
 * values of other curves there. */
void gallery_check_formula(struct gallery_reader *r, int node, const char *path,
                           const char *formula, bool along);

/* ---- entry.c ---- */

/* Adds the entry that the mapping `node` is. ERR_MEMORY. */
enum status gallery_entry_read(struct gallery_reader *r, int node, const char *path,
                               struct gallery_entry *e);
void gallery_entry_free(struct gallery_entry *e);
