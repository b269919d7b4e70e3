#include "common/base/params.h"

#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Every unit that a case file may write, with its size in SI: factor * H^h * g^k. */
static const struct unit {
  const char *name;
  enum quantity quantity;
  double factor, h, k;
} units[] = {
    {"m", QTY_LENGTH, 1, 0, 0},
    {"cm", QTY_LENGTH, 0.01, 0, 0},
    {"mm", QTY_LENGTH, 0.001, 0, 0},
    {"H", QTY_LENGTH, 1, 1, 0},
    {"s", QTY_TIME, 1, 0, 0},
    {"ms", QTY_TIME, 0.001, 0, 0},
    {"sqrt(H/g)", QTY_TIME, 1, 0.5, -0.5},
    {"m/s", QTY_VELOCITY, 1, 0, 0},
    {"sqrt(gH)", QTY_VELOCITY, 1, 0.5, 0.5},
    {"kg/m^3", QTY_DENSITY, 1, 0, 0},
    {"m/s^2", QTY_ACCELERATION, 1, 0, 0},
    {"1/s", QTY_RATE, 1, 0, 0},
    {"sqrt(g/H)", QTY_RATE, 1, -0.5, 0.5},
};
enum { N_UNITS = sizeof units / sizeof *units };

static const char *const quantity_names[] = {
    [QTY_NUMBER] = "number",     [QTY_LENGTH] = "length",   [QTY_TIME] = "time",
    [QTY_VELOCITY] = "velocity", [QTY_DENSITY] = "density", [QTY_ACCELERATION] = "acceleration",
    [QTY_RATE] = "rate",
};

/* The length of the decimal number at the start of `s`: digits with sign, point and exponent. Not
 * strtod's own idea of one, which takes hexadecimal, "inf" and "nan". */
static size_t number_length(const char *s) {
  const char *p = s;
  size_t digits = 0;
  if (*p == '+' || *p == '-') p++;
  for (; isdigit((unsigned char)*p); p++) digits++;
  if (*p == '.') p++;
  for (; isdigit((unsigned char)*p); p++) digits++;
  if (!digits) return 0;
  if (*p == 'e' || *p == 'E') {
    const char *e = p + 1;
    if (*e == '+' || *e == '-') e++;
    if (isdigit((unsigned char)*e)) {
      while (isdigit((unsigned char)*e)) e++;
      p = e;
    }
  }
  return (size_t)(p - s);
}

static bool has_leading_zero(const char *s) {
  if (*s == '+' || *s == '-') s++;
  return s[0] == '0' && isdigit((unsigned char)s[1]);
}

/* Looks a unit up with all blanks left out, so that "sqrt(g H)" is as good as "sqrt(gH)". */
static const struct unit *unit_find(const char *text) {
  char squeezed[16];
  size_t n = 0;
  for (; *text; text++) {
    if (isspace((unsigned char)*text)) continue;
    if (n + 1 == sizeof squeezed) return NULL;
    squeezed[n++] = *text;
  }
  squeezed[n] = 0;
  for (size_t i = 0; i < N_UNITS; i++)
    if (!strcmp(units[i].name, squeezed)) return &units[i];
  return NULL;
}

static double unit_size(const struct unit *u, const struct param_scales *scales) {
  return u->factor * (u->h != 0 ? pow(scales->H, u->h) : 1) *
         (u->k != 0 ? pow(scales->g, u->k) : 1);
}

void param_in_unit_of(const char *text, const char *si, const struct param_scales *scales,
                      double value, char *out, size_t size) {
  const struct unit *unit = NULL;
  if (text) {
    while (isspace((unsigned char)*text)) text++;
    unit = unit_find(text + number_length(text));
  }
  snprintf(out, size, "%.9g %s", unit ? value / unit_size(unit, scales) : value,
           unit ? unit->name : si);
}

static bool parse_real(const struct param *p, const char *text, const struct param_scales *scales,
                       double *out, char todo[160]) {
  while (isspace((unsigned char)*text)) text++;
  size_t n = number_length(text);
  double value = 1; /* "H" alone is 1 H */
  if (n) {
    if (has_leading_zero(text)) {
      snprintf(todo, 160, "write the number without its leading zero");
      return false;
    }
    errno = 0;
    value = strtod(text, NULL);
    if (errno == ERANGE) {
      snprintf(todo, 160, "the number is too %s to compute with",
               fabs(value) > 1 ? "large" : "small");
      return false;
    }
  }
  const char *rest = text + n;
  while (isspace((unsigned char)*rest)) rest++;
  if (*rest) {
    const struct unit *unit = unit_find(rest);
    if (!unit || unit->quantity != p->quantity) {
      if (unit && p->quantity == QTY_NUMBER)
        snprintf(todo, 160, "write it without a unit");
      else if (unit)
        snprintf(todo, 160, "%s is a unit of %s, not of %s", unit->name,
                 quantity_names[unit->quantity], quantity_names[p->quantity]);
      return false;
    }
    if (unit->h != 0 && isnan(scales->H)) {
      snprintf(todo, 160, "give scales.H in metres first");
      return false;
    }
    if (unit->k != 0 && isnan(scales->g)) {
      snprintf(todo, 160, "give fluid.gravity first");
      return false;
    }
    value *= unit_size(unit, scales);
  } else if (!n) {
    return false;
  }
  if (!isfinite(value)) {
    snprintf(todo, 160, "the number is too large to compute with");
    return false;
  }
  *out = value;
  return true;
}

static bool in_range(const struct param *p, double value) {
  return p->min == p->max || (value >= p->min && value <= p->max);
}

static bool parse_int(const struct param *p, const char *text, int *out, char todo[160]) {
  double value;
  struct param number = {.quantity = QTY_NUMBER};
  struct param_scales none = {NAN, NAN};
  if (!parse_real(&number, text, &none, &value, todo)) return false;
  if (value != floor(value) || fabs(value) > 1e9 || !in_range(p, value)) return false;
  *out = (int)value;
  return true;
}

static bool parse_bool(const char *text, bool *out) {
  bool yes = !strcmp(text, "true");
  if (!yes && strcmp(text, "false") != 0) return false;
  *out = yes;
  return true;
}

/* Its place among the choices, or -1. */
static int choice_find(const struct param *p, const char *text) {
  for (int k = 0; p->choices && p->choices[k]; k++)
    if (!strcmp(p->choices[k], text)) return k;
  return -1;
}

static bool parse_choice(const struct param *p, const char *text, int *out, char todo[160]) {
  const int found = choice_find(p, text);
  if (found >= 0) {
    *out = found;
    return true;
  }
  size_t n = 0;
  while (p->choices[n]) n++;
  const char *near = param_nearest(text, n, p->choices);
  if (near) snprintf(todo, 160, "did you mean '%s'?", near);
  return false;
}

static bool parse_text(const struct param *p, const char *text, char **out, char todo[160]) {
  size_t n = strlen(text);
  while (n && text[n - 1] == '\n') n--; /* a folded YAML block ends with one */
  if (!n || (p->max > 0 && (double)n > p->max)) return false;
  for (size_t i = 0; i < n; i++)
    if ((unsigned char)text[i] < 32 || text[i] == 127) {
      snprintf(todo, 160, "leave the line breaks and control characters out");
      return false;
    }
  char *copy = strndup(text, n);
  if (!copy) return false;
  free(*out);
  *out = copy;
  return true;
}

bool param_fill(const struct param *p, const char *text, const struct param_scales *scales,
                void *into, char todo[160]) {
  char *member = (char *)into + p->offset;
  todo[0] = 0;
  switch (p->type) {
  case PARAM_REAL: {
    const int word = choice_find(p, text);
    double value = -1 - word;
    if (word < 0 && (!parse_real(p, text, scales, &value, todo) || !in_range(p, value)))
      return false;
    *(double *)member = value;
    return true;
  }
  case PARAM_INT: {
    const int word = choice_find(p, text);
    if (word < 0) return parse_int(p, text, (int *)member, todo);
    *(int *)member = -1 - word;
    return true;
  }
  case PARAM_BOOL:
    return parse_bool(text, (bool *)member);
  case PARAM_CHOICE:
    return parse_choice(p, text, (int *)member, todo);
  case PARAM_TEXT:
    return parse_text(p, text, (char **)member, todo);
  case PARAM_NODE:
    break;
  }
  return false;
}

static void append(char *out, size_t size, const char *text) {
  size_t n = strlen(out);
  if (n + 1 < size) snprintf(out + n, size - n, "%s", text);
}

static void range_in_words(const struct param *p, char *out, size_t size) {
  if (p->min == p->max) return;
  char part[96];
  bool top = p->max < 1e30; /* beyond that the bound only stops overflow */
  if (p->min == PARAM_ABOVE_0 && top)
    snprintf(part, sizeof part, " above 0 and up to %.10g", p->max);
  else if (p->min == PARAM_ABOVE_0)
    snprintf(part, sizeof part, " above 0");
  else if (p->min > -1e30 && top)
    snprintf(part, sizeof part, " from %.10g to %.10g", p->min, p->max);
  else if (p->min > -1e30)
    snprintf(part, sizeof part, " of at least %.10g", p->min);
  else if (top)
    snprintf(part, sizeof part, " of at most %.10g", p->max);
  else
    return;
  append(out, size, part);
}

static void words_in_words(const struct param *p, char *out, size_t size) {
  for (size_t k = 0; p->choices && p->choices[k]; k++) {
    append(out, size, ", or ");
    append(out, size, p->choices[k]);
  }
}

void param_allowed(const struct param *p, char *out, size_t size) {
  out[0] = 0;
  switch (p->type) {
  case PARAM_REAL:
    append(out, size, p->quantity == QTY_ACCELERATION ? "an " : "a ");
    append(out, size, quantity_names[p->quantity]);
    range_in_words(p, out, size);
    for (size_t i = 0, n = 0; i < N_UNITS; i++) {
      if (units[i].quantity != p->quantity) continue;
      append(out, size, n++ ? ", " : " in ");
      append(out, size, units[i].name);
    }
    words_in_words(p, out, size);
    return;
  case PARAM_INT:
    append(out, size, "a whole number");
    range_in_words(p, out, size);
    words_in_words(p, out, size);
    return;
  case PARAM_BOOL:
    append(out, size, "true or false");
    return;
  case PARAM_CHOICE:
    for (size_t i = 0; p->choices[i]; i++) {
      append(out, size, i ? ", " : "one of ");
      append(out, size, p->choices[i]);
    }
    return;
  case PARAM_TEXT:
    append(out, size, "one line of text");
    if (p->max > 0) {
      char part[48];
      snprintf(part, sizeof part, " of at most %.0f bytes", p->max);
      append(out, size, part);
    }
    return;
  case PARAM_NODE:
    append(out, size, p->help);
    return;
  }
}

void params_write(FILE *out, const struct param *params, size_t n, const void *from) {
  for (size_t i = 0; i < n; i++) {
    const struct param *p = &params[i];
    const char *member = (const char *)from + p->offset;
    switch (p->type) {
    case PARAM_REAL:
      fprintf(out, "%s=%.17g\n", p->key, *(const double *)member);
      break;
    case PARAM_INT:
      fprintf(out, "%s=%d\n", p->key, *(const int *)member);
      break;
    case PARAM_BOOL:
      fprintf(out, "%s=%d\n", p->key, *(const bool *)member);
      break;
    case PARAM_CHOICE:
      fprintf(out, "%s=%s\n", p->key, p->choices[*(const int *)member]);
      break;
    case PARAM_TEXT: {
      const char *text = *(char *const *)member;
      fprintf(out, "%s=%s\n", p->key, text ? text : "");
      break;
    }
    case PARAM_NODE:
      break;
    }
  }
}

static void print_choices(FILE *out, const struct param *p, int indent) {
  int width = 0;
  for (size_t i = 0; p->choices[i]; i++)
    if ((int)strlen(p->choices[i]) > width) width = (int)strlen(p->choices[i]);
  for (size_t i = 0; p->choices[i]; i++)
    fprintf(out, "%*s%-*s  %s\n", indent, "", width, p->choices[i], p->helps[i]);
}

void params_print(FILE *out, const struct param *params, size_t n) {
  int width = 0;
  for (size_t i = 0; i < n; i++) {
    int w = (int)strlen(params[i].key);
    if (w > width) width = w;
  }
  for (size_t i = 0; i < n; i++) {
    const struct param *p = &params[i];
    char allowed[512];
    param_allowed(p, allowed, sizeof allowed);
    fprintf(out, "    %-*s  %s; ", width, p->key, allowed);
    if (!p->value)
      fprintf(out, "required\n");
    else if (*p->value)
      fprintf(out, "default %s\n", p->value);
    else
      fprintf(out, "optional\n");
    if (p->type != PARAM_NODE) fprintf(out, "    %-*s  %s\n", width, "", p->help);
    if (p->choices && p->helps) print_choices(out, p, width + 8);
  }
}

const char *param_preset_value(const struct param_preset *preset, const char *key) {
  for (const struct param_value *v = preset ? preset->values : NULL; v && v->key; v++)
    if (!strcmp(v->key, key)) return v->value;
  return NULL;
}

void param_presets_print(FILE *out, const struct param_preset *presets, size_t n) {
  int width = 0;
  for (size_t i = 0; i < n; i++)
    if ((int)strlen(presets[i].name) > width) width = (int)strlen(presets[i].name);
  for (size_t i = 0; i < n; i++) {
    fprintf(out, "    %-*s  %s\n", width, presets[i].name, presets[i].help);
    fprintf(out, "    %-*s ", width, "");
    for (const struct param_value *v = presets[i].values; v->key; v++)
      fprintf(out, " %s: %s%s", v->key, v->value, v[1].key ? "," : "");
    fputs(presets[i].values->key ? "\n" : " every default\n", out);
  }
}

void params_release(const struct param *params, size_t n, void *from) {
  for (size_t i = 0; from && i < n; i++)
    if (params[i].type == PARAM_TEXT) {
      char **member = (char **)((char *)from + params[i].offset);
      free(*member);
      *member = NULL;
    }
}

/* Edits (insert, delete, replace, swap two neighbours) that turn a into b; both short. */
static size_t edit_distance(const char *a, size_t n, const char *b, size_t m) {
  enum { LONGEST = 32 };
  size_t d[LONGEST + 1][LONGEST + 1];
  if (n > LONGEST || m > LONGEST) return LONGEST;
  for (size_t i = 0; i <= n; i++)
    for (size_t j = 0; j <= m; j++) {
      if (!i || !j) {
        d[i][j] = i + j;
        continue;
      }
      size_t best = d[i - 1][j - 1] + (a[i - 1] != b[j - 1]);
      if (d[i - 1][j] + 1 < best) best = d[i - 1][j] + 1;
      if (d[i][j - 1] + 1 < best) best = d[i][j - 1] + 1;
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] &&
          d[i - 2][j - 2] + 1 < best)
        best = d[i - 2][j - 2] + 1;
      d[i][j] = best;
    }
  return d[n][m];
}

const char *param_nearest(const char *key, size_t n, const char *const *names) {
  size_t length = strlen(key), best = length / 3 + 1;
  const char *nearest = NULL;
  for (size_t i = 0; i < n; i++) {
    size_t m = strlen(names[i]), d = edit_distance(key, length, names[i], m);
    if (d <= best && d < m && (!nearest || d < best)) {
      best = d;
      nearest = names[i];
    }
  }
  return nearest;
}
