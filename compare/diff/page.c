/* The page: a static one that needs no script, in a template whose script shows all quantities. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/diff/write.h"
#include "compare/markup.h"
#include "compare/picture.h"
#include "embed/cmp_diff_template.h"

enum { MOST_ROWS = 60, MOST_RUNS = 200 }; /* of what stands in the page without a script */

struct content { /* what the page is written from */
  const struct cmp_diff *d;
  const struct cmp_figures *figures;
  const json_t *json;
};

/* ---- tables ---- */

static const char *class_of(enum cmp_diff_outcome outcome) {
  static const char *const class[] = {"same", "differs", "only", "only", "trouble"};
  return class[outcome];
}

static void number(struct markup *p, int digits, double value) {
  char text[48] = "-";
  if (isfinite(value)) snprintf(text, sizeof text, "%.*g", digits, value);
  cmp_markup_element(p, "td", NULL, "%s", text);
}

static void run_link(struct markup *p, const struct cmp_diff *d, size_t k) {
  char href[32];
  cmp_markup_open(p, "td", "t");
  if (d->run[k].outcome == CMP_DIFF_DIFFERS) {
    snprintf(href, sizeof href, "#run-%zu", k + 1);
    cmp_markup_open(p, "a", NULL);
    cmp_markup_attribute(p, "href", href);
    cmp_markup_text(p, d->run[k].name);
    cmp_markup_close(p);
  } else {
    cmp_markup_text(p, d->run[k].name);
  }
  cmp_markup_close(p);
}

static void run_row(struct markup *p, const struct cmp_diff *d, size_t k) {
  const struct cmp_diff_run *run = &d->run[k];
  char *sentence = cmp_diff_run_sentence(run);
  cmp_markup_open(p, "tr", NULL);
  run_link(p, d, k);
  cmp_markup_open(p, "td", "t");
  cmp_markup_element(p, "b", class_of(run->outcome), "%s", cmp_diff_word(run->outcome));
  cmp_markup_close(p);
  cmp_markup_element(p, "td", "w", "%s", sentence && (run->d || run->trouble) ? sentence : "");
  cmp_markup_close(p);
  free(sentence);
}

static void runs_table(struct markup *p, const struct cmp_diff *d) {
  static const char *const head[] = {"run", "outcome", "what", NULL};
  size_t shown = 0;
  cmp_markup_element(p, "h2", NULL, "Runs");
  cmp_markup_table(p, NULL, 3, head);
  for (int same = 0; same < 2; same++) /* what differs comes first */
    for (size_t k = 0; k < d->n; k++) {
      if ((d->run[k].outcome == CMP_DIFF_SAME) != same || shown == MOST_RUNS) continue;
      run_row(p, d, k);
      shown++;
    }
  cmp_markup_table_close(p);
  if (shown < d->n)
    cmp_markup_element(p, "p", "soft", "%zu more are in diff.json and diff.xml.", d->n - shown);
}

static void quantity_row(struct markup *p, const struct cmp_diff_run *run,
                         const struct result_quantity *q) {
  char *says = result_quantity_say(run->d, q);
  const double since = result_quantity_since(q);
  cmp_markup_open(p, "tr", NULL);
  cmp_markup_element(p, "td", "t", "%s", q->name);
  number(p, 6, since);
  number(p, 4, since / run->d->time_scale);
  number(p, 3, q->beyond ? q->worst.difference : NAN);
  cmp_markup_element(p, "td", "t", "%s", q->units);
  number(p, 3, q->beyond ? cmp_diff_relative(q) : NAN);
  cmp_markup_element(p, "td", "w", "%s", says ? says : "");
  cmp_markup_close(p);
  free(says);
}

static enum status quantities_table(struct markup *p, const struct cmp_diff_run *run) {
  static const char *const head[] = {"quantity", "since t (s)", "t*",   "difference",
                                     "units",    "relative",    "what", NULL};
  const struct result_quantity **q;
  size_t n;
  TRY(cmp_diff_order(run, &n, &q));
  cmp_markup_element(p, "h3", NULL, "What differs, the first in time first");
  cmp_markup_table(p, NULL, 1, head);
  for (size_t i = 0; i < n && i < MOST_ROWS; i++) quantity_row(p, run, q[i]);
  cmp_markup_table_close(p);
  if (n > MOST_ROWS)
    cmp_markup_element(p, "p", "soft", "%zu more are in the table of all quantities and diff.json.",
                       n - MOST_ROWS);
  free(q);
  return OK;
}

/* ---- pictures ---- */

static enum status picture(struct markup *p, const struct cmp_figures *figures,
                           const struct cmp_figure *fig) {
  cmp_markup_open(p, "figure", NULL);
  if (*fig->missing) {
    cmp_markup_element(p, "p", "soft", "The figure %s is missing: %s.", fig->name, fig->missing);
  } else {
    cmp_markup_open(p, "div", NULL);
    TRY(cmp_picture_write(p, figures, fig));
    cmp_markup_close(p);
  }
  cmp_markup_element(p, "figcaption", NULL, "%s", fig->caption);
  cmp_markup_close(p);
  return OK;
}

static void distances(struct markup *p, const struct cmp_diff_run *run) {
  for (size_t k = 0; k < run->n_distances; k++) {
    const struct cmp_diff_distance *at = &run->distance[k];
    if (!isfinite(at->mean)) continue;
    cmp_markup_element(p, "p", NULL,
                       "At t* = %.4g the free surfaces are %.3g H apart in the mean, %.3g H where "
                       "they are furthest.",
                       at->t, at->mean, at->largest);
  }
}

static enum status run_section(struct markup *p, const struct cmp_diff *d, size_t k,
                               const struct cmp_figures *figures) {
  const struct cmp_diff_run *run = &d->run[k];
  char id[32], *sentence = cmp_diff_run_sentence(run);
  snprintf(id, sizeof id, "run-%zu", k + 1);
  cmp_markup_open(p, "h2", NULL);
  cmp_markup_attribute(p, "id", id);
  cmp_markup_text(p, run->name);
  cmp_markup_close(p);
  if (d->folders) cmp_markup_element(p, "p", NULL, "%s.", sentence ? sentence : "");
  free(sentence);
  distances(p, run);
  if (run->pictures_missing)
    cmp_markup_element(p, "p", "soft", "Without pictures of surfaces: %s.", run->pictures_missing);
  for (size_t i = 0; i < run->n_figures; i++)
    TRY(picture(p, figures, &figures->figure[run->first_figure + i]));
  return quantities_table(p, run);
}

/* ---- the page ---- */

static enum status write_title(struct markup *p, const void *content) {
  const struct cmp_diff *d = ((const struct content *)content)->d;
  char *title = NULL;
  CHECK(asprintf(&title, "%s against %s", d->path[1], d->path[0]) >= 0, ERR_MEMORY,
        "no memory for a page");
  cmp_markup_text(p, title);
  free(title);
  return OK;
}

static void lead(struct markup *p, const struct cmp_diff *d) {
  const enum cmp_diff_outcome outcome = cmp_diff_outcome(d);
  char *sentence = cmp_diff_sentence(d), class[32];
  cmp_markup_element(p, "h1", NULL, "A and B: %s",
                     outcome == CMP_DIFF_SAME ? "the same" : cmp_diff_word(outcome));
  snprintf(class, sizeof class, "lead %s", class_of(outcome));
  cmp_markup_element(p, "p", class, "%s.", sentence ? sentence : "");
  free(sentence);
  for (int k = 0; k < 2; k++) {
    cmp_markup_open(p, "p", "soft");
    cmp_markup_text(p, k ? "B: " : "A: ");
    cmp_markup_element(p, "code", NULL, "%s", d->path[k]);
    cmp_markup_close(p);
  }
}

static enum status write_body(struct markup *p, const void *content) {
  const struct content *w = content;
  cmp_markup_open(p, "main", NULL);
  lead(p, w->d);
  if (w->d->folders) runs_table(p, w->d);
  for (size_t k = 0; k < w->d->n; k++)
    if (w->d->run[k].outcome == CMP_DIFF_DIFFERS) TRY(run_section(p, w->d, k, w->figures));
  cmp_markup_close(p);
  return OK;
}

static enum status write_data(struct markup *p, const void *content) {
  return cmp_markup_json(p, ((const struct content *)content)->json);
}

enum status cmp_diff_page(const struct cmp_diff *d, const struct cmp_figures *figures,
                          const json_t *json, FILE *out) {
  static const struct markup_part parts[] = {
      {"title", write_title}, {"body", write_body}, {"data", write_data}, {NULL, NULL}};
  return cmp_markup_fill(out, cmp_diff_template, cmp_diff_template_size, parts,
                         &(struct content){d, figures, json});
}
