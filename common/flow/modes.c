#include "common/flow/modes.h"

#include <math.h>

#include "common/base/root.h"

static struct wave_mode mode_in(const struct wave_column *in, bool decays) {
  return (struct wave_mode){
      .in = *in, .decays = decays, .delta = in->gravity / (2 * in->sound * in->sound)};
}

/* (2.39), times its denominator. */
static double decaying(double mu, const void *with) {
  const struct wave_mode *m = with;
  const double k2 = m->in.wavenumber * m->in.wavenumber, d = m->delta, d2 = d * d;
  const double H = m->in.depth, a = mu * H, coth = a > 1e-8 ? a / tanh(a) : 1;
  return coth * (k2 + d2 - mu * mu) - d * H * (k2 - d2 + mu * mu);
}

struct wave_mode wave_mode_gravity(const struct wave_column *in) {
  struct wave_mode m = mode_in(in, true);
  const double k2 = in->wavenumber * in->wavenumber, d2 = m.delta * m.delta;
  m.root = root_between(decaying, &m, 0, sqrt(k2 + d2));
  /* omega^2 = g psi'(0)/psi(0), which loses no digits where c^2 (kappa^2 + delta^2 - mu^2) does */
  m.s = 1;
  m.omega = sqrt(in->gravity * wave_mode_slope(&m, 0));
  return m;
}

/* (2.57), times sin(nu H) over nu H and its denominator. */
static double oscillating(double nu, const void *with) {
  const struct wave_mode *m = with;
  const double k2 = m->in.wavenumber * m->in.wavenumber, d = m->delta, d2 = d * d;
  const double H = m->in.depth, a = nu * H, sinc = a > 1e-8 ? sin(a) / a : 1;
  return cos(a) * (k2 + d2 + nu * nu) - sinc * d * H * (k2 - d2 - nu * nu);
}

struct wave_mode wave_mode_acoustic(const struct wave_column *in, int n) {
  struct wave_mode m = mode_in(in, false);
  const double k2 = in->wavenumber * in->wavenumber, d2 = m.delta * m.delta;
  m.root = root_between(oscillating, &m, n * M_PI / in->depth, (n + 1) * M_PI / in->depth);
  m.omega = in->sound * sqrt(k2 + d2 + m.root * m.root);
  m.s = 2 * m.delta * m.root / (k2 + m.root * m.root - d2);
  return m;
}

/* exp(delta z) (cosh mu z - (delta/mu) sinh mu z), z = y + H, over exp((delta + mu) H)/2, and its
 * derivative: no slope at the bed, and nothing that overflows. */
static void decay(const struct wave_mode *m, double y, double *psi, double *slope) {
  const double H = m->in.depth, z = y + H, mu = m->root, d = m->delta, part = d / mu;
  const double up = exp(mu * (z - H)), down = exp(-mu * (z + H)), grow = exp(d * (z - H));
  *psi = grow * ((1 - part) * up + (1 + part) * down);
  *slope = grow * (mu - d * part) * (up - down);
}

double wave_mode_psi(const struct wave_mode *m, double y) {
  const double nu = m->root;
  double psi, slope, surface;
  if (!m->decays) return exp(m->delta * y) * (sin(nu * y) + m->s * cos(nu * y));
  decay(m, 0, &surface, &slope);
  decay(m, y, &psi, &slope);
  return psi / surface;
}

double wave_mode_slope(const struct wave_mode *m, double y) {
  const double nu = m->root, d = m->delta;
  double psi, slope, surface;
  if (!m->decays)
    return exp(d * y) * ((nu + d * m->s) * cos(nu * y) + (d - nu * m->s) * sin(nu * y));
  decay(m, 0, &surface, &slope);
  decay(m, y, &psi, &slope);
  return slope / surface;
}

/* With C = -i g A/(omega psi(0)). */
struct wave_motion wave_mode_motion(const struct wave_mode *m, double amplitude, double x, double y,
                                    double t) {
  const double kappa = m->in.wavenumber, phase = kappa * x - m->omega * t;
  const double size = m->in.gravity * amplitude / (m->omega * m->s);
  const double psi = size * wave_mode_psi(m, y), slope = size * wave_mode_slope(m, y);
  const double c = cos(phase), s = sin(phase);
  return (struct wave_motion){.u = kappa * psi * c,
                              .v = slope * s,
                              .xi = -kappa * psi / m->omega * s,
                              .zeta = slope / m->omega * c,
                              .potential = psi * s,
                              .push = m->omega * psi * c};
}
