#include "bem/water/inside.h"

#include <math.h>
#include <stdlib.h>

#include "bem/kernel/integrals.h"
#include "common/base/array.h"

void bem_inside_destroy(struct bem_inside *b) {
  free(b->re);
  *b = (struct bem_inside){0};
}

/* d beta/d zeta between walls, and round a bed the velocity itself: both are real on walls. */
enum status bem_inside_begin(struct bem_inside *b, const struct bem_flow *f) {
  const size_t n = f->surface.n;
  if (n > b->room) {
    TRY(array_resize(&b->re, 2 * n, "velocities inside the water"));
    b->room = n;
  }
  b->im = b->re + b->room;
  for (size_t k = 0; k < n; k++) {
    double complex own = f->w[k];
    if (bem_flow_has_part(f)) own -= f->known[k].w;
    if (!bem_surface_is_closed(&f->surface)) own /= f->panels.dzeta[k];
    CHECK(isfinite(cabs(own)), ERR_SOLVER,
          "the surface is on a bend of the walls, x = %g H, y = %g H", f->surface.state[k],
          f->surface.state[n + k]);
    b->re[k] = creal(own);
    b->im[k] = cimag(own);
  }
  return OK;
}

static void sweep_from(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                       size_t node) {
  if (!bem_pressure_is_swept(f)) return;
  b->tau = f->panels.zeta[node];
  b->sweep = p->sweep.nodes[node];
}

void bem_inside_start(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                      size_t node) {
  if (f->surface.walls) b->chart = f->panels.chart[node];
  sweep_from(b, p, f, node);
}

/* The sweep comes from the middle of the surface, on a way that meets no bend. */
bool bem_inside_start_on_wall(struct bem_inside *b, const struct bem_pressure *p,
                              const struct bem_flow *f, double complex z) {
  const struct bem_conformal *m = f->surface.walls;
  sweep_from(b, p, f, f->surface.n / 2);
  return bem_conformal_start(m, bem_conformal_side(m, z), z, &b->chart) == OK;
}

static bool map(struct bem_inside *b, const struct bem_surface *s, double complex z,
                double complex *tau, double complex *slope) {
  *slope = 1;
  if (bem_surface_is_closed(s)) {
    *tau = bem_period_map(&s->period, z);
    return true;
  }
  if (!s->walls) {
    *tau = bem_map(s->length, z - s->left);
    *slope = bem_map_slope(s->length, z - s->left);
    return true;
  }
  if (bem_chart_find(&b->chart, z, tau, slope)) return true;
  return bem_chart_walk(s->walls, &b->chart, z) == OK && bem_chart_find(&b->chart, z, tau, slope);
}

/* What the rate of change of phi has besides where the map of the walls changes. */
static double swept(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                    double complex tau, double complex w) {
  double complex value, slope;
  if (!bem_pressure_is_swept(f)) return 0;
  b->sweep = bem_sweep_on(&f->moving, &p->sweep.rate, &p->sweep.rule.gauss, b->tau, tau, b->sweep);
  b->tau = tau;
  bem_flux_at(&p->sweep.flux, tau, &value, &slope);
  return creal(value - w * b->sweep);
}

bool bem_inside_at(struct bem_inside *b, const struct bem_pressure *p, const struct bem_flow *f,
                   const double *state, double complex z, struct bem_place *out) {
  const struct bem_surface *s = &f->surface;
  const bool has_part = bem_flow_has_part(f);
  const double *real[BEM_VALUES] = {b->re, has_part ? f->phi_own : state + 2 * s->n, p->phi_t},
               *imaginary[BEM_VALUES] = {b->im, has_part ? f->psi_own : f->psi, p->psi_t};
  double complex tau, slope, value[BEM_VALUES];
  if (!map(b, s, z, &tau, &slope)) return false;
  const struct bem_part part = bem_flow_part(f, state, z, tau, slope);
  bem_integrals_values(&f->panels, BEM_VALUES, real, imaginary, tau, value);
  out->w = value[0] * slope + part.w;
  out->phi = creal(value[1] + part.beta);
  double rest = bem_flow_is_driven(f) ? bem_pressure_swept(f, &part, z, out->w) : 0;
  rest += swept(b, p, f, tau, out->w);
  out->pressure = -creal(value[2]) - rest - 0.5 * creal(out->w * conj(out->w)) -
                  bem_flow_head(f, creal(z), cimag(z));
  if (f->motion.rolls) out->w -= conj(bem_motion_carries(&f->motion, z));
  return true;
}
