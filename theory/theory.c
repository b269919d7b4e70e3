#include "theory/theory.h"

#include <assert.h>
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "theory/topics.h"

#define X(name) extern const struct theory_topic theory_##name;
THEORY_TOPICS(X)
#undef X

const struct theory_topic *const theory_topics[] = {
#define X(name) &theory_##name,
    THEORY_TOPICS(X)
#undef X
        NULL};

const struct theory_topic *theory_topic_find(const char *name) {
  for (size_t i = 0; theory_topics[i]; i++)
    if (!strcmp(theory_topics[i]->name, name)) return theory_topics[i];
  return NULL;
}

const char *theory_topic_nearest(const char *name) {
  const char *names[THEORY_COUNT(theory_topics)];
  size_t n = 0;
  for (; theory_topics[n]; n++) names[n] = theory_topics[n]->name;
  return param_nearest(name, n, names);
}

double theory_between(double low, double high, int i, int n) {
  return i == n - 1 ? high : low + (high - low) * i / (n - 1);
}

/* ---- curves ---- */

static void fill_with_nan(double *value, size_t n) {
  for (size_t k = 0; k < n; k++) value[k] = NAN;
}

enum status theory_row_add(struct theory_curve *c, size_t n, const double *row) {
  size_t columns = c->topic->n_columns, room = c->room * columns;
  assert(n == columns);
  TRY(array_grow(&c->row, &room, (c->n + 1) * columns, "rows of theory"));
  c->room = room / columns;
  memcpy(c->row + c->n++ * columns, row, n * sizeof *row);
  return OK;
}

static enum status curve_create(const struct theory_topic *topic, struct theory_curve *c) {
  c->topic = topic;
  c->params = calloc(1, topic->params_size);
  CHECK(c->params, ERR_MEMORY, "no memory for the parameters of %s", topic->name);
  TRY(array_create(&c->value, topic->n_values, "values of theory"));
  fill_with_nan(c->value, topic->n_values);
  return OK;
}

void theory_result_destroy(struct theory_result *r) {
  for (size_t i = 0; r->curve && i < r->n; i++) {
    struct theory_curve *c = &r->curve[i];
    if (c->topic) params_release(c->topic->params, c->topic->n_params, c->params);
    free(c->params);
    free(c->row);
    free(c->value);
  }
  free(r->curve);
  *r = (struct theory_result){0};
}

/* ---- settings ---- */

static const char *setting_of(const struct param *p, size_t n,
                              const struct theory_setting *setting) {
  const char *text = p->value;
  for (size_t i = 0; i < n; i++)
    if (!strcmp(setting[i].key, p->key)) text = setting[i].text;
  return text;
}

static size_t items_in(const char *text) {
  size_t n = 1;
  for (; *text; text++) n += *text == ',';
  return n;
}

/* The k-th item of a list, without blanks around it. */
static void item_of(const char *text, size_t k, char *out, size_t size) {
  while (k--) text = strchr(text, ',') + 1;
  size_t n = strcspn(text, ",");
  for (; n && isspace((unsigned char)*text); n--) text++;
  while (n && isspace((unsigned char)text[n - 1])) n--;
  snprintf(out, size, "%.*s", (int)n, text);
}

static enum status param_set(const struct param *p, const char *item, void *params) {
  static const struct param_scales none = {NAN, NAN};
  char todo[160], allowed[512];
  if (!*p->value && !*item) return OK; /* optional, and not given */
  if (param_fill(p, item, &none, params, todo)) return OK;
  param_allowed(p, allowed, sizeof allowed);
  return status_raise(ERR_USAGE, "%s: found '%.60s'; allowed: %s%s%s", p->key, item, allowed,
                      *todo ? "; " : "", todo);
}

/* One combination of the items of all lists; the last parameter changes fastest. */
static enum status curve_set(struct theory_curve *c, size_t index, size_t n,
                             const struct theory_setting *setting) {
  const struct theory_topic *t = c->topic;
  for (size_t p = t->n_params; p-- > 0;) {
    const char *text = setting_of(&t->params[p], n, setting);
    size_t items = items_in(text);
    char item[128];
    item_of(text, index % items, item, sizeof item);
    index /= items;
    TRY(param_set(&t->params[p], item, c->params));
  }
  return OK;
}

static enum status curves_count(const struct theory_topic *topic, size_t n,
                                const struct theory_setting *setting, size_t *curves) {
  *curves = 1;
  for (size_t p = 0; p < topic->n_params; p++) {
    *curves *= items_in(setting_of(&topic->params[p], n, setting));
    CHECK(*curves <= THEORY_MOST_CURVES, ERR_USAGE,
          "%s: the lists make more than %d curves; give fewer values", topic->name,
          THEORY_MOST_CURVES);
  }
  return OK;
}

static enum status keys_check(const struct theory_topic *topic, size_t n,
                              const struct theory_setting *setting) {
  for (size_t i = 0; i < n; i++) {
    size_t p = 0;
    while (p < topic->n_params && strcmp(topic->params[p].key, setting[i].key) != 0) p++;
    CHECK(p < topic->n_params, ERR_USAGE, "%s has no parameter '%.60s'", topic->name,
          setting[i].key);
  }
  return OK;
}

const char *theory_param_word(const struct param *row, const void *params) {
  const char *member = (const char *)params + row->offset;
  const bool real = row->type == PARAM_REAL, whole = row->type == PARAM_INT;
  if (!row->choices || !(real || whole)) return NULL;
  const double value = real ? *(const double *)member : *(const int *)member;
  return value < 0 ? row->choices[(int)(-1 - value)] : NULL;
}

void theory_param_text(const struct theory_curve *c, size_t p, char *out, size_t size) {
  const struct param *row = &c->topic->params[p];
  const char *member = (const char *)c->params + row->offset;
  const char *word = theory_param_word(row, c->params);
  if (word) {
    snprintf(out, size, "%s", word);
    return;
  }
  switch (row->type) {
  case PARAM_REAL:
    snprintf(out, size, "%.10g", *(const double *)member);
    return;
  case PARAM_INT:
    snprintf(out, size, "%d", *(const int *)member);
    return;
  case PARAM_BOOL:
    snprintf(out, size, "%s", *(const bool *)member ? "true" : "false");
    return;
  case PARAM_CHOICE:
    snprintf(out, size, "%s", row->choices[*(const int *)member]);
    return;
  case PARAM_TEXT:
  case PARAM_NODE:
    break;
  }
  *out = 0;
}

bool theory_param_is_common(const struct theory_result *r, size_t p) {
  char first[64], other[64];
  theory_param_text(&r->curve[0], p, first, sizeof first);
  for (size_t i = 1; i < r->n; i++) {
    theory_param_text(&r->curve[i], p, other, sizeof other);
    if (strcmp(first, other) != 0) return false;
  }
  return true;
}

static void curves_name(struct theory_result *r) {
  for (size_t p = 0; p < r->topic->n_params; p++) {
    const struct param *row = &r->topic->params[p];
    if (theory_param_is_common(r, p)) continue;
    for (size_t i = 0; i < r->n; i++) {
      char value[64], *name = r->curve[i].name;
      size_t used = strlen(name), room = sizeof r->curve[i].name - used;
      theory_param_text(&r->curve[i], p, value, sizeof value);
      const char *between = used ? ", " : "";
      if (row->type == PARAM_CHOICE)
        snprintf(name + used, room, "%s%s", between, value);
      else
        snprintf(name + used, room, "%s%s = %s", between, row->key, value);
    }
  }
}

static enum status curves_evaluate(struct theory_result *r) {
  for (size_t i = 0; i < r->n; i++) {
    enum status status = r->topic->evaluate(r->curve[i].params, &r->curve[i]);
    if (status != OK && *r->curve[i].name) status_context(status, "%s: ", r->curve[i].name);
    TRY(status);
  }
  return OK;
}

/* Curves with their parameters, and no rows yet. */
static enum status curves_prepare(const struct theory_topic *topic, size_t n,
                                  const struct theory_setting *setting, struct theory_result *r) {
  *r = (struct theory_result){.topic = topic};
  TRY(keys_check(topic, n, setting));
  TRY(curves_count(topic, n, setting, &r->n));
  TRY(array_create(&r->curve, r->n, "curves of theory"));
  for (size_t i = 0; i < r->n; i++) {
    TRY(curve_create(topic, &r->curve[i]));
    TRY(curve_set(&r->curve[i], i, n, setting));
  }
  return OK;
}

enum status theory_check(const struct theory_topic *topic, size_t n,
                         const struct theory_setting *setting, size_t *curves) {
  struct theory_result r;
  const enum status status = curves_prepare(topic, n, setting, &r);
  *curves = r.n;
  theory_result_destroy(&r);
  return status;
}

enum status theory_evaluate(const struct theory_topic *topic, size_t n,
                            const struct theory_setting *setting, struct theory_result *r) {
  enum status status = curves_prepare(topic, n, setting, r);
  if (status == OK) {
    curves_name(r);
    status = curves_evaluate(r);
  }
  if (status != OK) theory_result_destroy(r);
  return status;
}
