#include "compare/html_parts.h"

#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/output.h"

void cmp_html_cell(struct page *p, const char *class, const char *format, ...) {
  char text[512];
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  cmp_page_element(p, "td", class, "%s", text);
}

/* The mark (from 1) of a reason, new or seen before; 0 when the list is full. */
static size_t reason_mark(struct cmp_html_reasons *why, const char *reason) {
  for (size_t k = 0; k < why->n; k++)
    if (!strcmp(why->text[k], reason)) return k + 1;
  if (why->n == sizeof why->text / sizeof *why->text) {
    why->unlisted++;
    return 0;
  }
  snprintf(why->text[why->n], sizeof why->text[0], "%s", reason);
  return ++why->n;
}

void cmp_html_value(struct page *p, const struct cmp_value *v, struct cmp_html_reasons *why) {
  if (cmp_known(v)) {
    cmp_html_cell(p, NULL, "%.4g", v->value);
    return;
  }
  size_t mark = reason_mark(why, v->why);
  cmp_page_open(p, "td", "na");
  cmp_page_attribute(p, "title", v->why);
  cmp_page_text(p, "n/a");
  if (mark) cmp_page_element(p, "sup", NULL, "%zu", mark);
  cmp_page_close(p);
}

void cmp_html_reasons_list(struct page *p, const struct cmp_html_reasons *why) {
  if (!why->n) return;
  cmp_page_open(p, "p", "why");
  cmp_page_text(p, "n/a, not available: ");
  for (size_t k = 0; k < why->n; k++)
    cmp_page_text(p, "%s(%zu) %s", k ? "; " : "", k + 1, why->text[k]);
  if (why->unlisted) cmp_page_text(p, "; and %zu more, in report.json", why->unlisted);
  cmp_page_text(p, ".");
  cmp_page_close(p);
}

void cmp_html_run(struct page *p, const struct comparison *c, size_t r) {
  /* a ring of dashes or dots for the runs that have such a line */
  static const char *const ring[] = {"", " dash", " dots", " ring"};
  char style[64], class[16];
  struct cmp_style line = cmp_run_style(c, r);
  snprintf(class, sizeof class, "dot%s", ring[line.dashes]);
  cmp_page_open(p, "th", "t");
  cmp_page_open(p, "span", class);
  snprintf(style, sizeof style, "color:%s", r == SIZE_MAX ? "inherit" : line.colour);
  cmp_page_attribute(p, "style", style);
  cmp_page_close(p);
  cmp_page_text(p, "%s", cmp_run_or_ref(c, r)->data.label);
  cmp_page_close(p);
}

void cmp_html_headings(struct page *p, const char *const *heading) {
  cmp_page_open(p, "tr", NULL);
  for (size_t k = 0; heading[k]; k++) cmp_page_element(p, "th", k ? NULL : "t", "%s", heading[k]);
  cmp_page_close(p);
}

void cmp_html_table_open(struct page *p) {
  cmp_page_open(p, "div", "scroll");
  cmp_page_open(p, "table", NULL);
}

void cmp_html_table_close(struct page *p) {
  cmp_page_close(p);
  cmp_page_close(p);
}

static void link_to(struct page *p, const char *name, const char *suffix, const char *label) {
  char href[160];
  snprintf(href, sizeof href, "figures/%s%s", name, suffix);
  cmp_page_open(p, "a", NULL);
  cmp_page_attribute(p, "href", href);
  cmp_page_text(p, "%s", label);
  cmp_page_close(p);
}

static void links(struct page *p, const struct cmp_figure *fig) {
  static const char *const link[][2] = {
      {".svg", "SVG"}, {".pdf", "PDF"}, {".png", "PNG"}, {".gp", "script"}};
  cmp_page_open(p, "span", NULL);
  for (size_t k = *fig->missing ? 3 : 0; k < sizeof link / sizeof *link; k++) {
    link_to(p, fig->name, link[k][0], link[k][1]);
    if (k < 3) cmp_page_text(p, " · ");
  }
  cmp_page_close(p);
}

static enum status image_show(struct page *p, const struct cmp_figures *figures,
                              const struct cmp_figure *fig) {
  char file[128], path[PATH_MAX], *bytes;
  size_t n;
  snprintf(file, sizeof file, "%s%s", fig->name, fig->raster ? ".png" : ".svg");
  TRY(cmp_path_join(figures->dir, file, path));
  TRY(cmp_file_read(path, &bytes, &n));
  cmp_page_open(p, "div", NULL);
  cmp_page_image(p, fig->raster ? "image/png" : "image/svg+xml", bytes, n, fig->caption, fig->width,
                 fig->height);
  cmp_page_close(p);
  free(bytes);
  return OK;
}

static enum status figure_show(struct page *p, const struct cmp_figures *figures,
                               const struct cmp_figure *fig) {
  cmp_page_open(p, "figure", NULL);
  if (*fig->missing)
    cmp_page_element(p, "p", "why", "The figure %s is missing: %s.", fig->name, fig->missing);
  else
    TRY(image_show(p, figures, fig));
  cmp_page_open(p, "figcaption", NULL);
  cmp_page_text(p, "%s ", fig->caption);
  links(p, fig);
  cmp_page_close(p);
  cmp_page_close(p);
  return OK;
}

enum status cmp_html_figures(struct page *p, const struct cmp_figures *figures,
                             enum cmp_section section) {
  size_t shown = 0;
  for (size_t k = 0; k < figures->n; k++) {
    if (figures->figure[k].section != section) continue;
    TRY(figure_show(p, figures, &figures->figure[k]));
    shown++;
  }
  if (!shown)
    cmp_page_element(p, "p", "soft", "No figure: none of the files has what it would show.");
  return OK;
}
