/* The figure that `plunge theory` draws of a topic. */
#include <stdlib.h>

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

static void topic_check(struct gallery_reader *r, int node, const char *path,
                        const struct theory_spec *s) {
  const char *names[64];
  char full[CASE_PATH + 8], found[80];
  size_t n = 0;
  if (theory_topic_find(s->topic)) return;
  for (; theory_topics[n] && n < 64; n++) names[n] = theory_topics[n]->name;
  const struct case_offer offer = case_offer("one of ", n, names, s->topic);
  snprintf(full, sizeof full, "%s.topic", path);
  snprintf(found, sizeof found, "'%.64s'", s->topic);
  gallery_complain(r, node, full, found, offer.allowed, offer.todo);
}

static enum status read(struct gallery_reader *r, int node, const char *path, void **spec) {
  struct theory_spec *s = calloc(1, sizeof *s);
  const size_t faults = r->doc.faults;
  *spec = NULL;
  CHECK(s, ERR_MEMORY, "no memory for a figure");
  if (gallery_figure_read(r, node, path, rows, ROWS(rows), s)) topic_check(r, node, path, s);
  if (r->doc.faults == faults)
    *spec = s;
  else
    destroy(s);
  return OK;
}

static enum status draw(struct gallery_desk *desk, const struct gallery_entry *e, const void *spec,
                        const char *name, struct cmp_figures *f) {
  const struct theory_spec *s = spec;
  struct theory_result result = {0};
  (void)desk;
  (void)e;
  enum status status = gallery_theory(s->topic, s->set, &result);
  if (status == OK) status = gallery_topic_draw(&result, name, f);
  theory_result_destroy(&result);
  return status;
}

const struct gallery_drawer gallery_drawer_theory = {
    .name = "theory",
    .help = "the figure that plunge theory draws of a topic",
    .read = read,
    .destroy = destroy,
    .draw = draw,
};
