#include "compare/text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* Bytes of the well-formed UTF-8 character at s (RFC 3629), 0 if there is none. */
static size_t utf8_length(const unsigned char *s) {
  if (s[0] < 0x80) return 1;
  size_t n = s[0] >= 0xc2 && s[0] < 0xe0   ? 2
             : s[0] >= 0xe0 && s[0] < 0xf0 ? 3
             : s[0] >= 0xf0 && s[0] < 0xf5 ? 4
                                           : 0;
  for (size_t k = 1; k < n; k++)
    if ((s[k] & 0xc0) != 0x80) return 0;
  if (n == 3 && ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] >= 0xa0))) return 0;
  if (n == 3 && s[0] == 0xef && s[1] == 0xbf && s[2] >= 0xbe) return 0; /* U+FFFE, U+FFFF */
  if (n == 4 && ((s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] >= 0x90))) return 0;
  return n;
}

void cmp_text_clean(char *text) {
  unsigned char *to = (unsigned char *)text;
  for (const unsigned char *from = to; *from;) {
    size_t n = utf8_length(from);
    if (n == 0 || (n == 1 && ((*from < ' ' && *from != '\n' && *from != '\t') || *from == 0x7f))) {
      *to++ = '?';
      from++;
      continue;
    }
    memmove(to, from, n);
    to += n;
    from += n;
  }
  *to = 0;
}

char *cmp_text_copy(const char *text) {
  char *copy = strdup(text ? text : "");
  if (copy) cmp_text_clean(copy);
  return copy;
}

void cmp_gnuplot_string(FILE *script, const char *text) {
  fputc('\'', script); /* nothing is expanded in single quotes; a quote is doubled */
  for (; *text; text++) {
    if (*text == '\'') fputc('\'', script);
    fputc((unsigned char)*text < ' ' ? ' ' : *text, script);
  }
  fputc('\'', script);
}

void cmp_csv_string(FILE *data, const char *text) {
  fputc('"', data);
  for (; *text; text++) {
    if (*text == '"') fputc('"', data);
    fputc((unsigned char)*text < ' ' ? ' ' : *text, data);
  }
  fputc('"', data);
}

void cmp_slug(const char *text, char *out, size_t room) {
  size_t n = 0;
  for (; *text && n + 1 < room; text++)
    out[n++] = isalnum((unsigned char)*text) || *text == '_' ? *text : '-';
  out[n] = 0;
}
