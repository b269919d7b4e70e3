/* The figure that `plunge theory` draws of a topic. */
#include <stdlib.h>

#include "gallery/desk.h"
#include "gallery/drawer.h"
#include "gallery/figures/keys.h"
#include "gallery/figures/topic.h"
#include "gallery/sources/settings.h"

struct theory_spec {
  char *topic, *set;
};
static const struct param rows[] = {
    TEXT(struct theory_spec, topic, 64, NULL, "a topic of plunge theory"),
    TEXT(struct theory_spec, set, 1000, "", "its parameters: KEY=VALUE,... KEY=VALUE,..."),
};

static void destroy(void *spec) {
  if (spec) params_release(rows, ROWS(rows), spec);
  free(spec);
}

static enum status read(struct gallery_reader *r, int node, const char *path, void **spec) {
  struct theory_spec *s = calloc(1, sizeof *s);
  const size_t faults = r->doc.faults;
  size_t curves;
  *spec = NULL;
  CHECK(s, ERR_MEMORY, "no memory for a figure");
  if (gallery_figure_read(r, node, path, rows, ROWS(rows), s))
    (void)gallery_theory_check(r, node, path, s->topic, s->set, &curves);
  if (r->doc.faults == faults)
    *spec = s;
  else
    destroy(s);
  return OK;
}

static enum status draw(struct gallery_desk *desk, const struct gallery_entry *e, const void *spec,
                        const char *name, struct cmp_figures *f) {
  const struct theory_spec *s = spec;
  const struct theory_result *result;
  (void)e;
  TRY(gallery_desk_theory(desk, s->topic, s->set, &result));
  return gallery_topic_draw(result, name, f);
}

const struct gallery_drawer gallery_drawer_theory = {
    .name = "theory",
    .help = "the figure that plunge theory draws of a topic",
    .read = read,
    .destroy = destroy,
    .draw = draw,
};
