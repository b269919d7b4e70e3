/* Where the curves of entries come from. A source is a file in sources/ with a struct
 * gallery_source and a line in sources/list.h: its parameters, by which entries are read, and its
 * function. */
#pragma once
#include "common/base/params.h"
#include "common/base/status.h"

struct gallery_desk;
struct gallery_reader;

struct gallery_curve { /* y over x; NaN breaks it */
  size_t n, room;
  double *x, *y; /* [n] */
};
enum status gallery_curve_add(struct gallery_curve *c, double x, double y);
void gallery_curve_free(struct gallery_curve *c);

struct gallery_source {
  const char *name, *help; /* one sentence: what y is, what x, and their units */
  /* No row is called `name` or `from`, which a curve has itself. A row of text called `run` or
   * `against` is the name of a run, "CASE/RUN"; one called `curve`, the name of a curve of the
   * entry. */
  const struct param *params;
  size_t n_params, params_size;
  /* Complains, while the entry is read, of parameters that name what is not there: they are keys of
   * the mapping `node`, called `path`, and NULL where they were wrong. NULL: it names nothing. */
  void (*check)(struct gallery_reader *r, int node, const char *path, const void *params);
  /* Adds the points. ERR_INPUT when what it needs is not there. */
  enum status (*evaluate)(struct gallery_desk *desk, const void *params,
                          struct gallery_curve *curve);
};

extern const struct gallery_source *const gallery_sources[];        /* NULL at the end */
const struct gallery_source *gallery_source_find(const char *name); /* NULL: there is none */

/* Rows of a source's table. */
#define SOURCE_TEXT(struct_, member, standard, text)                                               \
  {                                                                                                \
    .key = #member, .type = PARAM_TEXT, .offset = offsetof(struct struct_, member), .max = 1000,   \
    .value = standard, .help = text                                                                \
  }
#define SOURCE_REAL(struct_, member, least, most, standard, text)                                  \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .offset = offsetof(struct struct_, member), .min = least,  \
    .max = most, .value = standard, .help = text                                                   \
  }
#define SOURCE_INT(struct_, member, least, most, standard, text)                                   \
  {                                                                                                \
    .key = #member, .type = PARAM_INT, .offset = offsetof(struct struct_, member), .min = least,   \
    .max = most, .value = standard, .help = text                                                   \
  }
#define SOURCE_CHOICE(struct_, member, names, standard, text)                                      \
  {                                                                                                \
    .key = #member, .type = PARAM_CHOICE, .offset = offsetof(struct struct_, member),              \
    .choices = names, .value = standard, .help = text                                              \
  }
#define SOURCE_RUN(struct_) SOURCE_TEXT(struct_, run, NULL, "a run, CASE/RUN")
#define SOURCE_TABLE        .params = params, .n_params = sizeof params / sizeof *params
