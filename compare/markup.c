#include "compare/markup.h"

#include <libxml/xmlwriter.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text.h"

struct markup {
  xmlTextWriterPtr writer;
  bool xml, failed;
};

static void note(struct markup *m, int outcome) {
  if (outcome < 0) m->failed = true;
}

struct markup *cmp_markup_create(FILE *stream, bool xml) {
  struct markup *m = calloc(1, sizeof *m);
  if (!m) return NULL;
  m->xml = xml;
  xmlOutputBufferPtr buffer = xmlOutputBufferCreateFile(stream, NULL);
  m->writer = buffer ? xmlNewTextWriter(buffer) : NULL;
  if (!m->writer) {
    if (buffer) xmlOutputBufferClose(buffer);
    free(m);
    return NULL;
  }
  if (!xml) return m;
  note(m, xmlTextWriterSetIndent(m->writer, 1));
  note(m, xmlTextWriterStartDocument(m->writer, NULL, "UTF-8", NULL));
  return m;
}

bool cmp_markup_finish(struct markup *m) {
  note(m, xmlTextWriterEndDocument(m->writer));
  note(m, xmlTextWriterFlush(m->writer));
  return !m->failed;
}

void cmp_markup_destroy(struct markup *m) {
  if (!m) return;
  xmlFreeTextWriter(m->writer);
  free(m);
}

void cmp_markup_open(struct markup *m, const char *tag, const char *class) {
  note(m, xmlTextWriterStartElement(m->writer, BAD_CAST tag));
  if (class) cmp_markup_attribute(m, "class", class);
}

void cmp_markup_attribute(struct markup *m, const char *name, const char *value) {
  char *clean = cmp_text_copy(value);
  note(m, clean ? xmlTextWriterWriteAttribute(m->writer, BAD_CAST name, BAD_CAST clean) : -1);
  free(clean);
}

void cmp_markup_number(struct markup *m, const char *name, size_t n) {
  char text[32];
  snprintf(text, sizeof text, "%zu", n);
  cmp_markup_attribute(m, name, text);
}

void cmp_markup_close(struct markup *m) {
  /* "full" in HTML: never <td/>, which it would take for an opening tag */
  note(m, m->xml ? xmlTextWriterEndElement(m->writer) : xmlTextWriterFullEndElement(m->writer));
}

void cmp_markup_close_void(struct markup *m) {
  note(m, xmlTextWriterEndElement(m->writer));
}

/* Escaped here, since the writer escapes within elements of its own alone, not those of a template. */
void cmp_markup_text(struct markup *m, const char *text) {
  char *visible = cmp_text_copy(text);
  xmlChar *escaped = visible ? xmlEncodeSpecialChars(NULL, BAD_CAST visible) : NULL;
  note(m, escaped ? xmlTextWriterWriteRaw(m->writer, escaped) : -1);
  xmlFree(escaped);
  free(visible);
}

void cmp_markup_raw(struct markup *m, const char *bytes, size_t n) {
  while (n) {
    const size_t most = 1 << 20, part = n < most ? n : most;
    note(m, xmlTextWriterWriteRawLen(m->writer, BAD_CAST bytes, (int)part));
    bytes += part;
    n -= part;
  }
}

enum status cmp_markup_json(struct markup *m, const json_t *value) {
  char *text = json_dumps(value, JSON_COMPACT | JSON_REAL_PRECISION(17));
  CHECK(text, ERR_MEMORY, "no memory for a page");
  const char *at = text;
  for (const char *end; (end = strchr(at, '<')); at = end + 1) {
    cmp_markup_raw(m, at, (size_t)(end - at));
    cmp_markup_raw(m, "\\u003c", 6);
  }
  cmp_markup_raw(m, at, strlen(at));
  free(text);
  return OK;
}

void cmp_markup_element(struct markup *m, const char *tag, const char *class, const char *format,
                        ...) {
  va_list args;
  char *text = NULL;
  va_start(args, format);
  if (vasprintf(&text, format, args) < 0) text = NULL;
  va_end(args);
  m->failed = m->failed || !text;
  cmp_markup_open(m, tag, class);
  cmp_markup_text(m, text);
  cmp_markup_close(m);
  free(text);
}

void cmp_markup_table(struct markup *m, const char *id, size_t left, const char *const *heading) {
  cmp_markup_open(m, "div", "scroll");
  cmp_markup_attribute(m, "tabindex", "0");
  cmp_markup_open(m, "table", NULL);
  if (id) cmp_markup_attribute(m, "id", id);
  cmp_markup_open(m, "thead", NULL);
  cmp_markup_open(m, "tr", NULL);
  for (size_t k = 0; heading[k]; k++) {
    cmp_markup_open(m, "th", k < left ? "t" : NULL);
    cmp_markup_attribute(m, "scope", "col");
    cmp_markup_text(m, heading[k]);
    cmp_markup_close(m);
  }
  cmp_markup_close(m);
  cmp_markup_close(m);
  cmp_markup_open(m, "tbody", NULL);
}

void cmp_markup_table_close(struct markup *m) {
  for (int k = 0; k < 3; k++) cmp_markup_close(m);
}

/* Bytes of a picture as text of a URI: those that a URI keeps stay, which takes less room than
 * base64 where most do. */
static void uri_write(struct markup *m, const char *bytes, size_t n) {
  static const char digits[] = "0123456789ABCDEF";
  char part[3 * 512];
  size_t used = 0;
  for (size_t i = 0; i < n; i++) {
    const unsigned char c = (unsigned char)bytes[i];
    if (c < ' ' || c >= 0x7f || strchr("<>#%\"'&?", c)) {
      part[used++] = '%';
      part[used++] = digits[c >> 4];
      part[used++] = digits[c & 15];
    } else {
      part[used++] = (char)c;
    }
    if (used + 3 > sizeof part || i + 1 == n) {
      cmp_markup_raw(m, part, used);
      used = 0;
    }
  }
}

void cmp_markup_image(struct markup *m, const char *type, const char *bytes, size_t n,
                      const char *alt, int width, int height) {
  note(m, xmlTextWriterStartElement(m->writer, BAD_CAST "img"));
  cmp_markup_attribute(m, "loading", "lazy");
  cmp_markup_number(m, "width", (size_t)width);
  cmp_markup_number(m, "height", (size_t)height);
  cmp_markup_attribute(m, "alt", alt);
  note(m, xmlTextWriterStartAttribute(m->writer, BAD_CAST "src"));
  if (!strcmp(type, "image/svg+xml")) {
    note(m, xmlTextWriterWriteString(m->writer, BAD_CAST "data:image/svg+xml,"));
    uri_write(m, bytes, n);
  } else {
    note(m, xmlTextWriterWriteFormatString(m->writer, "data:%s;base64,", type));
    note(m, xmlTextWriterWriteBase64(m->writer, bytes, 0, (int)n));
  }
  note(m, xmlTextWriterEndAttribute(m->writer));
  cmp_markup_close_void(m);
}

/* ---- templates ---- */

static enum status part_write(struct markup *m, const struct markup_part *part,
                              const void *content, const char *name, size_t n) {
  for (; part->name; part++)
    if (strlen(part->name) == n && !memcmp(part->name, name, n)) return part->write(m, content);
  return status_raise(ERR_USAGE, "the template of the page asks for %.*s", (int)n, name);
}

static enum status template_write(struct markup *m, const char *at, size_t n,
                                  const struct markup_part *part, const void *content) {
  const char *end = at + n, *open, *close;
  while ((open = strstr(at, "{{")) && (close = strstr(open, "}}"))) {
    cmp_markup_raw(m, at, (size_t)(open - at));
    TRY(part_write(m, part, content, open + 2, (size_t)(close - open - 2)));
    at = close + 2;
  }
  cmp_markup_raw(m, at, (size_t)(end - at));
  return OK;
}

enum status cmp_markup_fill(FILE *out, const char *template, size_t n,
                            const struct markup_part *part, const void *content) {
  struct markup *m = cmp_markup_create(out, false);
  CHECK(m, ERR_MEMORY, "no memory for a page");
  enum status status = template_write(m, template, n, part, content);
  if (!cmp_markup_finish(m) && status == OK) status = status_raise(ERR_IO, "cannot write the page");
  cmp_markup_destroy(m);
  return status;
}
