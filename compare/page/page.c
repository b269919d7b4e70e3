#include "compare/page/page.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/chart.h"
#include "compare/output.h"
#include "compare/page/html.h"
#include "compare/page/pack.h"
#include "compare/summary.h"
#include "embed/cmp_page_library.h"
#include "embed/cmp_page_licence.h"
#include "embed/cmp_page_script.h"
#include "embed/cmp_page_style.h"
#include "embed/cmp_page_template.h"

struct content { /* what the page is written from */
  const struct comparison *c;
  const struct cmp_rows *rows;
  const struct cmp_figures *figures;
  const char *sentence;
  const json_t *report, *pack;
};

/* The heading cell of a run (SIZE_MAX: the reference): its line and its name. */
static void run_cell(FILE *out, const struct comparison *c, size_t r) {
  static const char *const dashes[] = {"", " dash", " dots", " ring"};
  const struct cmp_style style = cmp_run_style(c, r);
  fprintf(out, "<th class=\"t\"><span class=\"dot%s\" style=\"color:%s\"></span>",
          dashes[style.dashes], r == SIZE_MAX ? "inherit" : style.colour);
  cmp_html_text(out, "%s", cmp_run_or_ref(c, r)->data.label);
  fputs("</th>", out);
}

/* ---- summary ---- */

/* Columns after the distances; one that no run has a number for is left out. */
static const struct {
  const char *heading;
  size_t measure;
  bool last; /* at the last comparison time */
} columns[] = {{"front / H", CMP_MEASURE_front, false},
               {"touchdown t*", CMP_MEASURE_touchdown_time, false},
               {"probe rms", CMP_MEASURE_probe_rms, false},
               {"rms to experiment", CMP_MEASURE_experiment_probe_rms, false},
               {"energy lost at the last time", CMP_MEASURE_decay, true},
               {"budget until impact", CMP_MEASURE_budget_before_impact, false}};
enum { COLUMNS = sizeof columns / sizeof *columns };

static const struct cmp_row *column_row(const struct content *w, size_t k, size_t r) {
  if (columns[k].last && !w->c->n_times) return NULL;
  return cmp_rows_find(w->rows, columns[k].measure, r,
                       columns[k].last ? w->c->n_times - 1 : SIZE_MAX);
}

static bool column_shown(const struct content *w, size_t k) {
  if (columns[k].measure == CMP_MEASURE_front && !cmp_comparison_has_front(w->c)) return false;
  for (size_t r = 0; r < w->c->n_runs; r++) {
    const struct cmp_row *row = column_row(w, k, r);
    if (row && cmp_known(&row->value)) return true;
  }
  return false;
}

static void summary_row(FILE *out, const struct content *w, size_t r) {
  const struct cmp_run *run = &w->c->run[r];
  const double shared = cmp_summary_shared(run);
  fputs("<tr>", out);
  run_cell(out, w->c, r);
  cmp_html_element(out, "td", NULL, "%.4g", run->data.dx);
  if (cmp_known(&run->agreement) || !isfinite(shared))
    cmp_html_value(out, &run->agreement);
  else
    cmp_html_element(out, "td", NULL, "%.4g (end%s)", shared,
                     isnan(run->blind[0]) ? "" : ", with gaps");
  for (size_t k = 0; k < w->c->n_times; k++) {
    const struct cmp_value *v = &run->at[k].mean;
    if (cmp_known(v) && v->value < run->noise)
      cmp_html_element(out, "td", "below", "%.3g", v->value);
    else
      cmp_html_value(out, v);
  }
  for (size_t k = 0; k < COLUMNS; k++)
    if (column_shown(w, k)) cmp_html_value(out, &column_row(w, k, r)->value);
  fputs("</tr>\n", out);
}

static enum status summary(FILE *out, const struct content *w) {
  size_t *order;
  TRY(cmp_summary_order(w->c, &order));
  fputs("<div class=\"scroll\" tabindex=\"0\"><table id=\"summary-table\"><thead><tr><th "
        "class=\"t\">run</th><th>dx / H</th><th>within one dx until t*</th>",
        out);
  for (size_t k = 0; k < w->c->n_times; k++)
    cmp_html_element(out, "th", NULL, "mean distance / H at %.4g", w->c->times[k]);
  for (size_t k = 0; k < COLUMNS; k++)
    if (column_shown(w, k)) cmp_html_element(out, "th", NULL, "%s", columns[k].heading);
  fputs("</tr></thead><tbody>\n", out);
  for (size_t k = 0; k < w->c->n_runs; k++) summary_row(out, w, order[k]);
  fputs("</tbody></table></div>\n", out);
  cmp_html_element(out, "p", "soft",
                   "All against %s. Distances in H, times in √(H/g), pressures in ρgH (the worst "
                   "probe), energies in E0; grey: below the noise floor of half a particle "
                   "spacing.",
                   w->c->ref.data.label);
  free(order);
  return OK;
}

/* ---- health ---- */

static void health_row(FILE *out, const struct comparison *c, size_t r) {
  static const char *const class[] = {"PASS", "doubt", "FAIL"};
  const struct cmp_run *run = cmp_run_or_ref(c, r);
  const struct health *h = &run->health;
  const char *ended = h->broke_off ? "" : run->data.file->ended; /* else the reasons tell */
  const bool told = !strcmp(health_word(h), health_verdicts[h->verdict]);
  fputs("<tr>", out);
  run_cell(out, c, r);
  cmp_html_element(out, "td", told ? class[h->verdict] : NULL, "%s", health_word(h));
  cmp_html_element(out, "td", "w", "%s%s%s%s%s%s", h->reasons, *h->reasons && *ended ? "; " : "",
                   ended, *h->missing && (*h->reasons || *ended) ? ". " : "",
                   *h->missing ? "Not told: " : "", h->missing);
  cmp_html_element(out, "td", "w", "%s", h->facts);
  fputs("</tr>\n", out);
}

static enum status health(FILE *out, const struct content *w) {
  cmp_html_table(out, "health-table",
                 (const char *const[]){"run", "health", "why", "measured", NULL});
  health_row(out, w->c, SIZE_MAX);
  for (int v = HEALTH_FAILED; v >= HEALTH_SOUND; v--) /* the worst first */
    for (size_t r = 0; r < w->c->n_runs; r++)
      if (w->c->run[r].health.verdict == (enum health_verdict)v) health_row(out, w->c, r);
  fputs("</tbody></table></div>\n", out);
  return OK;
}

/* ---- checks ---- */

static void verdict_cell(FILE *out, bool passed) {
  const char *word = passed ? "PASS" : "FAIL";
  cmp_html_element(out, "td", word, "%s", word);
}

static void check_row(FILE *out, const struct comparison *c, const struct cmp_row *row) {
  fputs("<tr>", out);
  run_cell(out, c, row->run);
  cmp_html_element(out, "td", "t", "%s", row->measure->name);
  if (row->time == SIZE_MAX)
    fputs("<td>all</td>", out);
  else
    cmp_html_element(out, "td", NULL, "%.4g", c->times[row->time]);
  cmp_html_value(out, &row->value);
  cmp_html_element(out, "td", NULL, "%.4g", row->limit);
  if (isfinite(row->noise))
    cmp_html_element(out, "td", NULL, "%.3g", row->noise);
  else
    fputs("<td>–</td>", out);
  cmp_html_element(out, "td", "t", "%s", row->measure->units);
  cmp_html_element(out, "td", "t", "%s", row->detail);
  verdict_cell(out, row->outcome == CMP_PASS);
  fputs("</tr>\n", out);
}

static void event_checks(FILE *out, const struct content *w) {
  const struct cmp_checks *checks = &w->rows->checks;
  if (!checks->n) return;
  fputs("<h3>Events against published numbers</h3>\n", out);
  cmp_html_table(out, "events-table",
                 (const char *const[]){"run", "event", "value", "published", "within", "units",
                                       "verdict", "source", NULL});
  for (size_t i = 0; i < checks->n; i++) {
    const struct cmp_check *check = &checks->check[i];
    fputs("<tr>", out);
    run_cell(out, w->c, check->run);
    cmp_html_element(out, "td", "t", "%s, %s", case_event_names[check->of->event],
                     case_event_parts[check->of->part]);
    if (cmp_known(&check->value)) /* instants are known to more digits than most measures */
      cmp_html_element(out, "td", NULL, "%.6g", check->value.value);
    else
      cmp_html_value(out, &check->value);
    cmp_html_element(out, "td", NULL, "%.6g", check->published);
    cmp_html_element(out, "td", NULL, "%.3g", check->within);
    cmp_html_element(out, "td", "t", "%s", cmp_check_units(check));
    verdict_cell(out, check->passed);
    cmp_html_element(out, "td", "w", "%s", check->of->source);
    fputs("</tr>\n", out);
  }
  fputs("</tbody></table></div>\n", out);
}

static enum status checks(FILE *out, const struct content *w) {
  const struct cmp_rows *rows = w->rows;
  if (!rows->passed && !rows->failed)
    cmp_html_element(out, "p", NULL,
                     "The case sets no tolerance for what was compared, so nothing passes or "
                     "fails. Put tolerances under compare.tolerances, for instance {measure: "
                     "mean_distance, max: 0.02}; the measures are listed at the end of this page.");
  if (rows->passed + rows->failed > rows->checks.n) {
    cmp_html_table(out, "checks-table",
                   (const char *const[]){"run", "measure", "t*", "value", "limit", "noise floor",
                                         "units", "where", "verdict", NULL});
    for (int pass = 0; pass < 2; pass++) /* failures first */
      for (size_t i = 0; i < rows->n; i++)
        if (rows->row[i].outcome == (pass ? CMP_PASS : CMP_FAIL))
          check_row(out, w->c, &rows->row[i]);
    fputs("</tbody></table></div>\n", out);
  }
  if (rows->unused)
    cmp_html_element(out, "p", "soft",
                     "Tolerances of the case that concern none of the runs compared here: %zu.",
                     rows->unused);
  event_checks(out, w);
  return OK;
}

/* ---- figures ---- */

static void links(FILE *out, const struct cmp_figure *fig) {
  static const char *const link[][2] = {
      {"svg", "SVG"}, {"pdf", "PDF"}, {"png", "PNG"}, {"gp", "script"}};
  fputs("<span class=\"links\">", out);
  for (size_t k = *fig->missing ? 3 : 0; k < sizeof link / sizeof *link; k++)
    fprintf(out, "%s<a href=\"figures/%s.%s\">%s</a>", k && !*fig->missing ? " · " : "", fig->name, link[k][0],
            link[k][1]);
  fputs("</span>", out);
}

static enum status image(FILE *out, const struct cmp_figures *figures,
                         const struct cmp_figure *fig) {
  char file[128], path[PATH_MAX], *bytes;
  size_t n;
  snprintf(file, sizeof file, "%s%s", fig->name, fig->raster ? ".png" : ".svg");
  TRY(cmp_path_join(figures->dir, file, path));
  TRY(cmp_file_read(path, &bytes, &n));
  fprintf(
      out,
      "<div class=\"paper\" tabindex=\"0\"><img loading=\"lazy\" width=\"%d\" height=\"%d\" alt=\"",
      fig->width, fig->height);
  cmp_html_text(out, "%s", fig->caption);
  fputs("\" src=\"", out);
  enum status status = OK;
  if (fig->raster)
    status = cmp_html_data(out, "image/png", bytes, n);
  else
    cmp_html_svg(out, bytes, n);
  fputs("\"></div>", out);
  free(bytes);
  return status;
}

static enum status section_figures(FILE *out, const struct content *w, enum cmp_section section) {
  size_t shown = 0;
  fputs("<div class=\"fixed\">\n", out);
  for (size_t k = 0; k < w->figures->n; k++) {
    const struct cmp_figure *fig = &w->figures->figure[k];
    if (fig->section != section) continue;
    fprintf(out, "<figure data-name=\"%s\">", fig->name);
    if (*fig->missing)
      cmp_html_element(out, "p", "why", "The figure %s is missing: %s.", fig->name, fig->missing);
    else
      TRY(image(out, w->figures, fig));
    fputs("<figcaption>", out);
    cmp_html_text(out, "%s ", fig->caption);
    links(out, fig);
    fputs("</figcaption></figure>\n", out);
    shown++;
  }
  if (!shown)
    fputs("<p class=\"soft\">No figure: none of the files has what it would show.</p>\n", out);
  fputs("</div>\n", out);
  return OK;
}

/* ---- sections ---- */

static bool always(const struct content *w) {
  (void)w;
  return true;
}

static bool has_overlays(const struct content *w) {
  for (size_t k = 0; k < w->c->n_times; k++)
    if (cmp_comparison_has_output(w->c, k)) return true;
  return false;
}

static bool has_front(const struct content *w) {
  return cmp_comparison_has_front(w->c);
}

static bool has_convergence(const struct content *w) {
  return json_array_size(json_object_get(w->report, "convergence")) > 0;
}

static bool has_spectra(const struct content *w) {
  return w->c->settings->compare.n_spectra > 0;
}

/* Whether the reference or any run has that. */
#define ANY(name, condition)                                                                       \
  static bool name(const struct content *w) {                                                      \
    for (size_t r = 0; r <= w->c->n_runs; r++) {                                                   \
      const struct cmp_data *d = &cmp_run_or_ref(w->c, r < w->c->n_runs ? r : SIZE_MAX)->data;     \
      if (condition) return true;                                                                  \
    }                                                                                              \
    return false;                                                                                  \
  }
ANY(has_jet, cmp_known(&d->overturning.time) || cmp_known(&d->touchdown.time))
ANY(has_probes, d->n_probes > 0)
ANY(has_gauges, d->n_gauges > 0)
ANY(has_diagnostics, d->n_diagnostics > 0)

#define NO_FIGURES CMP_SECTION_CHECKS

static const struct {
  const char *id, *title;
  bool (*has)(const struct content *w);
  enum status (*write)(FILE *out, const struct content *w); /* before the figures, or NULL */
  enum cmp_section figures;
} sections[] = {
    {"health", "Health", always, health, NO_FIGURES},
    {"summary", "Summary", always, summary, NO_FIGURES},
    {"checks", "Checks", always, checks, NO_FIGURES},
    {"convergence", "Convergence", has_convergence, NULL, CMP_SECTION_CONVERGENCE},
    {"distance", "Distance against time", always, NULL, CMP_SECTION_DISTANCE},
    {"overlays", "Overlays", has_overlays, NULL, CMP_SECTION_OVERLAY},
    {"jet", "Plunging jet", has_jet, NULL, CMP_SECTION_JET},
    {"front", "Front", has_front, NULL, CMP_SECTION_FRONT},
    {"energy", "Energy", always, NULL, CMP_SECTION_ENERGY},
    {"pressure", "Pressure", has_probes, NULL, CMP_SECTION_PRESSURE},
    {"gauges", "Water height", has_gauges, NULL, CMP_SECTION_GAUGE},
    {"spectra", "Spectra", has_spectra, NULL, CMP_SECTION_SPECTRA},
    {"diagnostics", "Noise, momenta and forces", has_diagnostics, NULL, CMP_SECTION_DIAGNOSTICS},
    {"runs", "Runs and provenance", always, NULL, NO_FIGURES},
    {"method", "How it is measured", always, NULL, NO_FIGURES}};
enum { SECTIONS = sizeof sections / sizeof *sections };

static enum status write_contents(FILE *out, const struct content *w) {
  for (size_t k = 0; k < SECTIONS; k++)
    if (sections[k].has(w))
      fprintf(out, "<a href=\"#%s\">%s</a>\n", sections[k].id, sections[k].title);
  return OK;
}

/* What scripts add to a section stands before its figures, in "live". */
static enum status write_sections(FILE *out, const struct content *w) {
  for (size_t k = 0; k < SECTIONS; k++) {
    if (!sections[k].has(w)) continue;
    fprintf(out, "<section aria-labelledby=\"%s\"><h2 id=\"%s\">%s</h2>\n", sections[k].id,
            sections[k].id, sections[k].title);
    if (sections[k].write) TRY(sections[k].write(out, w));
    fprintf(out, "<div class=\"live\" data-of=\"%s\"></div>\n", sections[k].id);
    if (sections[k].figures != NO_FIGURES) TRY(section_figures(out, w, sections[k].figures));
    fputs("</section>\n", out);
  }
  return OK;
}

/* ---- the page ---- */

static const char *title_of(const struct content *w) {
  const char *title = w->c->ref.data.file->title;
  return title && *title ? title : "plunge report";
}

static enum status write_title(FILE *out, const struct content *w) {
  cmp_html_text(out, "%s", title_of(w));
  return OK;
}

/* Whether the health of anybody has failed. */
static bool any_failed(const struct comparison *c) {
  bool any = c->ref.health.verdict == HEALTH_FAILED;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].health.verdict == HEALTH_FAILED;
  return any;
}

static enum status write_lead(FILE *out, const struct content *w) {
  const size_t missing = cmp_figures_missing(w->figures);
  cmp_html_element(out, "p",
                   w->rows->failed || any_failed(w->c) ? "lead fail"
                   : w->rows->passed                   ? "lead pass"
                                                       : "lead",
                   "%s", w->sentence);
  if (missing && missing == w->figures->n)
    cmp_html_element(out, "p", "lead fail", "There are no figures: %s.",
                     w->figures->figure[0].missing);
  else if (missing)
    cmp_html_element(out, "p", "lead fail",
                     "%zu of %zu figures are missing; each says why in its place.", missing,
                     w->figures->n);
  return OK;
}

/* JSON inside a script element: no '<' may end it, nor begin a comment. */
static enum status write_json(FILE *out, const json_t *value) {
  char *text = json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(17));
  CHECK(text, ERR_MEMORY, "no memory for the page");
  for (const char *c = text; *c; c++)
    if (*c == '<')
      fputs("\\u003c", out);
    else
      fputc(*c, out);
  free(text);
  return OK;
}

static enum status write_report(FILE *out, const struct content *w) {
  return write_json(out, w->report);
}

static enum status write_pack(FILE *out, const struct content *w) {
  return write_json(out, w->pack);
}

/* Of what is embedded: nothing in it comes from a file that is compared. */
#define EMBEDDED(name)                                                                             \
  static enum status write_##name(FILE *out, const struct content *w) {                            \
    (void)w;                                                                                       \
    fwrite(cmp_page_##name, 1, cmp_page_##name##_size, out);                                       \
    return OK;                                                                                     \
  }
EMBEDDED(style)
EMBEDDED(script)
EMBEDDED(library)

static enum status write_licence(FILE *out, const struct content *w) {
  (void)w;
  cmp_html_text(out, "%.*s", (int)cmp_page_licence_size, cmp_page_licence);
  return OK;
}

/* What stands in template.html for each {{name}}. */
static const struct {
  const char *name;
  enum status (*write)(FILE *out, const struct content *w);
} parts[] = {{"title", write_title},  {"style", write_style},       {"contents", write_contents},
             {"lead", write_lead},    {"sections", write_sections}, {"report", write_report},
             {"pack", write_pack},    {"library", write_library},   {"licence", write_licence},
             {"script", write_script}};

static enum status part_write(FILE *out, const struct content *w, const char *name, size_t n) {
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
    if (strlen(parts[k].name) == n && !strncmp(parts[k].name, name, n))
      return parts[k].write(out, w);
  return status_raise(ERR_USAGE, "the template of the page asks for %.*s", (int)n, name);
}

static enum status fill(FILE *out, const struct content *w) {
  const char *at = cmp_page_template, *open, *close;
  while ((open = strstr(at, "{{")) && (close = strstr(open, "}}"))) {
    fwrite(at, 1, (size_t)(open - at), out);
    TRY(part_write(out, w, open + 2, (size_t)(close - open - 2)));
    at = close + 2;
  }
  fputs(at, out);
  return OK;
}

enum status cmp_page_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_figures *figures, const char *sentence,
                           const json_t *report, const char *path) {
  enum status status = OK;
  struct cmp_output out = {0};
  json_t *pack = NULL;
  ATTEMPT(cmp_pack_create(c, &pack));
  ATTEMPT(cmp_output_open(path, &out));
  ATTEMPT(fill(out.stream, &(struct content){c, rows, figures, sentence, report, pack}));
  ATTEMPT(cmp_output_commit(&out));
done:
  cmp_output_abandon(&out);
  json_decref(pack);
  return status;
}
