/* Text from files on its way into other formats: whatever it holds, it stays text. */
#pragma once
#include <stddef.h>
#include <stdio.h>

/* Replaces, in place, what is not UTF-8 and control characters other than tab and newline by '?'.
 */
void cmp_text_clean(char *text);
char *cmp_text_copy(const char *text); /* cleaned; NULL gives ""; NULL back: no memory */

void cmp_gnuplot_string(FILE *script, const char *text); /* quoted */
void cmp_csv_string(FILE *data, const char *text);       /* quoted */
void cmp_slug(const char *text, char *out, size_t room); /* letters, digits, _; others as - */
