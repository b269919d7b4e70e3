/* Measured series: text files of two columns in the units of the scales,
 *     # any number of header lines (lines of at most 1000 bytes, files of at most 64 MB)
 *     t sqrt(g/H), value        (value: p/(rho g H) at a probe, eta/H at a gauge, x/H of the front)
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/case/case_draft.h"

enum { MOST_SAMPLES = 1000000, MOST_LINE_PROBLEMS = 10, MOST_BYTES = 64 << 20 };

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

/* "number, number" and nothing else; the parameter table's idea of a number. */
static bool parse_row(char *line, double row[2]) {
  static const struct param number = {.type = PARAM_REAL, .min = -1e30, .max = 1e30};
  struct param_scales none = {NAN, NAN};
  char todo[160], *comma = strchr(line, ',');
  if (!comma) return false;
  *comma = 0;
  char *second = comma + 1;
  for (char *end = comma; end > line && strchr(" \t", end[-1]); end--) end[-1] = 0;
  for (size_t n = strlen(second); n && strchr(" \t\r\n", second[n - 1]); n--) second[n - 1] = 0;
  return param_fill(&number, line, &none, &row[0], todo) &&
         param_fill(&number, second, &none, &row[1], todo);
}

static enum status append(struct case_experiment *e, size_t *room, double t, double value) {
  size_t more = array_room(*room, e->n + 1);
  if (more > *room) {
    TRY(array_resize(&e->t, more, "measured values"));
    TRY(array_resize(&e->value, more, "measured values"));
    *room = more;
  }
  e->t[e->n] = t;
  e->value[e->n++] = value;
  return OK;
}

/* What is wrong with a line, or NULL with its two numbers in `row`. */
static const char *judge_line(char *line, const struct case_experiment *e, double time_unit,
                              double row[2]) {
  if (strlen(line) > TEXT_LONGEST_LINE) return "lines of at most 1000 bytes";
  if (!parse_row(line, row)) return "two numbers with a comma between them";
  if (e->n && row[0] * time_unit < e->t[e->n - 1]) return "times that do not decrease";
  if (e->n == MOST_SAMPLES) return "at most 1000000 samples";
  return NULL;
}

static enum status read_rows(struct case_draft *d, struct case_experiment *e, char *text,
                             const char *name, int at, const char *path, double time_unit,
                             double unit) {
  char *line, found[192], shown[48];
  size_t room = 0, bad = 0;
  for (size_t k = 1; (line = text_line(&text)); k++) {
    double row[2];
    if (line[0] == '#' || !line[strspn(line, " \t")]) continue;
    case_quote(line, strlen(line), shown, sizeof shown);
    const char *why = judge_line(line, e, time_unit, row);
    if (why) {
      snprintf(found, sizeof found, "'%s' in line %zu of %s", shown, k, name);
      case_doc_problem(&d->doc, at, path, found, why, "correct that line");
      if (++bad == MOST_LINE_PROBLEMS || e->n == MOST_SAMPLES) break;
      continue;
    }
    TRY(append(e, &room, row[0] * time_unit, row[1] * unit));
  }
  if (!bad && !e->n) {
    snprintf(found, sizeof found, "no data in %s", name);
    case_doc_problem(&d->doc, at, path, found, "lines 'time, value'", "add the data");
  }
  return OK;
}

enum status case_read_experiment(struct case_draft *d, struct case_experiment *e, const char *file,
                                 int line, const char *path) {
  const struct case_file *c = d->c;
  const char *slash = strrchr(c->path, '/');
  char *full = NULL, shown[96], found[256];
  enum target target = find_target(c, e->target);
  if (target == TARGET_UNKNOWN) report_target(d, e, line, path);
  int n = asprintf(&full, "%.*s%s", file[0] == '/' || !slash ? 0 : (int)(slash - c->path + 1),
                   c->path, file);
  CHECK(n >= 0, ERR_MEMORY, "no memory for a file name");
  case_quote(file, strlen(file), shown, sizeof shown);
  char *text = NULL;
  size_t bytes;
  enum status status = text_read(full, MOST_BYTES, &text, &bytes);
  free(full);
  if (status == ERR_INPUT) {
    snprintf(found, sizeof found, "'%s', %s", shown, status_message());
    case_doc_problem(&d->doc, line, path, found,
                     "a data file of at most 64 MB, its path relative to the case file",
                     "correct the path");
    return OK;
  }
  TRY(status);
  double rho_g_H = c->density * c->g * c->H;
  status = read_rows(d, e, text, shown, line, path, sqrt(c->H / c->g),
                     target == TARGET_PRESSURE ? rho_g_H : c->H);
  free(text);
  return status;
}
