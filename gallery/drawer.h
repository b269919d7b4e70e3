/* Kinds of figures. A drawer is a file in figures/ with a struct gallery_drawer and a line in
 * figures/list.h. */
#pragma once
#include "common/base/status.h"
#include "compare/figure.h"

struct gallery_desk;
struct gallery_reader;
struct gallery_entry;

struct gallery_drawer {
  const char *name, *help;
  /* Reads the mapping `node`, called `path` in messages, whose keys `kind` and `caption` have been
   * read; complaints go to the reader's problems. *spec is NULL after one. */
  enum status (*read)(struct gallery_reader *r, int node, const char *path, void **spec);
  void (*destroy)(void *spec); /* NULL is fine */
  /* As gallery_entry_runs. NULL: needs none. */
  enum status (*runs)(const void *spec, enum status (*take)(void *data, const char *run),
                      void *data);
  /* Writes scripts and data of one or more figures; cmp_figures_draw makes the pictures. NULL: it is
   * a table of the page (gallery/figures/table.h). */
  enum status (*draw)(struct gallery_desk *desk, const struct gallery_entry *e, const void *spec,
                      const char *name, struct cmp_figures *f);
};

extern const struct gallery_drawer *const gallery_drawers[];        /* NULL at the end */
const struct gallery_drawer *gallery_drawer_find(const char *name); /* NULL: there is none */
