/* The water at t = 0. An initial state is a struct flow in a file of its own and a line in one of
 * the two lists below; whatever else must know of it - the case reader, `plunge list`, the
 * fingerprints, the solvers, the tests - takes it from there.
 *
 * Places are those of the case: m, y upwards. Functions read the case after it was checked, but for
 * `check` and `scale`. */
#pragma once
#include <stdbool.h>
#include <stddef.h>

#include "common/base/geometry.h"
#include "common/base/params.h"
#include "common/base/status.h"

struct case_draft;
struct case_file;

struct flow_scale {
  double depth;     /* of the water at rest, m */
  double mean;      /* depth of the same water spread evenly over the tank, m */
  double amplitude; /* height of the highest crest above the water at rest, m */
  double length;    /* over which the surface rises and falls once, m */
};

struct flow_point {
  double x, y; /* m */
  double
      rest; /* y of the same water when the column that it is in is not stretched by the wave, m */
};

/* How a flow goes on, where theory knows: what the solver `exact` evaluates. t in s. */
struct flow_theory {
  /* `order` is what the run asks for, 1 or 2. To be freed with free; NULL: no memory. */
  void *(*create)(const struct case_file *c, int order);
  double (*elevation)(const void *theory, double x, double t); /* y, m */
  /* In the water, and in its analytic continuation above it: m^2/s, m/s. */
  double (*potential)(const void *theory, double x, double y, double t);
  void (*velocity)(const void *theory, double x, double y, double t, double velocity[2]);
  double (*pressure)(const void *theory, double x, double y, double t); /* over density; 0 above */
  /* Of the water in the tank, over density, m^4 s^-2; the latter from y = 0. */
  double (*kinetic)(const void *theory, double t);
  double (*potential_energy)(const void *theory, double t);
  double (*error)(const void *theory, double end); /* what it leaves out up to t = end, relative */
};

struct flow {
  /* Rows of the section `water.wave` into a struct of the flow's own, which case_file.form holds.
   */
  const struct param *params;
  size_t n_params, params_size;
  const char *example; /* the section `water` of a case whose tank is 4 m long and 2 m high */
  /* Whether it makes sense, alone and, if case_file.rectangular, in the tank: case_flow_problem. */
  void (*check)(const struct case_file *c, struct case_draft *d);

  /* Of waves, which fill a rectangular tank from wall to wall below a surface that is a function of
   * x. Regions have neither: their outline is the case's. `scale` needs nothing but form and box of
   * the tank. */
  struct flow_scale (*scale)(const struct case_file *c);
  double (*elevation)(const struct case_file *c, double x); /* y, m */

  /* Inside the water and on its surface, m^2/s and m/s; velocity is the potential's gradient. NULL:
   * at rest. Of the flow as incompressible water has it from t = 0 on; regions have no potential.
   */
  double (*potential)(const struct case_file *c, double x, double y);
  void (*velocity)(const struct case_file *c, double x, double y, double velocity[2]);

  /* What compressible water starts with: p/(rho g), m. NULL: the depth below the elevation.
   * `prepare` makes what `head` needs besides the case, for particles of that spacing (m), and
   * `finish` (of NULL, too) ends it; both or neither. */
  enum status (*prepare)(const struct case_file *c, double spacing, void **prepared);
  enum status (*head)(const struct case_file *c, void *prepared, const struct flow_point *p,
                      double *head);
  void (*finish)(void *prepared);

  const struct flow_theory *theory; /* NULL: none */
};

/* X(name, help). Fingerprints hold places in these lists: new ones go to the end. What a case may
 * say for water.pressure of regions, and for water.wave.kind. */
#define FLOWS_OF_REGIONS(X)                                                                        \
  X(hydrostatic, "that of the surface above each point")                                           \
  X(released,                                                                                      \
    "that just after the gate before the water has gone: zero on every face without a wall")
#define FLOWS_OF_WAVES(X)                                                                          \
  X(standing, "at rest at its highest: a crest at the left wall, half waves from wall to wall")

#define X(name, help) extern const struct flow flow_##name;
FLOWS_OF_REGIONS(X)
FLOWS_OF_WAVES(X)
#undef X

struct flow_list {
  size_t n;
  const struct flow *const *flow; /* [n] */
};
extern const struct flow_list flow_regions, flow_waves;
/* Names and helps in the order of the lists, NULL at the end. */
extern const char *const flow_region_names[], *const flow_region_helps[];
extern const char *const flow_wave_names[], *const flow_wave_helps[];

const char *flow_name(const struct flow *f);
size_t flow_place(const struct flow *f); /* in its list */
bool flow_is_wave(const struct flow *f);

/* The flow's functions, or what stands for those that it has not. */
double flow_potential(const struct case_file *c, double x, double y);
void flow_velocity(const struct case_file *c, double x, double y, double velocity[2]);
enum status flow_head(const struct case_file *c, void *prepared, const struct flow_point *p,
                      double *head);

/* Draws the water under the elevation of a wave: one closed piece. ERR_MEMORY. */
enum status flow_outline(const struct case_file *c, struct geo_lines *water);
