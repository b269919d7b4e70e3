#include <math.h>
#include <stdlib.h>

#include "compare/diff/write.h"
#include "compare/json_maker.h"

static json_t *count(size_t n) {
  return json_integer((json_int_t)n);
}

static json_t *text_or_null(const char *string) {
  return string ? text(string) : json_null();
}

/* What is not finite stands as a word beside `null`. */
static void set_real(struct maker *m, json_t *object, const char *key, double value) {
  char word[64];
  set(m, object, key, number(value));
  if (isfinite(value)) return;
  snprintf(word, sizeof word, "%s_is", key);
  set(m, object, word, json_string(isnan(value) ? "nan" : value > 0 ? "inf" : "-inf"));
}

static json_t *spot(struct maker *m, const struct result_quantity *q, const struct result_spot *s,
                    double scale) {
  json_t *o = json_object();
  set_real(m, o, "a", s->value[0]);
  set_real(m, o, "b", s->value[1]);
  set(m, o, "difference", number(s->difference));
  set(m, o, "t", number(s->time));
  set(m, o, "t_star", number(s->time / scale));
  set(m, o, "x", number(s->place[0]));
  set(m, o, "y", number(s->place[1]));
  if (q->rank) set(m, o, "row", count(s->row));
  if (q->rank == 2) set(m, o, "component", count(s->component));
  return o;
}

static json_t *quantity(struct maker *m, const struct result_diff *r,
                        const struct result_quantity *q) {
  json_t *o = json_object();
  const double since = q->differs ? result_quantity_since(q) : NAN;
  set(m, o, "name", text(q->name));
  set(m, o, "units", text(q->units));
  set(m, o, "outcome", json_string(q->differs ? "differs" : q->ignored ? "ignored" : "same"));
  if (q->ignored) return o;
  set(m, o, "values", count(q->n));
  set(m, o, "beyond", count(q->beyond));
  if (q->differs) {
    char *words = result_quantity_say(r, q);
    set(m, o, "says", text(words ? words : ""));
    free(words);
    set(m, o, "t", number(since));
    set(m, o, "t_star", number(since / r->time_scale));
  }
  if (!(q->worst.difference > 0)) return o;
  set(m, o, "scale", number(q->scale));
  set(m, o, "relative", number(cmp_diff_relative(q)));
  set(m, o, "allowed", number(q->allowed));
  set(m, o, "worst", spot(m, q, &q->worst, r->time_scale));
  if (q->beyond) set(m, o, "first", spot(m, q, &q->first, r->time_scale));
  return o;
}

static json_t *distances(struct maker *m, const struct cmp_diff_run *run) {
  json_t *array = json_array();
  for (size_t k = 0; k < run->n_distances; k++) {
    json_t *o = json_object();
    set(m, o, "t_star", number(run->distance[k].t));
    set(m, o, "mean_distance", number(run->distance[k].mean));
    set(m, o, "largest_distance", number(run->distance[k].largest));
    set(m, o, "area", number(run->distance[k].area));
    add(m, array, o);
  }
  return array;
}

static json_t *figure(struct maker *m, const struct cmp_figure *fig) {
  json_t *o = json_object();
  set(m, o, "name", text(fig->name));
  set(m, o, "caption", text(fig->caption));
  if (*fig->missing) set(m, o, "missing", text(fig->missing));
  return o;
}

static json_t *run_of(struct maker *m, const struct cmp_diff_run *run,
                      const struct cmp_figures *figures) {
  json_t *o = json_object(), *list = json_array(), *drawn = json_array();
  char *sentence = cmp_diff_run_sentence(run);
  set(m, o, "name", text(run->name));
  set(m, o, "a", text_or_null(run->path[0]));
  set(m, o, "b", text_or_null(run->path[1]));
  set(m, o, "outcome", json_string(cmp_diff_word(run->outcome)));
  set(m, o, "sentence", text(sentence ? sentence : ""));
  free(sentence);
  if (run->trouble) set(m, o, "trouble", text(run->trouble));
  for (size_t k = 0; k < run->n_figures; k++)
    add(m, drawn, figure(m, &figures->figure[run->first_figure + k]));
  for (size_t i = 0; run->d && i < run->d->n; i++)
    add(m, list, quantity(m, run->d, &run->d->quantity[i]));
  if (run->d) {
    const struct result_quantity *first = result_diff_first(run->d);
    const double since = first ? result_quantity_since(first) : NAN;
    set(m, o, "differ", count(run->d->n_differ));
    set(m, o, "same", count(run->d->n_same));
    set(m, o, "ignored", count(run->d->n_ignored));
    set(m, o, "t", number(since));
    set(m, o, "t_star", number(since / run->d->time_scale));
    set(m, o, "first", text_or_null(first ? first->name : NULL));
    set(m, o, "surfaces", distances(m, run));
  }
  set(m, o, "figures", drawn);
  if (run->pictures_missing) set(m, o, "figures_unavailable", text(run->pictures_missing));
  set(m, o, "quantities", list);
  return o;
}

json_t *cmp_diff_json(const struct cmp_diff *d, const struct cmp_figures *figures) {
  struct maker m = {true};
  json_t *root = json_object(), *runs = json_array();
  char *sentence = cmp_diff_sentence(d);
  set(&m, root, "format", json_string("plunge diff"));
  set(&m, root, "format_version", json_integer(1));
  set(&m, root, "a", text(d->path[0]));
  set(&m, root, "b", text(d->path[1]));
  set(&m, root, "outcome", json_string(cmp_diff_word(cmp_diff_outcome(d))));
  set(&m, root, "sentence", text(sentence ? sentence : ""));
  free(sentence);
  for (size_t i = 0; i < d->n; i++) add(&m, runs, run_of(&m, &d->run[i], figures));
  set(&m, root, "runs", runs);
  if (m.ok) return root;
  json_decref(root);
  return NULL;
}
