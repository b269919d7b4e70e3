/* The page: a static one that needs no script, in a template whose script shows all quantities. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compare/diff/markup.h"
#include "compare/diff/write.h"
#include "compare/output.h"
#include "embed/cmp_diff_template.h"

enum { MOST_ROWS = 60, MOST_RUNS = 200 }; /* of what stands in the page without a script */

/* ---- the template ---- */

/* Writes the template up to a mark, and returns what is behind it. */
static const char *template_until(struct markup *p, const char *from, const char *mark) {
  const char *at = strstr(from, mark);
  char *part = at ? strndup(from, (size_t)(at - from)) : NULL;
  if (!part) return NULL;
  cmp_markup_raw(p, part);
  free(part);
  return at + strlen(mark);
}

/* A `<` is only ever within a string there: as \u003c none of them ends the script. */
static enum status data_write(struct markup *p, const json_t *json) {
  char *text = json_dumps(json, JSON_COMPACT | JSON_REAL_PRECISION(17));
  CHECK(text, ERR_MEMORY, "no memory for a page");
  for (char *from = text, *to = from; to;) {
    to = strchr(from, '<');
    if (to) *to = 0;
    cmp_markup_raw(p, from);
    if (to) cmp_markup_raw(p, "\\u003c");
    if (to) from = to + 1;
  }
  free(text);
  return OK;
}

/* ---- tables ---- */

static const char *class_of(enum cmp_diff_outcome outcome) {
  static const char *const class[] = {"same", "differs", "only", "only", "trouble"};
  return class[outcome];
}

static void headings(struct markup *p, const char *const *text, size_t n, size_t left) {
  cmp_markup_open(p, "tr", NULL);
  for (size_t k = 0; k < n; k++) {
    cmp_markup_open(p, "th", k < left ? "t" : NULL);
    cmp_markup_attribute(p, "scope", "col");
    cmp_markup_text(p, text[k]);
    cmp_markup_close(p);
  }
  cmp_markup_close(p);
}

static void table_open(struct markup *p) {
  cmp_markup_open(p, "div", "scroll");
  cmp_markup_open(p, "table", NULL);
}

static void table_close(struct markup *p) {
  cmp_markup_close(p);
  cmp_markup_close(p);
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
  static const char *const head[] = {"run", "outcome", "what"};
  size_t shown = 0;
  cmp_markup_element(p, "h2", NULL, "Runs");
  table_open(p);
  headings(p, head, 3, 3);
  for (int same = 0; same < 2; same++) /* what differs comes first */
    for (size_t k = 0; k < d->n; k++) {
      if ((d->run[k].outcome == CMP_DIFF_SAME) != same || shown == MOST_RUNS) continue;
      run_row(p, d, k);
      shown++;
    }
  table_close(p);
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
  static const char *const head[] = {"quantity", "since t (s)", "t*",  "difference",
                                     "units",    "relative",    "what"};
  const struct result_quantity **q;
  size_t n;
  TRY(cmp_diff_order(run, &n, &q));
  cmp_markup_element(p, "h3", NULL, "What differs, the first in time first");
  table_open(p);
  headings(p, head, sizeof head / sizeof *head, 1);
  for (size_t i = 0; i < n && i < MOST_ROWS; i++) quantity_row(p, run, q[i]);
  table_close(p);
  if (n > MOST_ROWS)
    cmp_markup_element(p, "p", "soft", "%zu more are in the table of all quantities and diff.json.",
                       n - MOST_ROWS);
  free(q);
  return OK;
}

/* ---- pictures ---- */

static enum status image(struct markup *p, const struct cmp_figures *figures,
                         const struct cmp_figure *fig) {
  char file[128], path[PATH_MAX], *bytes;
  size_t n;
  snprintf(file, sizeof file, "%s%s", fig->name, fig->raster ? ".png" : ".svg");
  TRY(cmp_path_join(figures->dir, file, path));
  TRY(cmp_file_read(path, &bytes, &n));
  cmp_markup_open(p, "div", NULL);
  cmp_markup_image(p, fig->raster ? "image/png" : "image/svg+xml", bytes, n, fig->caption,
                   fig->width, fig->height);
  cmp_markup_close(p);
  free(bytes);
  return OK;
}

static enum status picture(struct markup *p, const struct cmp_figures *figures,
                           const struct cmp_figure *fig) {
  cmp_markup_open(p, "figure", NULL);
  if (*fig->missing)
    cmp_markup_element(p, "p", "soft", "The figure %s is missing: %s.", fig->name, fig->missing);
  else
    TRY(image(p, figures, fig));
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

static enum status body(struct markup *p, const struct cmp_diff *d,
                        const struct cmp_figures *figures) {
  const enum cmp_diff_outcome outcome = cmp_diff_outcome(d);
  char *sentence = cmp_diff_sentence(d), class[32];
  cmp_markup_open(p, "main", NULL);
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
  if (d->folders) runs_table(p, d);
  for (size_t k = 0; k < d->n; k++)
    if (d->run[k].outcome == CMP_DIFF_DIFFERS) TRY(run_section(p, d, k, figures));
  cmp_markup_close(p);
  return OK;
}

static enum status page_write(struct markup *p, const struct cmp_diff *d,
                              const struct cmp_figures *figures, const json_t *json) {
  const char *rest = template_until(p, cmp_diff_template, "<!--head-->");
  cmp_markup_element(p, "title", NULL, "%s against %s", d->path[1], d->path[0]);
  if (rest) rest = template_until(p, rest, "<!--body-->");
  TRY(body(p, d, figures));
  if (rest) rest = template_until(p, rest, "<!--data-->");
  TRY(data_write(p, json));
  CHECK(rest, ERR_MEMORY, "no memory for a page");
  cmp_markup_raw(p, rest);
  return OK;
}

enum status cmp_diff_page(const struct cmp_diff *d, const struct cmp_figures *figures,
                          const json_t *json, FILE *out) {
  struct markup *p = cmp_markup_create(out, false);
  CHECK(p, ERR_MEMORY, "no memory for a page");
  enum status status = page_write(p, d, figures, json);
  if (!cmp_markup_finish(p) && status == OK) status = status_raise(ERR_IO, "cannot write the page");
  cmp_markup_destroy(p);
  return status;
}
