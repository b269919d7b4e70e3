/* Everything that is measured between runs and the reference; all dimensionless (compare/data.h).
 */
#pragma once
#include "common/case/case.h"
#include "common/result/health.h"
#include "compare/data.h"
#include "compare/filters.h"
#include "compare/measures/list.h"
#include "compare/spectrum.h"

/* A pressure of this many rho g H marks the arrival of the water at a probe, an elevation of this
 * many H its arrival at a gauge. */
#define CMP_ONSET       0.05
#define CMP_SHIFT_REACH 0.5 /* sqrt(H/g): largest time shift tried */

struct cmp_at {              /* one run and the reference at one comparison time */
  size_t output, ref_output; /* SIZE_MAX: none */
  double t, ref_t;           /* of those outputs */
  struct cmp_value hausdorff, frechet, mean, largest, area;
  double where[2];   /* of the largest distance */
  double noise_area; /* noise floor of the area */
};

struct cmp_evolution { /* at every output of the run at which the reference has one too */
  size_t n;
  double *t;                     /* [n] */
  double *value[CMP_N_MEASURES]; /* [n]; NaN: not available; NULL: a measure not taken ALWAYS */
};

struct cmp_pair { /* a signal of a run against the same of the reference or of an experiment */
  const struct cmp_series *a, *b;
  size_t experiment; /* index in the reference's experiments; SIZE_MAX: b is the reference's */
  enum cmp_quantity { CMP_PRESSURE, CMP_ELEVATION, CMP_FRONT } quantity;
  struct cmp_signal_pair m;
};

struct cmp_run {
  struct cmp_data data;
  struct health health;
  bool foreign;      /* of another tank, water or scale than the reference */
  struct cmp_at *at; /* [comparison.n_times] */
  struct cmp_evolution evolution;
  double noise;               /* of lengths, H: half a particle spacing */
  struct cmp_value off;       /* largest mean distance, as a part of comparison.motion */
  struct cmp_value agreement; /* t* until which the mean distance stays within one dx */
  double blind[2]; /* t*: the longest stretch of outputs until then without a distance; NaN: none */
  double unseen[2];                         /* the same of the whole run */
  struct cmp_value closure, closure_before; /* of the energy budget: whole run, until impact */
  struct cmp_value volume;                  /* largest change, relative */
  size_t n_pairs;
  struct cmp_pair *pairs;
  struct cmp_filtered *filtered; /* by the settings, [settings->compare.n_filters] */
  struct cmp_spectrum *spectrum; /* [settings->compare.n_spectra] */
  size_t rank; /* among the runs, from 0: the one that agrees longest (compare/pick.h) */
};

struct comparison {
  const struct case_file *settings;
  struct cmp_scales scales;
  const struct geo_lines *tank; /* m; of files that have no walls; borrowed */
  struct geo_box window;        /* finite */
  bool window_whole;            /* the window leaves nothing out */
  double depth;                 /* at which fronts are taken; films on walls are thinner */
  struct cmp_run ref;           /* at, evolution unused; pairs: against experiments */
  double until; /* t* at which the reference fails: nothing is compared beyond; INFINITY */
  struct cmp_value motion; /* the largest mean distance of its surface from its first */
  enum cmp_side side;      /* to which its front runs */
  size_t n_runs;
  struct cmp_run *run;
  size_t n_times;
  double *times; /* t*, ascending */
};

/* The settings of a case (NULL: with walls at rest), but for what is to be compared: nothing but
 * outputs at `times` (s, [n], borrowed), within the window (NULL: all). */
struct case_file cmp_settings_at(const struct case_file *settings, const struct geo_box *window,
                                 double *times, size_t n);
/* `anyway`: also what is of another tank, water or scale; each is then measured by its own scales.
 */
enum status cmp_comparison_create(const struct case_file *settings, const struct result_file *ref,
                                  size_t n, struct result_file *const *runs, bool anyway,
                                  struct comparison **out);
/* The same without measuring anything: outputs are chosen, and can be drawn. */
enum status cmp_comparison_open(const struct case_file *settings, const struct result_file *ref,
                                size_t n, struct result_file *const *runs, bool anyway,
                                struct comparison **out);
void cmp_comparison_destroy(struct comparison *c);

/* Whether any run has an output at the comparison time. */
bool cmp_comparison_has_output(const struct comparison *c, size_t time);

/* From when on medians of noise are taken: the wall impact of the reference, or its first instant.
 */
double cmp_comparison_settled(const struct comparison *c);

/* Whether a front runs to a wall in the reference. */
bool cmp_comparison_has_front(const struct comparison *c);
