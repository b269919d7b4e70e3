#include "compare/page/html.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/page/planes.h"
#include "compare/text.h"

static void escape(FILE *out, const char *text) {
  char *copy = cmp_text_copy(text);
  for (const char *c = copy ? copy : ""; *c; c++) switch (*c) {
    case '&':
      fputs("&amp;", out);
      break;
    case '<':
      fputs("&lt;", out);
      break;
    case '>':
      fputs("&gt;", out);
      break;
    case '"':
      fputs("&quot;", out);
      break;
    case '\'':
      fputs("&#39;", out);
      break;
    default:
      fputc(*c, out);
    }
  free(copy);
}

static void text_write(FILE *out, const char *format, va_list args) {
  char *text = NULL;
  if (vasprintf(&text, format, args) < 0) return;
  escape(out, text);
  free(text);
}

void cmp_html_text(FILE *out, const char *format, ...) {
  va_list args;
  va_start(args, format);
  text_write(out, format, args);
  va_end(args);
}

void cmp_html_element(FILE *out, const char *tag, const char *class, const char *format, ...) {
  va_list args;
  fprintf(out, class ? "<%s class=\"%s\">" : "<%s>", tag, class);
  va_start(args, format);
  text_write(out, format, args);
  va_end(args);
  fprintf(out, "</%s>", tag);
}

void cmp_html_value(FILE *out, const struct cmp_value *v) {
  if (cmp_known(v)) {
    cmp_html_element(out, "td", NULL, "%.4g", v->value);
    return;
  }
  fputs("<td class=\"na\" title=\"", out);
  cmp_html_text(out, "%s", v->why);
  fputs("\">n/a", out);
  cmp_html_element(out, "span", "why", "%s", v->why);
  fputs("</td>", out);
}

void cmp_html_table(FILE *out, const char *id, const char *const *heading) {
  fprintf(out, "<div class=\"scroll\" tabindex=\"0\"><table id=\"%s\"><thead><tr>", id);
  for (size_t k = 0; heading[k]; k++) cmp_html_element(out, "th", k ? NULL : "t", "%s", heading[k]);
  fputs("</tr></thead><tbody>\n", out);
}

void cmp_html_svg(FILE *out, const char *bytes, size_t n) {
  fputs("data:image/svg+xml,", out);
  for (size_t i = 0; i < n; i++)
    if (strchr("<>#%\"'&?\n\t\r", bytes[i]) || (unsigned char)bytes[i] >= 0x7f || bytes[i] < ' ')
      fprintf(out, "%%%02X", (unsigned char)bytes[i]);
    else
      fputc(bytes[i], out);
}

enum status cmp_html_data(FILE *out, const char *type, const char *bytes, size_t n) {
  char *text = cmp_base64((const uint8_t *)bytes, n);
  CHECK(text, ERR_MEMORY, "no memory for the figures of the page");
  fprintf(out, "data:%s;base64,%s", type, text);
  free(text);
  return OK;
}
