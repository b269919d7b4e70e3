#include "compare/page.h"

#include <libxml/xmlwriter.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "compare/text.h"

struct page {
  xmlTextWriterPtr writer;
  bool failed;
};

static void note(struct page *p, int outcome) {
  if (outcome < 0) p->failed = true;
}

struct page *cmp_page_create(FILE *stream) {
  struct page *p = calloc(1, sizeof *p);
  if (!p) return NULL;
  xmlOutputBufferPtr buffer = xmlOutputBufferCreateFile(stream, NULL);
  p->writer = buffer ? xmlNewTextWriter(buffer) : NULL;
  if (!p->writer) {
    if (buffer) xmlOutputBufferClose(buffer);
    free(p);
    return NULL;
  }
  cmp_page_raw(p, "<!DOCTYPE html>\n");
  return p;
}

bool cmp_page_finish(struct page *p) {
  note(p, xmlTextWriterEndDocument(p->writer));
  note(p, xmlTextWriterFlush(p->writer));
  return !p->failed;
}

void cmp_page_destroy(struct page *p) {
  if (!p) return;
  xmlFreeTextWriter(p->writer);
  free(p);
}

void cmp_page_open(struct page *p, const char *tag, const char *class) {
  note(p, xmlTextWriterStartElement(p->writer, BAD_CAST tag));
  if (class) cmp_page_attribute(p, "class", class);
}

void cmp_page_attribute(struct page *p, const char *name, const char *value) {
  char *clean = cmp_text_copy(value);
  if (clean)
    note(p, xmlTextWriterWriteAttribute(p->writer, BAD_CAST name, BAD_CAST clean));
  else
    p->failed = true;
  free(clean);
}

void cmp_page_close(struct page *p) {
  /* "full": never <td/>, which HTML would take for an opening tag */
  note(p, xmlTextWriterFullEndElement(p->writer));
}

static void text_write(struct page *p, const char *format, va_list args) {
  char *text = NULL;
  if (vasprintf(&text, format, args) < 0) {
    p->failed = true;
    return;
  }
  char *visible = cmp_text_copy(text);
  if (visible)
    note(p, xmlTextWriterWriteString(p->writer, BAD_CAST visible));
  else
    p->failed = true;
  free(visible);
  free(text);
}

void cmp_page_text(struct page *p, const char *format, ...) {
  va_list args;
  va_start(args, format);
  text_write(p, format, args);
  va_end(args);
}

void cmp_page_raw(struct page *p, const char *markup) {
  note(p, xmlTextWriterWriteRaw(p->writer, BAD_CAST markup));
}

void cmp_page_element(struct page *p, const char *tag, const char *class, const char *format, ...) {
  va_list args;
  cmp_page_open(p, tag, class);
  va_start(args, format);
  text_write(p, format, args);
  va_end(args);
  cmp_page_close(p);
}

void cmp_page_image(struct page *p, const char *type, const char *bytes, size_t n, const char *alt,
                    int width, int height) {
  char size[16];
  note(p, xmlTextWriterStartElement(p->writer, BAD_CAST "img"));
  cmp_page_attribute(p, "alt", alt);
  snprintf(size, sizeof size, "%d", width);
  cmp_page_attribute(p, "width", size);
  snprintf(size, sizeof size, "%d", height);
  cmp_page_attribute(p, "height", size);
  note(p, xmlTextWriterStartAttribute(p->writer, BAD_CAST "src"));
  note(p, xmlTextWriterWriteFormatString(p->writer, "data:%s;base64,", type));
  note(p, xmlTextWriterWriteBase64(p->writer, bytes, 0, (int)n));
  note(p, xmlTextWriterEndAttribute(p->writer));
  note(p, xmlTextWriterEndElement(p->writer)); /* void element: <img/> */
}
