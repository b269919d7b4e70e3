#include "compare/diff/markup.h"

#include <libxml/xmlwriter.h>
#include <stdarg.h>
#include <stdlib.h>

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

void cmp_markup_text(struct markup *m, const char *text) {
  char *visible = cmp_text_copy(text);
  note(m, visible ? xmlTextWriterWriteString(m->writer, BAD_CAST visible) : -1);
  free(visible);
}

void cmp_markup_raw(struct markup *m, const char *markup) {
  note(m, xmlTextWriterWriteRaw(m->writer, BAD_CAST markup));
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

void cmp_markup_image(struct markup *m, const char *type, const char *bytes, size_t n,
                      const char *alt, int width, int height) {
  note(m, xmlTextWriterStartElement(m->writer, BAD_CAST "img"));
  cmp_markup_attribute(m, "alt", alt);
  cmp_markup_number(m, "width", (size_t)width);
  cmp_markup_number(m, "height", (size_t)height);
  note(m, xmlTextWriterStartAttribute(m->writer, BAD_CAST "src"));
  note(m, xmlTextWriterWriteFormatString(m->writer, "data:%s;base64,", type));
  note(m, xmlTextWriterWriteBase64(m->writer, bytes, 0, (int)n));
  note(m, xmlTextWriterEndAttribute(m->writer));
  note(m, xmlTextWriterEndElement(m->writer)); /* void element: <img/> */
}
