#include "gallery/json.h"

#include <string.h>

#include "compare/json_maker.h"

static void set_text(struct cmp_json_maker *m, json_t *object, const char *key, const char *text) {
  if (text) cmp_json_set(m, object, key, cmp_json_text(text));
}

static json_t *check_json(struct cmp_json_maker *m, const struct gallery_check *c,
                          const struct gallery_answer *a) {
  json_t *o = json_object();
  set_text(m, o, "says", c->says);
  set_text(m, o, "value", c->value);
  set_text(m, o, "of", gallery_origin_names[c->of]);
  set_text(m, o, "source", c->source);
  set_text(m, o, "equals", c->equals);
  set_text(m, o, "above", c->above);
  set_text(m, o, "below", c->below);
  set_text(m, o, "because", c->because);
  if (a->left) {
    cmp_json_set(m, o, "left_out", json_true());
    return o;
  }
  cmp_json_set(m, o, "measured", cmp_json_number(a->value));
  if (c->equals) {
    cmp_json_set(m, o, "expected", cmp_json_number(a->expected));
    cmp_json_set(m, o, "tolerance", cmp_json_number(a->tolerance));
  }
  cmp_json_set(m, o, "low", cmp_json_number(a->low));
  cmp_json_set(m, o, "high", cmp_json_number(a->high));
  if (c->scatter) cmp_json_set(m, o, "scatter", cmp_json_number(a->scatter));
  cmp_json_set(m, o, "holds", json_boolean(a->holds));
  cmp_json_set(m, o, "as_expected", json_boolean(gallery_answer_is_expected(c, a)));
  if (*a->failure) set_text(m, o, "failure", a->failure);
  return o;
}

struct listing {
  struct cmp_json_maker *m;
  json_t *runs;
};

static enum status list_run(void *data, const char *run) {
  const struct listing *l = data;
  size_t i;
  json_t *known;
  json_array_foreach(l->runs, i, known) if (!strcmp(json_string_value(known), run)) return OK;
  cmp_json_add(l->m, l->runs, cmp_json_text(run));
  return OK;
}

enum status gallery_json_entry(const struct gallery_entry *e, const struct gallery_answer *answer,
                               json_t **out) {
  struct cmp_json_maker m = {true};
  json_t *o = json_object(), *remarks = json_array(), *checks = json_array();
  const enum gallery_verdict verdict = gallery_verdict_of(e, answer);
  set_text(&m, o, "id", e->id);
  set_text(&m, o, "key", e->key);
  set_text(&m, o, "document", *e->id == 'P' ? "P" : "T");
  set_text(&m, o, "title", e->title);
  set_text(&m, o, "where", e->where);
  set_text(&m, o, "kind", gallery_kind_names[e->kind]);
  cmp_json_set(&m, o, "corrected", json_boolean(e->corrected));
  set_text(&m, o, "setup", e->setup);
  for (size_t i = 0; i < e->n_remarks; i++)
    cmp_json_add(&m, remarks, cmp_json_text(e->remarks[i]));
  cmp_json_set(&m, o, "remarks", remarks);
  set_text(&m, o, "verdict", gallery_verdict_names[verdict]);
  set_text(&m, o, "verdict_words", gallery_verdict_words[verdict]);
  cmp_json_set(&m, o, "as_expected", json_boolean(gallery_is_expected(e, answer)));
  for (size_t i = 0; i < e->n_checks; i++)
    cmp_json_add(&m, checks, check_json(&m, &e->checks[i], &answer[i]));
  cmp_json_set(&m, o, "checks", checks);
  struct listing listing = {&m, json_array()};
  const enum status status = gallery_entry_runs(e, list_run, &listing);
  cmp_json_set(&m, o, "runs", listing.runs);
  *out = o;
  if (status == OK && m.ok) return OK;
  json_decref(o);
  *out = NULL;
  return status_raise(ERR_MEMORY, "no memory for the gallery");
}

const char *gallery_text(const json_t *object, const char *key) {
  const char *text = json_string_value(json_object_get(object, key));
  return text ? text : "";
}

bool gallery_is_true(const json_t *object, const char *key) {
  return json_is_true(json_object_get(object, key));
}

enum gallery_verdict gallery_json_verdict(const json_t *entry) {
  const char *name = gallery_text(entry, "verdict");
  int k = 0;
  while (k + 1 < GALLERY_N_VERDICTS && strcmp(gallery_verdict_names[k], name)) k++;
  return (enum gallery_verdict)k;
}

struct gallery_tally gallery_json_tally(const json_t *entry) {
  struct gallery_tally t = {0};
  size_t i;
  json_t *check;
  if (!*gallery_text(entry, "verdict") || gallery_json_verdict(entry) == GALLERY_VERDICT_failed)
    return t;
  json_array_foreach(json_object_get(entry, "checks"), i, check) {
    t.checks += !gallery_is_true(check, "left_out");
    t.hold += gallery_is_true(check, "holds");
  }
  t.changed = t.checks > 0 && !gallery_is_true(entry, "as_expected");
  return t;
}
