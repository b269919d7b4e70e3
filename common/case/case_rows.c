/* Columns of numbers in text files that a case names,
 *     # any number of header lines (lines of at most 1000 bytes, files of at most 64 MB)
 *     number, number        (or three, or four)
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/case/case_draft.h"
#include "common/tank/motion.h"

static const double MOST_GAP = 10; /* over the median one: beyond it a row is missing */
enum { MOST_SAMPLES = 1000000, MOST_LINE_PROBLEMS = 10, MOST_BYTES = 64 << 20 };

/* Numbers with commas between them and nothing else, the parameter table's idea of a number; how
 * many, or 0. */
static size_t parse_row(char *line, double row[CASE_MOST_COLUMNS]) {
  static const struct param number = {.type = PARAM_REAL, .min = -1e30, .max = 1e30};
  struct param_scales none = {NAN, NAN};
  char todo[160], *next = line;
  size_t n = 0;
  while (next) {
    char *comma = strchr(next, ','), *one = next;
    next = comma ? comma + 1 : NULL;
    if (comma) *comma = 0;
    for (size_t k = strlen(one); k && strchr(" \t\r\n", one[k - 1]); k--) one[k - 1] = 0;
    if (n == CASE_MOST_COLUMNS || !param_fill(&number, one, &none, &row[n++], todo)) return 0;
  }
  return n;
}

static enum status append(struct case_rows *r, size_t *room, const double *row,
                          const double *unit) {
  double **columns[] = {&r->x, &r->y, &r->z, &r->w};
  size_t more = array_room(*room, r->n + 1);
  for (size_t k = 0; k < r->columns; k++) {
    if (more > *room) TRY(array_resize(columns[k], more, "values of a file"));
    (*columns[k])[r->n] = row[k] * unit[k];
  }
  *room = more;
  r->n++;
  return OK;
}

/* What is wrong with a line, or NULL with its numbers in `row`. */
static const char *judge_line(char *line, struct case_rows *r, const struct case_columns *columns,
                              double row[CASE_MOST_COLUMNS]) {
  if (strlen(line) > TEXT_LONGEST_LINE) return "lines of at most 1000 bytes";
  const size_t n = parse_row(line, row);
  if (n < 2 || n > columns->most || (r->n && n != r->columns))
    return columns->most == 2 ? "two numbers with a comma between them"
                              : "two to four numbers with commas between them, in all lines alike";
  const double last = r->n ? r->x[r->n - 1] : -INFINITY, next = row[0] * columns->unit[0];
  if (columns->order == CASE_ROWS_RISE && !(next > last)) return columns->ordered;
  if (columns->order == CASE_ROWS_DO_NOT_FALL && next < last) return columns->ordered;
  if (r->n == MOST_SAMPLES) return "at most 1000000 samples";
  r->columns = n;
  return NULL;
}

static enum status read_rows(struct case_draft *d, const struct case_columns *columns, char *text,
                             const char *name, int at, const char *path, struct case_rows *r) {
  char *line, found[192], shown[48], allowed[64];
  size_t room = 0, bad = 0;
  for (size_t k = 1; (line = text_line(&text)); k++) {
    double row[CASE_MOST_COLUMNS];
    if (line[0] == '#' || !line[strspn(line, " \t")]) continue;
    case_quote(line, strlen(line), shown, sizeof shown);
    const char *why = judge_line(line, r, columns, row);
    if (why) {
      snprintf(found, sizeof found, "'%s' in line %zu of %s", shown, k, name);
      case_doc_problem(&d->doc, at, path, found, why, "correct that line");
      if (++bad == MOST_LINE_PROBLEMS || r->n == MOST_SAMPLES) break;
      continue;
    }
    TRY(append(r, &room, row, columns->unit));
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
  free(r->z);
  free(r->w);
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

static void check_gaps(struct case_draft *d, const char *file, int line, const char *path,
                       const struct case_columns *columns, const struct case_rows *r,
                       double *gaps) {
  char found[256], shown[96], allowed[96];
  for (size_t k = 0; k + 1 < r->n; k++) gaps[k] = r->x[k + 1] - r->x[k];
  qsort(gaps, r->n - 1, sizeof *gaps, array_ascending);
  const double median = gaps[(r->n - 1) / 2];
  for (size_t k = 0; k + 1 < r->n; k++) {
    if (r->x[k + 1] - r->x[k] <= MOST_GAP * median) continue;
    case_quote(file, strlen(file), shown, sizeof shown);
    snprintf(found, sizeof found, "a hole from %.6g to %.6g %s in %s", r->x[k], r->x[k + 1],
             columns->si, shown);
    snprintf(allowed, sizeof allowed,
             "rows at most %g times as far apart as most, which are %.3g %s", MOST_GAP, median,
             columns->si);
    case_doc_problem(&d->doc, line, path, found, allowed, "add the rows that are missing");
    return;
  }
}

enum status case_check_rows(struct case_draft *d, const char *file, int line, const char *path,
                            const struct case_columns *columns, const struct case_rows *r) {
  double *gaps;
  if (r->n < TANK_LEAST_ROWS) {
    char found[128], allowed[64];
    snprintf(found, sizeof found, "%zu row%s", r->n, r->n == 1 ? "" : "s");
    snprintf(allowed, sizeof allowed, "at least %d rows '%s'", TANK_LEAST_ROWS, columns->what);
    case_doc_problem(&d->doc, line, path, found, allowed, "add rows");
    return OK;
  }
  TRY(array_create(&gaps, r->n, "rows of a file"));
  check_gaps(d, file, line, path, columns, r, gaps);
  free(gaps);
  return OK;
}
