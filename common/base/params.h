/* The parameter table: one row per key gives its type, unit, range, default and help, and from it
 * the case reader checks, fills, and prints (`plunge list`, README) everything. */
#pragma once
#include <float.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum param_type {
  PARAM_REAL,   /* double; a number, or a number with a unit that matches `quantity` */
  PARAM_INT,    /* int */
  PARAM_BOOL,   /* bool */
  PARAM_CHOICE, /* int: index into `choices` */
  PARAM_TEXT,   /* char *, owned by the struct (params_release); one line of at most `max` bytes */
  PARAM_NODE,   /* int: handle of a nested list or mapping, read by the caller; 0: absent; help says
                   what is   allowed there */
};

#define PARAM_ABOVE_0 DBL_MIN

/* The dimension of a PARAM_REAL; a value may be given with a unit: "0.266 H", "6 sqrt(H/g)",
 * "20 mm", "12 sqrt(gH)". A bare number is in SI. */
enum quantity {
  QTY_NUMBER,
  QTY_LENGTH,
  QTY_TIME,
  QTY_VELOCITY,
  QTY_DENSITY,
  QTY_ACCELERATION,
  QTY_RATE
};

struct param {
  const char *key;
  enum param_type type;
  enum quantity quantity;
  size_t offset;   /* of the member in the struct that is filled */
  double min, max; /* allowed range, ends included (PARAM_REAL and PARAM_INT), in SI; PARAM_ABOVE_0
                      as min: greater than zero; min = max: any finite number */
  const char *value; /* default, written as in a case file; NULL: the key is required; "": optional,
                        the member keeps what it held */
  const char *const
      *choices;     /* PARAM_CHOICE: NULL-terminated names. PARAM_REAL, PARAM_INT: words that
                       are allowed besides, for which the member is -1, -2, ...; or NULL */
  const char *help; /* one sentence: what it is, its source (paper and equation) */
  const char *const *helps; /* one a choice, or NULL */
};

/* What "H" and "g" in a unit stand for; NaN while not known. */
struct param_scales {
  double H, g; /* m, m s^-2 */
};

/* Values that stand in place of the defaults of some rows, under one name: what the choice of that
 * name in one row sets, as long as a case does not say otherwise. */
struct param_preset {
  const char *name, *help;
  const struct param_value {
    const char *key, *value; /* as in a case file */
  } * values;                /* a key of NULL ends them */
};

/* What the preset has for `key`, or NULL; a preset of NULL has nothing. */
const char *param_preset_value(const struct param_preset *preset, const char *key);

/* Fills the member of `into` that row `p` describes from `text`. False when that is not allowed:
 * nothing is filled and `todo` says what to do about it ("" when param_allowed says it all). */
bool param_fill(const struct param *p, const char *text, const struct param_scales *scales,
                void *into, char todo[160]);

/* `value`, in SI, in the unit that `text` is written in (a bare number's, and that of NULL, is
 * `si`): "2.24 sqrt(H/g)". */
void param_in_unit_of(const char *text, const char *si, const struct param_scales *scales,
                      double value, char *out, size_t size);

/* What row `p` allows, in words: "a number from 0 to 1", "one of rk4, tvd-rk3". */
void param_allowed(const struct param *p, char *out, size_t size);

/* Appends the members that row by row describe the struct, as "key=value\n" with all digits. */
void params_write(FILE *out, const struct param *params, size_t n, const void *from);

/* One readable paragraph a key: name, what is allowed, default, help, and a line for each choice.
 */
void params_print(FILE *out, const struct param *params, size_t n);

/* A line a preset: its name and help, and one below with what it sets. */
void param_presets_print(FILE *out, const struct param_preset *presets, size_t n);

/* Frees what PARAM_TEXT rows own in `from`. */
void params_release(const struct param *params, size_t n, void *from);

/* The name nearest in spelling to `key`, or NULL when none is near. */
const char *param_nearest(const char *key, size_t n, const char *const *names);
