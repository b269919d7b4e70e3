#include "common/result/result_tolerance.h"

#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"

enum { MOST_BYTES = 1 << 20 };

static enum status add(struct result_tolerances *t, const char *pattern, bool ignore,
                       double relative, double absolute) {
  TRY(array_grow(&t->rule, &t->room, t->n + 1, "tolerances"));
  char *copy = strdup(pattern);
  CHECK(copy, ERR_MEMORY, "no memory for a tolerance");
  t->rule[t->n++] = (struct tolerance){copy, ignore, relative, absolute};
  return OK;
}

enum status result_tolerances_default(struct result_tolerances *t, double relative,
                                      double absolute) {
  static const char *const ignored[] = {"@created",
                                        "@version",
                                        "@revision",
                                        "@fingerprint",
                                        "series/run/wall_time",
                                        "statistics/wall_time*"};
  *t = (struct result_tolerances){0};
  TRY(add(t, "*", false, relative, absolute));
  for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++) TRY(add(t, ignored[i], true, 0, 0));
  return OK;
}

static enum status read_line(struct result_tolerances *t, const char *path, int number,
                             char *line) {
  static const char space[] = " \t\r\n";
  CHECK(strlen(line) <= TEXT_LONGEST_LINE, ERR_INPUT,
        "%s:%d: a line of %zu bytes; at most %d are allowed", path, number, strlen(line),
        TEXT_LONGEST_LINE);
  line[strcspn(line, "#")] = 0;
  char *rest, *word[4];
  int n = 0;
  for (char *w = strtok_r(line, space, &rest); w && n < 4; w = strtok_r(NULL, space, &rest))
    word[n++] = w;
  if (n == 0) return OK;
  if (n == 2 && !strcmp(word[1], "ignore")) return add(t, word[0], true, 0, 0);
  double value[2] = {0, 0};
  bool good = n == 3;
  for (int k = 0; k < 2 && good; k++) {
    char *end;
    value[k] = strtod(word[k + 1], &end);
    good = !*end && isfinite(value[k]) && value[k] >= 0;
  }
  CHECK(good, ERR_INPUT,
        "%s:%d: a tolerance is 'PATTERN RELATIVE ABSOLUTE' or 'PATTERN ignore', with "
        "numbers of at least 0",
        path, number);
  return add(t, word[0], false, value[0], value[1]);
}

enum status result_tolerances_read(struct result_tolerances *t, const char *path) {
  char *text, *line;
  size_t n;
  enum status status = text_read(path, MOST_BYTES, &text, &n);
  if (status == ERR_INPUT)
    return status_context(status, "cannot read tolerances, a text of at most 1 MB, from %s: found ",
                          path);
  char *rest = text;
  for (int number = 1; status == OK && (line = text_line(&rest)); number++)
    status = read_line(t, path, number, line);
  free(text);
  return status;
}

void result_tolerances_destroy(struct result_tolerances *t) {
  for (size_t i = 0; i < t->n; i++) free(t->rule[i].pattern);
  free(t->rule);
  *t = (struct result_tolerances){0};
}

const struct tolerance *result_tolerances_find(const struct result_tolerances *t,
                                               const char *name) {
  for (size_t i = t->n; i-- > 0;)
    if (!fnmatch(t->rule[i].pattern, name, 0)) return &t->rule[i];
  return NULL;
}
