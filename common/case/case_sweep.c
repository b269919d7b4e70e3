/* A run with `sweep` stands for as many as there are values in it. They take its place in the
 * document before anything is read of it, so that nothing else knows of sweeps. */
#include <string.h>

#include "common/case/case_draft.h"

/* One choice: as many pairs as there are keys. */
enum { MOST_KEYS = 16 };
struct choice {
  size_t n;
  yaml_node_pair_t pair[MOST_KEYS];
};

static size_t count_pairs(struct case_doc *d, int node) {
  yaml_node_t *n = yaml_document_get_node(&d->yaml, node);
  return (size_t)(n->data.mapping.pairs.top - n->data.mapping.pairs.start);
}

static yaml_node_pair_t pair_at(struct case_doc *d, int node, size_t i) {
  return yaml_document_get_node(&d->yaml, node)->data.mapping.pairs.start[i];
}

/* Takes the line of `of`, for messages. */
static int at_line(struct case_doc *d, int node, int of) {
  yaml_node_t *n = yaml_document_get_node(&d->yaml, node);
  if (n) n->start_mark = yaml_document_get_node(&d->yaml, of)->start_mark;
  return node;
}

static bool add_pair(struct case_doc *d, int mapping, int key, int value) {
  if (key && value && yaml_document_append_mapping_pair(&d->yaml, mapping, key, value)) return true;
  d->problems->out_of_memory = true;
  return false;
}

/* ---- names ---- */

struct name {
  size_t n;
  char text[CASE_LONGEST_NAME + 2]; /* one more than fits shows that it does not */
};

static void name_add(struct name *name, const char *text, size_t n) {
  for (size_t i = 0; i < n && name->n < sizeof name->text - 1; i++)
    if (text[i] != ' ') name->text[name->n++] = text[i];
  name->text[name->n] = 0;
}

/* What the choice has for a key of `n` bytes. */
static const char *chosen(struct case_doc *d, const struct choice *c, const char *key, size_t n) {
  for (size_t i = 0; i < c->n; i++) {
    const char *its = case_doc_text(d, c->pair[i].key);
    if (its && strlen(its) == n && !strncmp(its, key, n)) return case_doc_text(d, c->pair[i].value);
  }
  return NULL;
}

/* "{diffusion}-{resolution}" with the values in place of the keys. False with a problem. */
static bool name_fill(struct case_doc *d, const struct choice *c, const char *pattern, int node,
                      const char *path, struct name *name) {
  char key[CASE_PATH + 8], found[96], shown[48];
  for (const char *p = pattern; *p;) {
    const size_t plain = strcspn(p, "{"), inside = strcspn(p + plain, "}");
    name_add(name, p, plain);
    p += plain;
    if (!*p) break;
    const char *value = p[inside] ? chosen(d, c, p + 1, inside - 1) : NULL;
    if (!value) {
      case_quote(p, p[inside] ? inside + 1 : inside, shown, sizeof shown);
      snprintf(key, sizeof key, "%s.name", path);
      snprintf(found, sizeof found, "'%s'", shown);
      case_doc_problem(d, case_doc_line(d, node), key, found,
                       "a key of the sweep, of which every run has one value, in braces",
                       "correct it");
      return false;
    }
    name_add(name, value, strlen(value));
    p += inside + 1;
  }
  return true;
}

/* NAME-VALUE-VALUE, of a run without a name after its solver. */
static void name_join(struct case_doc *d, const struct choice *c, const char *base,
                      struct name *name) {
  name_add(name, base, strlen(base));
  for (size_t i = 0; i < c->n; i++) {
    const char *value = case_doc_text(d, c->pair[i].value);
    name_add(name, "-", 1);
    if (value) name_add(name, value, strlen(value));
  }
}

/* ---- runs ---- */

/* The run with one choice in place of the sweep; 0 with a problem. */
static int make_run(struct case_doc *d, int run, int sweep, const struct choice *c,
                    const char *path) {
  const int name_node = case_doc_member(d, run, "name");
  const char *pattern = case_doc_text(d, name_node);
  struct name name = {0};
  if (pattern && strchr(pattern, '{')) {
    if (!name_fill(d, c, pattern, name_node, path, &name)) return 0;
  } else {
    const char *solver = case_doc_text(d, case_doc_member(d, run, "solver"));
    name_join(d, c, pattern ? pattern : solver ? solver : "run", &name);
  }
  const int made = yaml_document_add_mapping(&d->yaml, NULL, YAML_FLOW_MAPPING_STYLE);
  bool good =
      made &&
      add_pair(d, made,
               yaml_document_add_scalar(&d->yaml, NULL, (const yaml_char_t *)"name", 4,
                                        YAML_ANY_SCALAR_STYLE),
               at_line(d,
                       yaml_document_add_scalar(&d->yaml, NULL, (const yaml_char_t *)name.text,
                                                (int)name.n, YAML_ANY_SCALAR_STYLE),
                       name_node ? name_node : sweep));
  for (size_t i = 0; good && i < count_pairs(d, run); i++) {
    const yaml_node_pair_t pair = pair_at(d, run, i);
    if (pair.value != sweep && pair.value != name_node)
      good = add_pair(d, made, pair.key, pair.value);
  }
  for (size_t i = 0; good && i < c->n; i++)
    good = add_pair(d, made, c->pair[i].key, c->pair[i].value);
  if (!good) d->problems->out_of_memory = true;
  return good ? at_line(d, made, run) : 0;
}

static bool append(struct case_doc *d, int list, int item) {
  if (item && yaml_document_append_sequence_item(&d->yaml, list, item)) return true;
  if (item) d->problems->out_of_memory = true;
  return false;
}

/* Keys that the sweep may have: none of the run's own, `name` and `sweep` among them. */
static bool check_key(struct case_doc *d, int run, int key, const char *path) {
  const char *text = case_doc_text(d, key);
  char full[CASE_PATH + 64], shown[48];
  if (!text || !(case_doc_member(d, run, text) || !strcmp(text, "name"))) return true;
  case_quote(text, strlen(text), shown, sizeof shown);
  snprintf(full, sizeof full, "%s.sweep.%s", path, shown);
  case_doc_problem(d, case_doc_line(d, key), full, "a key that the run has itself",
                   "keys of the run that it does not give", "remove one of them");
  return false;
}

static void refuse(struct case_doc *d, int node, const char *path, const char *key,
                   const char *allowed) {
  char found[64], full[CASE_PATH + 64];
  case_doc_found(d, node, found);
  if (case_doc_is_list(d, node) && !case_doc_size(d, node))
    snprintf(found, sizeof found, "an empty list");
  snprintf(full, sizeof full, "%s.sweep%s%.48s", path, *key ? "." : "", key);
  case_doc_problem(d, case_doc_line(d, node), full, found, allowed, "");
}

/* Every value of a key with every value of the others, those of the last key in a row. */
static void expand_product(struct case_doc *d, int run, int sweep, const char *path, int list) {
  const size_t keys = count_pairs(d, sweep);
  size_t all = 1;
  struct choice c = {.n = keys};
  if (keys == 0 || keys > MOST_KEYS) {
    refuse(d, sweep, path, "", "a mapping of 1 to 16 keys, each with a list of values");
    return;
  }
  for (size_t k = 0; k < keys; k++) {
    const yaml_node_pair_t pair = pair_at(d, sweep, k);
    const char *key = case_doc_text(d, pair.key);
    const size_t n = case_doc_size(d, pair.value);
    if (!check_key(d, run, pair.key, path)) return;
    if (n == 0) {
      refuse(d, pair.value, path, key ? key : "", "a list of values in brackets");
      return;
    }
    all = all > CASE_MOST_ITEMS ? all : all * n;
  }
  if (all > CASE_MOST_ITEMS) {
    char found[64], full[CASE_PATH + 8];
    snprintf(full, sizeof full, "%s.sweep", path);
    snprintf(found, sizeof found, "more than %d combinations", CASE_MOST_ITEMS);
    case_doc_problem(d, case_doc_line(d, sweep), full, found, "at most 1000 of them",
                     "leave values out");
    return;
  }
  for (size_t i = 0; i < all; i++) {
    size_t rest = i;
    for (size_t k = keys; k-- > 0;) {
      const yaml_node_pair_t pair = pair_at(d, sweep, k);
      const size_t n = case_doc_size(d, pair.value);
      c.pair[k] = (yaml_node_pair_t){pair.key, case_doc_item(d, pair.value, rest % n)};
      rest /= n;
    }
    if (!append(d, list, make_run(d, run, sweep, &c, path))) return;
  }
}

/* Each item of the sweep is what one run has. */
static void expand_list(struct case_doc *d, int run, int sweep, const char *path, int list) {
  for (size_t i = 0; i < case_doc_size(d, sweep); i++) {
    const int item = case_doc_item(d, sweep, i);
    struct choice c = {0};
    if (!case_doc_is_mapping(d, item) || count_pairs(d, item) == 0 ||
        count_pairs(d, item) > MOST_KEYS) {
      refuse(d, item, path, "", "a mapping of 1 to 16 keys with the values of one run");
      return;
    }
    for (; c.n < count_pairs(d, item); c.n++) {
      c.pair[c.n] = pair_at(d, item, c.n);
      if (!check_key(d, run, c.pair[c.n].key, path)) return;
    }
    if (!append(d, list, make_run(d, run, sweep, &c, path))) return;
  }
}

static void expand_run(struct case_doc *d, int run, size_t number, int list) {
  char path[CASE_PATH];
  const int sweep = case_doc_member(d, run, "sweep");
  if (!sweep) {
    append(d, list, run);
    return;
  }
  snprintf(path, sizeof path, "runs[%zu]", number);
  if (case_doc_is_mapping(d, sweep))
    expand_product(d, run, sweep, path, list);
  else if (case_doc_size(d, sweep))
    expand_list(d, run, sweep, path, list);
  else
    refuse(d, sweep, path, "",
           "a mapping of keys with lists of values, or a list of mappings with values");
}

static bool any_sweep(struct case_doc *d, int runs) {
  for (size_t i = 0; i < case_doc_size(d, runs); i++)
    if (case_doc_member(d, case_doc_item(d, runs, i), "sweep")) return true;
  return false;
}

bool case_sweep_expand(struct case_doc *d) {
  const int root = case_doc_root(d), runs = case_doc_member(d, root, "runs");
  const size_t faults = d->faults;
  if (!any_sweep(d, runs)) return true;
  const int list = yaml_document_add_sequence(&d->yaml, NULL, YAML_ANY_SEQUENCE_STYLE);
  if (!list) {
    d->problems->out_of_memory = true;
    return false;
  }
  at_line(d, list, runs);
  for (size_t i = 0; i < case_doc_size(d, runs); i++)
    expand_run(d, case_doc_item(d, runs, i), i, list);
  for (size_t i = 0; i < count_pairs(d, root); i++) {
    yaml_node_pair_t *pair = &yaml_document_get_node(&d->yaml, root)->data.mapping.pairs.start[i];
    if (pair->value == runs) pair->value = list;
  }
  return d->faults == faults;
}
