/* Measured series: text files of two columns in the units of the scales,
 *     t sqrt(g/H), value        (value: p/(rho g H) at a probe, eta/H at a gauge, x/H of the front)
 */
#include <math.h>
#include <string.h>

#include "common/case/case_draft.h"

enum target { TARGET_UNKNOWN, TARGET_PRESSURE, TARGET_LENGTH };

static enum target find_target(const struct case_file *c, const char *name) {
  for (size_t i = 0; i < c->n_probes; i++)
    if (c->probes[i].name && !strcmp(c->probes[i].name, name)) return TARGET_PRESSURE;
  for (size_t i = 0; i < c->n_gauges; i++)
    if (c->gauges[i].name && !strcmp(c->gauges[i].name, name)) return TARGET_LENGTH;
  return strcmp(name, "front") ? TARGET_UNKNOWN : TARGET_LENGTH;
}

static void report_target(struct case_draft *d, const struct case_experiment *e, int line,
                          const char *path) {
  const struct case_file *c = d->c;
  char allowed[512] = "", found[96], shown[64];
  for (size_t i = 0; i < c->n_probes + c->n_gauges; i++) {
    size_t at = strlen(allowed);
    const char *name = i < c->n_probes ? c->probes[i].name : c->gauges[i - c->n_probes].name;
    if (name) snprintf(allowed + at, sizeof allowed - at, "%s, ", name);
  }
  size_t at = strlen(allowed);
  snprintf(allowed + at, sizeof allowed - at, "front");
  case_quote(e->target, strlen(e->target), shown, sizeof shown);
  snprintf(found, sizeof found, "the target '%s'", shown);
  case_doc_problem(&d->doc, line, path, found, allowed, "name a probe, a gauge or front");
}

enum status case_read_experiment(struct case_draft *d, struct case_experiment *e, const char *file,
                                 int line, const char *path) {
  const struct case_file *c = d->c;
  enum target target = find_target(c, e->target);
  const double unit = target == TARGET_PRESSURE ? c->density * c->g * c->H : c->H;
  const struct case_columns columns = {"time, value",
                                       2,
                                       {sqrt(c->H / c->g), unit},
                                       CASE_ROWS_DO_NOT_FALL,
                                       "times that do not decrease",
                                       "s"};
  struct case_rows rows;
  if (target == TARGET_UNKNOWN) report_target(d, e, line, path);
  enum status status = case_read_rows(d, file, line, path, &columns, &rows);
  e->n = rows.n;
  e->t = rows.x;
  e->value = rows.y;
  return status;
}
