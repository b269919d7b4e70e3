/* XML and HTML through libxml2's text writer: tags close in order, all text is escaped by
 * construction, and what a text holds that neither can show is made visible. Errors are remembered
 * and reported once, at the end. */
#pragma once
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"

struct markup;

/* Writes to `stream`, which stays the caller's. `xml`: begins as XML does, a tag a line. NULL: no
 * memory. */
struct markup *cmp_markup_create(FILE *stream, bool xml);
/* Closes what is open; false when anything could not be written. */
bool cmp_markup_finish(struct markup *m);
void cmp_markup_destroy(struct markup *m);

void cmp_markup_open(struct markup *m, const char *tag, const char *class); /* class may be NULL */
void cmp_markup_attribute(struct markup *m, const char *name, const char *value); /* after open */
void cmp_markup_number(struct markup *m, const char *name, size_t n);             /* likewise */
void cmp_markup_close(struct markup *m);
void cmp_markup_close_void(struct markup *m); /* of a tag that holds nothing: img */
void cmp_markup_text(struct markup *m, const char *text);
/* n bytes as they are: ours only, never from a file */
void cmp_markup_raw(struct markup *m, const char *bytes, size_t n);
/* Inside a script element: no `<` of a string may end it, nor begin a comment. */
enum status cmp_markup_json(struct markup *m, const json_t *value);

/* <tag class="class">text</tag>, the text printf style */
void cmp_markup_element(struct markup *m, const char *tag, const char *class, const char *format,
                        ...) __attribute__((format(printf, 4, 5)));

/* A row of headings, from a NULL-terminated list, of a table that starts here, the first `left` of
 * them aligned left; id may be NULL. */
void cmp_markup_table(struct markup *m, const char *id, size_t left, const char *const *heading);
void cmp_markup_table_close(struct markup *m);

/* A picture inside the page, as a data: URI. `type` is "image/png" or "image/svg+xml". */
void cmp_markup_image(struct markup *m, const char *type, const char *bytes, size_t n,
                      const char *alt, int width, int height);

/* What stands in a template for each {{name}}. */
struct markup_part {
  const char *name;
  enum status (*write)(struct markup *m, const void *content);
};
/* Writes the template with its parts to a stream, which stays the caller's. */
enum status cmp_markup_fill(FILE *out, const char *template, size_t n,
                            const struct markup_part *part, const void *content);
