#include <jansson.h>
#include <math.h>

#include "revision.h"
#include "theory/theory.h"

/* jansson takes a NULL value as a failure and frees what it was given: a failure anywhere makes
 * the whole NULL or incomplete, which `ok` remembers. */
struct maker {
  bool ok;
};

static void set(struct maker *m, json_t *object, const char *key, json_t *value) {
  if (json_object_set_new(object, key, value) != 0) m->ok = false;
}

static void add(struct maker *m, json_t *array, json_t *value) {
  if (json_array_append_new(array, value) != 0) m->ok = false;
}

static json_t *number(double value) {
  return isfinite(value) ? json_real(value) : json_null();
}

static json_t *described(struct maker *m, const char *unit, const char *help) {
  json_t *object = json_object();
  set(m, object, "unit", json_string(unit));
  set(m, object, "help", json_string(help));
  return object;
}

static json_t *param_value(const struct param *row, const void *params) {
  const char *member = (const char *)params + row->offset;
  const char *word = theory_param_word(row, params);
  if (word) return json_string(word);
  switch (row->type) {
  case PARAM_REAL:
    return number(*(const double *)member);
  case PARAM_INT:
    return json_integer(*(const int *)member);
  case PARAM_BOOL:
    return json_boolean(*(const bool *)member);
  case PARAM_CHOICE:
    return json_string(row->choices[*(const int *)member]);
  case PARAM_TEXT:
  case PARAM_NODE:
    break;
  }
  return json_null();
}

static json_t *curve_object(struct maker *m, const struct theory_curve *c) {
  const struct theory_topic *t = c->topic;
  json_t *object = json_object(), *params = json_object(), *values = json_object(),
         *rows = json_object();
  set(m, object, "name", json_string(c->name));
  for (size_t p = 0; p < t->n_params; p++)
    set(m, params, t->params[p].key, param_value(&t->params[p], c->params));
  for (size_t k = 0; k < t->n_values; k++) set(m, values, t->values[k].key, number(c->value[k]));
  for (size_t k = 0; k < t->n_columns; k++) {
    json_t *column = json_array();
    for (size_t i = 0; i < c->n; i++) add(m, column, number(c->row[i * t->n_columns + k]));
    set(m, rows, t->columns[k].key, column);
  }
  set(m, object, "parameters", params);
  set(m, object, "values", values);
  set(m, object, "columns", rows);
  return object;
}

static json_t *result_object(struct maker *m, const struct theory_result *r) {
  json_t *object = json_object(), *columns = json_object(), *values = json_object(),
         *curves = json_array();
  const struct theory_topic *t = r->topic;
  set(m, object, "plunge", json_string(PLUNGE_VERSION " (" PLUNGE_REVISION ")"));
  set(m, object, "topic", json_string(t->name));
  set(m, object, "help", json_string(t->help));
  for (size_t k = 0; k < t->n_columns; k++)
    set(m, columns, t->columns[k].key, described(m, t->columns[k].unit, t->columns[k].help));
  for (size_t k = 0; k < t->n_values; k++)
    set(m, values, t->values[k].key, described(m, t->values[k].unit, t->values[k].help));
  for (size_t i = 0; i < r->n; i++) add(m, curves, curve_object(m, &r->curve[i]));
  set(m, object, "columns", columns);
  set(m, object, "values", values);
  set(m, object, "curves", curves);
  return object;
}

enum status theory_write_json(const struct theory_result *r, FILE *out) {
  struct maker m = {true};
  json_t *object = result_object(&m, r);
  bool made = object && m.ok;
  if (made) {
    m.ok = json_dumpf(object, out, JSON_INDENT(1)) == 0;
    fputc('\n', out);
  }
  json_decref(object);
  CHECK(made, ERR_MEMORY, "no memory for the numbers of %s", r->topic->name);
  CHECK(m.ok, ERR_IO, "cannot write the numbers of %s", r->topic->name);
  return OK;
}
