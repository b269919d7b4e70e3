#include "import/lists.h"

#include <jansson.h>
#include <libxml/parser.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"

enum { MOST_BYTES = 64 << 20 };

static bool ends_with(const char *s, const char *end) {
  const size_t n = strlen(s), m = strlen(end);
  return n > m && !strcmp(s + n - m, end);
}

bool import_is_list(const char *path) {
  return ends_with(path, ".pvd") || ends_with(path, ".series");
}

void import_list_destroy(struct import_list *list) {
  for (size_t i = 0; i < list->n; i++) free(list->item[i].file);
  free(list->item);
  *list = (struct import_list){0};
}

/* Neither from the root nor upwards. */
static bool stays_below(const char *file) {
  if (!*file || *file == '/') return false;
  for (const char *at = file; (at = strstr(at, "..")); at += 2)
    if ((at == file || at[-1] == '/') && (!at[2] || at[2] == '/')) return false;
  return true;
}

static enum status add(const char *path, const char *file, double time, struct import_list *list) {
  const char *slash = strrchr(path, '/');
  CHECK(stays_below(file), ERR_INPUT,
        "%s names the file '%s', which is not in its folder; name that file in the sidecar", path,
        file);
  CHECK(isfinite(time), ERR_INPUT, "%s gives '%s' no time", path, file);
  TRY(array_resize(&list->item, list->n + 1, "files"));
  char *full = NULL;
  CHECK(asprintf(&full, "%.*s%s", slash ? (int)(slash - path + 1) : 0, path, file) >= 0, ERR_MEMORY,
        "no memory for a file name");
  list->item[list->n++] = (struct import_listed){full, time};
  return OK;
}

/* <VTKFile><Collection><DataSet timestep="0.5" file="a.vtu"/>... */
static enum status read_collection(const char *path, const xmlNode *node,
                                   struct import_list *list) {
  for (; node; node = node->next) {
    if (node->type != XML_ELEMENT_NODE) continue;
    if (!xmlStrEqual(node->name, BAD_CAST "DataSet")) {
      TRY(read_collection(path, node->children, list));
      continue;
    }
    xmlChar *file = xmlGetProp(node, BAD_CAST "file"),
            *time = xmlGetProp(node, BAD_CAST "timestep");
    enum status status =
        add(path, file ? (char *)file : "", time ? strtod((char *)time, NULL) : NAN, list);
    xmlFree(file);
    xmlFree(time);
    TRY(status);
  }
  return OK;
}

static enum status read_pvd(const char *path, const char *text, size_t n,
                            struct import_list *list) {
  xmlDoc *doc = xmlReadMemory(text, (int)n, NULL, NULL,
                              XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
  CHECK(doc, ERR_INPUT, "%s is no XML", path);
  enum status status = read_collection(path, xmlDocGetRootElement(doc), list);
  xmlFreeDoc(doc);
  return status;
}

/* {"file-series-version": "1.0", "files": [{"name": "a.vtk", "time": 0.5}, ...]} */
static enum status read_series(const char *path, const char *text, size_t n,
                               struct import_list *list) {
  json_error_t error;
  json_t *root = json_loadb(text, n, 0, &error), *one;
  size_t i;
  enum status status = OK;
  CHECK(root, ERR_INPUT, "%s:%d: no JSON: %s", path, error.line, error.text);
  json_array_foreach(json_object_get(root, "files"), i, one) {
    const char *name = json_string_value(json_object_get(one, "name"));
    const json_t *time = json_object_get(one, "time");
    status =
        add(path, name ? name : "", json_is_number(time) ? json_number_value(time) : NAN, list);
    if (status != OK) break;
  }
  json_decref(root);
  return status;
}

enum status import_list_read(const char *path, struct import_list *list) {
  char *text;
  size_t n;
  *list = (struct import_list){0};
  enum status status = text_read(path, MOST_BYTES, &text, &n);
  if (status == ERR_INPUT)
    return status_context(ERR_INPUT, "cannot read %s, a list of files: found ", path);
  TRY(status);
  status =
      ends_with(path, ".pvd") ? read_pvd(path, text, n, list) : read_series(path, text, n, list);
  free(text);
  if (status == OK && !list->n) status = status_raise(ERR_INPUT, "%s names no files", path);
  if (status != OK) import_list_destroy(list);
  return status;
}
