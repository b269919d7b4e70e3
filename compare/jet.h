/* The plunging jet of the main breaker, read off a free surface. */
#pragma once
#include <stdbool.h>

#include "common/base/geometry.h"
#include "compare/value.h"

/* Thickness is taken where circles of these radii (in H) about the tip cut the jet's two sides. */
#define CMP_JET_STATIONS 3
extern const double cmp_jet_station[CMP_JET_STATIONS];

struct cmp_jet {
  bool found;      /* the main surface overhangs by more than asked */
  bool forward;    /* it plunges towards +x */
  double overhang; /* horizontal, from the tip's vertical tangent to the cavity's */
  double tip[2];   /* the point furthest along the jet */
  double root[2];  /* the cavity's vertical tangent */
  double foot[2];  /* of the vertical dropped from the tip onto the surface, m; NaN: none */
  double gap;      /* from the tip to the nearest point of the surface below the cavity */
  struct cmp_value direction;                   /* degrees, counter-clockwise from +x */
  struct cmp_value thickness[CMP_JET_STATIONS]; /* m */
  struct cmp_value cavity; /* air between the jet, the surface below and the vertical at the tip */
};

/* Where jets are looked for. */
struct cmp_jet_place {
  const struct geo_lines *walls;
  struct geo_box window;
  double H;     /* scale of the stations */
  double least; /* the overhang that noise may have: about three particle spacings */
  double film;  /* the thickness of films on walls, whose folds are not jets */
};

/* The jet with the largest overhang inside the window. All lengths alike in m, or in H with H = 1.
 */
void cmp_jet_find(const struct geo_lines *surface, const struct cmp_jet_place *place,
                  struct cmp_jet *jet);

/* The instants seen in a sequence of jets, [n] at times t in sqrt(H/g), lengths in H. Between
 * outputs the overhang is taken to grow as (t - t0)^(3/2), as it does at a generic vertical
 * tangent, and the gap below the tip to close linearly. What overhangs at the first output already
 * is no breaker.
 *
 * `error` of one that is found here holds what is not known: the interval between outputs, the time
 * from the estimated instant to the first output that shows it, and how far the instant moves when
 * the surface does by half a particle spacing. A face of water falling back from a wall may stand
 * within a few degrees of the vertical for long; a surface half a spacing off at either end of a
 * section six spacings high then turns at any time of that, so the bar reaches back to when such a
 * section came up. */
struct cmp_instant {
  struct cmp_value time;
  double error; /* of one that a solver located its own standard error, 0: it states none */
  bool located; /* by a solver */
  double at[2]; /* NaN when unknown */
};
struct cmp_jet_sequence {
  size_t n;
  const double *t;                 /* [n] */
  const struct cmp_jet *jet;       /* [n] */
  const struct geo_lines *surface; /* [n]; NULL: only jets are known */
  struct cmp_jet_place place;
  double spacing; /* of the particles */
};
void cmp_jet_overturning(const struct cmp_jet_sequence *s, struct cmp_instant *instant);
void cmp_jet_touchdown(const struct cmp_jet_sequence *s, struct cmp_instant *instant);
