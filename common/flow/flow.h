/* The water at t = 0, and what theory knows of it later. An initial state is a struct flow in a
 * file of its own and a line in one of the three lists below; whatever else must know of it - the
 * case reader, `plunge list`, the fingerprints, the solvers, the tests - takes it from there.
 *
 * Places are those of the case: m, y upwards. */
#pragma once
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

#include "common/base/geometry.h"
#include "common/base/params.h"
#include "common/base/status.h"

struct case_draft;
struct case_file;
struct flow_line;

struct flow_scale {
  double depth;     /* of the water at rest, m; of a body, its side or radius */
  double mean;      /* depth of the same water spread evenly over the tank, m */
  double amplitude; /* height of the highest crest above the water at rest, m */
  double length;    /* over which the surface rises and falls once, m */
};

/* A force that draws water to a point: the acceleration is -rate^2 (r - r0), and the energy for
 * each mass rate^2 |r - r0|^2/2. A rate of 0: there is none. */
struct flow_pull {
  double x, y, rate; /* m, 1/s */
};

static inline double flow_pull_energy(const struct flow_pull *p, double x, double y) {
  return 0.5 * p->rate * p->rate * ((x - p->x) * (x - p->x) + (y - p->y) * (y - p->y));
}

/* Of an area of water, m^2, at rest in it, over density, m^4 s^-2: of a disc. */
static inline double flow_pull_rest(struct flow_pull p, double area) {
  return p.rate * p.rate * area * area / (4 * M_PI);
}

struct flow_point {
  double x, y; /* m */
  double rest; /* m, what y would be in water at rest: a wave stretches its columns */
};

struct flow_use {
  int order;      /* of the theory, as a run of `exact` asks; 0: nothing but t = 0 is wanted */
  double spacing; /* of the particles, m; 0: neither `head` nor `start` is wanted */
  double sound; /* speed of it where the water is compressible, m/s; 0: nothing of that is wanted */
  bool even;    /* compressible water weighs, in its momentum equation, as if it were not */
};

/* How a particle of compressible water starts, in place of `flow_velocity` and `flow_head`. */
struct flow_start {
  double x, y, u, v; /* m, m/s */
  double head;       /* p/(rho g), m */
  double rest;       /* the same where it rests: its mass is the density there times its cell */
};

/* The water of a checked case, to be evaluated. */
struct flow_water {
  const struct case_file *c;
  struct flow_use use;
  void *own; /* the flow's, from its create */
};

struct flow {
  /* Rows of the section `water.wave` or `water.body` into a struct of its own, which case_file.form
   * holds. */
  const struct param *params;
  size_t n_params, params_size;
  const char *example; /* the section `water` of a case whose tank is 4 m long and 2 m high */
  /* Whether it makes sense, alone and, if case_file.rectangular, in the tank: case_flow_problem. */
  void (*check)(const struct case_file *c, struct case_draft *d);

  /* Of a form that a file of its own describes, or NULL: reads it into case_file.form, adding
   * problems (not of a case that is read from a result file: then the water is level); releases
   * what was read; and writes that for fingerprints, which have no paths. */
  enum status (*read)(struct case_draft *d, int node);
  void (*release)(void *form);
  void (*write)(FILE *out, const void *form);

  /* What the functions below need besides, into w->own; both or neither. After a create that failed
   * destroy is called, too. */
  enum status (*create)(struct flow_water *w);
  void (*destroy)(struct flow_water *w);
  /* What create takes of one processor for points `spacing` (m) apart, s; NULL: next to nothing. */
  double (*seconds)(const struct case_file *c, double spacing);

  /* Of waves, which fill a tank from wall to wall below a surface that is a function of x, and of
   * bodies `scale`, which needs nothing but form and walls. Regions have neither: their outline is
   * the case's. */
  struct flow_scale (*scale)(const struct case_file *c);
  double (*elevation)(const struct flow_water *w, double x, double t); /* y, m */
  double (*bed)(const struct case_file *c); /* y below the depth, m; NULL: the walls' lowest */
  /* Of waves whose surface may hang over: as a line, or NULL where there is none (line.h); the
   * elevation is its highest point then, and the flow below it is known where `use` has a spacing.
   */
  const struct flow_line *(*line)(const struct case_file *c);

  /* Of bodies, which float without gravity in the middle of a rectangular tank and touch no wall:
   * one closed piece at t = 0; where theory follows them, their rim, clockwise from part = 0 to 1;
   * what holds them together, or NULL. */
  enum status (*outline)(const struct case_file *c, struct geo_lines *water);
  void (*rim)(const struct flow_water *w, double part, double t, double p[2]);
  struct flow_pull (*pull)(const struct case_file *c);

  /* In the water, on its surface, and in its analytic continuation above, m^2/s and m/s: velocity
   * is the potential's gradient. Of the flow as incompressible water has it from t = 0 on; regions
   * have no potential, nor have bodies that turn. */
  bool at_rest; /* at t = 0, when neither is asked */
  bool round;   /* they go round a tank with periodic sides; there are none between walls */
  bool sounds;  /* only in compressible water: all of them want use.sound */
  /* Of a case, or NULL: whether the potential is known on the surface alone, and the velocity
   * nowhere. */
  bool (*on_surface_alone)(const struct case_file *c);
  double (*potential)(const struct flow_water *w, double x, double y, double t);
  void (*velocity)(const struct flow_water *w, double x, double y, double t, double velocity[2]);

  /* What compressible water starts with: p/(rho g), m, with the g of the scales. NULL: the depth
   * below the elevation. */
  enum status (*head)(const struct flow_water *w, const struct flow_point *p, double *head);

  /* Of a small wave that moves particles of a lattice from where they rest, (X, Y), with the mass
   * that they have there; or NULL. */
  void (*start)(const struct flow_water *w, double X, double Y, struct flow_start *start);

  /* How it goes on, for the solver `exact`, and then the functions above hold at any t; or NULL.
   * Pressure is over density, and zero above the water. Energies are of the water in the tank, over
   * density, m^4 s^-2, potential energy from y = 0 or in the pull. `error` is what the theory
   * leaves out up to t = end, relative to the wave. */
  double (*pressure)(const struct flow_water *w, double x, double y, double t);
  double (*kinetic)(const struct flow_water *w, double t);
  double (*potential_energy)(const struct flow_water *w, double t);
  double (*error)(const struct flow_water *w, double end);
};

/* X(name, help). Fingerprints hold places in these lists: new ones go to the end. What a case may
 * say for water.pressure of regions, for water.wave.kind, and for water.body.kind. */
#define FLOWS_OF_REGIONS(X)                                                                        \
  X(hydrostatic, "that of the surface above each point")                                           \
  X(released,                                                                                      \
    "that just after the gate before the water has gone: zero on every face without a wall")
#define FLOWS_OF_WAVES(X)                                                                          \
  X(standing, "at rest at its highest: a crest at the left wall, half waves from wall to wall")    \
  X(airy, "a small wave that runs to the right, round a tank with periodic sides")                 \
  X(acoustic, "sound between surface and bed that runs to the right, round the same")              \
  X(pressed, "water at rest under a pressure that varies along the surface, round the same")       \
  X(still, "water at rest, in a tank of any one wall")                                             \
  X(solitary, "the exact solitary wave, one crest over a flat bed that runs to a side")            \
  X(stream, "exact steady waves of any height that run to the right, round the same")              \
  X(stokes, "a wave of second order that runs to the right, round the same")                       \
  X(hump, "a hump or a hollow of Gaussian shape, at rest")                                         \
  X(bore, "a smooth step between two levels that runs to a side of a flat tank")                   \
  X(file, "a surface from a file, at rest or with the potential on it")                            \
  X(curve, "a surface from a file that may hang over, at rest or with the potential on it")
#define FLOWS_OF_BODIES(X)                                                                         \
  X(patch, "a square that turns like a rigid body: u = rate y, v = -rate x from its middle")       \
  X(drop,                                                                                          \
    "a disc that is drawn out, u = strain x, v = -strain y, in a pull -pull^2 r to its middle")

#define X(name, help) extern const struct flow flow_##name;
FLOWS_OF_REGIONS(X)
FLOWS_OF_WAVES(X)
FLOWS_OF_BODIES(X)
#undef X

/* Rows of a struct: a length of the key's name, m, and which way a wave runs. */
#define FLOW_LENGTH(struct_, member, least, text)                                                  \
  {                                                                                                \
    .key = #member, .type = PARAM_REAL, .quantity = QTY_LENGTH,                                    \
    .offset = offsetof(struct_, member), .min = least, .max = 1e6, .help = text                    \
  }
#define FLOW_DIRECTION(struct_, member)                                                            \
  {                                                                                                \
    .key = #member, .type = PARAM_CHOICE, .offset = offsetof(struct_, member),                     \
    .choices = flow_direction_names, .value = "right", .help = "where it runs",                    \
    .helps = flow_direction_helps                                                                  \
  }
extern const char *const flow_direction_names[], *const flow_direction_helps[];

struct flow_list {
  size_t n;
  const struct flow *const *flow; /* [n] */
};
extern const struct flow_list flow_regions, flow_waves, flow_bodies;
/* Names and helps in the order of the lists, NULL at the end. */
extern const char *const flow_region_names[], *const flow_region_helps[];
extern const char *const flow_wave_names[], *const flow_wave_helps[];
extern const char *const flow_body_names[], *const flow_body_helps[];

const char *flow_name(const struct flow *f);
size_t flow_place(const struct flow *f); /* in its list */
bool flow_is_wave(const struct flow *f);
bool flow_is_body(const struct flow *f);
bool flow_has_theory(const struct flow *f);

/* What was opened is closed in any case. */
enum status flow_open(const struct case_file *c, struct flow_use use, struct flow_water *w);
void flow_close(struct flow_water *w);

/* The surface of a wave that may hang over, or NULL. */
const struct flow_line *flow_line_of(const struct case_file *c);

/* y of the surface of a wave's water at rest, m. */
double flow_level(const struct case_file *c);

/* The flow's functions, or what stands for those that it has not. */
double flow_elevation(const struct flow_water *w, double x, double t);
double flow_potential(const struct flow_water *w, double x, double y, double t);
void flow_velocity(const struct flow_water *w, double x, double y, double t, double velocity[2]);
enum status flow_head(const struct flow_water *w, const struct flow_point *p, double *head);

/* Draws the water under the elevation of a wave, or a body: one closed piece. ERR_MEMORY. */
enum status flow_outline(const struct case_file *c, struct geo_lines *water);
