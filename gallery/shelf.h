/* The files that the gallery is made of, which the build puts into the program
 * (cmake/gallery.cmake): entries, case files, and the data that these read. */
#pragma once
#include "gallery/book.h"

struct gallery_shelf_file {
  const char *path;  /* in the source tree: "gallery/entries/p.yaml", "cases/data/..." */
  const char *bytes; /* and a '\0' behind them */
  size_t size;       /* without that */
};
extern const struct gallery_shelf_file gallery_shelf[]; /* in the order of their paths */
extern const size_t gallery_shelf_count;

/* NULL: there is none. */
const struct gallery_shelf_file *gallery_shelf_find(const char *path);

/* The case file of that name, one in gallery/cases/ before one in cases/; NULL: there is none. */
const struct gallery_shelf_file *gallery_shelf_find_case(const char *name);

/* The files of entries, for gallery_book_read; *files is the caller's to free, what it points to is
 * not. ERR_MEMORY. */
enum status gallery_shelf_entries(size_t *n, struct gallery_file **files);
