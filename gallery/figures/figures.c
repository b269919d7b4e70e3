#include "gallery/figures/figures.h"

#include <stdlib.h>

#include "common/base/array.h"
#include "compare/drawing.h"
#include "compare/json_maker.h"
#include "compare/output.h"
#include "gallery/drawer.h"
#include "gallery/figures/table.h"

enum { THUMB = 360 }; /* px, width of the small pictures of the page */

struct making { /* of one figure */
  size_t first, n; /* of the figures in `f` */
  json_t *table;
  char name[80];   /* of its files, KEY and a letter */
  char failure[300];
};

/* KEY, KEYb, KEYc ... */
static void name_of(const struct gallery_entry *e, size_t i, char *out, size_t room) {
  if (i)
    snprintf(out, room, "%.60s%c", e->key, (char)('a' + (i < 26 ? i : 25)));
  else
    snprintf(out, room, "%.60s", e->key);
}

/* The table as a file beside the figures. */
static enum status table_publish(const json_t *table, const char *name, struct cmp_figures *f) {
  struct cmp_figure nameless = {.script = NULL};
  FILE *out;
  snprintf(nameless.name, sizeof nameless.name, "%s", name);
  TRY(cmp_figure_data(f, &nameless, ".csv", &out));
  gallery_table_csv(table, out);
  return cmp_figure_data_end(&nameless, out);
}

static enum status figure_write(struct gallery_desk *desk, const struct gallery_entry *e, size_t i,
                                struct cmp_figures *f, struct making *m) {
  const struct gallery_figure *figure = &e->figures[i];
  name_of(e, i, m->name, sizeof m->name);
  m->first = f->n;
  if (figure->drawer->draw) {
    TRY(figure->drawer->draw(desk, e, figure->spec, m->name, f));
    m->n = f->n - m->first;
    return OK;
  }
  TRY(gallery_table_json(desk, figure->spec, &m->table));
  return table_publish(m->table, m->name, f);
}

static json_t *file_json(struct cmp_json_maker *m, const struct cmp_figure *fig) {
  json_t *o = json_object();
  cmp_json_set(m, o, "name", cmp_json_text(fig->name));
  cmp_json_set(m, o, "width", json_integer(fig->width));
  cmp_json_set(m, o, "height", json_integer(fig->height));
  cmp_json_set(m, o, "raster", json_boolean(fig->raster));
  if (*fig->missing) cmp_json_set(m, o, "missing", cmp_json_text(fig->missing));
  return o;
}

static json_t *figure_json(struct cmp_json_maker *m, const struct gallery_figure *figure,
                           const struct cmp_figures *f, struct making *of) {
  json_t *o = json_object(), *files = json_array();
  cmp_json_set(m, o, "kind", cmp_json_text(figure->drawer->name));
  cmp_json_set(m, o, "name", cmp_json_text(of->name));
  if (figure->caption) cmp_json_set(m, o, "caption", cmp_json_text(figure->caption));
  for (size_t k = 0; k < of->n; k++)
    cmp_json_add(m, files, file_json(m, &f->figure[of->first + k]));
  cmp_json_set(m, o, "files", files);
  if (of->table) cmp_json_set(m, o, "table", json_incref(of->table));
  if (*of->failure) cmp_json_set(m, o, "failure", cmp_json_text(of->failure));
  return o;
}

static enum status all_write(struct gallery_desk *desk, const struct gallery_entry *e,
                             struct cmp_figures *f, struct making *of) {
  for (size_t i = 0; i < e->n_figures; i++) {
    const size_t before = f->n;
    const enum status status = figure_write(desk, e, i, f, &of[i]);
    if (status == INTERRUPTED || status == ERR_MEMORY) return status;
    if (status == OK) continue;
    snprintf(of[i].failure, sizeof of[i].failure, "%s", status_message());
    cmp_figures_forget(f, before);
  }
  return OK;
}

enum status gallery_figures_make(struct gallery_desk *desk, const struct gallery_entry *e,
                                 struct cmp_figures *f, json_t **figures) {
  struct cmp_json_maker m = {true};
  struct making *of = NULL;
  enum status status;
  *figures = json_array();
  f->thumb = THUMB;
  ATTEMPT(array_create(&of, e->n_figures, "figures"));
  ATTEMPT(all_write(desk, e, f, of));
  status = cmp_figures_draw(f, CMP_DRAWING_LIMITS);
  if (status == INTERRUPTED) goto done;
  status = OK; /* what is missing says so */
  for (size_t i = 0; i < e->n_figures; i++)
    cmp_json_add(&m, *figures, figure_json(&m, &e->figures[i], f, &of[i]));
  if (!m.ok) status = status_raise(ERR_MEMORY, "no memory for figures");
done:
  for (size_t i = 0; of && i < e->n_figures; i++) json_decref(of[i].table);
  free(of);
  if (status == OK) return OK;
  json_decref(*figures);
  *figures = NULL;
  return status;
}
