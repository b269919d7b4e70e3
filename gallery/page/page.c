#include "gallery/page/page.h"

#include <string.h>

#include "compare/markup.h"
#include "compare/output.h"
#include "embed/gallery_page_script.h"
#include "embed/gallery_page_style.h"
#include "embed/gallery_page_template.h"
#include "gallery/json.h"
#include "gallery/page/content.h"

/* ---- verdicts ---- */

void gallery_verdict_write(struct markup *m, const json_t *e) {
  char class[64];
  const enum gallery_verdict k = gallery_json_verdict(e);
  snprintf(class, sizeof class, "verdict %s", gallery_verdict_names[k]);
  cmp_markup_element(m, "span", class, "%s", gallery_verdict_words[k]);
}

static size_t count(const json_t *entries, enum gallery_verdict verdict) {
  size_t i, n = 0;
  json_t *e;
  json_array_foreach(entries, i, e) n += gallery_json_verdict(e) == verdict;
  return n;
}

/* ---- groups: a document, or a chapter of it ---- */

struct group {
  const char *name, *title; /* what ids begin with */
};
static const struct group groups[] = {
    {"P", "P: Antuono, Colagrossi & Marrone"}, {"T 2", "T, chapter 2: stability of SPH"},
    {"T 3", "T, chapter 3: ingredients"},      {"T 4", "T, chapter 4: simulations"},
    {"T", "T: the rest"},
};
enum { GROUPS = sizeof groups / sizeof *groups };

static size_t group_of(const json_t *e) {
  const char *id = gallery_text(e, "id");
  char chapter[8];
  if (*id == 'P') return 0;
  const char *digit = id + strcspn(id, "0123456789");
  snprintf(chapter, sizeof chapter, "T %.1s", digit);
  for (size_t k = 1; k < GROUPS; k++)
    if (!strcmp(groups[k].name, chapter)) return k;
  return GROUPS - 1;
}

static bool group_is_empty(const struct page_content *c, size_t group) {
  size_t i;
  json_t *e;
  json_array_foreach(c->entries, i, e) if (group_of(e) == group) return false;
  return true;
}

static void id_of(size_t group, char id[24]) {
  snprintf(id, 24, "of-%s", groups[group].name);
  for (char *p = id; *p; p++)
    if (*p == ' ') *p = '-';
}

/* ---- parts of the template ---- */

static enum status write_style(struct markup *m, const void *content) {
  (void)content;
  cmp_markup_raw(m, gallery_page_style, gallery_page_style_size);
  return OK;
}

static enum status write_script(struct markup *m, const void *content) {
  (void)content;
  cmp_markup_raw(m, gallery_page_script, gallery_page_script_size);
  return OK;
}

static enum status write_contents(struct markup *m, const void *content) {
  for (size_t k = 0; k < GROUPS; k++) {
    char id[24], href[32];
    if (group_is_empty(content, k)) continue;
    id_of(k, id);
    snprintf(href, sizeof href, "#%s", id);
    cmp_markup_open(m, "a", NULL);
    cmp_markup_attribute(m, "href", href);
    cmp_markup_text(m, k ? groups[k].name : "P");
    cmp_markup_close(m);
  }
  return OK;
}

static void option(struct markup *m, const char *value, const char *text) {
  cmp_markup_open(m, "option", NULL);
  cmp_markup_attribute(m, "value", value);
  cmp_markup_text(m, text);
  cmp_markup_close(m);
}

static enum status write_groups(struct markup *m, const void *content) {
  for (size_t k = 0; k < GROUPS; k++)
    if (!group_is_empty(content, k)) option(m, groups[k].name, groups[k].title);
  return OK;
}

static enum status write_verdicts(struct markup *m, const void *content) {
  const struct page_content *c = content;
  for (int k = 0; k < GALLERY_N_VERDICTS; k++)
    if (count(c->entries, (enum gallery_verdict)k))
      option(m, gallery_verdict_names[k], gallery_verdict_words[k]);
  return OK;
}

static void tally_write(struct markup *m, const struct page_content *c) {
  cmp_markup_open(m, "ul", "tally");
  for (int k = 0; k < GALLERY_N_VERDICTS; k++) {
    const size_t n = count(c->entries, (enum gallery_verdict)k);
    char class[64], text[80];
    if (!n) continue;
    snprintf(class, sizeof class, "verdict %s", gallery_verdict_names[k]);
    snprintf(text, sizeof text, "%zu %s", n, gallery_verdict_words[k]);
    cmp_markup_open(m, "li", NULL);
    cmp_markup_open(m, "span", class);
    cmp_markup_attribute(m, "data-of", gallery_verdict_names[k]);
    cmp_markup_text(m, text);
    cmp_markup_close(m);
    cmp_markup_close(m);
  }
  cmp_markup_close(m);
}

static void missing_write(struct markup *m, const json_t *missing) {
  size_t i;
  json_t *id;
  cmp_markup_open(m, "p", "soft");
  cmp_markup_text(m, "Not made here: ");
  json_array_foreach(missing, i, id) {
    if (i) cmp_markup_text(m, ", ");
    cmp_markup_text(m, json_string_value(id));
  }
  cmp_markup_text(m, ".");
  cmp_markup_close(m);
}

static enum status write_lead(struct markup *m, const void *content) {
  const struct page_content *c = content;
  size_t i, checks = 0, hold = 0, changed = 0;
  json_t *e;
  json_array_foreach(c->entries, i, e) {
    const struct gallery_tally t = gallery_json_tally(e);
    checks += t.checks;
    hold += t.hold;
    changed += t.changed;
  }
  const json_t *missing = json_object_get(c->gallery, "not_made");
  const size_t made = json_array_size(c->entries), all = made + json_array_size(missing);
  char of[64] = "";
  if (made < all) snprintf(of, sizeof of, " of the %zu", all);
  cmp_markup_element(
      m, "p", "lead",
      "%zu%s entries of two documents, made anew by plunge: P, Antuono, Colagrossi & "
      "Marrone, and T, the thesis of Kiara. %zu of %zu checks hold. Where a document "
      "is wrong in print, what follows from its equations is drawn and the remarks "
      "say why.%s",
      made, of, hold, checks, changed ? " Something has changed: see the entries marked so." : "");
  tally_write(m, c);
  if (json_is_true(json_object_get(c->gallery, "quick")))
    cmp_markup_element(
        m, "p", "soft",
        "Made with --quick: runs are coarser, and some entries and checks are left out.");
  if (made < all) missing_write(m, missing);
  cmp_markup_element(m, "p", "soft", "plunge %s, revision %s.", gallery_text(c->gallery, "plunge"),
                     gallery_text(c->gallery, "revision"));
  return OK;
}

static enum status card_write(struct markup *m, const struct page_content *c, const json_t *e) {
  char href[80];
  cmp_markup_open(m, "li", NULL);
  cmp_markup_attribute(m, "data-group", groups[group_of(e)].name);
  cmp_markup_attribute(m, "data-verdict", gallery_verdict_names[gallery_json_verdict(e)]);
  cmp_markup_attribute(m, "data-entry", gallery_text(e, "key"));
  snprintf(href, sizeof href, "#%.70s", gallery_text(e, "key"));
  cmp_markup_open(m, "a", NULL);
  cmp_markup_attribute(m, "href", href);
  cmp_markup_open(m, "span", "thumb");
  TRY(gallery_thumb_write(m, c, e));
  cmp_markup_close(m);
  cmp_markup_open(m, "span", NULL);
  cmp_markup_element(m, "b", NULL, "%s", gallery_text(e, "id"));
  cmp_markup_text(m, " ");
  cmp_markup_text(m, gallery_text(e, "title"));
  cmp_markup_close(m);
  gallery_verdict_write(m, e);
  cmp_markup_close(m);
  cmp_markup_close(m);
  return OK;
}

static enum status write_cards(struct markup *m, const void *content) {
  const struct page_content *c = content;
  size_t i;
  json_t *e;
  cmp_markup_open(m, "section", NULL);
  cmp_markup_attribute(m, "aria-label", "All entries");
  cmp_markup_open(m, "ul", "cards");
  json_array_foreach(c->entries, i, e) TRY(card_write(m, c, e));
  cmp_markup_close(m);
  cmp_markup_close(m);
  return OK;
}

static void entry_open(struct markup *m, const json_t *e) {
  cmp_markup_open(m, "article", NULL);
  cmp_markup_attribute(m, "id", gallery_text(e, "key"));
  cmp_markup_attribute(m, "data-group", groups[group_of(e)].name);
  cmp_markup_attribute(m, "data-verdict", gallery_verdict_names[gallery_json_verdict(e)]);
}

static enum status write_entries(struct markup *m, const void *content) {
  const struct page_content *c = content;
  for (size_t k = 0; k < GROUPS; k++) {
    char id[24];
    size_t i;
    json_t *e;
    if (group_is_empty(c, k)) continue;
    id_of(k, id);
    cmp_markup_open(m, "section", NULL);
    cmp_markup_attribute(m, "id", id);
    cmp_markup_attribute(m, "data-group", groups[k].name);
    cmp_markup_element(m, "h2", NULL, "%s", groups[k].title);
    json_array_foreach(c->entries, i, e) {
      if (group_of(e) != k) continue;
      entry_open(m, e);
      TRY(gallery_entry_write(m, c, e));
      cmp_markup_close(m);
    }
    cmp_markup_close(m);
  }
  return OK;
}

enum status gallery_page_write(const char *dir, const json_t *gallery) {
  static const struct markup_part parts[] = {
      {"style", write_style},       {"script", write_script}, {"contents", write_contents},
      {"groups", write_groups},     {"verdicts", write_verdicts}, {"lead", write_lead},
      {"cards", write_cards},       {"entries", write_entries}, {NULL, NULL}};
  const struct page_content content = {
      .dir = dir, .gallery = gallery, .entries = json_object_get(gallery, "entries")};
  char path[PATH_MAX];
  struct cmp_output o;
  TRY(cmp_path_join(dir, "gallery.html", path));
  TRY(cmp_output_open(path, &o));
  enum status status = cmp_markup_fill(o.stream, gallery_page_template, gallery_page_template_size,
                                       parts, &content);
  if (status == OK) status = cmp_output_commit(&o);
  cmp_output_abandon(&o);
  return status;
}
