/* What the case in a result file says of its runs, as text: the comparator knows no solver's
 * keys, and tells by it which runs differ by their resolution alone. */
#include <stdlib.h>
#include <string.h>

#include "common/case/case_draft.h"

/* Aliases can make a value large, or a part of itself. */
enum { MOST_DEPTH = 32, MOST_BYTES = 4000 };

struct words {
  struct case_doc *doc;
  FILE *out;
  int depth;
  bool cut; /* what is left out may differ from that of others */
};

static void write_node(struct words *w, int node);

static void write_list(struct words *w, const yaml_node_t *n) {
  fputc('[', w->out);
  for (yaml_node_item_t *i = n->data.sequence.items.start; i < n->data.sequence.items.top; i++) {
    if (i > n->data.sequence.items.start) fputs(", ", w->out);
    write_node(w, *i);
  }
  fputc(']', w->out);
}

static void write_mapping(struct words *w, const yaml_node_t *n) {
  fputc('{', w->out);
  for (yaml_node_pair_t *p = n->data.mapping.pairs.start; p < n->data.mapping.pairs.top; p++) {
    if (p > n->data.mapping.pairs.start) fputs(", ", w->out);
    write_node(w, p->key);
    fputs(": ", w->out);
    write_node(w, p->value);
  }
  fputc('}', w->out);
}

static void write_node(struct words *w, int node) {
  const yaml_node_t *n = yaml_document_get_node(&w->doc->yaml, node);
  if (w->depth >= MOST_DEPTH || ftell(w->out) > MOST_BYTES || !n) {
    fputs("...", w->out);
    w->cut = true;
    return;
  }
  w->depth++;
  if (n->type == YAML_SEQUENCE_NODE)
    write_list(w, n);
  else if (n->type == YAML_MAPPING_NODE)
    write_mapping(w, n);
  else if (n->type == YAML_SCALAR_NODE)
    fputs((const char *)n->data.scalar.value, w->out);
  w->depth--;
}

/* ---- a run ---- */

struct setting {
  const char *key;
  int value;
};

static int by_key(const void *a, const void *b) {
  return strcmp(((const struct setting *)a)->key, ((const struct setting *)b)->key);
}

/* Keys that name the run, or say how fine it is. */
static bool is_setting(const char *key) {
  static const char *const others[] = {"name", "solver", "resolution", "accuracy"};
  for (size_t i = 0; key && i < sizeof others / sizeof *others; i++)
    if (!strcmp(key, others[i])) return false;
  return key != NULL;
}

static int find_run(struct case_doc *d, const char *name) {
  const int runs = case_doc_member(d, case_doc_root(d), "runs");
  for (size_t i = 0; i < case_doc_size(d, runs); i++) {
    const int run = case_doc_item(d, runs, i);
    const char *own = case_doc_text(d, case_doc_member(d, run, "name"));
    if (!own) own = case_doc_text(d, case_doc_member(d, run, "solver"));
    if (own && !strcmp(own, name)) return run;
  }
  return 0;
}

static enum status write_run(struct words *w, int run, const char *name) {
  const yaml_node_t *n = yaml_document_get_node(&w->doc->yaml, run);
  const yaml_node_pair_t *pair = n->data.mapping.pairs.start;
  const size_t all = (size_t)(n->data.mapping.pairs.top - pair);
  struct setting *setting = malloc((all + 1) * sizeof *setting);
  size_t kept = 0;
  CHECK(setting, ERR_MEMORY, "no memory for %zu settings", all);
  for (size_t i = 0; i < all; i++) {
    const char *key = case_doc_text(w->doc, pair[i].key);
    if (is_setting(key)) setting[kept++] = (struct setting){key, pair[i].value};
  }
  qsort(setting, kept, sizeof *setting, by_key);
  for (size_t i = 0; i < kept; i++) {
    fprintf(w->out, "%s%s: ", i ? ", " : "", setting[i].key);
    write_node(w, setting[i].value);
  }
  /* it sets more than the resolution: not of one group with runs that have that themselves */
  if (case_doc_member(w->doc, run, "accuracy")) fprintf(w->out, "%sby accuracy", kept ? ", " : "");
  if (w->cut) fprintf(w->out, ", and more, of %s alone", name);
  free(setting);
  return OK;
}

static enum status write_settings(struct case_doc *d, int run, const char *name, char **settings) {
  size_t n;
  struct words words = {.doc = d, .out = open_memstream(settings, &n)};
  CHECK(words.out, ERR_MEMORY, "no memory for the settings of a run");
  const enum status status = write_run(&words, run, name);
  const bool written = !fclose(words.out);
  if (status == OK && written) return OK;
  free(*settings);
  *settings = NULL;
  return status != OK ? status : status_raise(ERR_MEMORY, "no memory for the settings of a run");
}

static enum status write_all(struct case_doc *d, size_t n, const char *const *run,
                             char **settings) {
  for (size_t i = 0; i < n; i++) {
    const int found = find_run(d, run[i]);
    if (found && case_doc_is_mapping(d, found)) TRY(write_settings(d, found, run[i], &settings[i]));
  }
  return OK;
}

enum status case_run_settings(const char *text, size_t n, const char *const *run, char **settings) {
  struct problems problems = {0};
  struct case_doc doc = {0};
  enum status status = OK;
  for (size_t i = 0; i < n; i++) settings[i] = NULL;
  if (case_doc_load(&doc, text, strlen(text), &problems) && case_sweep_expand(&doc))
    status = write_all(&doc, n, run, settings);
  if (problems.out_of_memory && status == OK)
    status = status_raise(ERR_MEMORY, "no memory to read a case");
  for (size_t i = 0; status != OK && i < n; i++) {
    free(settings[i]);
    settings[i] = NULL;
  }
  case_doc_destroy(&doc);
  problems_destroy(&problems);
  return status;
}
