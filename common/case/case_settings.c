/* Settings of a comparison in a file of their own: the section `compare` of a case, for results
 * that are there already. What it is checked against is what those results say of themselves, so
 * that results of other programs and versions can be compared too. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/case/case_draft.h"

enum { MOST_BYTES = 1 << 20 };

static enum status take_frame(struct case_file *c, const struct case_frame *frame) {
  c->H = frame->H;
  c->gravity = c->g = frame->gravity;
  c->tank = frame->tank;
  TRY(array_create(&c->runs, frame->n_runs, "entries of the case"));
  for (size_t i = 0; i < frame->n_runs; i++) {
    struct case_run *r = &c->runs[c->n_runs++];
    r->name = strdup(frame->runs[i]);
    CHECK(r->name, ERR_MEMORY, "no memory for the name of a run");
  }
  TRY(array_create(&c->probes, frame->n_probes, "entries of the case"));
  for (size_t i = 0; i < frame->n_probes; i++) {
    struct case_probe *p = &c->probes[c->n_probes++];
    p->name = strdup(frame->probes[i]);
    CHECK(p->name, ERR_MEMORY, "no memory for the name of a probe");
  }
  TRY(array_create(&c->gauges, frame->n_gauges, "entries of the case"));
  for (size_t i = 0; i < frame->n_gauges; i++) {
    struct case_gauge *g = &c->gauges[c->n_gauges++];
    g->name = strdup(frame->gauges[i]);
    CHECK(g->name, ERR_MEMORY, "no memory for the name of a gauge");
  }
  TRY(array_create(&c->points, frame->n_points, "entries of the case"));
  for (size_t i = 0; i < frame->n_points; i++) {
    struct case_point *p = &c->points[c->n_points++];
    p->name = strdup(frame->points[i]);
    CHECK(p->name, ERR_MEMORY, "no memory for the name of a point");
  }
  return OK;
}

/* What belongs to a case and not to results that are there already. */
static void check_absent(struct case_draft *d, const char *key, const char *why) {
  int node = case_doc_member(&d->doc, d->at.compare, key);
  char path[CASE_PATH];
  if (!node) return;
  snprintf(path, sizeof path, "compare.%s", key);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, "a key of a case", why,
                   "remove it");
}

/* Puts a time to the output that it names; that of another one is a problem. */
static void check_time(struct case_draft *d, const struct case_frame *frame, int item, size_t i) {
  double *time = &d->c->compare.times[i], nearest = NAN;
  char path[CASE_PATH], found[64], words[64], todo[96];
  for (size_t k = 0; k < frame->n_times; k++)
    if (!(fabs(frame->times[k] - *time) >= fabs(nearest - *time))) nearest = frame->times[k];
  bool near = fabs(nearest - *time) <= 1e-6 * fmax(*time, fabs(nearest));
  if (near) *time = nearest;
  bool later = !i || *time > d->c->compare.times[i - 1];
  if (near && later) return;
  snprintf(path, sizeof path, "compare.times[%zu]", i);
  case_time_words(d, item, *time, found);
  case_time_words(d, item, nearest, words);
  snprintf(todo, sizeof todo, near ? "put them in order" : "the nearest is %s", words);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, item), path, found,
                   near ? "times that increase" : "an output time of the reference", todo);
}

/* The section without its name: one hint for all of its keys. */
static bool is_bare_section(struct case_draft *d, int root) {
  static const char *const keys[] = {"times",    "window",  "tolerances",
                                     "averages", "filters", "spectra"};
  if (case_doc_member(&d->doc, root, "compare")) return false;
  for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
    if (!case_doc_member(&d->doc, root, keys[k])) continue;
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, root, keys[k]), keys[k],
                     "a key of the section `compare`, outside of it", "compare",
                     "write `compare:` on a line above and indent what follows");
    return true;
  }
  return false;
}

static enum status read_settings(struct case_draft *d, const struct case_frame *frame) {
  static const struct param rows[] = {
      {.key = "compare",
       .type = PARAM_NODE,
       .offset = offsetof(struct case_draft, at.compare),
       .value = NULL,
       .help = "a mapping with times, window, tolerances, averages, filters, spectra"},
  };
  struct case_block block = {rows, ROWS(rows), d, NULL};
  int root = case_doc_root(&d->doc);
  if (is_bare_section(d, root)) return OK;
  case_doc_read(&d->doc, root, "", case_doc_line(&d->doc, root), 1, &block);
  if (!d->at.compare) return OK;
  TRY(case_read_compare(d));
  check_absent(d, "reference", "none, the reference is the first file");
  check_absent(d, "experiments", "none, they are in the reference's file");
  int list = case_doc_member(&d->doc, d->at.compare, "times");
  for (size_t i = 0; i < d->c->compare.n_times; i++)
    check_time(d, frame, case_doc_item(&d->doc, list, i), i);
  case_check_tolerances(d);
  if (frame->n_times) {
    const double end = frame->times[frame->n_times - 1];
    const char *what = "the reference's last output";
    case_check_averages(d, end, what);
    case_check_filters(d, 0, end, what);
    case_check_spectra(d, end, what);
  }
  case_check_window(d);
  return OK;
}

enum status case_load_settings(const char *path, const struct case_frame *frame,
                               const struct registry *registry, struct problems *problems,
                               struct case_file **out) {
  struct case_draft d = {.registry = registry};
  char *text;
  size_t n;
  *problems = (struct problems){0};
  *out = NULL;
  enum status status = text_read(path, MOST_BYTES, &text, &n);
  if (status == ERR_INPUT)
    return status_context(ERR_INPUT, "cannot read settings, YAML of at most 1 MB, from %s: found ",
                          path);
  TRY(status);
  d.c = calloc(1, sizeof *d.c);
  if (!d.c)
    status = status_raise(ERR_MEMORY, "no memory for settings");
  else
    status = take_frame(d.c, frame);
  if (status == OK && case_doc_load(&d.doc, text, n, problems)) {
    d.doc.scales = (struct param_scales){frame->H, frame->gravity};
    status = read_settings(&d, frame);
  }
  case_doc_destroy(&d.doc);
  free(text);
  size_t faults = problems->n + problems->unlisted;
  problems_finish(problems, path, 0, NULL);
  if (status == OK && problems->out_of_memory)
    status = status_raise(ERR_MEMORY, "no memory to read %s", path);
  if (status == OK && faults)
    status = status_raise(ERR_INPUT, "%s has %zu problem%s", path, faults, faults == 1 ? "" : "s");
  if (status == OK)
    *out = d.c;
  else
    case_destroy(d.c);
  return status;
}
