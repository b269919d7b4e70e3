#include "common/case/case_doc.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Far more than any case needs; they bound the work that a hostile file can ask for. */
enum { MOST_KEYS = 200, MOST_DEPTH = 32, MOST_ANCHORS = 1000 };

static bool parser_begin(yaml_parser_t *parser, const char *text, size_t n,
                         struct problems *problems) {
  if (!yaml_parser_initialize(parser)) {
    problems->out_of_memory = true;
    return false;
  }
  yaml_parser_set_encoding(parser, YAML_UTF8_ENCODING);
  yaml_parser_set_input_string(parser, (const unsigned char *)text, n);
  return true;
}

static void report_syntax(struct problems *problems, const yaml_parser_t *parser) {
  const char *problem = parser->problem ? parser->problem : "not YAML";
  int line = (int)parser->problem_mark.line + 1;
  char found[200];
  if (parser->error == YAML_MEMORY_ERROR)
    problems->out_of_memory = true;
  else if (parser->error == YAML_READER_ERROR)
    problems_add(problems, 0, "found a byte that cannot stand in YAML at offset %zu (%s)",
                 parser->problem_offset, problem);
  else {
    snprintf(found, sizeof found, "%s%s%s", parser->context ? parser->context : "",
             parser->context ? ": " : "", problem);
    problems_add(problems, line, "found broken YAML (%s); correct line %d or the one before", found,
                 line);
  }
}

/* What has been counted of a text so far. */
struct census {
  size_t depth, anchors, documents;
};

/* Whether there is more to come. */
static bool count_event(struct census *c, const yaml_event_t *event) {
  switch (event->type) {
  case YAML_NO_EVENT:
  case YAML_STREAM_END_EVENT:
    return false;
  case YAML_DOCUMENT_START_EVENT:
    c->documents++;
    return true;
  case YAML_SEQUENCE_START_EVENT:
    c->depth++;
    c->anchors += event->data.sequence_start.anchor != NULL;
    return true;
  case YAML_MAPPING_START_EVENT:
    c->depth++;
    c->anchors += event->data.mapping_start.anchor != NULL;
    return true;
  case YAML_SEQUENCE_END_EVENT:
  case YAML_MAPPING_END_EVENT:
    c->depth--;
    return true;
  case YAML_SCALAR_EVENT:
    c->anchors += event->data.scalar.anchor != NULL;
    return true;
  default:
    return true;
  }
}

static void judge_census(const struct census *c, int line, struct problems *problems) {
  if (c->documents > 1)
    problems_add(problems, line,
                 "found a second YAML document; allowed: one a file; remove the line '---' and "
                 "what follows");
  else if (c->depth > MOST_DEPTH)
    problems_add(problems, line,
                 "found lists and mappings more than %d deep; allowed: %d; close the brackets",
                 MOST_DEPTH, MOST_DEPTH);
  else if (c->anchors > MOST_ANCHORS)
    problems_add(problems, line,
                 "found more than %d anchors (&name); allowed: %d; write the values out",
                 MOST_ANCHORS, MOST_ANCHORS);
}

/* Reads through the text once without keeping anything: syntax errors, a second document, and what
 * would make libyaml's composing parser take quadratic time. */
static void survey(const char *text, size_t n, struct problems *problems) {
  yaml_parser_t parser;
  yaml_event_t event;
  struct census census = {0};
  if (!parser_begin(&parser, text, n, problems)) return;
  for (bool more = true; more && !problems->n;) {
    if (!yaml_parser_parse(&parser, &event)) {
      report_syntax(problems, &parser);
      break;
    }
    more = count_event(&census, &event);
    judge_census(&census, (int)event.start_mark.line + 1, problems);
    yaml_event_delete(&event);
  }
  yaml_parser_delete(&parser);
}

bool case_doc_load_other(struct case_doc *d, const char *text, size_t n, const char *wanted,
                         struct problems *problems) {
  *d = (struct case_doc){.problems = problems, .scales = {NAN, NAN}};
  yaml_parser_t parser;
  survey(text, n, problems);
  if (problems->n || !parser_begin(&parser, text, n, problems)) return false;
  if (!yaml_parser_load(&parser, &d->yaml)) {
    report_syntax(problems, &parser);
  } else {
    d->loaded = true;
    if (!case_doc_root(d)) problems_add(problems, 0, "found no keys; allowed: %s", wanted);
  }
  yaml_parser_delete(&parser);
  return d->loaded && !problems->n && !problems->out_of_memory;
}

bool case_doc_load(struct case_doc *d, const char *text, size_t n, struct problems *problems) {
  return case_doc_load_other(d, text, n, "a mapping with tank, water, time and runs at least",
                             problems);
}

void case_doc_destroy(struct case_doc *d) {
  if (d->loaded) yaml_document_delete(&d->yaml);
  d->loaded = false;
}

static yaml_node_t *get(struct case_doc *d, int node) {
  return node ? yaml_document_get_node(&d->yaml, node) : NULL;
}

int case_doc_root(struct case_doc *d) {
  return yaml_document_get_root_node(&d->yaml) ? 1 : 0;
}

int case_doc_line(struct case_doc *d, int node) {
  yaml_node_t *n = get(d, node);
  if (!n) return 0;
  /* nodes that --set made carry its number, counted down from the largest line there is */
  if (n->start_mark.line > (size_t)-1 / 2) return -(int)((size_t)-1 - n->start_mark.line) - 1;
  return (int)n->start_mark.line + 1;
}

bool case_doc_is_list(struct case_doc *d, int node) {
  yaml_node_t *n = get(d, node);
  return n && n->type == YAML_SEQUENCE_NODE;
}

bool case_doc_is_mapping(struct case_doc *d, int node) {
  yaml_node_t *n = get(d, node);
  return n && n->type == YAML_MAPPING_NODE;
}

size_t case_doc_size(struct case_doc *d, int node) {
  if (!case_doc_is_list(d, node)) return 0;
  yaml_node_t *n = get(d, node);
  return (size_t)(n->data.sequence.items.top - n->data.sequence.items.start);
}

int case_doc_item(struct case_doc *d, int node, size_t i) {
  return get(d, node)->data.sequence.items.start[i];
}

const char *case_doc_text(struct case_doc *d, int node) {
  yaml_node_t *n = get(d, node);
  if (!n || n->type != YAML_SCALAR_NODE) return NULL;
  const char *text = (const char *)n->data.scalar.value;
  return strlen(text) == n->data.scalar.length ? text : NULL; /* "\0" inside is no text */
}

static bool is_nothing(struct case_doc *d, int node) {
  yaml_node_t *n = get(d, node);
  if (!n) return true;
  if (n->type != YAML_SCALAR_NODE || n->data.scalar.style > YAML_PLAIN_SCALAR_STYLE)
    return false; /* "" in quotes is a text */
  const char *text = (const char *)n->data.scalar.value;
  return !*text || !strcmp(text, "~") || !strcmp(text, "null");
}

int case_doc_member(struct case_doc *d, int node, const char *key) {
  yaml_node_t *n = get(d, node);
  if (!n || n->type != YAML_MAPPING_NODE) return 0;
  for (yaml_node_pair_t *p = n->data.mapping.pairs.start; p < n->data.mapping.pairs.top; p++) {
    const char *k = case_doc_text(d, p->key);
    if (k && !strcmp(k, key)) return p->value;
  }
  return 0;
}

int case_doc_member_line(struct case_doc *d, int node, const char *key) {
  int member = case_doc_member(d, node, key);
  return case_doc_line(d, member ? member : node);
}

bool case_name_fits(const char *name) {
  size_t n = strlen(name);
  return n > 0 && n <= CASE_LONGEST_NAME && name[0] != '.' &&
         strspn(name, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789._-") == n;
}

void case_doc_item_path(struct case_doc *d, const char *list, int item, size_t i,
                        char out[CASE_PATH]) {
  const char *name = case_doc_text(d, case_doc_member(d, item, "name"));
  if (name && case_name_fits(name))
    snprintf(out, CASE_PATH, "%s.%s", list, name);
  else
    snprintf(out, CASE_PATH, "%s[%zu]", list, i);
}

void case_doc_problem(struct case_doc *d, int line, const char *path, const char *found,
                      const char *allowed, const char *todo) {
  d->faults++;
  problems_add(d->problems, line, "%s%sfound %s; allowed: %s%s%s", path, *path ? ": " : "", found,
               allowed, *todo ? "; " : "", todo);
}

void case_doc_found(struct case_doc *d, int node, char out[64]) {
  yaml_node_t *n = get(d, node);
  char shown[48];
  if (is_nothing(d, node))
    snprintf(out, 64, "nothing");
  else if (n->type == YAML_SEQUENCE_NODE)
    snprintf(out, 64, "a list");
  else if (n->type == YAML_MAPPING_NODE)
    snprintf(out, 64, "a mapping");
  else {
    case_quote((const char *)n->data.scalar.value, n->data.scalar.length, shown, sizeof shown);
    snprintf(out, 64, "'%s'", shown);
  }
}

struct case_offer case_offer(const char *lead, size_t n, const char *const *names,
                             const char *text) {
  struct case_offer offer = {"", ""};
  snprintf(offer.allowed, sizeof offer.allowed, "%s", lead);
  for (size_t i = 0; i < n; i++) {
    size_t at = strlen(offer.allowed);
    snprintf(offer.allowed + at, sizeof offer.allowed - at, "%s%s", i ? ", " : "", names[i]);
  }
  const char *near = text ? param_nearest(text, n, names) : NULL;
  if (near) snprintf(offer.todo, sizeof offer.todo, "did you mean '%s'?", near);
  return offer;
}

bool case_doc_value(struct case_doc *d, int node, const char *path, const struct param *p,
                    void *into) {
  char found[64], allowed[640], todo[160] = "";
  const char *text = is_nothing(d, node) ? NULL : case_doc_text(d, node);
  if (text && param_fill(p, text, &d->scales, into, todo)) return true;
  if (text && isnan(d->scales.H) && !strcmp(todo, "give scales.H in metres first")) {
    d->faults++;
    if (d->H_missed) return false; /* one word is enough however many lengths are in units of H */
    d->H_missed = true;
  }
  case_doc_found(d, node, found);
  param_allowed(p, allowed, sizeof allowed);
  case_doc_problem(d, case_doc_line(d, node), path, found, allowed, todo);
  return false;
}

bool case_doc_expect_list(struct case_doc *d, int node, const char *path, size_t n_min,
                          size_t n_max, const char *what) {
  char found[64], allowed[160];
  size_t n = case_doc_size(d, node);
  if (case_doc_is_list(d, node) && n >= n_min && n <= n_max) return true;
  if (case_doc_is_list(d, node))
    snprintf(found, sizeof found,
             n == 1 ? "a list of 1 item"
             : n    ? "a list of %zu items"
                    : "an empty list",
             n);
  else
    case_doc_found(d, node, found);
  if (n_min == n_max)
    snprintf(allowed, sizeof allowed, "a list of %zu %s", n_min, what);
  else
    snprintf(allowed, sizeof allowed, "a list of %zu to %zu %s", n_min, n_max, what);
  case_doc_problem(d, case_doc_line(d, node), path, found, allowed, "");
  return false;
}

static void join(char out[CASE_PATH], const char *path, const char *key) {
  snprintf(out, CASE_PATH, "%s%s%s", path, *path ? "." : "", key);
}

static const struct param *find_row(size_t n_blocks, const struct case_block *blocks,
                                    const char *key, void **into) {
  for (size_t b = 0; b < n_blocks; b++)
    for (size_t i = 0; i < blocks[b].n; i++)
      if (!strcmp(blocks[b].params[i].key, key)) {
        *into = blocks[b].into;
        return &blocks[b].params[i];
      }
  return NULL;
}

static size_t list_keys(size_t n_blocks, const struct case_block *blocks,
                        const char *names[MOST_KEYS]) {
  size_t n = 0;
  for (size_t b = 0; b < n_blocks; b++)
    for (size_t i = 0; i < blocks[b].n && n < MOST_KEYS; i++) names[n++] = blocks[b].params[i].key;
  return n;
}

static void report_unknown(struct case_doc *d, int key, const char *path, size_t n_blocks,
                           const struct case_block *blocks) {
  const char *names[MOST_KEYS], *text = case_doc_text(d, key);
  char shown[48], full[CASE_PATH];
  struct case_offer offer = case_offer("", list_keys(n_blocks, blocks, names), names, text);
  if (!text) {
    case_doc_problem(d, case_doc_line(d, key), path, "a key that is not text", offer.allowed, "");
    return;
  }
  case_quote(text, strlen(text), shown, sizeof shown);
  join(full, path, shown);
  case_doc_problem(d, case_doc_line(d, key), full, "an unknown key", offer.allowed, offer.todo);
}

/* Reads one key: value pair; `pairs` are those before it. */
static void read_pair(struct case_doc *d, int node, yaml_node_pair_t pair, size_t before,
                      const char *path, size_t n_blocks, const struct case_block *blocks) {
  void *into = NULL;
  const char *key = case_doc_text(d, pair.key);
  const struct param *row = key ? find_row(n_blocks, blocks, key, &into) : NULL;
  char full[CASE_PATH];
  if (!row) {
    report_unknown(d, pair.key, path, n_blocks, blocks);
    return;
  }
  join(full, path, key);
  yaml_node_pair_t *pairs = get(d, node)->data.mapping.pairs.start;
  for (size_t i = 0; i < before; i++) {
    const char *other = case_doc_text(d, pairs[i].key);
    if (other && !strcmp(other, key)) {
      char found[96];
      snprintf(found, sizeof found, "the key a second time (first in line %d)",
               case_doc_line(d, pairs[i].key));
      case_doc_problem(d, case_doc_line(d, pair.key), full, found, "each key once", "remove one");
      return;
    }
  }
  if (row->type == PARAM_NODE)
    *(int *)((char *)into + row->offset) = pair.value;
  else
    case_doc_value(d, pair.value, full, row, into);
}

/* Defaults first, so that a table row need not care about the order in the file. */
static void fill_defaults(struct case_doc *d, int node, const char *path, int line,
                          const struct case_block *block) {
  for (size_t i = 0; i < block->n; i++) {
    const struct param *p = &block->params[i];
    char full[CASE_PATH], allowed[640], todo[160];
    if (case_doc_member(d, node, p->key)) continue;
    join(full, path, p->key);
    const char *preset = param_preset_value(block->preset, p->key);
    const char *value = preset ? preset : p->value;
    if (!value) {
      param_allowed(p, allowed, sizeof allowed);
      case_doc_problem(d, line, full, "nothing", allowed, "add this key");
    } else if (*value && !param_fill(p, value, &d->scales, block->into, todo)) {
      d->faults++;
      if (d->H_missed) continue;
      d->H_missed = isnan(d->scales.H);
      param_allowed(p, allowed, sizeof allowed);
      snprintf(todo, sizeof todo, "its default is %s: give scales.H in metres or this key", value);
      case_doc_problem(d, line, full, "nothing", allowed, todo);
    }
  }
}

bool case_doc_read(struct case_doc *d, int node, const char *path, int line_if_absent,
                   size_t n_blocks, const struct case_block *blocks) {
  yaml_node_t *n = get(d, node);
  size_t faults = d->faults;
  bool mapping = n && n->type == YAML_MAPPING_NODE;
  size_t n_pairs = mapping ? (size_t)(n->data.mapping.pairs.top - n->data.mapping.pairs.start) : 0;
  if ((n && !mapping) || n_pairs > MOST_KEYS) {
    char found[64];
    case_doc_found(d, node, found);
    if (n_pairs > MOST_KEYS) snprintf(found, sizeof found, "a mapping of %zu keys", n_pairs);
    const char *names[MOST_KEYS];
    struct case_offer offer =
        case_offer("a mapping with the keys ", list_keys(n_blocks, blocks, names), names, NULL);
    case_doc_problem(d, case_doc_line(d, node), path, found, offer.allowed,
                     is_nothing(d, node) ? "give its keys or remove it" : "");
    return false;
  }
  int line = n ? case_doc_line(d, node) : line_if_absent;
  for (size_t b = 0; b < n_blocks; b++) fill_defaults(d, node, path, line, &blocks[b]);
  for (size_t i = 0; i < n_pairs; i++)
    read_pair(d, node, get(d, node)->data.mapping.pairs.start[i], i, path, n_blocks, blocks);
  return d->faults == faults;
}
