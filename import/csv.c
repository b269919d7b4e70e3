/* Columns of numbers in text:
 *     # any comments
 *     names, with or without a # before them
 *     number, number, ...
 * The names are the last line before the first one of numbers. A column that has none there is
 * asked for by its place, from 1. */
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "import/formats.h"

enum { MOST_BYTES = 1 << 30, MOST_FIELDS = 1000 };

struct csv {
  const struct import_ask *ask;
  char *text;   /* owned; its lines and fields are cut off one by one */
  char *header; /* the line of names, within text; NULL: none */
  size_t n_fields;
  char *field[MOST_FIELDS];  /* of the line at hand */
  int place[IMPORT_N_ROLES]; /* of each column that is asked for; -1: it is not */
  double time;
};

/* Without blanks and quotes around it. */
static char *trim(char *s) {
  while (isspace((unsigned char)*s)) s++;
  size_t n = strlen(s);
  while (n && isspace((unsigned char)s[n - 1])) s[--n] = 0;
  if (n >= 2 && (*s == '"' || *s == '\'') && s[n - 1] == *s) {
    s[n - 1] = 0;
    s++;
  }
  return s;
}

/* Cuts a line into fields. */
static void divide(struct csv *c, char *line) {
  const char by = c->ask->separator;
  c->n_fields = 0;
  if (by == ' ') {
    char *rest = NULL;
    for (char *f = strtok_r(line, " \t", &rest); f && c->n_fields < MOST_FIELDS;
         f = strtok_r(NULL, " \t", &rest))
      c->field[c->n_fields++] = trim(f);
    return;
  }
  for (char *next = line; next && c->n_fields < MOST_FIELDS;) {
    char *one = next, *end = strchr(next, by);
    next = end ? end + 1 : NULL;
    if (end) *end = 0;
    c->field[c->n_fields++] = trim(one);
  }
}

/* Decimal numbers, and "nan" or nothing for one that is missing. */
static bool number_of(const char *s, double *value) {
  char *end;
  if (!*s || !strcasecmp(s, "nan")) {
    *value = NAN;
    return true;
  }
  if (s[strspn(s, "+-.0123456789eE")]) return false;
  *value = strtod(s, &end);
  return end != s && !*end && isfinite(*value);
}

/* Whether it begins with a number: no line of names. */
static bool is_row(struct csv *c, const char *line) {
  double value;
  char *copy = strdup(line);
  if (!copy) return false;
  divide(c, copy);
  const bool row = c->n_fields && *c->field[0] && number_of(c->field[0], &value);
  free(copy);
  return row;
}

static void note_time(struct csv *c, const char *line) {
  const char *at = c->ask->time_after ? strstr(line, c->ask->time_after) : NULL;
  char *end;
  if (!at) return;
  at += strlen(c->ask->time_after);
  const double time = strtod(at, &end);
  if (end != at) c->time = time;
}

/* The place of a column, by name, or by number. */
static enum status find_column(const struct csv *c, size_t n, char *const *names,
                               const char *column, int *place) {
  char *end;
  for (size_t i = 0; i < n; i++)
    if (!strcmp(names[i], column)) {
      *place = (int)i;
      return OK;
    }
  const long number = strtol(column, &end, 10);
  if (*column && !*end && number >= 1 && number <= MOST_FIELDS) {
    *place = (int)number - 1;
    return OK;
  }
  return import_no_column(c->ask->path, column, n, (const char *const *)names);
}

static enum status find_columns(struct csv *c) {
  char *names = c->header;
  if (names) {
    while (*names == '#' || isspace((unsigned char)*names)) names++;
    divide(c, names);
  } else
    c->n_fields = 0;
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    c->place[k] = -1;
    if (c->ask->names[k])
      TRY(find_column(c, c->n_fields, c->field, c->ask->names[k], &c->place[k]));
  }
  return OK;
}

static enum status take_row(struct csv *c, size_t line, size_t *room, struct import_table *t) {
  const char *path = c->ask->path;
  const size_t more = array_room(*room, t->n + 1);
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    if (c->place[k] < 0) continue;
    if (more > *room) TRY(array_resize(&t->column[k], more, "rows of a file"));
    CHECK((size_t)c->place[k] < c->n_fields, ERR_INPUT,
          "%s:%zu: found %zu field%s; the column '%s' is number %d; correct that line", path, line,
          c->n_fields, c->n_fields == 1 ? "" : "s", c->ask->names[k], c->place[k] + 1);
    const char *text = c->field[c->place[k]];
    CHECK(number_of(text, &t->column[k][t->n]), ERR_INPUT,
          "%s:%zu: found '%.40s' in the column '%s'; allowed: a decimal number; correct that line",
          path, line, text, c->ask->names[k]);
  }
  *room = more;
  t->n++;
  return OK;
}

static enum status read_lines(struct csv *c, struct import_table *t) {
  char *rest = c->text, *line;
  size_t room = 0, number = 0;
  bool rows = false;
  while ((line = text_line(&rest))) {
    number++;
    const char *begin = line + strspn(line, " \t");
    if (!*begin) continue;
    if (*begin == '#') note_time(c, begin);
    if (!rows && (*begin == '#' || !is_row(c, line))) {
      c->header = line;
      continue;
    }
    if (*begin == '#') continue;
    if (!rows) TRY(find_columns(c));
    rows = true;
    divide(c, line);
    TRY(take_row(c, number, &room, t));
  }
  CHECK(rows, ERR_INPUT, "%s has no line of numbers", c->ask->path);
  t->time = c->time;
  return OK;
}

enum status import_csv_steps(const struct import_ask *ask, size_t *n, double **times) {
  (void)ask;
  return import_one_step(n, times);
}

enum status import_csv_read(const struct import_ask *ask, struct import_table *t) {
  struct csv *c;
  size_t n;
  *t = (struct import_table){.time = NAN};
  TRY(array_create(&c, 1, "a text of columns"));
  c->ask = ask;
  c->time = NAN;
  enum status status = text_read(ask->path, MOST_BYTES, &c->text, &n);
  if (status == ERR_INPUT)
    status = status_context(ERR_INPUT, "cannot read %s, a text of at most 1 GB: found ", ask->path);
  if (status == OK) status = read_lines(c, t);
  if (status != OK) import_table_destroy(t);
  free(c->text);
  free(c);
  return status;
}
