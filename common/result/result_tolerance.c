#include "common/result/result_tolerance.h"

#include <ctype.h>
#include <fnmatch.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "common/base/array.h"
#include "common/base/text.h"

enum { MOST_BYTES = 1 << 20 };

static enum status add(struct result_tolerances *t, const char *pattern,
                       const struct tolerance *rule) {
  TRY(array_grow(&t->rule, &t->room, t->n + 1, "tolerances"));
  t->rule[t->n] = *rule;
  t->rule[t->n].pattern = strdup(pattern);
  CHECK(t->rule[t->n].pattern, ERR_MEMORY, "no memory for a tolerance");
  t->n++;
  return OK;
}

enum status result_tolerances_default(struct result_tolerances *t, double relative,
                                      double absolute) {
  static const char *const ignored[] = {"@created",
                                        "@version",
                                        "@revision",
                                        "@fingerprint",
                                        "@imported", /* says the version, too */
                                        "series/run/wall_time",
                                        "statistics/wall_time*"};
  *t = (struct result_tolerances){0};
  TRY(add(t, "*", &(struct tolerance){.relative = relative, .absolute = absolute}));
  for (size_t i = 0; i < sizeof ignored / sizeof *ignored; i++)
    TRY(add(t, ignored[i], &(struct tolerance){.ignore = true}));
  return OK;
}

/* ---- a line ---- */

struct line {
  const char *path;
  int number;
  char *rest; /* of strtok_r */
};

static char *next_word(struct line *l, char *line) {
  return strtok_r(line, " \t\r\n", &l->rest);
}

static enum status read_number(const struct line *l, const char *what, const char *word,
                               double *value) {
  char *end;
  *value = strtod(word, &end);
  CHECK(end != word && !*end && isfinite(*value) && *value >= 0, ERR_INPUT,
        "%s:%d: the %s tolerance: found %s, allowed: a number of at least 0", l->path, l->number,
        what, word);
  return OK;
}

/* "t>0.5", "t*<=4" */
static enum status read_bound(const struct line *l, const char *word, struct tolerance_bound *b) {
  const char *at = word + strspn(word, "t");
  *b = (struct tolerance_bound){0};
  if (*at == '*') b->stars = true, at++;
  const char *sign = at;
  b->below = *sign == '<';
  at += *sign == '<' || *sign == '>';
  b->equal = at > sign && *at == '=';
  at += b->equal;
  char *end;
  b->at = strtod(at, &end);
  CHECK(word[0] == 't' && word[1] != 't' && at > sign && end != at && !*end && isfinite(b->at),
        ERR_INPUT,
        "%s:%d: a time: found %s, allowed: t>T, t>=T, t<T, t<=T with T in s, or t* in place of t "
        "with T in sqrt(H/g), without spaces",
        l->path, l->number, word);
  return OK;
}

static enum status read_bounds(struct line *l, struct tolerance *rule) {
  for (char *word; (word = next_word(l, NULL));) {
    CHECK(rule->n_bounds < 2, ERR_INPUT,
          "%s:%d: found %s after two times, allowed: at most two, as in t>1 t<=2", l->path,
          l->number, word);
    TRY(read_bound(l, word, &rule->bound[rule->n_bounds++]));
  }
  if (rule->n_bounds < 2) return OK;
  const struct tolerance_bound *a = &rule->bound[0], *b = &rule->bound[1];
  CHECK(a->stars == b->stars && a->below != b->below, ERR_INPUT,
        "%s:%d: two times: allowed: one with > and one with <, both with t or both with t*",
        l->path, l->number);
  const struct tolerance_bound *from = a->below ? b : a, *to = a->below ? a : b;
  CHECK(from->at < to->at || (from->at == to->at && from->equal && to->equal), ERR_INPUT,
        "%s:%d: no time is after %g and before %g; exchange them", l->path, l->number, from->at,
        to->at);
  return OK;
}

static enum status read_line(struct result_tolerances *t, const char *path, int number,
                             char *line) {
  struct line l = {path, number, NULL};
  struct tolerance rule = {.line = number};
  CHECK(strlen(line) <= TEXT_LONGEST_LINE, ERR_INPUT,
        "%s:%d: a line of %zu bytes; at most %d are allowed", path, number, strlen(line),
        TEXT_LONGEST_LINE);
  line[strcspn(line, "#")] = 0;
  const char *pattern = next_word(&l, line), *word = pattern ? next_word(&l, NULL) : NULL;
  if (!pattern) return OK;
  CHECK(word, ERR_INPUT,
        "%s:%d: found %s alone; a tolerance is 'PATTERN RELATIVE ABSOLUTE' or 'PATTERN ignore', "
        "then times, if any",
        path, number, pattern);
  rule.ignore = !strcmp(word, "ignore");
  if (!rule.ignore) {
    const char *absolute = next_word(&l, NULL);
    CHECK(isdigit((unsigned char)*word) || *word == '.' || *word == '-' || *word == '+' ||
              !strcasecmp(word, "nan") || !strcasecmp(word, "inf"),
          ERR_INPUT, "%s:%d: found %s after the pattern %s, allowed: a number, or ignore", path,
          number, word, pattern);
    TRY(read_number(&l, "relative", word, &rule.relative));
    CHECK(absolute, ERR_INPUT,
          "%s:%d: the absolute tolerance is missing; write 0 where there is none", path, number);
    TRY(read_number(&l, "absolute", absolute, &rule.absolute));
  }
  TRY(read_bounds(&l, &rule));
  return add(t, pattern, &rule);
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

/* ---- which rule ---- */

size_t result_tolerances_match(const struct result_tolerances *t, const char *name,
                               const struct tolerance **rule) {
  size_t n = 0;
  for (size_t i = t->n; i-- > 0;) {
    if (fnmatch(t->rule[i].pattern, name, 0)) continue;
    rule[n++] = &t->rule[i];
    if (!t->rule[i].n_bounds) break;
  }
  return n;
}

static bool holds(const struct tolerance *rule, double time, double scale) {
  for (int k = 0; k < rule->n_bounds; k++) {
    const struct tolerance_bound *b = &rule->bound[k];
    const double at = b->stars ? b->at * scale : b->at;
    if (!(b->equal && time == at) && !(b->below ? time < at : time > at)) return false;
  }
  return true;
}

const struct tolerance *result_tolerance_at(size_t n, const struct tolerance *const *rule,
                                            double time, double scale) {
  for (size_t i = 0; i < n; i++)
    if (holds(rule[i], time, scale)) return rule[i];
  return NULL;
}

void result_tolerance_when(const struct tolerance *rule, char *out, size_t room) {
  size_t n = 0;
  *out = 0;
  for (int k = 0; k < rule->n_bounds; k++) {
    const struct tolerance_bound *b = &rule->bound[k];
    char at[32];
    snprintf(at, sizeof at, "%.15g", b->at);
    if (strtod(at, NULL) != b->at) snprintf(at, sizeof at, "%.17g", b->at);
    n += (size_t)snprintf(out + n, n < room ? room - n : 0, " t%s%s%s%s", b->stars ? "*" : "",
                          b->below ? "<" : ">", b->equal ? "=" : "", at);
  }
}
