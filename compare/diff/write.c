#include "compare/diff/write.h"

#include "compare/output.h"

struct report {
  const struct cmp_diff *d;
  const struct cmp_figures *figures;
  const json_t *json;
};

static enum status page(const struct report *r, FILE *out) {
  return cmp_diff_page(r->d, r->figures, r->json, out);
}

static enum status numbers(const struct report *r, FILE *out) {
  const size_t flags = JSON_INDENT(1) | JSON_REAL_PRECISION(17);
  CHECK(json_dumpf(r->json, out, flags) == 0, ERR_IO, "cannot write diff.json");
  fputc('\n', out);
  return OK;
}

static enum status markdown(const struct report *r, FILE *out) {
  return cmp_diff_markdown(r->d, out);
}

static enum status junit(const struct report *r, FILE *out) {
  return cmp_diff_junit(r->d, out);
}

static enum status file_write(const struct report *r, const char *dir, const char *name,
                              enum status (*write)(const struct report *r, FILE *out)) {
  struct cmp_output o;
  char path[PATH_MAX];
  TRY(cmp_path_join(dir, name, path));
  TRY(cmp_output_open(path, &o));
  enum status status = write(r, o.stream);
  if (status == OK) status = cmp_output_commit(&o);
  cmp_output_abandon(&o);
  return status;
}

enum status cmp_diff_write(const struct cmp_diff *d, const struct cmp_figures *figures,
                           const char *out_dir) {
  json_t *json = cmp_diff_json(d, figures);
  CHECK(json, ERR_MEMORY, "no memory for a report");
  const struct report r = {d, figures, json};
  enum status status;
  ATTEMPT(file_write(&r, out_dir, "diff.html", page));
  ATTEMPT(file_write(&r, out_dir, "diff.json", numbers));
  ATTEMPT(file_write(&r, out_dir, "diff.md", markdown));
  ATTEMPT(file_write(&r, out_dir, "diff.xml", junit));
done:
  json_decref(json);
  return status;
}
