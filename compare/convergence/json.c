#include "compare/convergence/json.h"

#include <stdint.h>

#include "compare/chart.h"

/* ---- rows ---- */

static void set_triple(struct maker *m, json_t *object, const struct cmp_triple *t) {
  set(m, object, "trend", t ? text(cmp_trend_names[t->trend]) : json_null());
  set(m, object, "order", number(t ? t->order : NAN));
  set(m, object, "richardson", number(t ? t->limit : NAN));
  set(m, object, "gci", number(t ? t->gci : NAN));
  set(m, object, "error_bar", number(t ? t->bar : NAN));
}

static json_t *values(struct maker *m, const struct cmp_group *g,
                      const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < g->n; i++) add(m, array, number(row->value[i].value));
  return array;
}

static json_t *reasons(struct maker *m, const struct cmp_group *g,
                       const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < g->n; i++)
    add(m, array, cmp_known(&row->value[i]) ? json_null() : text(row->value[i].why));
  return array;
}

static json_t *error_orders(struct maker *m, const struct cmp_group *g,
                            const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i + 1 < g->n; i++)
    add(m, array, number(cmp_error_order(&g->spacing[i], &row->error[i])));
  return array;
}

static json_t *triples(struct maker *m, const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < row->n_triples; i++) {
    json_t *object = json_object(), *runs = json_array();
    for (int k = 0; k < 3; k++) add(m, runs, json_integer((json_int_t)row->triple[i].member[k]));
    set(m, object, "runs", runs);
    set_triple(m, object, &row->triple[i].triple);
    add(m, array, object);
  }
  return array;
}

static json_t *row_of(struct maker *m, const struct comparison *c, const struct cmp_group *g,
                      const struct cmp_row_of_group *row) {
  const struct cmp_neighbours *finest = cmp_row_finest(row);
  char says[400];
  json_t *object = json_object();
  cmp_row_say(g, row, says, sizeof says);
  set(m, object, "name", text(row->name));
  set(m, object, "of", row->of ? text(row->of) : json_null());
  set(m, object, "section", text(cmp_section_name(row->section)));
  set(m, object, "units", text(row->units));
  set(m, object, "t_star", row->time == SIZE_MAX ? json_null() : number(c->times[row->time]));
  set(m, object, "is_difference", json_boolean(row->is_difference));
  set(m, object, "values", values(m, g, row));
  set(m, object, "values_unavailable", reasons(m, g, row));
  set(m, object, "known_to", numbers(m, row->known_to, g->n));
  set(m, object, "errors", numbers(m, row->error, g->n));
  set(m, object, "error_orders", error_orders(m, g, row));
  set(m, object, "triples", triples(m, row));
  set_triple(m, object, finest ? &finest->triple : NULL);
  set(m, object, "says", text(says));
  return object;
}

/* ---- groups ---- */

static json_t *group_of(struct maker *m, const struct comparison *c, const struct cmp_group *g) {
  json_t *object = json_object(), *runs = json_array(), *seconds = json_array();
  json_t *evaluations = json_array(), *left_out = json_array(), *rows = json_array();
  json_t *reference = json_null();
  for (size_t i = 0; i < g->n; i++) {
    add(m, runs, text(cmp_run_or_ref(c, g->member[i])->data.label));
    add(m, seconds, number(cmp_member_seconds(c, g->member[i])));
    add(m, evaluations, number(cmp_member_evaluations(c, g->member[i])));
    if (g->member[i] == SIZE_MAX) reference = json_integer((json_int_t)i);
  }
  for (size_t i = 0; i < g->n_left_out; i++) {
    json_t *out = json_object();
    set(m, out, "run", text(cmp_run_or_ref(c, g->left_out[i].run)->data.label));
    set(m, out, "why", text(g->left_out[i].why));
    add(m, left_out, out);
  }
  for (size_t k = 0; k < g->n_rows; k++) add(m, rows, row_of(m, c, g, &g->row[k]));
  set(m, object, "name", text(g->name));
  set(m, object, "solver", text(cmp_run_or_ref(c, g->member[0])->data.file->solver));
  set(m, object, "settings", g->settings ? text(g->settings) : json_null());
  set(m, object, "runs", runs);
  set(m, object, "spacing", numbers(m, g->spacing, g->n));
  set(m, object, "wall_time_s", seconds);
  set(m, object, "evaluations", evaluations);
  set(m, object, "reference", reference);
  set(m, object, "left_out", left_out);
  set(m, object, "rows", rows);
  return object;
}

json_t *cmp_convergence_json(struct maker *m, const struct comparison *c,
                             const struct cmp_convergence *v) {
  json_t *array = json_array();
  for (size_t i = 0; i < v->n; i++) add(m, array, group_of(m, c, &v->group[i]));
  return array;
}
