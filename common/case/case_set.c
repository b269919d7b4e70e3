/* Overrides ("--set runs.bem.resolution=80") work on the document, not on the text: whatever they
 * change is then checked like the rest of the case. */
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case_doc.h"

enum { MOST_DEPTH = 16, MOST_NODES = 10000 }; /* of a value: bounds alias bombs */

/* Marks a node as made by the k-th --set: see case_doc_line. */
static int mark(struct case_doc *d, int node, size_t k) {
  yaml_node_t *n = yaml_document_get_node(&d->yaml, node);
  if (n) n->start_mark.line = (size_t)-1 - k;
  return node;
}

static int add_scalar(struct case_doc *d, const char *text, size_t n, yaml_scalar_style_t style,
                      size_t k) {
  return mark(d, yaml_document_add_scalar(&d->yaml, NULL, (const yaml_char_t *)text, (int)n, style),
              k);
}

/* Copies a node of another document into this one. 0 when it is too large or memory is short. */
static int copy_in(struct case_doc *d, yaml_document_t *from, int node, size_t k, int depth,
                   size_t *nodes) {
  yaml_node_t *n = yaml_document_get_node(from, node);
  if (depth > MOST_DEPTH || ++*nodes > MOST_NODES) return 0;
  if (n->type == YAML_SCALAR_NODE)
    return add_scalar(d, (const char *)n->data.scalar.value, n->data.scalar.length,
                      n->data.scalar.style, k);
  int copy = 0;
  if (n->type == YAML_SEQUENCE_NODE) {
    copy = mark(d, yaml_document_add_sequence(&d->yaml, NULL, n->data.sequence.style), k);
    for (int *i = n->data.sequence.items.start; copy && i < n->data.sequence.items.top; i++) {
      int item = copy_in(d, from, *i, k, depth + 1, nodes);
      if (!item || !yaml_document_append_sequence_item(&d->yaml, copy, item)) return 0;
    }
  } else if (n->type == YAML_MAPPING_NODE) {
    copy = mark(d, yaml_document_add_mapping(&d->yaml, NULL, n->data.mapping.style), k);
    for (yaml_node_pair_t *p = n->data.mapping.pairs.start; copy && p < n->data.mapping.pairs.top;
         p++) {
      int key = copy_in(d, from, p->key, k, depth + 1, nodes);
      int value = key ? copy_in(d, from, p->value, k, depth + 1, nodes) : 0;
      if (!value || !yaml_document_append_mapping_pair(&d->yaml, copy, key, value)) return 0;
    }
  }
  return copy;
}

/* A value that starts like YAML's brackets or quotes is YAML; anything else is taken as it stands.
 */
static int parse_value(struct case_doc *d, size_t k, const char *text) {
  if (!*text || !strchr("[{\"'", *text))
    return add_scalar(d, text, strlen(text), YAML_ANY_SCALAR_STYLE, k);
  struct problems unheard = {0};
  struct case_doc value;
  size_t nodes = 0;
  int node = 0;
  if (case_doc_load(&value, text, strlen(text), &unheard))
    node = copy_in(d, &value.yaml, case_doc_root(&value), k, 0, &nodes);
  case_doc_destroy(&value);
  problems_destroy(&unheard);
  return node;
}

/* A copy of a list or mapping with the same items, so that changing it does not reach what an alias
 * elsewhere in the file shows. */
static int copy_shallow(struct case_doc *d, int node) {
  yaml_node_t *n = yaml_document_get_node(&d->yaml, node);
  yaml_mark_t at = n->start_mark;
  bool list = n->type == YAML_SEQUENCE_NODE;
  int copy = list ? yaml_document_add_sequence(&d->yaml, NULL, n->data.sequence.style)
                  : yaml_document_add_mapping(&d->yaml, NULL, n->data.mapping.style);
  if (!copy) return 0;
  n = yaml_document_get_node(&d->yaml, node); /* adding may have moved it */
  size_t items = list ? (size_t)(n->data.sequence.items.top - n->data.sequence.items.start)
                      : (size_t)(n->data.mapping.pairs.top - n->data.mapping.pairs.start);
  for (size_t i = 0; i < items; i++) {
    n = yaml_document_get_node(&d->yaml, node);
    yaml_node_pair_t *pair = list ? NULL : &n->data.mapping.pairs.start[i];
    if (!(list ? yaml_document_append_sequence_item(&d->yaml, copy, n->data.sequence.items.start[i])
               : yaml_document_append_mapping_pair(&d->yaml, copy, pair->key, pair->value)))
      return 0;
  }
  yaml_document_get_node(&d->yaml, copy)->start_mark = at;
  return copy;
}

/* The place in the document that holds a node: an item of a list or the value of a mapping. */
struct place {
  int holder; /* list or mapping; 0: the document itself */
  size_t index;
};

static void put(struct case_doc *d, struct place at, int node) {
  yaml_node_t *n = yaml_document_get_node(&d->yaml, at.holder);
  if (!n) return;
  if (n->type == YAML_SEQUENCE_NODE)
    n->data.sequence.items.start[at.index] = node;
  else
    n->data.mapping.pairs.start[at.index].value = node;
}

/* Finds the item of list `node` that `path` starts with: "NAME" (the longest that fits, since names
 * may hold dots) or "[i]". Returns how many bytes of the path that took, 0 when there is none. */
static size_t find_item(struct case_doc *d, int node, const char *path, size_t *index) {
  size_t n = case_doc_size(d, node), best = 0;
  if (*path == '[') {
    char *end;
    unsigned long i = strtoul(path + 1, &end, 10);
    if (end == path + 1 || *end != ']' || i >= n) return 0;
    *index = i;
    return (size_t)(end - path) + 1;
  }
  for (size_t i = 0; i < n; i++) {
    int item = case_doc_item(d, node, i);
    const char *name = case_doc_text(d, case_doc_member(d, item, "name"));
    if (!name) name = case_doc_text(d, case_doc_member(d, item, "solver")); /* the default name */
    size_t length = name ? strlen(name) : 0;
    if (length > best && !strncmp(path, name, length) && (!path[length] || path[length] == '.')) {
      best = length;
      *index = i;
    }
  }
  return best;
}

/* Finds or adds the key that `path` starts with in mapping `node`. Bytes taken, 0 on failure. */
static size_t find_key(struct case_doc *d, int node, const char *path, size_t k, size_t *index) {
  size_t length = strcspn(path, ".[");
  yaml_node_t *n = yaml_document_get_node(&d->yaml, node);
  yaml_node_pair_t *pairs = n->data.mapping.pairs.start;
  size_t count = (size_t)(n->data.mapping.pairs.top - pairs);
  if (!length) return 0;
  for (*index = 0; *index < count; ++*index) {
    const char *key = case_doc_text(d, pairs[*index].key);
    if (key && strlen(key) == length && !strncmp(key, path, length)) return length;
  }
  if (path[length] == '[') return 0; /* an item of a list that is not there */
  int key = add_scalar(d, path, length, YAML_ANY_SCALAR_STYLE, k);
  int value = mark(d, yaml_document_add_mapping(&d->yaml, NULL, YAML_ANY_MAPPING_STYLE), k);
  if (!key || !value || !yaml_document_append_mapping_pair(&d->yaml, node, key, value)) return 0;
  return length;
}

static void report_item(struct case_doc *d, size_t k, int list, const char *path) {
  char allowed[512] = "", found[96], shown[64];
  size_t n = case_doc_size(d, list);
  for (size_t i = 0; i < n && strlen(allowed) < sizeof allowed - 1; i++) {
    const char *name = case_doc_text(d, case_doc_member(d, case_doc_item(d, list, i), "name"));
    size_t at = strlen(allowed);
    if (name && case_name_fits(name))
      snprintf(allowed + at, sizeof allowed - at, "%s%s", i ? ", " : "", name);
    else
      snprintf(allowed + at, sizeof allowed - at, "%s[%zu]", i ? ", " : "", i);
  }
  case_quote(path, strcspn(path, "."), shown, sizeof shown);
  snprintf(found, sizeof found, "no item '%s' in the list", shown);
  case_doc_problem(d, -(int)k - 1, "", found, *allowed ? allowed : "nothing, the list is empty",
                   "correct the path");
}

static void report_key(struct case_doc *d, int line, const char *path) {
  char found[96], shown[64];
  case_quote(path, strcspn(path, ".["), shown, sizeof shown);
  snprintf(found, sizeof found, "no list '%s' in the case", shown);
  if (*shown)
    case_doc_problem(d, line, "", found, "items of a list that is there",
                     "set the list as a whole");
  else
    case_doc_problem(d, line, "", "an empty word in the path", "words joined by '.'",
                     "correct the path");
}

/* What `place` holds. */
static int get(struct case_doc *d, struct place at) {
  if (case_doc_is_list(d, at.holder)) return case_doc_item(d, at.holder, at.index);
  return yaml_document_get_node(&d->yaml, at.holder)->data.mapping.pairs.start[at.index].value;
}

/* From what `at` holds (no holder: the root) to the item or key that *path starts with, which is
 * taken off it. False with a problem when there is no such. */
static bool step(struct case_doc *d, size_t k, struct place *at, const char **path) {
  int line = -(int)k - 1, node = at->holder ? get(d, *at) : case_doc_root(d);
  if (yaml_document_get_node(&d->yaml, node)->type == YAML_SCALAR_NODE) {
    char found[64];
    case_doc_found(d, node, found);
    case_doc_problem(d, line, "", found, "a path to a key of a section or of a run",
                     "the path goes on behind a value: correct it");
    return false;
  }
  if (at->holder) { /* the root has no alias */
    node = copy_shallow(d, node);
    if (node) put(d, *at, node);
  }
  size_t taken = 0, index = 0;
  bool list = node && case_doc_is_list(d, node);
  if (list)
    taken = find_item(d, node, *path, &index);
  else if (node)
    taken = find_key(d, node, *path, k, &index);
  if (!taken && list) report_item(d, k, node, *path);
  if (!taken && !list) report_key(d, line, *path);
  *at = (struct place){node, index};
  *path += taken;
  if (**path == '.' && (*path)[1]) ++*path;
  return taken > 0;
}

void case_doc_set(struct case_doc *d, size_t k, const char *assignment) {
  const char *equals = strchr(assignment, '=');
  int line = -(int)k - 1;
  if (!equals || equals == assignment) {
    case_doc_problem(d, line, "", "no 'PATH=VALUE'", "runs.NAME.KEY=VALUE or SECTION.KEY=VALUE",
                     "");
    return;
  }
  int value = parse_value(d, k, equals + 1);
  if (!value) {
    case_doc_problem(d, line, "", "a value that is not YAML", "a number, a word, a text or a list",
                     "correct the brackets or quotes");
    return;
  }
  char *path = strndup(assignment, (size_t)(equals - assignment));
  if (!path) {
    d->problems->out_of_memory = true;
    return;
  }
  const char *rest = path;
  struct place at = {0, 0};
  while (*rest && step(d, k, &at, &rest)) continue;
  if (!*rest) put(d, at, value);
  free(path);
}

struct sink {
  char *text;
  size_t n, room;
};

static int sink_write(void *to, unsigned char *bytes, size_t size) {
  struct sink *s = to;
  if (array_grow(&s->text, &s->room, s->n + size + 1, "bytes of a case") != OK) return 0;
  memcpy(s->text + s->n, bytes, size);
  s->n += size;
  s->text[s->n] = 0;
  return 1;
}

enum status case_doc_emit(struct case_doc *d, char **text) {
  yaml_emitter_t emitter;
  struct sink sink = {0};
  CHECK(yaml_emitter_initialize(&emitter), ERR_MEMORY, "no memory to write the case");
  yaml_emitter_set_output(&emitter, sink_write, &sink);
  yaml_emitter_set_unicode(&emitter, 1);
  yaml_emitter_set_width(&emitter, -1);
  d->yaml.start_implicit = d->yaml.end_implicit = 1;
  int good = yaml_emitter_open(&emitter) && yaml_emitter_dump(&emitter, &d->yaml) &&
             yaml_emitter_close(&emitter);
  d->loaded = false; /* yaml_emitter_dump has deleted it */
  yaml_emitter_delete(&emitter);
  if (!good) free(sink.text);
  CHECK(good, ERR_MEMORY, "no memory to write the case");
  *text = sink.text;
  return OK;
}
