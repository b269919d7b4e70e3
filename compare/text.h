/* Text from files on its way into other formats: whatever it holds, it stays text, and what cannot
 * be shown is made visible (common/base/text.h). */
#pragma once
#include <stddef.h>
#include <stdio.h>

/* With tabs and line ends as they are; NULL gives ""; NULL back: no memory. */
char *cmp_text_copy(const char *text);
void cmp_text_fit(const char *text, char *out, size_t room); /* in one line; cut, with a mark, if too long */

void cmp_gnuplot_string(FILE *script, const char *text); /* quoted */
void cmp_csv_string(FILE *data, const char *text);       /* quoted, and no formula */
void cmp_slug(const char *text, char *out, size_t room); /* letters, digits, _; others as - */
