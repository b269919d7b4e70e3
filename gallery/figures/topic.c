#include "gallery/figures/topic.h"

#include <string.h>

#include "compare/graph.h"

static struct cmp_graph_column column_of(const struct theory_column *c, char *head, size_t room) {
  snprintf(head, room, "%s [%s]", c->key, c->unit);
  return (struct cmp_graph_column){.head = head,
                                   .label = c->label,
                                   .axis = c->axis,
                                   .level = c->level,
                                   .top = c->top,
                                   .panel = c->panel,
                                   .log = c->log,
                                   .points = c->points,
                                   .same = c->same,
                                   .undrawn = c->undrawn};
}

enum status gallery_topic_draw(const struct theory_result *r, const char *name,
                               struct cmp_figures *f) {
  enum { MOST_COLUMNS = 16 };
  const struct theory_topic *t = r->topic;
  struct cmp_graph_column column[MOST_COLUMNS];
  struct cmp_graph_curve curve[THEORY_MOST_CURVES];
  char head[MOST_COLUMNS][64], title[256];
  CHECK(t->n_columns <= MOST_COLUMNS, ERR_USAGE, "%s has too many columns for a figure", t->name);
  for (size_t k = 0; k < t->n_columns; k++)
    column[k] = column_of(&t->columns[k], head[k], sizeof head[k]);
  for (size_t i = 0; i < r->n; i++)
    curve[i] = (struct cmp_graph_curve){
        .name = r->curve[i].name, .n = r->curve[i].n, .row = r->curve[i].row};
  const char *source = strstr(t->help, " (");
  snprintf(title, sizeof title, "%.*s", source ? (int)(source - t->help) : -1, t->help);
  return cmp_graph_write(&(struct cmp_graph){.name = name,
                                             .title = title,
                                             .n_columns = t->n_columns,
                                             .n_curves = r->n,
                                             .column = column,
                                             .curve = curve},
                         f);
}
