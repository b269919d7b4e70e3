/* Pieces of a page. Text is escaped, and made visible (common/base/text.h), wherever it comes from.
 */
#pragma once
#include <stdio.h>

#include "compare/value.h"

void cmp_html_text(FILE *out, const char *format, ...) __attribute__((format(printf, 2, 3)));
/* <tag class="class">text</tag>; class may be NULL */
void cmp_html_element(FILE *out, const char *tag, const char *class, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* A cell with the number, or n/a and why. */
void cmp_html_value(FILE *out, const struct cmp_value *v);
/* A row of headings, from a NULL-terminated list, of a table that starts here. */
void cmp_html_table(FILE *out, const char *id, const char *const *heading);
/* data:image/svg+xml,..., which takes less room than base64 */
void cmp_html_svg(FILE *out, const char *bytes, size_t n);
/* data:TYPE;base64,... */
enum status cmp_html_data(FILE *out, const char *type, const char *bytes, size_t n);
