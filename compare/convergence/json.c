#include "compare/convergence/json.h"

#include <stdint.h>

#include "compare/chart.h"

/* ---- rows ---- */

static void set_triple(struct cmp_json_maker *m, json_t *object, const struct cmp_triple *t) {
  cmp_json_set(m, object, "trend", t ? cmp_json_text(cmp_trend_names[t->trend]) : json_null());
  cmp_json_set(m, object, "order", cmp_json_number(t ? t->order : NAN));
  cmp_json_set(m, object, "richardson", cmp_json_number(t ? t->limit : NAN));
  cmp_json_set(m, object, "gci", cmp_json_number(t ? t->gci : NAN));
  cmp_json_set(m, object, "error_bar", cmp_json_number(t ? t->bar : NAN));
}

static json_t *values(struct cmp_json_maker *m, const struct cmp_group *g,
                      const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < g->n; i++) cmp_json_add(m, array, cmp_json_number(row->value[i].value));
  return array;
}

static json_t *reasons(struct cmp_json_maker *m, const struct cmp_group *g,
                       const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < g->n; i++)
    cmp_json_add(m, array,
                 cmp_known(&row->value[i]) ? json_null() : cmp_json_text(row->value[i].why));
  return array;
}

static json_t *error_orders(struct cmp_json_maker *m, const struct cmp_group *g,
                            const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i + 1 < g->n; i++)
    cmp_json_add(m, array, cmp_json_number(cmp_error_order(&g->spacing[i], &row->error[i])));
  return array;
}

static json_t *triples(struct cmp_json_maker *m, const struct cmp_row_of_group *row) {
  json_t *array = json_array();
  for (size_t i = 0; i < row->n_triples; i++) {
    json_t *object = json_object(), *runs = json_array();
    for (int k = 0; k < 3; k++)
      cmp_json_add(m, runs, json_integer((json_int_t)row->triple[i].member[k]));
    cmp_json_set(m, object, "runs", runs);
    set_triple(m, object, &row->triple[i].triple);
    cmp_json_add(m, array, object);
  }
  return array;
}

static json_t *row_of(struct cmp_json_maker *m, const struct comparison *c,
                      const struct cmp_group *g, const struct cmp_row_of_group *row) {
  const struct cmp_neighbours *finest = cmp_row_finest(row);
  char says[400];
  json_t *object = json_object();
  cmp_row_say(g, row, says, sizeof says);
  cmp_json_set(m, object, "name", cmp_json_text(row->name));
  cmp_json_set(m, object, "of", row->of ? cmp_json_text(row->of) : json_null());
  cmp_json_set(m, object, "section", cmp_json_text(cmp_section_name(row->section)));
  cmp_json_set(m, object, "units", cmp_json_text(row->units));
  cmp_json_set(m, object, "t_star",
               row->time == SIZE_MAX ? json_null() : cmp_json_number(c->times[row->time]));
  cmp_json_set(m, object, "is_difference", json_boolean(row->is_difference));
  cmp_json_set(m, object, "values", values(m, g, row));
  cmp_json_set(m, object, "values_unavailable", reasons(m, g, row));
  cmp_json_set(m, object, "known_to", cmp_json_numbers(m, row->known_to, g->n));
  cmp_json_set(m, object, "errors", cmp_json_numbers(m, row->error, g->n));
  cmp_json_set(m, object, "error_orders", error_orders(m, g, row));
  cmp_json_set(m, object, "triples", triples(m, row));
  set_triple(m, object, finest ? &finest->triple : NULL);
  cmp_json_set(m, object, "says", cmp_json_text(says));
  return object;
}

/* ---- groups ---- */

static json_t *group_of(struct cmp_json_maker *m, const struct comparison *c,
                        const struct cmp_group *g) {
  json_t *object = json_object(), *runs = json_array(), *seconds = json_array();
  json_t *evaluations = json_array(), *left_out = json_array(), *rows = json_array();
  json_t *reference = json_null();
  for (size_t i = 0; i < g->n; i++) {
    cmp_json_add(m, runs, cmp_json_text(cmp_run_or_ref(c, g->member[i])->data.label));
    cmp_json_add(m, seconds, cmp_json_number(cmp_member_seconds(c, g->member[i])));
    cmp_json_add(m, evaluations, cmp_json_number(cmp_member_evaluations(c, g->member[i])));
    if (g->member[i] == SIZE_MAX) reference = json_integer((json_int_t)i);
  }
  for (size_t i = 0; i < g->n_left_out; i++) {
    json_t *out = json_object();
    cmp_json_set(m, out, "run", cmp_json_text(cmp_run_or_ref(c, g->left_out[i].run)->data.label));
    cmp_json_set(m, out, "why", cmp_json_text(g->left_out[i].why));
    cmp_json_add(m, left_out, out);
  }
  for (size_t k = 0; k < g->n_rows; k++) cmp_json_add(m, rows, row_of(m, c, g, &g->row[k]));
  cmp_json_set(m, object, "name", cmp_json_text(g->name));
  cmp_json_set(m, object, "solver",
               cmp_json_text(cmp_run_or_ref(c, g->member[0])->data.file->solver));
  cmp_json_set(m, object, "settings", g->settings ? cmp_json_text(g->settings) : json_null());
  cmp_json_set(m, object, "runs", runs);
  cmp_json_set(m, object, "spacing", cmp_json_numbers(m, g->spacing, g->n));
  cmp_json_set(m, object, "wall_time_s", seconds);
  cmp_json_set(m, object, "evaluations", evaluations);
  cmp_json_set(m, object, "reference", reference);
  cmp_json_set(m, object, "left_out", left_out);
  cmp_json_set(m, object, "rows", rows);
  return object;
}

json_t *cmp_convergence_json(struct cmp_json_maker *m, const struct comparison *c,
                             const struct cmp_convergence *v) {
  json_t *array = json_array();
  for (size_t i = 0; i < v->n; i++) cmp_json_add(m, array, group_of(m, c, &v->group[i]));
  return array;
}
