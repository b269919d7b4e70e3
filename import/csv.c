/* Columns of numbers in text:
 *     # any comments
 *     names, with or without a # before them
 *     number, number, ...
 * The names are the last line before the first one of numbers. A column that has none there is
 * asked for by its place, from 1. */
#include <ctype.h>
#include <math.h>
#include <stddef.h>
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

/* Whether the fields at hand have all names that are asked for. */
static bool has_names(const struct csv *c) {
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) {
    bool there = !c->ask->names[k];
    for (size_t i = 0; i < c->n_fields && !there; i++)
      there = !strcmp(c->field[i], c->ask->names[k]);
    if (!there) return false;
  }
  return true;
}

/* Whether a line before all rows is one: it begins with a number, or its first field is empty and
 * the others are numbers or empty. Names that are numbers, beside a column without a name, look
 * like that too. */
static enum status find_row(struct csv *c, const char *line, size_t number, bool *row) {
  double value;
  size_t filled = 0;
  char *copy = strdup(line);
  CHECK(copy, ERR_MEMORY, "no memory for a line of a file");
  divide(c, copy);
  *row = c->n_fields && number_of(c->field[0], &value);
  const bool begins = *row && *c->field[0];
  for (size_t i = 0; i < c->n_fields && *row && !begins; i++) {
    *row = number_of(c->field[i], &value);
    filled += *c->field[i] != 0;
  }
  *row = *row && (begins || filled);
  const bool unclear = *row && !begins && has_names(c);
  free(copy);
  CHECK(!unclear, ERR_INPUT,
        "%s:%zu: this line may be names or numbers; put a # before it if they are names, or a "
        "number into each field",
        c->ask->path, number);
  return OK;
}

static bool is_of_word(char c) {
  return isalnum((unsigned char)c) || c == '_' || (unsigned char)c >= 0x80;
}

/* Whether this is a decimal number: "1,5" and "0x10" are none; a unit may follow. */
static bool is_decimal(const char *begin, const char *end) {
  const size_t n = (size_t)(end - begin);
  return strspn(begin, " \t+-.0123456789eE") >= n && *end != '.' &&
         !(*end == ',' && isdigit((unsigned char)end[1])) && *end != 'x';
}

/* The one number behind the words that are asked for, which are not the end of longer ones: "t=" is
 * not in "dt=". */
static enum status note_time(struct csv *c, const char *line, size_t number) {
  const char *words = c->ask->time_after;
  const size_t n = words ? strlen(words) : 0;
  for (const char *at = line; words && (at = strstr(at, words)); at += n) {
    char *end;
    const char *begin = at + n;
    if (at > line && is_of_word(*words) && is_of_word(at[-1])) continue;
    const double time = strtod(begin, &end);
    if (end == begin) continue;
    CHECK(is_decimal(begin, end), ERR_INPUT,
          "%s:%zu: found the time '%.*s'; allowed: a decimal number; correct that line",
          c->ask->path, number, (int)(end - begin + (ptrdiff_t)strcspn(end, " \t")), begin);
    CHECK(isnan(c->time) || c->time == time, ERR_INPUT,
          "%s:%zu: found the time %.9g after %.9g; allowed: one time in a file; divide it, or make "
          "the times a column",
          c->ask->path, number, time, c->time);
    c->time = time;
  }
  return OK;
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
  const char blank[] = {' ', '\t', c->ask->separator, 0};
  while ((line = text_line(&rest))) {
    number++;
    const char *begin = line + strspn(line, " \t");
    if (!line[strspn(line, blank)]) continue;
    if (*begin == '#') TRY(note_time(c, begin, number));
    bool row = *begin != '#';
    if (row && !rows) TRY(find_row(c, line, number, &row));
    if (!rows && !row) {
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
  CHECK(!c->ask->time_after || !isnan(c->time), ERR_INPUT,
        "%s has no comment with a number after '%s'; correct time_after, or give the files their "
        "time by another key",
        c->ask->path, c->ask->time_after);
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
