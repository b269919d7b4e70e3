#include "compare/html_parts.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/output.h"

void html_cell(struct page *p, const char *class, const char *format, ...) {
  char text[512];
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  page_element(p, "td", class, "%s", text);
}

/* The mark (from 1) of a reason, new or seen before; 0 when the list is full. */
static size_t reason_mark(struct html_reasons *why, const char *reason) {
  for (size_t k = 0; k < why->n; k++)
    if (!strcmp(why->text[k], reason)) return k + 1;
  if (why->n == sizeof why->text / sizeof *why->text) {
    why->unlisted++;
    return 0;
  }
  snprintf(why->text[why->n], sizeof why->text[0], "%s", reason);
  return ++why->n;
}

void html_value(struct page *p, const struct cmp_value *v, struct html_reasons *why) {
  if (cmp_known(v)) {
    html_cell(p, NULL, "%.4g", v->value);
    return;
  }
  size_t mark = reason_mark(why, v->why);
  page_open(p, "td", "na");
  page_attribute(p, "title", v->why);
  page_text(p, "n/a");
  if (mark) page_element(p, "sup", NULL, "%zu", mark);
  page_close(p);
}

void html_reasons_list(struct page *p, const struct html_reasons *why) {
  if (!why->n) return;
  page_open(p, "p", "why");
  page_text(p, "n/a, not available: ");
  for (size_t k = 0; k < why->n; k++)
    page_text(p, "%s(%zu) %s", k ? "; " : "", k + 1, why->text[k]);
  if (why->unlisted) page_text(p, "; and %zu more, in report.json", why->unlisted);
  page_text(p, ".");
  page_close(p);
}

void html_run(struct page *p, const struct comparison *c, size_t r) {
  char style[64];
  page_open(p, "th", "t");
  page_open(p, "span", "dot");
  snprintf(style, sizeof style, "background:%s", r == SIZE_MAX ? "currentColor" : cmp_colour(r));
  page_attribute(p, "style", style);
  page_close(p);
  page_text(p, "%s", cmp_run_or_ref(c, r)->data.label);
  page_close(p);
}

void html_headings(struct page *p, const char *const *heading) {
  page_open(p, "tr", NULL);
  for (size_t k = 0; heading[k]; k++) page_element(p, "th", k ? NULL : "t", "%s", heading[k]);
  page_close(p);
}

void html_table_open(struct page *p) {
  page_open(p, "div", "scroll");
  page_open(p, "table", NULL);
}

void html_table_close(struct page *p) {
  page_close(p);
  page_close(p);
}

static void link_to(struct page *p, const char *name, const char *suffix, const char *label) {
  char href[160];
  snprintf(href, sizeof href, "figures/%s%s", name, suffix);
  page_open(p, "a", NULL);
  page_attribute(p, "href", href);
  page_text(p, "%s", label);
  page_close(p);
}

static enum status figure_show(struct page *p, const struct cmp_figures *figures,
                               const struct cmp_figure *fig) {
  char file[128], path[PATH_MAX], *bytes;
  size_t n;
  snprintf(file, sizeof file, "%s%s", fig->name, fig->raster ? ".png" : ".svg");
  TRY(cmp_path_join(figures->dir, file, path));
  TRY(cmp_file_read(path, &bytes, &n));
  page_open(p, "figure", NULL);
  page_open(p, "div", NULL);
  page_image(p, fig->raster ? "image/png" : "image/svg+xml", bytes, n, fig->caption, fig->width,
             fig->height);
  page_close(p);
  page_open(p, "figcaption", NULL);
  page_text(p, "%s ", fig->caption);
  page_open(p, "span", NULL);
  static const char *const links[][2] = {
      {".svg", "SVG"}, {".pdf", "PDF"}, {".png", "PNG"}, {".gp", "script"}};
  for (size_t k = 0; k < sizeof links / sizeof *links; k++) {
    if (k) page_text(p, " · ");
    link_to(p, fig->name, links[k][0], links[k][1]);
  }
  page_close(p);
  page_close(p);
  page_close(p);
  free(bytes);
  return OK;
}

enum status html_figures(struct page *p, const struct cmp_figures *figures,
                         enum cmp_section section) {
  for (size_t k = 0; k < figures->n; k++)
    if (figures->figure[k].section == section) TRY(figure_show(p, figures, &figures->figure[k]));
  return OK;
}
