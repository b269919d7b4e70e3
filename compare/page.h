/* A small HTML writer over libxml2's text writer: tags close in order and all text is escaped by
 * construction. Errors are remembered and reported once, at the end. */
#pragma once
#include <stdbool.h>
#include <stdio.h>

#include "common/status.h"

struct page;

/* Writes to `stream`, which stays the caller's. NULL: no memory. */
struct page *page_create(FILE *stream);
/* Closes what is open; false when anything could not be written. */
bool page_finish(struct page *p);
void page_destroy(struct page *p);

void page_open(struct page *p, const char *tag, const char *class);       /* class may be NULL */
void page_attribute(struct page *p, const char *name, const char *value); /* right after open */
void page_close(struct page *p);
void page_text(struct page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void page_raw(struct page *p, const char *markup); /* ours only, never from a file */

/* <tag class="class">text</tag> */
void page_element(struct page *p, const char *tag, const char *class, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* An image inside the page, as a data: URI. `type` is "image/png" or "image/svg+xml". */
void page_image(struct page *p, const char *type, const char *bytes, size_t n, const char *alt,
                int width, int height);
