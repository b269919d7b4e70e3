#include "import/lists.h"

#include <jansson.h>
#include <libxml/parser.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/result/result_guard.h"

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

/* As the file has it; looked through by `settle`. */
static enum status add(const char *file, double time, struct import_list *list) {
  char *copy = strdup(file);
  CHECK(copy, ERR_MEMORY, "no memory for a file name");
  enum status status = array_resize(&list->item, list->n + 1, "files");
  if (status == OK)
    list->item[list->n++] = (struct import_listed){copy, time};
  else
    free(copy);
  return status;
}

/* NAN unless all of the text is a number. */
static double time_of(const char *text) {
  char *end = NULL;
  const double time = text ? strtod(text, &end) : NAN;
  return end && end != text && !end[strspn(end, " \t\r\n")] ? time : NAN;
}

/* <VTKFile><Collection><DataSet timestep="0.5" file="a.vtu"/>... */
static enum status read_collection(const xmlNode *node, struct import_list *list) {
  for (; node; node = node->next) {
    if (node->type != XML_ELEMENT_NODE) continue;
    if (!xmlStrEqual(node->name, BAD_CAST "DataSet")) {
      TRY(read_collection(node->children, list));
      continue;
    }
    xmlChar *file = xmlGetProp(node, BAD_CAST "file"),
            *time = xmlGetProp(node, BAD_CAST "timestep");
    enum status status = add(file ? (char *)file : "", time_of((char *)time), list);
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
  enum status status = read_collection(xmlDocGetRootElement(doc), list);
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
    status = add(name ? name : "", json_is_number(time) ? json_number_value(time) : NAN, list);
    if (status != OK) break;
  }
  json_decref(root);
  return status;
}

struct request {
  const char *path;
  struct import_list *list;
};

static enum status read_there(void *data) {
  const struct request *q = data;
  char *text;
  size_t n;
  enum status status = text_read(q->path, MOST_BYTES, &text, &n);
  if (status == ERR_INPUT)
    return status_context(ERR_INPUT, "cannot read %s, a list of files: found ", q->path);
  TRY(status);
  status = ends_with(q->path, ".pvd") ? read_pvd(q->path, text, n, q->list)
                                      : read_series(q->path, text, n, q->list);
  free(text);
  return status;
}

static enum status carry_listed(struct carrier *c, void *element) {
  struct import_listed *one = element;
  TRY(carry_text(c, &one->file));
  return carry_bytes(c, &one->time, sizeof one->time);
}

static enum status carry_list(struct carrier *c, void *data) {
  struct import_list *list = ((const struct request *)data)->list;
  return carry_each(c, &list->n, &list->item, carry_listed);
}

/* What the child says of the files becomes their paths. */
static enum status settle(const char *path, struct import_list *list) {
  const char *slash = strrchr(path, '/');
  CHECK(list->n, ERR_INPUT, "%s names no files", path);
  for (size_t i = 0; i < list->n; i++) {
    struct import_listed *one = &list->item[i];
    char *full = NULL;
    CHECK(one->file && stays_below(one->file), ERR_INPUT,
          "%s names the file '%s', which is not in its folder; name that file in the sidecar", path,
          one->file ? one->file : "");
    CHECK(isfinite(one->time), ERR_INPUT, "%s gives '%s' no time, or one that is no decimal number",
          path, one->file);
    CHECK(asprintf(&full, "%.*s%s", slash ? (int)(slash - path + 1) : 0, path, one->file) >= 0,
          ERR_MEMORY, "no memory for a file name");
    free(one->file);
    one->file = full;
  }
  return OK;
}

enum status import_list_read(const char *path, struct import_list *list) {
  struct stat about = {0};
  struct request q = {path, list};
  *list = (struct import_list){0};
  const size_t size = stat(path, &about) ? 0 : (size_t)about.st_size;
  enum status status = guard_run(&(struct guard){
      .name = {path}, .size = size, .data = &q, .read = read_there, .carry = carry_list});
  if (status == OK) status = settle(path, list);
  if (status != OK) import_list_destroy(list);
  return status;
}

/* ---- parts ---- */

enum { MOST_PARTS = 10000 };

struct parts { /* that have been counted */
  size_t n, bytes;
  struct stat *seen; /* [MOST_PARTS] */
};

static bool has_parts(const char *path) {
  static const char *const endings[] = {".vtm",  ".vtmb", ".vth",  ".vthb", ".pvtu",
                                        ".pvtp", ".pvti", ".pvts", ".pvtr"};
  for (size_t k = 0; k < sizeof endings / sizeof *endings; k++)
    if (ends_with(path, endings[k])) return true;
  return false;
}

static void count_parts(const char *path, struct parts *p);

static void count_part(const char *index, const char *file, size_t n, struct parts *p) {
  const char *slash = strrchr(index, '/');
  char *full = NULL;
  struct stat about;
  if (asprintf(&full, "%.*s%.*s", slash && *file != '/' ? (int)(slash - index + 1) : 0, index,
               (int)n, file) < 0)
    return;
  bool news = p->n < MOST_PARTS && !stat(full, &about) && S_ISREG(about.st_mode);
  for (size_t k = 0; k < p->n && news; k++)
    news = p->seen[k].st_ino != about.st_ino || p->seen[k].st_dev != about.st_dev;
  if (news) {
    p->seen[p->n++] = about;
    p->bytes += (size_t)about.st_size;
    if (has_parts(full)) count_parts(full, p);
  }
  free(full);
}

/* <Piece Source="a.vtu"/>, <DataSet file="b.vtu"/>: looked for in the text, for no more than its
 * limits is at stake. */
static void count_parts(const char *path, struct parts *p) {
  static const char *const keys[] = {"Source=", "file="};
  char *text;
  size_t n;
  if (text_read(path, MOST_BYTES, &text, &n) != OK) return;
  for (size_t k = 0; k < sizeof keys / sizeof *keys; k++)
    for (const char *at = text; (at = strstr(at, keys[k]));) {
      at += strlen(keys[k]);
      const char *end = *at == '"' || *at == '\'' ? strchr(at + 1, *at) : NULL;
      if (!end) continue;
      count_part(path, at + 1, (size_t)(end - at - 1), p);
      at = end;
    }
  free(text);
}

size_t import_parts_size(const char *path) {
  struct parts p = {0};
  if (!has_parts(path) || array_create(&p.seen, MOST_PARTS, "parts of a file") != OK) return 0;
  count_parts(path, &p);
  free(p.seen);
  return p.bytes;
}
