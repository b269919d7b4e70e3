/* Bodies of water that float: their cases, and what is measured of them. */
#pragma once
#include <math.h>

#include "common/flow/flow.h"
#include "sph/fluid/energy.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

#define BODY(half, body)                                                                           \
  "fluid: {gravity: 0}\nscales: {H: 1, g: 1}\ntank: {walls: [[[-" half ", " half "], [-" half      \
  ", -" half "], [" half ", -" half "], [" half ", " half "]]]}\n"                                 \
  "water: {body: {kind: " body "}}\n" POOL_TIMES
#define BODY_PATCH BODY("2", "patch, side: 1, rate: 1")
#define BODY_DROP  BODY("3", "drop, radius: 1, strain: 1, pull: 1")

static inline void body_march(struct sph *s, double t) {
  while (s->t < t) {
    if (sph_treat(s) != OK || sph_rates(s, 0, true, true) != OK) exit(1);
    const double dt = sph_timestep(s, t);
    if (sph_step(s, dt) != OK) exit(1);
    if (t - s->t < 1e-9 * dt) s->t = t;
  }
}

struct body_sums {
  double angular, size; /* sum m (x v - y u), and of the values of its terms, kg m/s */
  double xx, yy;        /* second moments, kg m */
};

static inline struct body_sums body_sums_of(const struct sph *s) {
  const struct sph_state *w = &s->f.w;
  struct body_sums b = {0};
  for (size_t i = 0; i < s->f.n; i++) {
    const double m = s->f.m[i], a = m * w->x[i] * w->v[i], c = m * w->y[i] * w->u[i];
    b.angular += a - c;
    b.size += fabs(a) + fabs(c);
    b.xx += m * w->x[i] * w->x[i];
    b.yy += m * w->y[i] * w->y[i];
  }
  return b;
}

/* The share of particles that have another nearer than half a spacing. */
static inline double body_clumped(const struct sph *s) {
  size_t n = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    bool near = false;
    for (size_t j = 0; j < s->f.n; j++)
      near |= j != i && hypot(s->f.w.x[i] - s->f.w.x[j], s->f.w.y[i] - s->f.w.y[j]) < 0.5 * s->dx;
    n += near;
  }
  return (double)n / (double)s->f.n;
}

/* What kinetic and potential energy have lost, and what the budget is off, over the energy that the
 * body has more than at rest. */
struct body_energy {
  double lost, off;
};

static inline struct body_energy body_energy_since(const struct sph *s,
                                                   const struct result_energy *first) {
  const struct result_energy e = sph_energy(s);
  const double E = first->kinetic + first->potential - sph_rest_potential(s);
  double left = first->total - e.total;
  for (int k = 0; k < SPH_TERM_COUNT; k++) left -= e.term[k];
  return (struct body_energy){(first->kinetic + first->potential - e.kinetic - e.potential) / E,
                              fabs(left) / E};
}

/* The drop's half axes by the second moments, in its radius. */
struct body_axes {
  double a, b;
};

static inline struct body_axes body_axes_since(const struct sph *s, const struct body_sums *first) {
  const struct body_sums now = body_sums_of(s);
  return (struct body_axes){sqrt(now.xx / first->xx), sqrt(now.yy / first->yy)};
}

static inline struct body_axes body_axes_exact(const struct flow_water *w, double t) {
  double a[2], b[2];
  w->c->flow->rim(w, 0.5, t, a);
  w->c->flow->rim(w, 0.25, t, b);
  return (struct body_axes){a[0], b[1]};
}
