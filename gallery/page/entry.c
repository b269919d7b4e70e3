#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "compare/figure.h"
#include "compare/output.h"
#include "gallery/json.h"
#include "gallery/page/content.h"

/* ---- pictures ---- */

static bool is_there(const struct page_content *c, const char *file) {
  char path[PATH_MAX];
  return cmp_path_join(c->dir, file, path) == OK && access(path, R_OK) == 0;
}

/* A link to a file, or words in `tag` where it is not there. */
static void reference_write(struct markup *m, const struct page_content *c, const char *file,
                            const char *words, const char *tag) {
  const bool there = is_there(c, file);
  cmp_markup_open(m, there ? "a" : tag, NULL);
  if (there) cmp_markup_attribute(m, "href", file);
  cmp_markup_text(m, words);
  cmp_markup_close(m);
}

static void path_of(const json_t *file, const char *suffix, char out[160]) {
  snprintf(out, 160, "figures/%.96s%s", gallery_text(file, "name"), suffix);
}

/* The first file of the first figure that has any. */
static const json_t *first_file(const json_t *e) {
  size_t i;
  json_t *figure;
  json_array_foreach(json_object_get(e, "figures"), i, figure) {
    const json_t *file = json_array_get(json_object_get(figure, "files"), 0);
    if (file && !*gallery_text(file, "missing")) return file;
  }
  return NULL;
}

/* Width and height stand in the head of a PNG. */
static int png_number(const char *bytes, size_t at) {
  const unsigned char *b = (const unsigned char *)bytes + at;
  return b[0] << 24 | b[1] << 16 | b[2] << 8 | b[3];
}

enum status gallery_thumb_write(struct markup *m, const struct page_content *c, const json_t *e) {
  const json_t *file = first_file(e);
  char name[160], path[PATH_MAX], *bytes;
  size_t n;
  if (file) {
    path_of(file, ".thumb.png", name);
    if (is_there(c, name)) {
      TRY(cmp_path_join(c->dir, name, path));
      TRY(cmp_file_read(path, &bytes, &n));
      if (n > 24)
        cmp_markup_image(m, "image/png", bytes, n, "", png_number(bytes, 16),
                         png_number(bytes, 20));
      free(bytes);
      return OK;
    }
  }
  cmp_markup_text(m, json_array_size(json_object_get(e, "figures")) && !file ? "table"
                     : file                                                  ? "figure"
                                                                             : "no figure");
  return OK;
}

static void link_write(struct markup *m, const struct page_content *c, const json_t *file,
                       const char *suffix, const char *text) {
  char path[160];
  path_of(file, suffix, path);
  if (!is_there(c, path)) return;
  cmp_markup_open(m, "a", NULL);
  cmp_markup_attribute(m, "href", path);
  cmp_markup_text(m, text);
  cmp_markup_close(m);
  cmp_markup_text(m, " ");
}

static void links_write(struct markup *m, const struct page_content *c, const json_t *file) {
  cmp_markup_open(m, "span", "links");
  for (size_t k = 0; k < CMP_FORMATS; k++)
    link_write(m, c, file, cmp_formats[k].suffix, cmp_formats[k].says);
  link_write(m, c, file, ".csv", "numbers");
  link_write(m, c, file, ".gp", "script");
  cmp_markup_close(m);
}

static void picture_write(struct markup *m, const struct page_content *c, const json_t *e,
                          const json_t *file) {
  const double width = json_number_value(json_object_get(file, "width"));
  char path[160], alt[320], size[48];
  const char *missing = gallery_text(file, "missing");
  path_of(file, json_is_true(json_object_get(file, "raster")) ? ".png" : ".svg", path);
  if (*missing || !is_there(c, path)) {
    cmp_markup_element(m, "p", "soft", "The figure %s is missing%s%s.", gallery_text(file, "name"),
                       *missing ? ": " : "", missing);
    return;
  }
  snprintf(alt, sizeof alt, "%.40s: %.250s", gallery_text(e, "id"), gallery_text(e, "title"));
  snprintf(size, sizeof size, "width: %.4grem", width / 16); /* as large as the text around it */
  cmp_markup_open(m, "div", "paper");
  cmp_markup_open(m, "img", NULL);
  cmp_markup_attribute(m, "loading", "lazy");
  cmp_markup_attribute(m, "src", path);
  cmp_markup_attribute(m, "style", size);
  cmp_markup_number(m, "width", (size_t)width);
  cmp_markup_number(m, "height", (size_t)json_integer_value(json_object_get(file, "height")));
  cmp_markup_attribute(m, "alt", alt);
  cmp_markup_close_void(m);
  cmp_markup_close(m);
}

static void caption_write(struct markup *m, const struct page_content *c, const json_t *figure) {
  size_t i;
  json_t *file;
  cmp_markup_open(m, "figcaption", NULL);
  cmp_markup_text(m, gallery_text(figure, "caption"));
  json_array_foreach(json_object_get(figure, "files"), i, file) {
    cmp_markup_text(m, " ");
    links_write(m, c, file);
  }
  if (json_object_get(figure, "table")) {
    cmp_markup_text(m, " ");
    links_write(m, c, figure);
  }
  cmp_markup_close(m);
}

static void table_write(struct markup *m, const json_t *table) {
  size_t i, k;
  json_t *row, *cell;
  cmp_markup_open(m, "div", "scroll");
  cmp_markup_attribute(m, "tabindex", "0");
  cmp_markup_open(m, "table", NULL);
  cmp_markup_open(m, "thead", NULL);
  cmp_markup_open(m, "tr", NULL);
  json_array_foreach(json_object_get(table, "head"), k, cell) {
    cmp_markup_open(m, "th", NULL);
    cmp_markup_attribute(m, "scope", "col");
    cmp_markup_text(m, json_string_value(cell));
    cmp_markup_close(m);
  }
  cmp_markup_close(m);
  cmp_markup_close(m);
  cmp_markup_open(m, "tbody", NULL);
  json_array_foreach(json_object_get(table, "rows"), i, row) {
    cmp_markup_open(m, "tr", NULL);
    json_array_foreach(row, k, cell)
        cmp_markup_element(m, "td", "t", "%s", json_string_value(cell));
    cmp_markup_close(m);
  }
  cmp_markup_table_close(m);
}

static void figure_write(struct markup *m, const struct page_content *c, const json_t *e,
                         const json_t *figure) {
  const json_t *table = json_object_get(figure, "table");
  size_t i;
  json_t *file;
  cmp_markup_open(m, "figure", table ? "set" : NULL);
  json_array_foreach(json_object_get(figure, "files"), i, file) picture_write(m, c, e, file);
  if (table) table_write(m, table);
  if (*gallery_text(figure, "failure"))
    cmp_markup_element(m, "p", "soft", "This figure could not be made: %s.",
                       gallery_text(figure, "failure"));
  caption_write(m, c, figure);
  cmp_markup_close(m);
}

/* ---- words ---- */

static void remarks_write(struct markup *m, const json_t *e) {
  const json_t *remarks = json_object_get(e, "remarks");
  size_t i;
  json_t *remark;
  if (!json_array_size(remarks)) return;
  cmp_markup_element(m, "h4", NULL, "Misprints and traps");
  cmp_markup_open(m, "ul", NULL);
  json_array_foreach(remarks, i, remark)
      cmp_markup_element(m, "li", NULL, "%s", json_string_value(remark));
  cmp_markup_close(m);
}

static void runs_write(struct markup *m, const struct page_content *c, const json_t *e) {
  const json_t *runs = json_object_get(e, "runs");
  size_t i;
  json_t *run;
  if (!json_array_size(runs)) return;
  cmp_markup_open(m, "p", "soft");
  cmp_markup_text(m, json_array_size(runs) == 1 ? "Run: " : "Runs: ");
  json_array_foreach(runs, i, run) {
    char path[300];
    const char *name = json_string_value(run);
    snprintf(path, sizeof path, "runs/%.200s.h5", name);
    if (i) cmp_markup_text(m, ", ");
    reference_write(m, c, path, name, "span");
  }
  cmp_markup_text(m, ".");
  cmp_markup_close(m);
}

/* The case files of its runs. */
static void cases_write(struct markup *m, const struct page_content *c, const json_t *e) {
  size_t i;
  json_t *of;
  const json_t *cases = json_object_get(e, "cases");
  if (!json_array_size(cases)) return;
  cmp_markup_open(m, "p", "soft");
  cmp_markup_text(m, json_array_size(cases) > 1 ? "Cases: " : "Case: ");
  json_array_foreach(cases, i, of) {
    if (i) cmp_markup_text(m, ", ");
    reference_write(m, c, gallery_text(of, "file"), gallery_text(of, "file"), "code");
  }
  cmp_markup_text(m, ".");
  cmp_markup_close(m);
}

static void origin_write(struct markup *m, const struct page_content *c, const json_t *e) {
  size_t i;
  json_t *of;
  const json_t *cases = json_object_get(e, "cases");
  cmp_markup_element(m, "h4", NULL, "Made by, in the folder of this page");
  cmp_markup_element(m, "pre", NULL, "%s", gallery_text(e, "command"));
  if (json_array_size(cases)) {
    cmp_markup_element(m, "p", "soft", "which makes its runs as these do:");
    cmp_markup_open(m, "pre", NULL);
    json_array_foreach(cases, i, of) {
      if (i) cmp_markup_text(m, "\n");
      cmp_markup_text(m, gallery_text(of, "command"));
    }
    cmp_markup_close(m);
  }
  runs_write(m, c, e);
  cases_write(m, c, e);
}

enum status gallery_entry_write(struct markup *m, const struct page_content *c, const json_t *e) {
  const char *failure = gallery_text(e, "failure"), *broke_off = gallery_text(e, "broke_off"),
             *unsound = gallery_text(e, "not_believed");
  size_t i;
  json_t *figure;
  cmp_markup_open(m, "h3", NULL);
  cmp_markup_element(m, "span", "id", "%s", gallery_text(e, "id"));
  cmp_markup_text(m, gallery_text(e, "title"));
  cmp_markup_close(m);
  cmp_markup_open(m, "p", "soft");
  gallery_verdict_write(m, e);
  cmp_markup_text(m, " ");
  cmp_markup_text(m, gallery_text(e, "where"));
  cmp_markup_text(m, "; ");
  cmp_markup_text(m, gallery_text(e, "kind"));
  if (gallery_json_tally(e).changed) cmp_markup_element(m, "b", "not", " Something has changed.");
  cmp_markup_close(m);
  if (*failure) cmp_markup_element(m, "p", NULL, "It could not be made: %s.", failure);
  if (*broke_off) cmp_markup_element(m, "p", NULL, "A run ended early: %s.", broke_off);
  if (*unsound)
    cmp_markup_element(m, "p", NULL, "A run has failed by its own measures: %s.", unsound);
  json_array_foreach(json_object_get(e, "figures"), i, figure) figure_write(m, c, e, figure);
  cmp_markup_element(m, "p", NULL, "%s", gallery_text(e, "setup"));
  gallery_checks_write(m, e);
  remarks_write(m, e);
  origin_write(m, c, e);
  return OK;
}
