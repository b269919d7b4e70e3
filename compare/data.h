/* A result file as the comparator uses it: without dimensions. Lengths in H, times in sqrt(H/g),
 * pressures in rho g H, energies in E0: the initial mechanical energy of the reference relative to
 * its own water at rest, or rho g H^3 where it starts at rest. Dimensionless times are written t*
 * in what users read. */
#pragma once
#include "common/result/result.h"
#include "compare/jet.h"
#include "compare/series.h"

struct cmp_scales {
  double H, T, p; /* m, s, Pa */
  double E;       /* J/m: energies are value/E, potential ones less the run's own rest potential */
  double rest;    /* J/m: the rest potential of the reference */
  bool at_rest;   /* the reference starts at rest in equilibrium: E is rho g H^3 */
};

/* ERR_INPUT when the file lacks what scales need. */
enum status cmp_scales_set(const struct result_file *reference, struct cmp_scales *s);

/* The scales of a run whose water is not the reference's (compared all the same): its own, and E0
 * in proportion. Of the same water they are the reference's. */
struct cmp_scales cmp_scales_of(const struct cmp_scales *reference, const struct result_file *run);

/* The wall that a front runs to: the bed before it is dry at first. */
enum cmp_side { CMP_LEFT, CMP_RIGHT, CMP_NO_SIDE };

/* What a unit of the files becomes. */
struct cmp_unit {
  const char *si;           /* in the file */
  const char *name, *label; /* in tables, "rho g H", and on axes, "ρ g H"; "1" of a pure number */
  double size;              /* in SI */
};

struct cmp_series {
  const char *name;  /* borrowed from the file */
  double x, y, size; /* size: of the sensor that it is the mean over, along the wall */
  double average;    /* time that `value` is the running mean over; 0: none */
  size_t n;
  double *t, *value; /* owned */
  const char *units; /* "rho g H"; NULL where nobody asks */
  const char *label; /* the same on an axis */
  double *raw;       /* what `value` is the mean of; NULL without an average; owned */
  double *error;     /* standard errors of `value`, NaN where not known; NULL: none; owned */
};

enum { CMP_LABEL = 60 }; /* bytes of a run's name in labels */

struct cmp_data {
  const struct result_file *file; /* borrowed */
  char label[96]; /* of 60 bytes at most and a number, unique among what is compared */
  double dx;
  bool floats; /* the water is a body without gravity, which overhangs from the first on: no jets */

  size_t n;                  /* outputs with a surface */
  double *t;                 /* [n] */
  struct geo_lines *surface; /* [n] */
  struct geo_lines walls;

  /* Each on the energy series' own times. mechanical = kinetic + potential + removed, relative to
   * rest; closure = sum of the budget minus its first value; removed: with water that was taken
   * out. */
  struct cmp_series kinetic, potential, mechanical, internal, closure, removed;
  size_t n_terms;
  struct cmp_series *terms; /* what has left by each of the solver's own terms, [n_terms] */
  struct cmp_series volume; /* with what was removed added back, in H^2 */

  size_t n_probes, n_gauges, n_experiments;
  struct cmp_series *probes, *gauges;
  size_t n_points, n_diagnostics;
  struct cmp_series *points; /* one for each field of each, "NAME.a_y"; names owned */
  struct cmp_series *diagnostics;
  struct cmp_series *experiments; /* name: the label; see file->experiments for the rest */

  struct cmp_series fronts[2]; /* the ends of the standing water, by side */
  struct cmp_series front;     /* the one of cmp_data_face (borrowed from it); n = 0: none */
  struct cmp_jet *jet;         /* [n] */
  struct cmp_instant impact, overturning, touchdown;
};

/* A jet overhangs by more than this many times the depth at which fronts are taken. */
#define CMP_JET_LEAST 1.5

/* `walls` (m): the file's own, or those that it is taken to have. `depth` (in H): the front is
 * where the depth falls to it, and films on walls are thinner. `window` (in H): where jets are
 * looked for. */
enum status cmp_data_create(const struct result_file *file, const struct geo_lines *walls,
                            const struct cmp_scales *s, double depth, const struct geo_box *window,
                            struct cmp_data *d);
void cmp_data_destroy(struct cmp_data *d);

/* To which wall the water runs: where the bed is dry at first to more than `depth`. When it is on
 * both sides, to the one where the front moves furthest before it arrives. */
enum cmp_side cmp_data_side(const struct cmp_data *d, double depth);

/* Takes the front and the impact on this side. */
void cmp_data_face(struct cmp_data *d, const struct cmp_scales *s, enum cmp_side side);

/* Forgets what is compared with other runs after t = `until`; budget and volume stay. */
void cmp_data_cut(struct cmp_data *d, double until);

/* Puts the running mean over `over` in the place of a probe's signal and of its experiments'. */
enum status cmp_data_average(struct cmp_data *d, const char *probe, double over);

static inline struct cmp_signal cmp_series_signal(const struct cmp_series *s) {
  return (struct cmp_signal){s->n, s->t, s->value};
}

/* Of what an average has replaced, if any. */
static inline struct cmp_signal cmp_series_raw(const struct cmp_series *s) {
  return (struct cmp_signal){s->n, s->t, s->raw ? s->raw : s->value};
}

/* A probe, a gauge, or a field of a point; NULL when there is none. */
const struct cmp_series *cmp_data_series(const struct cmp_data *d, const char *name);

/* One of the energies at t: where its last row precedes t by up to a sampling interval and a step,
 * that row. */
struct cmp_value cmp_data_energy(const struct cmp_data *d, const struct cmp_series *s, double t);

/* The output nearest to t; SIZE_MAX when none is within `slack`. */
size_t cmp_data_output(const struct cmp_data *d, double t, double slack);
double cmp_data_interval(const struct cmp_data *d); /* median time between outputs */
const struct cmp_series *cmp_series_find(const struct cmp_series *s, size_t n, const char *name);
