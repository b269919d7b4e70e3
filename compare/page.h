/* A small HTML writer over libxml2's text writer: tags close in order and all text is escaped by
 * construction. Errors are remembered and reported once, at the end. */
#pragma once
#include <stdbool.h>
#include <stdio.h>

#include "common/base/status.h"

struct page;

/* Writes to `stream`, which stays the caller's. NULL: no memory. */
struct page *cmp_page_create(FILE *stream);
/* Closes what is open; false when anything could not be written. */
bool cmp_page_finish(struct page *p);
void cmp_page_destroy(struct page *p);

void cmp_page_open(struct page *p, const char *tag, const char *class); /* class may be NULL */
void cmp_page_attribute(struct page *p, const char *name, const char *value); /* right after open */
void cmp_page_close(struct page *p);
void cmp_page_text(struct page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void cmp_page_raw(struct page *p, const char *markup); /* ours only, never from a file */

/* <tag class="class">text</tag> */
void cmp_page_element(struct page *p, const char *tag, const char *class, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* An image inside the page, as a data: URI. `type` is "image/png" or "image/svg+xml". */
void cmp_page_image(struct page *p, const char *type, const char *bytes, size_t n, const char *alt,
                    int width, int height);
