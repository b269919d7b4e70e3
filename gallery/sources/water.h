/* Particles of the outputs of a run, without dimensions: a field of those that a curve is of,
 * output by output. */
#pragma once
#include "common/result/result.h"
#include "gallery/desk.h"
#include "gallery/source.h"

/* X(name, what a file stores of it, whether that is a vector, whether it has either sign, head of a
 * column, label of an axis); of places nothing else is stored. */
#define WATER_FIELDS(X)                                                                            \
  X(x, NULL, false, false, "x [H]", "x / H")                                                       \
  X(y, NULL, false, false, "y [H]", "y / H")                                                       \
  X(u, "velocity", true, true, "u [sqrt(g H)]", "u / √(g H)")                                      \
  X(v, "velocity", true, true, "v [sqrt(g H)]", "v / √(g H)")                                      \
  X(speed, "velocity", true, false, "speed [sqrt(g H)]", "|u| / √(g H)")                           \
  X(pressure, "pressure", false, false, "pressure [rho g H]", "p / (ρ g H)")                       \
  X(dynamic, "pressure", false, true, "dynamic [rho g H]", "p_d / (ρ g H)")                        \
  X(excess, "pressure", false, true, "excess [rho g H]", "p / (ρ g H) + y / H - level")            \
  X(density, "density", false, false, "density [rho0]", "ρ / ρ_0")                                 \
  X(mass, "mass", false, false, "mass [rho0 H^2]", "m / (ρ_0 H^2)")                                \
  X(volume, "volume", false, false, "volume [H^2]", "V / H^2")                                     \
  X(a_x, "acceleration", true, true, "a_x [g]", "a_x / g")                                         \
  X(a_y, "acceleration", true, true, "a_y [g]", "a_y / g")                                         \
  X(acceleration, "acceleration", true, false, "acceleration [g]", "|a| / g")
enum water_field {
#define X(name, ...) WATER_##name,
  WATER_FIELDS(X)
#undef X
      WATER_FIRST_STORED = WATER_u
};
extern const char *const gallery_water_field_names[];

struct water_field_about {
  const char *stored;
  bool vector, sign;
  const char *head, *label;
};
extern const struct water_field_about gallery_water_fields[];

/* A field of particle i, in H, g and rho, from what is stored of it (value[0]) and, where that does
 * not do, from its place. `level`: as the row below. */
double gallery_water_value(enum water_field field, const struct result_file *f, double level,
                           const struct result_water *r, size_t i);

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
