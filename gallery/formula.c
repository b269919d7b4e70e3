#include "gallery/formula.h"

#include <math.h>
#include <muParserDLL.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "gallery/reduce.h"

enum { MOST_NAMES = 64, MOST_MESSAGE = 600, MOST_SHOWN = 160 };

struct evaluation {
  const struct gallery_scope *scope;
  size_t n_known;
  double known[MOST_NAMES];   /* values of numbers that it has asked for */
  char failure[MOST_MESSAGE]; /* the first; "" */
  double nowhere;
};

static void fail(struct evaluation *e, const char *message) {
  if (!*e->failure) snprintf(e->failure, sizeof e->failure, "%s", message);
}

/* ---- functions of a curve ---- */

static double reduce(struct evaluation *e, const char *name,
                     double (*f)(const struct gallery_curve *, const double *),
                     const double *arguments) {
  const struct gallery_curve *curve;
  if (*e->failure) return NAN;
  if (e->scope->curve && e->scope->curve(e->scope->with, name, &curve)) return f(curve, arguments);
  fail(e, status_message());
  return NAN;
}

#define ARGUMENTS_0
#define ARGUMENTS_1 , double p
#define ARGUMENTS_2 , double p, double q
#define ARGUMENTS_3 , double p, double q, double r
#define VALUES_0 0
#define VALUES_1 p
#define VALUES_2 p, q
#define VALUES_3 p, q, r
#define X(name, n, help)                                                                           \
  static double call_##name(void *with, const char *curve ARGUMENTS_##n) {                         \
    return reduce(with, curve, gallery_reduce_##name, (double[]){VALUES_##n});                     \
  }
GALLERY_REDUCTIONS(X)
#undef X

/* ---- functions of numbers ---- */

/* muParser's own max and min pass over what is not a number, and one that does not exist would look
 * like one that holds. */
static double greatest(const double *v, int n) {
  double most = n > 0 ? v[0] : NAN;
  for (int i = 1; i < n; i++)
    if (isnan(v[i]) || v[i] > most) most = v[i];
  return most;
}

static double smallest(const double *v, int n) {
  double least = n > 0 ? v[0] : NAN;
  for (int i = 1; i < n; i++)
    if (isnan(v[i]) || v[i] < least) least = v[i];
  return least;
}

/* ---- both by their names ---- */

#define DEFINE_0 mupDefineStrFunUserData1
#define DEFINE_1 mupDefineStrFunUserData2
#define DEFINE_2 mupDefineStrFunUserData3
#define DEFINE_3 mupDefineStrFunUserData4

static void define_functions(muParserHandle_t parser, struct evaluation *e) {
#define X(name, n, help) DEFINE_##n(parser, #name, call_##name, e);
  GALLERY_REDUCTIONS(X)
#undef X
  mupDefineMultFun(parser, "max", greatest, 1);
  mupDefineMultFun(parser, "min", smallest, 1);
}

/* ---- numbers ---- */

/* muParser asks for the place of a variable that it does not know. */
static double *place_of(const char *name, void *with) {
  struct evaluation *e = with;
  char message[MOST_MESSAGE];
  double value = NAN;
  if (e->n_known == MOST_NAMES) {
    fail(e, "a formula of too many names");
    return &e->nowhere;
  }
  if (!e->scope->number || !e->scope->number(e->scope->with, name, &value)) {
    snprintf(message, sizeof message, "%s",
             e->scope->number ? status_message() : "a name that nothing here has");
    fail(e, message);
  }
  double *place = &e->known[e->n_known++];
  *place = value;
  return place;
}

/* ---- evaluation ---- */

/* muParser would take one = for an assignment to what stands before it. */
static bool assigns(const char *formula) {
  bool quoted = false;
  for (const char *p = formula; *p; p++) {
    quoted ^= *p == '"';
    if (quoted || *p != '=') continue;
    if (p[1] == '=')
      p++;
    else if (p == formula || !strchr("<>!", p[-1]))
      return true;
  }
  return false;
}

/* Enough of a formula for a message, to the end of a character. */
static int shown(const char *formula) {
  size_t n = strlen(formula);
  if (n <= MOST_SHOWN) return (int)n;
  for (n = MOST_SHOWN; n > 0 && ((unsigned char)formula[n] & 0xc0) == 0x80;) n--;
  return (int)n;
}

/* Errors are asked for after each call; without a handler muParser would print them. */
static void keep_quiet(muParserHandle_t parser) {
  (void)parser;
}

static bool is_well(muParserHandle_t parser, struct evaluation *e) {
  if (!mupError(parser)) return !*e->failure;
  char message[MOST_MESSAGE];
  snprintf(message, sizeof message, "%s", mupGetErrorMsg(parser));
  mupErrorReset(parser);
  fail(e, message);
  return false;
}

enum status gallery_formula_rows(const struct gallery_scope *scope, const char *formula,
                                 size_t n_names, const char *const *names,
                                 const double *const *column, size_t n, double *value) {
  struct evaluation e = {.scope = scope};
  double row[MOST_NAMES];
  CHECK(n_names <= MOST_NAMES, ERR_INPUT, "a formula over %zu columns; allowed: %d", n_names,
        MOST_NAMES);
  muParserHandle_t parser = mupCreate(muBASETYPE_FLOAT);
  CHECK(parser, ERR_MEMORY, "no memory for a formula");
  mupSetErrorHandler(parser, keep_quiet);
  mupDefineConst(parser, "pi", acos(-1.0));
  define_functions(parser, &e);
  for (size_t k = 0; k < n_names; k++) mupDefineVar(parser, names[k], &row[k]);
  mupSetVarFactory(parser, place_of, &e);
  mupSetExpr(parser, formula);
  if (assigns(formula)) fail(&e, "found '='; allowed: == where two numbers are compared");
  for (size_t i = 0; i < n && is_well(parser, &e); i++) {
    int n_values = 1;
    for (size_t k = 0; k < n_names; k++) row[k] = column[k][i];
    const double *values = mupEvalMulti(parser, &n_values);
    const bool one = is_well(parser, &e) && n_values == 1;
    value[i] = one ? values[0] : NAN;
    if (!one) fail(&e, "found several values; allowed: one");
  }
  const bool well = is_well(parser, &e);
  mupRelease(parser);
  CHECK(well, ERR_INPUT, "%s, in the formula %.*s%s", e.failure, shown(formula), formula,
        strlen(formula) > MOST_SHOWN ? "..." : "");
  return OK;
}

enum status gallery_formula(const struct gallery_scope *scope, const char *formula, double *value) {
  return gallery_formula_rows(scope, formula, 0, NULL, NULL, 1, value);
}
