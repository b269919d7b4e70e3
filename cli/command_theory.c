/* plunge theory: theory without a run. Topics and their parameters are theory/'s; here they become
 * options, and their curves files and figures. */
#include <argp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cli/command.h"
#include "common/base/array.h"
#include "compare/drawing.h"
#include "compare/output.h"
#include "gallery/figures/topic.h"
#include "theory/theory.h"

enum { OPTION_JSON = 1, OPTION_CSV, OPTION_FIGURE, OPTION_PARAM = 256 };

struct theory_arguments {
  const struct theory_topic *topic;
  const char *json, *csv, *figure;
  struct theory_setting *setting; /* [n], owned */
  size_t n;
};

/* ---- options ---- */

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct theory_arguments *a = state->input;
  switch (key) {
  case OPTION_JSON:
    a->json = arg;
    return 0;
  case OPTION_CSV:
    a->csv = arg;
    return 0;
  case OPTION_FIGURE:
    a->figure = arg;
    return 0;
  case ARGP_KEY_ARG:
    argp_error(state, "%s: one topic at a time; a parameter is --NAME=VALUE", arg);
    return 0;
  }
  if (key < OPTION_PARAM || key >= OPTION_PARAM + (int)a->topic->n_params) return ARGP_ERR_UNKNOWN;
  if (array_resize(&a->setting, a->n + 1, "parameters") != OK) return ENOMEM;
  a->setting[a->n++] = (struct theory_setting){a->topic->params[key - OPTION_PARAM].key, arg};
  return 0;
}

static char *param_doc(const struct param *p) {
  char allowed[512], *doc = NULL;
  size_t n;
  param_allowed(p, allowed, sizeof allowed);
  FILE *out = open_memstream(&doc, &n);
  if (!out) return NULL;
  fprintf(out, "%s: %s; default %s", p->help, allowed, p->value);
  for (size_t i = 0; p->type == PARAM_CHOICE && p->helps && p->choices[i]; i++)
    fprintf(out, "%s %s: %s", i ? ";" : ".", p->choices[i], p->helps[i]);
  return fclose(out) == 0 ? doc : NULL;
}

static const struct argp_option file_options[] = {
    {"json", OPTION_JSON, "FILE", 0, "numbers with all digits, units and helps; - is stdout", 0},
    {"csv", OPTION_CSV, "FILE", 0, "a line for each row of each curve; - is stdout", 0},
    {"figure", OPTION_FIGURE, "FILE", 0, "picture: NAME.svg, NAME.pdf or NAME.png", 0}};
enum { FILE_OPTIONS = sizeof file_options / sizeof *file_options };

/* The topic's parameters, then the files; the docs of the former are owned by the list. */
static enum status options_create(const struct theory_topic *t, struct argp_option **options) {
  TRY(array_create(options, t->n_params + FILE_OPTIONS + 1, "options"));
  struct argp_option *o = *options;
  for (size_t p = 0; p < t->n_params; p++) {
    o[p] = (struct argp_option){.name = t->params[p].key,
                                .key = OPTION_PARAM + (int)p,
                                .arg = "VALUES",
                                .doc = param_doc(&t->params[p]),
                                .group = 1};
    CHECK(o[p].doc, ERR_MEMORY, "no memory for options");
  }
  for (size_t k = 0; k < FILE_OPTIONS; k++) {
    o[t->n_params + k] = file_options[k];
    o[t->n_params + k].group = 2;
  }
  return OK;
}

static void options_destroy(const struct theory_topic *t, struct argp_option *options) {
  for (size_t p = 0; options && p < t->n_params; p++) free((char *)options[p].doc);
  free(options);
}

/* ---- what is asked for ---- */

static enum status file_write(const struct theory_result *r, const char *path,
                              enum status (*write)(const struct theory_result *r, FILE *out)) {
  if (!strcmp(path, "-")) return write(r, stdout);
  struct cmp_output o;
  TRY(cmp_output_open(path, &o));
  enum status status = write(r, o.stream);
  if (status == OK) status = cmp_output_commit(&o);
  cmp_output_abandon(&o);
  return status;
}

static enum status csv_write(const struct theory_result *r, FILE *out) {
  theory_write_csv(r, out);
  return OK;
}

static enum status figure_write(const struct theory_result *r, const char *path) {
  struct cmp_figures figures;
  enum status status;
  ATTEMPT(cmp_figures_open_file(path, &figures));
  ATTEMPT(gallery_topic_draw(r, r->topic->name, &figures));
  ATTEMPT(cmp_figures_draw(&figures, CMP_DRAWING_LIMITS));
done:
  cmp_figures_close(&figures);
  return status;
}

static enum status answer(const struct theory_arguments *a, const struct theory_result *r) {
  if (a->json) TRY(file_write(r, a->json, theory_write_json));
  if (a->csv) TRY(file_write(r, a->csv, csv_write));
  if (a->figure) TRY(figure_write(r, a->figure));
  if (!a->json && !a->csv && !a->figure) theory_write_table(r, stdout);
  return OK;
}

/* ---- the command ---- */

static int topics_print(void) {
  puts("plunge theory TOPIC [--PARAMETER=VALUE,...]... [--json FILE] [--csv FILE] [--figure FILE]\n"
       "Several values of a parameter make a curve each. plunge theory TOPIC --help names the\n"
       "parameters; units, equations and what is wrong in the printed texts: docs/theory.md.\n");
  for (size_t i = 0; theory_topics[i]; i++)
    printf("  %-14s %s\n", theory_topics[i]->name, theory_topics[i]->help);
  return EXIT_FINE;
}

static int topic_refuse(const char *name) {
  const char *near = theory_topic_nearest(name);
  enum status status = status_raise(ERR_USAGE, "there is no topic '%.60s'; %s%s%s", name,
                                    near ? "did you mean '" : "",
                                    near ? near : "plunge theory lists them", near ? "'?" : "");
  return command_fail(status);
}

static int topic_run(struct theory_arguments *a, int argc, char **argv) {
  struct argp_option *options = NULL;
  struct theory_result result = {0};
  enum status status;
  ATTEMPT(options_create(a->topic, &options));
  const struct argp argp = {.options = options, .parser = parse, .doc = a->topic->help};
  argp_parse(&argp, argc, argv, 0, NULL, a);
  ATTEMPT(theory_evaluate(a->topic, a->n, a->setting, &result));
  status = answer(a, &result);
done:
  theory_result_destroy(&result);
  options_destroy(a->topic, options);
  free(a->setting);
  return status == OK ? EXIT_FINE : command_fail(status);
}

int command_theory(int argc, char **argv) {
  if (argc < 2 || !strcmp(argv[1], "--help") || !strcmp(argv[1], "-?")) return topics_print();
  struct theory_arguments a = {.topic = theory_topic_find(argv[1])};
  if (!a.topic) return topic_refuse(argv[1]);
  char title[64];
  snprintf(title, sizeof title, "%s %s", argv[0], argv[1]);
  argv[1] = title;
  return topic_run(&a, argc - 1, argv + 1);
}
