/* Particles of the outputs of a run, without dimensions: a field of those that a curve is of,
 * output by output. */
#pragma once
#include "common/result/result.h"
#include "gallery/desk.h"
#include "gallery/source.h"

#define WATER_FIELDS(X)                                                                            \
  X(x)                                                                                             \
  X(y) X(u) X(v) X(speed) X(pressure) X(dynamic) X(excess) X(density) X(mass) X(volume) X(a_x)     \
      X(a_y) X(acceleration)
enum water_field {
#define X(name) WATER_##name,
  WATER_FIELDS(X)
#undef X
};
extern const char *const gallery_water_field_names[];

/* Which particles, by their places at the first output. */
#define WATER_CHOICES(X) X(all) X(row) X(column) X(nearest)
enum water_choice {
#define X(name) WATER_OF_##name,
  WATER_CHOICES(X)
#undef X
};
extern const char *const gallery_water_choice_names[]; /* all, row, column */

/* Parameters of the sources that are made of particles; each has rows for those that it needs. */
struct water_source {
  char *run;
  double x, y, level, start, to, at, k;
  int field, of, take, less, over, every;
};
#define WATER_FIELD                                                                                \
  SOURCE_CHOICE(water_source, field, gallery_water_field_names, NULL, "a field of the particles"), \
      SOURCE_REAL(water_source, level, -1e9, 1e9, "1",                                             \
                  "height of the water at rest, for dynamic and excess")
#define WATER_PLACE(standard, what)                                                                \
  SOURCE_REAL(water_source, x, -1e9, 1e9, standard, "x at t = 0 of " what),                        \
      SOURCE_REAL(water_source, y, -1e9, 1e9, standard, "y at t = 0 of " what)
#define WATER_TIMES                                                                                \
  SOURCE_REAL(water_source, start, -1e9, 1e9, "0", "first time"),                                  \
      SOURCE_REAL(water_source, to, -1e9, 1e9, "1e9", "last time"),                                \
      SOURCE_INT(water_source, every, 1, 1000000, "1",                                             \
                 "2: every other output, 3: every third ...")

struct gallery_water {
  const struct result_file *file; /* the desk's */
  double T;                       /* sqrt(H/g), s */
  enum water_field field;
  double level;
  size_t n_chosen, *chosen; /* ascending, owned; NULL: all */
  size_t n, *output;        /* those that are asked for, owned */
};

/* The particles `of` a source, and its outputs between its times (`instant`: the one at `at`).
 * ERR_INPUT: there are none; ERR_MEMORY. */
enum status gallery_water_open(struct gallery_desk *desk, const struct water_source *s,
                               enum water_choice of, bool instant, struct gallery_water *w);
void gallery_water_close(struct gallery_water *w);

/* One output: n particles, in the order of the first output. n = 0: particles have been taken out,
 * so that it is not known which are which. */
struct water_state {
  double t;
  size_t n;
  const double (*place)[2]; /* [n]; NULL when not asked for */
  const double *value;      /* of the field, [n] */
};
enum status gallery_water_each(const struct gallery_water *w, bool places,
                               enum status (*take)(void *data, const struct water_state *state),
                               void *data);
