/* Columns of numbers in text files that a case names,
 *     # any number of header lines (lines of at most 1000 bytes, files of at most 64 MB)
 *     number, number
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/case/case_draft.h"

enum { MOST_SAMPLES = 1000000, MOST_LINE_PROBLEMS = 10, MOST_BYTES = 64 << 20 };

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

static enum status append(struct case_rows *r, size_t *room, double x, double y) {
  size_t more = array_room(*room, r->n + 1);
  if (more > *room) {
    TRY(array_resize(&r->x, more, "measured values"));
    TRY(array_resize(&r->y, more, "measured values"));
    *room = more;
  }
  r->x[r->n] = x;
  r->y[r->n++] = y;
  return OK;
}

/* What is wrong with a line, or NULL with its two numbers in `row`. */
static const char *judge_line(char *line, const struct case_rows *r,
                              const struct case_columns *columns, double row[2]) {
  if (strlen(line) > TEXT_LONGEST_LINE) return "lines of at most 1000 bytes";
  if (!parse_row(line, row)) return "two numbers with a comma between them";
  const double last = r->n ? r->x[r->n - 1] : -INFINITY, next = row[0] * columns->unit[0];
  if (columns->order == CASE_ROWS_RISE && !(next > last)) return "times that increase";
  if (columns->order == CASE_ROWS_DO_NOT_FALL && next < last) return "times that do not decrease";
  if (r->n == MOST_SAMPLES) return "at most 1000000 samples";
  return NULL;
}

static enum status read_rows(struct case_draft *d, const struct case_columns *columns, char *text,
                             const char *name, int at, const char *path, struct case_rows *r) {
  char *line, found[192], shown[48], allowed[64];
  size_t room = 0, bad = 0;
  for (size_t k = 1; (line = text_line(&text)); k++) {
    double row[2];
    if (line[0] == '#' || !line[strspn(line, " \t")]) continue;
    case_quote(line, strlen(line), shown, sizeof shown);
    const char *why = judge_line(line, r, columns, row);
    if (why) {
      snprintf(found, sizeof found, "'%s' in line %zu of %s", shown, k, name);
      case_doc_problem(&d->doc, at, path, found, why, "correct that line");
      if (++bad == MOST_LINE_PROBLEMS || r->n == MOST_SAMPLES) break;
      continue;
    }
    TRY(append(r, &room, row[0] * columns->unit[0], row[1] * columns->unit[1]));
  }
  if (!bad && !r->n) {
    snprintf(found, sizeof found, "no data in %s", name);
    snprintf(allowed, sizeof allowed, "lines '%s'", columns->what);
    case_doc_problem(&d->doc, at, path, found, allowed, "add the data");
  }
  return OK;
}

void case_rows_destroy(struct case_rows *r) {
  free(r->x);
  free(r->y);
  *r = (struct case_rows){0};
}

enum status case_read_rows(struct case_draft *d, const char *file, int line, const char *path,
                           const struct case_columns *columns, struct case_rows *r) {
  const struct case_file *c = d->c;
  const char *slash = strrchr(c->path, '/');
  char *full = NULL, shown[96], found[256];
  *r = (struct case_rows){0};
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
  status = read_rows(d, columns, text, shown, line, path, r);
  free(text);
  return status;
}
