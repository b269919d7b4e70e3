/* What the page is made of, and its parts that are files of their own. Internal. */
#pragma once
#include <jansson.h>

#include "compare/markup.h"
#include "gallery/json.h"

struct page_content {
  const char *dir;         /* of the page */
  const json_t *gallery;   /* gallery.json */
  const json_t *entries;   /* its list */
};

/* The verdict of an entry in a few words. */
void gallery_verdict_write(struct markup *m, const json_t *e);

/* A small picture of its first figure, or words in its place. ERR_MEMORY. */
enum status gallery_thumb_write(struct markup *m, const struct page_content *c, const json_t *e);

/* Everything about an entry. */
enum status gallery_entry_write(struct markup *m, const struct page_content *c, const json_t *e);

/* Its checks as a table. */
void gallery_checks_write(struct markup *m, const json_t *e);
