/* compare.profiles: measured surfaces at an instant, text files of two columns in units of H. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case_draft.h"

struct profile_section {
  char *file, *label, *source;
  double time;
};
static const struct param profile_rows[] = {
    TEXT(struct profile_section, file, 1000, NULL,
         "data file of lines 'x/H, y/H', relative to the case"),
    REAL(struct profile_section, time, QTY_TIME, 0, 1e9, NULL,
         "when the surface was there: one of compare.times"),
    TEXT(struct profile_section, label, 200, "", "name in figures; default: the file's"),
    TEXT(struct profile_section, source, 1000, "", "citation"),
};
const struct case_table case_profile_tables[] = {
    {"compare.profiles (a list)", profile_rows, ROWS(profile_rows)},
    {0},
};

/* A wrong entry keeps its place, without points or a time. */
static enum status read_profile(struct case_draft *d, int node, size_t i) {
  struct case_file *c = d->c;
  struct profile_section s = {0};
  const struct case_columns columns = {"x, y", 2, {c->H, c->H}, CASE_ROWS_ANY, "", "m"};
  struct case_profile *p = &c->compare.profiles[c->compare.n_profiles++];
  struct case_rows rows = {0};
  char path[CASE_PATH], key[CASE_PATH + 16];
  enum status status = OK;
  snprintf(path, sizeof path, "compare.profiles[%zu]", i);
  snprintf(key, sizeof key, "%s.file", path);
  *p = (struct case_profile){.time = NAN};
  if (case_read_section(d, node, path, profile_rows, ROWS(profile_rows), &s)) {
    const char *slash = strrchr(s.file, '/');
    status = case_read_rows(d, s.file, case_doc_member_line(&d->doc, node, "file"), key, &columns,
                            &rows);
    *p = (struct case_profile){.label = s.label ? s.label : strdup(slash ? slash + 1 : s.file),
                               .source = s.source ? s.source : strdup(""),
                               .time = s.time,
                               .n = rows.n,
                               .x = rows.x,
                               .y = rows.y};
    s.label = s.source = NULL;
    if (!p->label || !p->source) status = status_raise(ERR_MEMORY, "no memory for a profile");
  }
  params_release(profile_rows, ROWS(profile_rows), &s);
  return status;
}

enum status case_read_profiles(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.profiles", 0, CASE_MOST_ITEMS, "profiles"))
    return OK;
  const size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.profiles, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) TRY(read_profile(d, case_doc_item(doc, node, i), i));
  return OK;
}

/* Where every run has its surface; on the dot after this. */
void case_check_profiles(struct case_draft *d) {
  struct case_file *c = d->c;
  const int list = case_doc_member(&d->doc, d->at.compare, "profiles");
  char path[CASE_PATH];
  for (size_t i = 0; i < c->compare.n_profiles; i++) {
    double *time = &c->compare.profiles[i].time;
    snprintf(path, sizeof path, "compare.profiles[%zu].time", i);
    if (!isnan(*time)) case_check_compared(d, case_doc_item(&d->doc, list, i), "time", path, time);
  }
}

void case_profile_destroy(struct case_profile *p) {
  free(p->label);
  free(p->source);
  free(p->x);
  free(p->y);
}
