/* The parameter table: one row per key gives its type, unit, range, default and help, and from it
 * the case reader checks, fills, and prints (`plunge list`, README) everything. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

enum param_type {
  PARAM_REAL,   /* double; a number, or a number with a unit that matches `quantity` */
  PARAM_INT,    /* int */
  PARAM_BOOL,   /* bool */
  PARAM_CHOICE, /* int: index into `choices` */
};

/* The dimension of a PARAM_REAL; a value may be given with a unit: "0.266 H", "6 sqrt(H/g)",
 * "20 mm", "12 sqrt(gH)". A bare number is in SI. */
enum quantity { QTY_NUMBER, QTY_LENGTH, QTY_TIME, QTY_VELOCITY, QTY_DENSITY, QTY_ACCELERATION };

struct param {
  const char *key;
  enum param_type type;
  enum quantity quantity;
  size_t offset;     /* of the member in the struct that is filled */
  double min, max;   /* allowed range, ends included (PARAM_REAL and PARAM_INT), in SI */
  const char *value; /* default, written as in a case file; NULL: the key is required */
  const char *const *choices; /* PARAM_CHOICE: NULL-terminated names */
  const char *help;           /* one sentence: what it is, its source (paper and equation) */
};
