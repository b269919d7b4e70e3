#include "bem/shape/period.h"

#include <math.h>
#include <stdbool.h>

#include "bem/shape/smooth.h"
#include "bem/shape/surface.h"

static double wavenumber(const struct bem_period *p) {
  return 2 * M_PI / p->length;
}

struct bem_period bem_period_create(double length, double level) {
  struct bem_period p = {.length = length, .level = level};
  p.bed = exp(-2 * wavenumber(&p) * level);
  return p;
}

double complex bem_period_map(const struct bem_period *p, double complex z) {
  return cexp(-I * wavenumber(p) * (z - I * p->level));
}

double complex bem_period_slope(const struct bem_period *p, double complex z) {
  return -I * wavenumber(p) * bem_period_map(p, z);
}

double bem_period_current(const struct bem_surface *s, const double *state) {
  const double *phi = state + 2 * s->n;
  return s->period.length > 0 ? (phi[s->n - 1] - phi[0]) / s->period.length : 0;
}

/* Which period a node is in. */
static double cell(const struct bem_surface *s, const double *state, size_t k) {
  return floor(state[k] / s->period.length);
}

/* Where the panel after node k goes through a side: in the tank that it leaves, (out, y), and in
 * the one that it enters, (in, y). */
struct passage {
  double out, in, y;
};

/* Height at this x between nodes k and k + 1. */
static double height_at(const struct bem_surface *s, const double *state, size_t k, double x) {
  const double *at = state + k, *y = at + s->n;
  if (s->smooth)
    return bem_smooth_value(s, state + s->n, BEM_EVEN, bem_smooth_find(s, state, k, x));
  return y[0] + (x - at[0]) / (at[1] - at[0]) * (y[1] - y[0]);
}

static bool passes(const struct bem_surface *s, const double *state, size_t k, struct passage *p) {
  const double length = s->period.length;
  const double from = cell(s, state, k), to = cell(s, state, k + 1), side = length * fmax(from, to);
  if (from == to) return false;
  p->out = side - length * from;
  p->in = side - length * to;
  p->y = height_at(s, state, k, side);
  return true;
}

static enum status add_node(const struct bem_surface *s, const double *state, size_t k,
                            struct geo_lines *out) {
  return geo_lines_add(out, state[k] - s->period.length * cell(s, state, k), state[s->n + k]);
}

static enum status enter(const struct bem_surface *s, const double *state, size_t k,
                         const struct passage *p, struct geo_lines *out) {
  TRY(geo_lines_begin(out, false));
  TRY(geo_lines_add(out, p->in, p->y));
  const bool at_side = state[k + 1] == s->period.length * cell(s, state, k + 1);
  return at_side ? OK : add_node(s, state, k + 1, out);
}

enum status bem_period_cut(const struct bem_surface *s, const double *state,
                           struct geo_lines *out) {
  const size_t panels = s->n - 1;
  struct passage p;
  size_t first = 0;
  while (!passes(s, state, first, &p)) first++; /* a whole period passes one */
  TRY(enter(s, state, first, &p, out));
  for (size_t j = 1; j <= panels; j++) {
    const size_t k = (first + j) % panels;
    if (!passes(s, state, k, &p)) {
      TRY(add_node(s, state, k + 1, out));
      continue;
    }
    TRY(geo_lines_add(out, p.out, p.y));
    if (j < panels) TRY(enter(s, state, k, &p, out));
  }
  return OK;
}
