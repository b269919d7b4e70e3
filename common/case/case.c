/* From a file on disk to a checked case. */
#include "common/case/case.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/text.h"
#include "common/case/case_draft.h"
#include "common/flow/flow.h"

enum { MOST_BYTES = 10 * 1024 * 1024 };

/* The line of the first byte that is not UTF-8, or 0. */
static int find_bad_utf8(const char *text, size_t n) {
  const char *bad = text_bad_utf8(text, n);
  int line = 1;
  for (const char *c = text; bad && c < bad; c++) line += *c == '\n';
  return bad ? line : 0;
}

static bool text_is_fit(struct problems *problems, const char *text, size_t n) {
  const char *allowed = "a case file in YAML, UTF-8 text";
  if (!text[strspn(text, " \t\r\n")]) {
    problems_add(problems, 0, "found an empty file; allowed: %s", allowed);
    return false;
  }
  int line = find_bad_utf8(text, n);
  if (line) {
    problems_add(problems, line, "found a byte that is not UTF-8; allowed: %s; save it as UTF-8",
                 allowed);
    return false;
  }
  return true;
}

/* The whole text, or NULL with a problem added. */
static char *read_text(const char *path, struct problems *problems, size_t *n) {
  char *text;
  enum status status = text_read(path, MOST_BYTES, &text, n);
  if (status == ERR_INPUT)
    problems_add(
        problems, 0,
        "found %s; allowed: a case file in YAML of at most 10 MB, or - for standard input; "
        "correct the path",
        status_message());
  else if (status != OK)
    problems->out_of_memory = true;
  return text;
}

/* "dam-break" of "cases/dam-break.yaml": the title of a case without one. */
static char *title_from_path(const char *path) {
  const char *slash = strrchr(path, '/');
  const char *name = slash ? slash + 1 : path;
  const char *dot = strrchr(name, '.');
  return strndup(name, dot && dot > name ? (size_t)(dot - name) : strlen(name));
}

static enum status build(struct case_draft *d, const char *path, const char *text, size_t n_set) {
  struct case_file *c = d->c;
  c->path = strdup(path);
  CHECK(c->path, ERR_MEMORY, "no memory for the case");
  TRY(case_read_sections(d));
  if (!case_doc_is_mapping(&d->doc, case_doc_root(&d->doc))) return OK;
  TRY(case_read_runs(d));
  TRY(case_read_compare(d));
  if (!c->title) c->title = title_from_path(path);
  CHECK(c->title, ERR_MEMORY, "no memory for the case");
  case_check(d);
  bool solvable = d->good.scales && d->good.shapes && d->good.time && d->good.runs;
  for (size_t i = 0; solvable && i < c->n_runs; i++) {
    struct case_run *r = &c->runs[i];
    if (r->solver->settle) r->solver->settle(c, r);
    if (r->solver->check) r->solver->check(c, r, d->doc.problems);
  }
  if (d->doc.problems->n) return OK;
  if (n_set) return case_doc_emit(&d->doc, &c->text);
  c->text = strdup(text);
  CHECK(c->text, ERR_MEMORY, "no memory for the case");
  return OK;
}

static enum status parse(const char *name, const char *text, size_t n, size_t n_set,
                         const char *const *set, const struct registry *registry, bool read_data,
                         struct problems *problems, struct case_file **out) {
  struct case_draft d = {.registry = registry, .read_data = read_data};
  enum status status = OK;
  d.c = calloc(1, sizeof *d.c);
  CHECK(d.c, ERR_MEMORY, "no memory for the case");
  if (text_is_fit(problems, text, n) && case_doc_load(&d.doc, text, n, problems)) {
    for (size_t k = 0; k < n_set; k++) case_doc_set(&d.doc, k, set[k]);
    /* a path that led nowhere changed nothing, so the rest can be judged all the same */
    if (case_sweep_expand(&d.doc)) status = build(&d, name, text, n_set);
  }
  case_doc_destroy(&d.doc);
  if (status == OK && !problems->n && !problems->out_of_memory)
    *out = d.c;
  else
    case_destroy(d.c);
  return status;
}

static enum status conclude(enum status status, const char *name, size_t n_set,
                            const char *const *set, struct problems *problems) {
  size_t n = problems->n + problems->unlisted;
  problems_finish(problems, name, n_set, set);
  TRY(status);
  CHECK(!problems->out_of_memory, ERR_MEMORY, "no memory to read %s", name);
  CHECK(!n, ERR_INPUT, "%s has %zu problem%s", name, n, n == 1 ? "" : "s");
  return OK;
}

enum status case_load(const char *path, size_t n_set, const char *const *set,
                      const struct registry *registry, struct problems *problems,
                      struct case_file **c) {
  size_t n = 0;
  enum status status = OK;
  *c = NULL;
  *problems = (struct problems){0};
  char *text = read_text(path, problems, &n);
  const char *name = strcmp(path, "-") ? path : "stdin";
  if (text) status = parse(name, text, n, n_set, set, registry, true, problems, c);
  free(text);
  return conclude(status, name, n_set, set, problems);
}

enum status case_parse(const char *name, const char *text, const struct registry *registry,
                       struct problems *problems, struct case_file **c) {
  *c = NULL;
  *problems = (struct problems){0};
  enum status status = parse(name, text, strlen(text), 0, NULL, registry, false, problems, c);
  return conclude(status, name, 0, NULL, problems);
}

static void print_section(FILE *out, const char *name, const struct param *params, size_t n) {
  fprintf(out, "%s\n", name);
  params_print(out, params, n);
  fputc('\n', out);
}

static void print_kinds(FILE *out, const char *section, const struct flow_list *l) {
  char name[96];
  for (size_t i = 0; i < l->n; i++) {
    snprintf(name, sizeof name, "%s of kind %s", section, flow_name(l->flow[i]));
    print_section(out, name, l->flow[i]->params, l->flow[i]->n_params);
  }
}

void case_print_keys(FILE *out) {
  const struct case_table *const lists[] = {
      case_section_tables, case_line_tables,  case_motion_tables, case_run_tables,
      case_profile_tables, case_event_tables, case_signal_tables};
  for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
    for (const struct case_table *t = lists[i]; t->name; t++) {
      print_section(out, t->name, t->params, t->n);
      if (!strcmp(t->name, "water.wave")) print_kinds(out, t->name, &flow_waves);
      if (!strcmp(t->name, "water.body")) print_kinds(out, t->name, &flow_bodies);
    }
}

void case_release_form(struct case_file *c) {
  if (c->form && c->flow->release) c->flow->release(c->form);
  if (c->form) params_release(c->flow->params, c->flow->n_params, c->form);
  free(c->form);
  c->form = NULL;
}

void case_destroy(struct case_file *c) {
  if (!c) return;
  free(c->path);
  free(c->text);
  free(c->title);
  case_release_form(c);
  case_release_motions(c);
  free(c->velocities);
  geo_lines_destroy(&c->walls);
  geo_lines_destroy(&c->water);
  for (size_t i = 0; i < c->n_probes; i++) free(c->probes[i].name);
  for (size_t i = 0; i < c->n_gauges; i++) free(c->gauges[i].name);
  for (size_t i = 0; i < c->n_points; i++) free(c->points[i].name);
  for (size_t i = 0; i < c->n_runs; i++) {
    struct case_run *r = &c->runs[i];
    if (r->solver) params_release(r->solver->params, r->solver->n_params, r->options);
    free(r->name);
    free(r->options);
    free(r->key_line);
    free(r->key_given);
  }
  for (size_t i = 0; i < c->compare.n_tolerances; i++) {
    free(c->compare.tolerances[i].measure);
    free(c->compare.tolerances[i].runs);
  }
  for (size_t i = 0; i < c->compare.n_experiments; i++) {
    struct case_experiment *e = &c->compare.experiments[i];
    free(e->label);
    free(e->source);
    free(e->target);
    free(e->t);
    free(e->value);
  }
  free(c->probes);
  free(c->gauges);
  free(c->points);
  free(c->runs);
  free(c->compare.times);
  free(c->compare.tolerances);
  free(c->compare.averages);
  free(c->compare.filters);
  for (size_t i = 0; i < c->compare.n_spectra; i++) free(c->compare.spectra[i].series);
  free(c->compare.spectra);
  free(c->compare.experiments);
  for (size_t i = 0; i < c->compare.n_profiles; i++) case_profile_destroy(&c->compare.profiles[i]);
  free(c->compare.profiles);
  for (size_t i = 0; i < c->compare.n_events; i++) case_event_destroy(&c->compare.events[i]);
  free(c->compare.events);
  free(c);
}
