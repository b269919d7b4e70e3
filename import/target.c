#include "import/target.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "common/result/result_hdf.h"
#include "common/result/result_layout.h"
#include "common/result/result_open.h"
#include "import/lists.h"

static const char ending[] = ".h5";

struct target {
  const char *path;
  struct stat about;
};

static enum status differ(const struct target *t, const char *input) {
  struct stat about;
  CHECK(stat(input, &about) || about.st_dev != t->about.st_dev || about.st_ino != t->about.st_ino,
        ERR_INPUT,
        "cannot write %s: it is %s, which this import reads; name another file with --out", t->path,
        input);
  return OK;
}

static enum status differ_from_item(const struct target *t, const struct import_section *section,
                                    const struct import_item *item) {
  struct import_list list;
  TRY(differ(t, item->file));
  if (section->format != IMPORT_FORMAT_vtk || !import_is_list(item->file)) return OK;
  enum status status = import_list_read(item->file, &list);
  if (status != OK) return status_context(status, "%s: ", item->where);
  for (size_t i = 0; i < list.n && status == OK; i++) status = differ(t, list.item[i].file);
  import_list_destroy(&list);
  return status;
}

static enum status differ_from_section(const struct target *t,
                                       const struct import_section *section) {
  for (size_t i = 0; i < section->n_items; i++)
    TRY(differ_from_item(t, section, &section->items[i]));
  return OK;
}

/* None of what the import reads, if there is such a file at all. */
static enum status differ_from_inputs(const char *path, const struct import_sidecar *s) {
  struct target t = {.path = path};
  if (stat(path, &t.about)) return OK;
  TRY(differ(&t, s->path));
  TRY(differ(&t, s->scales->path)); /* the case, or the sidecar once more */
  TRY(differ_from_section(&t, &s->profiles));
  TRY(differ_from_section(&t, &s->grid));
  TRY(differ_from_section(&t, &s->particles));
  for (size_t i = 0; i < s->n_series; i++) TRY(differ_from_section(&t, &s->series[i]));
  return OK;
}

static enum status find_format(const hid_t *file, void *data) {
  bool *ours = data;
  char *format = NULL;
  *ours = hdf_get_string(*file, "format", &format) == OK && !strcmp(format, RESULT_FORMAT);
  free(format);
  return OK;
}

static enum status carry_format(struct carrier *c, void *data) {
  return carry_bytes(c, data, sizeof(bool));
}

static enum status check_replaced(const char *path) {
  struct stat about;
  bool ours = false;
  if (stat(path, &about)) {
    CHECK(errno == ENOENT, ERR_INPUT, "cannot write %s: %s", path, strerror(errno));
    return OK;
  }
  enum status status = result_read_safely(&(struct result_request){
      1, {path}, .any = true, .data = &ours, .read = find_format, .carry = carry_format});
  if (status == ERR_INPUT || (status == OK && !ours))
    return status_raise(ERR_INPUT,
                        "cannot write %s: it is there and is no result that plunge wrote; name "
                        "another file with --out, or remove it",
                        path);
  return status;
}

enum status import_check_target(const char *path, const struct import_sidecar *s) {
  const size_t n = strlen(path), m = sizeof ending - 1;
  char *xdmf = NULL;
  const char *slash = strrchr(path, '/');
  CHECK(n > m && !strcmp(path + n - m, ending) && strcmp(slash ? slash + 1 : path, ending),
        ERR_INPUT, "cannot write '%s'; allowed: a file whose name ends in %s; correct --out", path,
        ending);
  CHECK(asprintf(&xdmf, "%.*s.xdmf", (int)(n - m), path) >= 0, ERR_MEMORY,
        "no memory for a file name");
  enum status status = differ_from_inputs(path, s);
  if (status == OK) status = differ_from_inputs(xdmf, s);
  if (status == OK) status = check_replaced(path);
  free(xdmf);
  return status;
}
