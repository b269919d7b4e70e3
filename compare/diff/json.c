#include <math.h>
#include <stdlib.h>

#include "compare/diff/write.h"
#include "compare/json_maker.h"

static json_t *count(size_t n) {
  return json_integer((json_int_t)n);
}

static json_t *text_or_null(const char *string) {
  return string ? cmp_json_text(string) : json_null();
}

/* What is not finite stands as a word beside `null`. */
static void set_real(struct cmp_json_maker *m, json_t *object, const char *key, double value) {
  char word[64];
  cmp_json_set(m, object, key, cmp_json_number(value));
  if (isfinite(value)) return;
  snprintf(word, sizeof word, "%s_is", key);
  cmp_json_set(m, object, word, json_string(isnan(value) ? "nan" : value > 0 ? "inf" : "-inf"));
}

static json_t *spot(struct cmp_json_maker *m, const struct result_quantity *q,
                    const struct result_spot *s, double scale) {
  json_t *o = json_object();
  set_real(m, o, "a", s->value[0]);
  set_real(m, o, "b", s->value[1]);
  cmp_json_set(m, o, "difference", cmp_json_number(s->difference));
  cmp_json_set(m, o, "t", cmp_json_number(s->time));
  cmp_json_set(m, o, "t_star", cmp_json_number(s->time / scale));
  cmp_json_set(m, o, "x", cmp_json_number(s->place[0]));
  cmp_json_set(m, o, "y", cmp_json_number(s->place[1]));
  if (q->rank) cmp_json_set(m, o, "row", count(s->row));
  if (q->rank == 2) cmp_json_set(m, o, "component", count(s->component));
  return o;
}

static json_t *quantity(struct cmp_json_maker *m, const struct result_diff *r,
                        const struct result_quantity *q) {
  json_t *o = json_object();
  const double since = q->differs ? result_quantity_since(q) : NAN;
  cmp_json_set(m, o, "name", cmp_json_text(q->name));
  cmp_json_set(m, o, "units", cmp_json_text(q->units));
  cmp_json_set(m, o, "outcome",
               json_string(q->differs   ? "differs"
                           : q->ignored ? "ignored"
                                        : "same"));
  if (q->ignored) return o;
  cmp_json_set(m, o, "values", count(q->n));
  cmp_json_set(m, o, "beyond", count(q->beyond));
  if (q->differs) {
    char *words = result_quantity_say(r, q);
    cmp_json_set(m, o, "says", cmp_json_text(words ? words : ""));
    free(words);
    cmp_json_set(m, o, "t", cmp_json_number(since));
    cmp_json_set(m, o, "t_star", cmp_json_number(since / r->time_scale));
  }
  if (!(q->worst.difference > 0)) return o;
  cmp_json_set(m, o, "scale", cmp_json_number(q->scale));
  cmp_json_set(m, o, "relative", cmp_json_number(cmp_diff_relative(q)));
  cmp_json_set(m, o, "allowed", cmp_json_number(q->allowed));
  cmp_json_set(m, o, "worst", spot(m, q, &q->worst, r->time_scale));
  if (q->beyond) cmp_json_set(m, o, "first", spot(m, q, &q->first, r->time_scale));
  return o;
}

static json_t *distances(struct cmp_json_maker *m, const struct cmp_diff_run *run) {
  json_t *array = json_array();
  for (size_t k = 0; k < run->n_distances; k++) {
    json_t *o = json_object();
    cmp_json_set(m, o, "t_star", cmp_json_number(run->distance[k].t));
    cmp_json_set(m, o, "mean_distance", cmp_json_number(run->distance[k].mean));
    cmp_json_set(m, o, "largest_distance", cmp_json_number(run->distance[k].largest));
    cmp_json_set(m, o, "area", cmp_json_number(run->distance[k].area));
    cmp_json_add(m, array, o);
  }
  return array;
}

static json_t *figure(struct cmp_json_maker *m, const struct cmp_figure *fig) {
  json_t *o = json_object();
  cmp_json_set(m, o, "name", cmp_json_text(fig->name));
  cmp_json_set(m, o, "caption", cmp_json_text(fig->caption));
  if (*fig->missing) cmp_json_set(m, o, "missing", cmp_json_text(fig->missing));
  return o;
}

static json_t *run_of(struct cmp_json_maker *m, const struct cmp_diff_run *run,
                      const struct cmp_figures *figures) {
  json_t *o = json_object(), *list = json_array(), *drawn = json_array();
  char *sentence = cmp_diff_run_sentence(run);
  cmp_json_set(m, o, "name", cmp_json_text(run->name));
  cmp_json_set(m, o, "a", text_or_null(run->path[0]));
  cmp_json_set(m, o, "b", text_or_null(run->path[1]));
  cmp_json_set(m, o, "outcome", json_string(cmp_diff_word(run->outcome)));
  cmp_json_set(m, o, "sentence", cmp_json_text(sentence ? sentence : ""));
  free(sentence);
  if (run->trouble) cmp_json_set(m, o, "trouble", cmp_json_text(run->trouble));
  for (size_t k = 0; k < run->n_figures; k++)
    cmp_json_add(m, drawn, figure(m, &figures->figure[run->first_figure + k]));
  for (size_t i = 0; run->d && i < run->d->n; i++)
    cmp_json_add(m, list, quantity(m, run->d, &run->d->quantity[i]));
  if (run->d) {
    const struct result_quantity *first = result_diff_first(run->d);
    const double since = first ? result_quantity_since(first) : NAN;
    cmp_json_set(m, o, "differ", count(run->d->n_differ));
    cmp_json_set(m, o, "same", count(run->d->n_same));
    cmp_json_set(m, o, "ignored", count(run->d->n_ignored));
    cmp_json_set(m, o, "t", cmp_json_number(since));
    cmp_json_set(m, o, "t_star", cmp_json_number(since / run->d->time_scale));
    cmp_json_set(m, o, "first", text_or_null(first ? first->name : NULL));
    cmp_json_set(m, o, "surfaces", distances(m, run));
  }
  cmp_json_set(m, o, "figures", drawn);
  if (run->pictures_missing)
    cmp_json_set(m, o, "figures_unavailable", cmp_json_text(run->pictures_missing));
  cmp_json_set(m, o, "quantities", list);
  return o;
}

json_t *cmp_diff_json(const struct cmp_diff *d, const struct cmp_figures *figures) {
  struct cmp_json_maker m = {true};
  json_t *root = json_object(), *runs = json_array();
  char *sentence = cmp_diff_sentence(d);
  cmp_json_set(&m, root, "format", json_string("plunge diff"));
  cmp_json_set(&m, root, "format_version", json_integer(1));
  cmp_json_set(&m, root, "a", cmp_json_text(d->path[0]));
  cmp_json_set(&m, root, "b", cmp_json_text(d->path[1]));
  cmp_json_set(&m, root, "outcome", json_string(cmp_diff_word(cmp_diff_outcome(d))));
  cmp_json_set(&m, root, "sentence", cmp_json_text(sentence ? sentence : ""));
  free(sentence);
  for (size_t i = 0; i < d->n; i++) cmp_json_add(&m, runs, run_of(&m, &d->run[i], figures));
  cmp_json_set(&m, root, "runs", runs);
  if (m.ok) return root;
  json_decref(root);
  return NULL;
}
