#include "compare/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/text.h"

char *cmp_text_copy(const char *text) {
  return text_visible(text ? text : "", "\n\t\r");
}

void cmp_text_fit(const char *text, char *out, size_t room) {
  char *copy = text_visible(text, "");
  size_t n = copy ? strlen(copy) : 0;
  if (n >= room) {
    static const char mark[] = "…";
    const char *cut = text_bad_utf8(copy, room - sizeof mark); /* a character cut in half */
    n = cut ? (size_t)(cut - copy) : room - sizeof mark;
    memcpy(copy + n, mark, sizeof mark); /* it was longer */
    n += sizeof mark - 1;
  }
  if (n) memcpy(out, copy, n);
  out[n] = 0;
  free(copy);
}

/* With the quotes in it doubled, as gnuplot's single and CSV's double ones want it: nothing else
 * means anything there. */
static void quoted(FILE *out, const char *text, char quote) {
  char *copy = text_visible(text, "");
  fputc(quote, out);
  for (const char *c = copy ? copy : ""; *c; c++) {
    if (*c == quote) fputc(quote, out);
    fputc(*c, out);
  }
  fputc(quote, out);
  free(copy);
}

/* gnuplot takes two quotes that begin a string for an empty one: leading ones are another string.
 */
void cmp_gnuplot_string(FILE *script, const char *text) {
  const size_t n = strspn(text, "'");
  if (n) fprintf(script, "\"%.*s\".", (int)n, text);
  quoted(script, text + n, '\'');
}

/* Spreadsheets take what begins with one of these for a formula, quoted or not, and what begins
 * with an apostrophe for text. */
void cmp_csv_string(FILE *data, const char *text) {
  char *safe = NULL;
  if (*text && strchr("=+-@", *text) && asprintf(&safe, "'%s", text) < 0) safe = NULL;
  quoted(data, safe ? safe : text, '"');
  free(safe);
}

void cmp_slug(const char *text, char *out, size_t room) {
  size_t n = 0;
  for (; *text && n + 1 < room; text++)
    out[n++] = isalnum((unsigned char)*text) || *text == '_' ? *text : '-';
  if (*out == '-') *out = '_'; /* a file of that name would be an option */
  out[n] = 0;
}
