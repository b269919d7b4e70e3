#include "compare/page/page.h"

#include "compare/chart.h"
#include "compare/output.h"
#include "compare/page/content.h"
#include "compare/page/pack.h"
#include "compare/picture.h"
#include "embed/cmp_page_library.h"
#include "embed/cmp_page_licence.h"
#include "embed/cmp_page_script.h"
#include "embed/cmp_page_style.h"
#include "embed/cmp_page_template.h"

/* ---- figures ---- */

static void link_to(struct markup *m, const struct cmp_figure *fig, const char *suffix,
                    const char *says) {
  char file[160];
  snprintf(file, sizeof file, "figures/%s%s", fig->name, suffix);
  cmp_markup_open(m, "a", NULL);
  cmp_markup_attribute(m, "href", file);
  cmp_markup_text(m, says);
  cmp_markup_close(m);
}

static void links(struct markup *m, const struct cmp_figure *fig) {
  cmp_markup_open(m, "span", "links");
  for (size_t k = 0; k < CMP_FORMATS && !*fig->missing; k++) {
    if (!cmp_figure_has(fig, &cmp_formats[k])) continue;
    link_to(m, fig, cmp_formats[k].suffix, cmp_formats[k].says);
    cmp_markup_text(m, " · ");
  }
  link_to(m, fig, ".gp", "script");
  cmp_markup_close(m);
}

static enum status picture(struct markup *m, const struct cmp_figures *figures,
                           const struct cmp_figure *fig) {
  cmp_markup_open(m, "div", "paper");
  cmp_markup_attribute(m, "tabindex", "0");
  TRY(cmp_picture_write(m, figures, fig));
  cmp_markup_close(m);
  return OK;
}

static enum status section_figures(struct markup *m, const struct cmp_page_content *w,
                                   enum cmp_section section) {
  size_t shown = 0;
  cmp_markup_open(m, "div", "fixed");
  for (size_t k = 0; k < w->figures->n; k++) {
    const struct cmp_figure *fig = &w->figures->figure[k];
    if (fig->section != section) continue;
    cmp_markup_open(m, "figure", NULL);
    cmp_markup_attribute(m, "data-name", fig->name);
    if (*fig->missing)
      cmp_markup_element(m, "p", "why", "The figure %s is missing: %s.", fig->name, fig->missing);
    else
      TRY(picture(m, w->figures, fig));
    cmp_markup_open(m, "figcaption", NULL);
    cmp_markup_text(m, fig->caption);
    cmp_markup_text(m, " ");
    links(m, fig);
    cmp_markup_close(m);
    cmp_markup_close(m);
    shown++;
  }
  if (!shown)
    cmp_markup_element(m, "p", "soft", "No figure: none of the files has what it would show.");
  cmp_markup_close(m);
  return OK;
}

/* ---- sections ---- */

static bool always(const struct cmp_page_content *w) {
  (void)w;
  return true;
}

static bool has_overlays(const struct cmp_page_content *w) {
  for (size_t k = 0; k < w->c->n_times; k++)
    if (cmp_comparison_has_output(w->c, k)) return true;
  return false;
}

static bool has_front(const struct cmp_page_content *w) {
  return cmp_comparison_has_front(w->c);
}

static bool has_convergence(const struct cmp_page_content *w) {
  return json_array_size(json_object_get(w->report, "convergence")) > 0;
}

static bool has_spectra(const struct cmp_page_content *w) {
  return w->c->settings->compare.n_spectra > 0;
}

/* Whether the reference or any run has that. */
#define ANY(name, condition)                                                                       \
  static bool name(const struct cmp_page_content *w) {                                                      \
    for (size_t r = 0; r <= w->c->n_runs; r++) {                                                   \
      const struct cmp_data *d = &cmp_run_or_ref(w->c, r < w->c->n_runs ? r : SIZE_MAX)->data;     \
      if (condition) return true;                                                                  \
    }                                                                                              \
    return false;                                                                                  \
  }
ANY(has_jet, cmp_known(&d->overturning.time) || cmp_known(&d->touchdown.time))
ANY(has_energies, d->file->n_energy > 0)
ANY(has_probes, d->n_probes > 0)
ANY(has_gauges, d->n_gauges > 0)
ANY(has_diagnostics, d->n_diagnostics > 0)

static const struct {
  bool (*has)(const struct cmp_page_content *w);
  /* what stands before the figures, or NULL */
  enum status (*write)(struct markup *m, const struct cmp_page_content *w);
  bool figures;
} sections[CMP_N_SECTIONS] = {
    [CMP_SECTION_HEALTH] = {always, cmp_page_health, false},
    [CMP_SECTION_SUMMARY] = {always, cmp_page_summary, false},
    [CMP_SECTION_CHECKS] = {always, cmp_page_checks, false},
    [CMP_SECTION_CONVERGENCE] = {has_convergence, NULL, true},
    [CMP_SECTION_DISTANCE] = {always, NULL, true},
    [CMP_SECTION_OVERLAY] = {has_overlays, NULL, true},
    [CMP_SECTION_JET] = {has_jet, NULL, true},
    [CMP_SECTION_FRONT] = {has_front, NULL, true},
    [CMP_SECTION_ENERGY] = {has_energies, NULL, true},
    [CMP_SECTION_PRESSURE] = {has_probes, NULL, true},
    [CMP_SECTION_GAUGE] = {has_gauges, NULL, true},
    [CMP_SECTION_SPECTRA] = {has_spectra, NULL, true},
    [CMP_SECTION_DIAGNOSTICS] = {has_diagnostics, NULL, true},
    [CMP_SECTION_RUNS] = {always, NULL, false},
    [CMP_SECTION_METHOD] = {always, NULL, false}};

static enum status write_contents(struct markup *m, const void *content) {
  for (enum cmp_section k = 0; k < CMP_N_SECTIONS; k++) {
    char href[32];
    if (!sections[k].has(content)) continue;
    snprintf(href, sizeof href, "#%s", cmp_section_name(k));
    cmp_markup_open(m, "a", NULL);
    cmp_markup_attribute(m, "href", href);
    cmp_markup_text(m, cmp_section_title(k));
    cmp_markup_close(m);
    cmp_markup_raw(m, "\n", 1);
  }
  return OK;
}

/* What scripts add to a section stands before its figures, in "live". */
static enum status section_write(struct markup *m, const struct cmp_page_content *w,
                                 enum cmp_section section) {
  const char *id = cmp_section_name(section);
  cmp_markup_open(m, "section", NULL);
  cmp_markup_attribute(m, "aria-labelledby", id);
  cmp_markup_open(m, "h2", NULL);
  cmp_markup_attribute(m, "id", id);
  cmp_markup_text(m, cmp_section_title(section));
  cmp_markup_close(m);
  if (sections[section].write) TRY(sections[section].write(m, w));
  cmp_markup_open(m, "div", "live");
  cmp_markup_attribute(m, "data-of", id);
  cmp_markup_close(m);
  if (sections[section].figures) TRY(section_figures(m, w, section));
  cmp_markup_close(m);
  return OK;
}

static enum status write_sections(struct markup *m, const void *content) {
  for (enum cmp_section k = 0; k < CMP_N_SECTIONS; k++)
    if (sections[k].has(content)) TRY(section_write(m, content, k));
  return OK;
}

/* ---- the page ---- */

static const char *title_of(const struct cmp_page_content *w) {
  const char *title = w->c->ref.data.file->title;
  return title && *title ? title : "plunge report";
}

static enum status write_title(struct markup *m, const void *content) {
  cmp_markup_text(m, title_of(content));
  return OK;
}

/* Whether the health of anybody has failed. */
static bool any_failed(const struct comparison *c) {
  bool any = c->ref.health.verdict == HEALTH_FAILED;
  for (size_t r = 0; r < c->n_runs; r++) any = any || c->run[r].health.verdict == HEALTH_FAILED;
  return any;
}

static enum status write_lead(struct markup *m, const void *content) {
  const struct cmp_page_content *w = content;
  const size_t missing = cmp_figures_missing(w->figures);
  cmp_markup_element(m, "p",
                   w->rows->failed || any_failed(w->c) ? "lead fail"
                   : w->rows->passed                   ? "lead pass"
                                                       : "lead",
                   "%s", w->sentence);
  if (missing && missing == w->figures->n)
    cmp_markup_element(m, "p", "lead fail", "There are no figures: %s.",
                     w->figures->figure[0].missing);
  else if (missing)
    cmp_markup_element(m, "p", "lead fail",
                     "%zu of %zu figures are missing; each says why in its place.", missing,
                     w->figures->n);
  return OK;
}

static enum status write_report(struct markup *m, const void *content) {
  return cmp_markup_json(m, ((const struct cmp_page_content *)content)->report);
}

static enum status write_pack(struct markup *m, const void *content) {
  return cmp_markup_json(m, ((const struct cmp_page_content *)content)->pack);
}

/* Of what is embedded: nothing in it comes from a file that is compared. */
#define EMBEDDED(name)                                                                             \
  static enum status write_##name(struct markup *m, const void *content) {                         \
    (void)content;                                                                                 \
    cmp_markup_raw(m, cmp_page_##name, cmp_page_##name##_size);                                    \
    return OK;                                                                                     \
  }
EMBEDDED(style)
EMBEDDED(script)
EMBEDDED(library)

static enum status write_licence(struct markup *m, const void *content) {
  (void)content;
  cmp_markup_text(m, cmp_page_licence);
  return OK;
}

static const struct markup_part parts[] = {
    {"title", write_title},       {"style", write_style},   {"contents", write_contents},
    {"lead", write_lead},         {"report", write_report}, {"pack", write_pack},
    {"sections", write_sections}, {"script", write_script}, {"library", write_library},
    {"licence", write_licence},   {NULL, NULL}};

enum status cmp_page_write(const struct comparison *c, const struct cmp_rows *rows,
                           const struct cmp_figures *figures, const char *sentence,
                           const json_t *report, const char *path) {
  enum status status = OK;
  struct cmp_output out = {0};
  json_t *pack = NULL;
  ATTEMPT(cmp_pack_create(c, &pack));
  ATTEMPT(cmp_output_open(path, &out));
  ATTEMPT(cmp_markup_fill(
      out.stream, cmp_page_template, cmp_page_template_size, parts,
      &(struct cmp_page_content){c, rows, figures, sentence, report, pack}));
  ATTEMPT(cmp_output_commit(&out));
done:
  cmp_output_abandon(&out);
  json_decref(pack);
  return status;
}
