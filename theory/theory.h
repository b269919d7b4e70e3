/* Theory without a run: laws of both documents as tables of numbers. A topic is a file with a
 * struct theory_topic and a line in topics.h; its parameters, columns and helps are all that the
 * command knows of it. Evaluating a topic for one set of parameters gives one curve: rows of
 * columns, and single values. A parameter may be given several values, "1, 0.8, 0.5": one curve for
 * each.
 *
 * "P" is Antuono, Colagrossi & Marrone, "T" is Kiara (2010): REFERENCES.md. What is wrong in the
 * printed texts, and why: docs/theory.md. */
#pragma once
#include <stdio.h>

#include "common/base/params.h"
#include "common/base/status.h"

enum { THEORY_MOST_CURVES = 64 };

struct theory_column {
  const char *key, *unit; /* of a column in CSV and JSON; "1" for a number */
  const char *label;      /* in the key of a figure, and on its axis where there is no other */
  const char *axis;       /* on the axis of its panel, of the panel's first column */
  const char *level;      /* a line across the panel, likewise */
  const char *help;
  int panel;    /* of a figure, from the top; the first column is the axis of them all */
  double top;   /* the panel goes no higher, likewise; 0: as high as its curves */
  bool log;     /* the axis of the panel whose first column it is; of the first column, its own */
  bool points;  /* symbols, not a line */
  bool same;    /* alike in all curves: drawn once */
  bool undrawn; /* only in tables */
};

struct theory_value {
  const char *key, *unit, *help;
};

struct theory_curve {
  char name[192]; /* "delta = 1, alpha = 0.01": what is its own; "" when there is but one */
  void *params;   /* the topic's struct, owned */
  const struct theory_topic *topic;
  size_t n, room; /* rows */
  double *row;    /* [n][n_columns]; NaN: there is none */
  double *value;  /* [n_values], likewise */
};

struct theory_topic {
  const char *name, *help; /* one sentence with its source */
  const struct param *params;
  size_t n_params, params_size;
  const struct theory_column *columns;
  size_t n_columns;
  const struct theory_value *values;
  size_t n_values;
  /* Adds the rows and sets the values, all of which are NaN before. */
  enum status (*evaluate)(const void *params, struct theory_curve *curve);
};

/* Adds a row: an expression for each column. */
#define THEORY_ROW(curve, ...)                                                                     \
  theory_row_add(curve, sizeof((double[]){__VA_ARGS__}) / sizeof(double), (double[]){__VA_ARGS__})
enum status theory_row_add(struct theory_curve *curve, size_t n, const double *row);

/* Rows of a table of parameters, for the struct `struct_`. */
#define THEORY_REAL(struct_, member, least, most, standard, text)                                  \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .offset = offsetof(struct struct_, member), .min = least,  \
    .max = most, .value = standard, .help = text                                                   \
  }
/* A number, or a word that stands for one (params.h). */
#define THEORY_REAL_OR(struct_, member, least, most, words, about, standard, text)                 \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .offset = offsetof(struct struct_, member), .min = least,  \
    .max = most, .choices = words, .helps = about, .value = standard, .help = text                 \
  }
#define THEORY_INT(struct_, member, least, most, standard, text)                                   \
  {                                                                                                \
    .key = #member, .type = PARAM_INT, .offset = offsetof(struct struct_, member), .min = least,   \
    .max = most, .value = standard, .help = text                                                   \
  }
#define THEORY_CHOICE(struct_, member, names, about, standard, text)                               \
  {                                                                                                \
    .key = #member, .type = PARAM_CHOICE, .offset = offsetof(struct struct_, member),              \
    .choices = names, .helps = about, .value = standard, .help = text                              \
  }
#define THEORY_POINTS(struct_) THEORY_INT(struct_, points, 2, 100000, "400", "points of each curve")

#define THEORY_COUNT(array) (sizeof(array) / sizeof *(array))
#define THEORY_TABLES                                                                              \
  .params = params, .n_params = THEORY_COUNT(params), .columns = columns,                          \
  .n_columns = THEORY_COUNT(columns)
#define THEORY_VALUES .values = values, .n_values = THEORY_COUNT(values)

/* The word that a parameter's value stands for (params.h), or NULL. */
const char *theory_param_word(const struct param *row, const void *params);

/* The i-th of n points from low to high, both included. */
double theory_between(double low, double high, int i, int n);

extern const struct theory_topic *const theory_topics[];        /* NULL at the end */
const struct theory_topic *theory_topic_find(const char *name); /* NULL: there is none */
/* The topic nearest in spelling to `name`, or NULL. */
const char *theory_topic_nearest(const char *name);

struct theory_setting {
  const char *key, *text;
};

struct theory_result {
  const struct theory_topic *topic;
  size_t n;
  struct theory_curve *curve; /* [n] */
};

/* ERR_USAGE with one message when a setting is not allowed: its key, what was found, what is. */
enum status theory_evaluate(const struct theory_topic *topic, size_t n,
                            const struct theory_setting *setting, struct theory_result *result);
/* Whether the settings are allowed, and how many curves they make; nothing is evaluated. */
enum status theory_check(const struct theory_topic *topic, size_t n,
                         const struct theory_setting *setting, size_t *curves);
void theory_result_destroy(struct theory_result *result);

/* Whether all curves have parameter p alike. */
bool theory_param_is_common(const struct theory_result *r, size_t p);
/* The value of parameter p of a curve as it would be written; `out` [size]. */
void theory_param_text(const struct theory_curve *curve, size_t p, char *out, size_t size);

void theory_write_table(const struct theory_result *r, FILE *out);
/* curve,name,KEY [UNIT],... with a line for each row of each curve. */
void theory_write_csv(const struct theory_result *r, FILE *out);
enum status theory_write_json(const struct theory_result *r, FILE *out);
