#include <math.h>
#include <string.h>

#include "gallery/page/content.h"

static double number_of(const json_t *object, const char *key) {
  const json_t *value = json_object_get(object, key);
  return json_is_number(value) ? json_number_value(value) : NAN;
}

/* As many digits as show where a value stands within what is allowed. */
static int digits_for(double value, double tolerance) {
  if (!(tolerance > 0) || !isfinite(value) || value == 0) return 6;
  const double digits = ceil(log10(fabs(value) / tolerance)) + 2;
  return digits < 4 ? 4 : digits > 13 ? 13 : (int)digits;
}

static void number_cell(struct markup *m, double value, int digits) {
  if (isfinite(value))
    cmp_markup_element(m, "td", "n", "%.*g", digits, value);
  else
    cmp_markup_element(m, "td", "n", "–");
}

/* A number; of a run of chaos, with how far others lie that differ by rounding alone. */
static void measured_cell(struct markup *m, double value, double scatter, int digits) {
  if (isfinite(scatter) && isfinite(value))
    cmp_markup_element(m, "td", "n", "%.4g (scatter %.2g)", value, scatter);
  else
    number_cell(m, value, digits);
}

static void allowed_cell(struct markup *m, const json_t *check, double tolerance) {
  const double low = number_of(check, "low"), high = number_of(check, "high");
  if (isfinite(tolerance))
    cmp_markup_element(m, "td", "n", "± %.3g", tolerance);
  else if (isfinite(low) && isfinite(high))
    cmp_markup_element(m, "td", "n", "%.6g to %.6g", low, high);
  else if (isfinite(low))
    cmp_markup_element(m, "td", "n", "above %.6g", low);
  else if (isfinite(high))
    cmp_markup_element(m, "td", "n", "below %.6g", high);
  else
    cmp_markup_element(m, "td", "n", "–");
}

static void outcome_cell(struct markup *m, const json_t *check) {
  const bool holds = json_is_true(json_object_get(check, "holds"));
  const bool expected = json_is_true(json_object_get(check, "as_expected"));
  const bool open = expected && holds == (*gallery_text(check, "because") != 0);
  cmp_markup_open(m, "td", "n");
  if (json_is_true(json_object_get(check, "left_out")))
    cmp_markup_element(m, "span", "na", "left out");
  else if (*gallery_text(check, "failure"))
    cmp_markup_element(m, "span", "na", "no value");
  else if (holds)
    cmp_markup_element(m, "span", "holds", expected ? "holds" : "holds, unlike before");
  else
    cmp_markup_element(m, "span", "not", expected ? "does not hold" : "does not hold: changed");
  if (open) cmp_markup_element(m, "span", "na", ", within its scatter");
  cmp_markup_close(m);
}

static void says_cell(struct markup *m, const json_t *check) {
  const char *because = gallery_text(check, "because"), *failure = gallery_text(check, "failure");
  cmp_markup_open(m, "td", "t");
  cmp_markup_text(m, gallery_text(check, "says"));
  cmp_markup_text(m, " ");
  cmp_markup_element(m, "code", NULL, "%s", gallery_text(check, "value"));
  if (*because) cmp_markup_element(m, "span", "because", "Because: %s", because);
  if (*failure) cmp_markup_element(m, "span", "because", "No value: %s", failure);
  cmp_markup_close(m);
}

static void check_row(struct markup *m, const json_t *check) {
  const double measured = number_of(check, "measured"), expected = number_of(check, "expected");
  const double tolerance = number_of(check, "tolerance");
  const int digits = digits_for(expected, tolerance);
  const char *of = gallery_text(check, "of");
  cmp_markup_open(m, "tr", NULL);
  says_cell(m, check);
  number_cell(m, expected, digits);
  allowed_cell(m, check, tolerance);
  measured_cell(m, measured, number_of(check, "scatter"), digits);
  outcome_cell(m, check);
  cmp_markup_element(m, "td", "t", "%s%s%s", of, *of ? ": " : "", gallery_text(check, "source"));
  cmp_markup_close(m);
}

void gallery_checks_write(struct markup *m, const json_t *e) {
  static const char *const head[] = {"check",   "expected", "allowed",
                                     "measured", "verdict",  "whose number, and source", NULL};
  const json_t *checks = json_object_get(e, "checks");
  size_t i;
  json_t *check;
  if (!json_array_size(checks)) return;
  cmp_markup_element(m, "h4", NULL, "Checks");
  cmp_markup_open(m, "div", "checks");
  cmp_markup_table(m, NULL, 1, head);
  json_array_foreach(checks, i, check) check_row(m, check);
  cmp_markup_table_close(m);
  cmp_markup_close(m);
}
