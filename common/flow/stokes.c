/* Stokes' waves of second order that run to the right round a tank with periodic sides, with a
 * crest at its left side: with theta = k x - omega t, T = tanh kd, omega^2 = g k T and Y from the
 * bed,
 *     eta = a cos theta + k a^2 (3 - T^2)/(4 T^3) cos 2 theta,
 *     phi = a omega/k cosh kY/sinh kd sin theta + 3 a^2 omega/8 cosh 2kY/sinh^4 kd sin 2 theta.
 * The mean velocity at any level below the troughs is 0. */
#include <math.h>
#include <stdlib.h>

#include "common/flow/round.h"

struct form {
  double amplitude, wavelength, depth; /* m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, amplitude, PARAM_ABOVE_0, "half of its height from trough to crest"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "mean depth"),
};

struct wave {
  double k, omega, top; /* rad/m, rad/s; y of the mean level, m */
  double second;        /* m: amplitude of cos 2 theta */
};

static struct wave wave_of(const struct case_file *c) {
  const struct form *f = c->form;
  const double k = 2 * M_PI / f->wavelength, T = tanh(k * f->depth);
  return (struct wave){k, sqrt(c->gravity * k * T), c->tank.min[1] + f->depth,
                       k * f->amplitude * f->amplitude * (3 - T * T) / (4 * T * T * T)};
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, f->depth, f->amplitude + wave_of(c).second, f->wavelength};
}

/* Beyond a second harmonic of a quarter of the first the troughs have crests of their own. */
static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double part = wave_of(c).second / f->amplitude;
  char found[96], allowed[128];
  wave_round_check(c, d, f->wavelength);
  if (part <= 0.25) return;
  snprintf(found, sizeof found, "an amplitude of %.6g m", f->amplitude);
  snprintf(allowed, sizeof allowed,
           "up to %.4g m, where the second harmonic is a quarter of the first",
           f->amplitude * 0.25 / part);
  case_flow_problem(d, "amplitude", found, allowed, "take a stream wave, which is exact");
}

/* ---- the wave, at any time ---- */

static enum status create(struct flow_water *w) {
  struct wave *wave = w->own = malloc(sizeof *wave);
  CHECK(wave, ERR_MEMORY, "no memory for a Stokes wave");
  *wave = wave_of(w->c);
  return OK;
}

static void destroy(struct flow_water *w) {
  free(w->own);
}

static double phase(const struct flow_water *w, double x, double t) {
  const struct wave *wave = w->own;
  return wave->k * (x - w->c->tank.min[0]) - wave->omega * t;
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double theta = phase(w, x, t);
  return wave->top + f->amplitude * cos(theta) + wave->second * cos(2 * theta);
}

/* Of the harmonics 1 and 2: the amplitude of phi at the mean level, m^2/s, times cosh and sinh of n
 * k Y over cosh n k d. */
static void profile(const struct flow_water *w, double y, double ch[2], double sh[2]) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double d = f->depth, Y = y - w->c->tank.min[1], T = tanh(wave->k * d);
  /* cosh 2kd/sinh^4 kd = (1 + T^2)(1 - T^2)/T^4 */
  const double size[2] = {f->amplitude * wave->omega / wave->k / T,
                          3 * f->amplitude * f->amplitude * wave->omega / 8 * (1 + T * T) /
                              (pow(T, 4) * pow(cosh(wave->k * d), 2))};
  for (int i = 0; i < 2; i++) {
    const double q = (i + 1) * wave->k, up = exp(q * (Y - d)), down = exp(-q * (Y + d));
    const double part = size[i] / (1 + exp(-2 * q * d));
    ch[i] = (up + down) * part;
    sh[i] = (up - down) * part;
  }
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  const double theta = phase(w, x, t);
  double ch[2], sh[2];
  profile(w, y, ch, sh);
  return ch[0] * sin(theta) + ch[1] * sin(2 * theta);
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct wave *wave = w->own;
  const double theta = phase(w, x, t);
  double ch[2], sh[2];
  profile(w, y, ch, sh);
  out[0] = wave->k * (ch[0] * cos(theta) + 2 * ch[1] * cos(2 * theta));
  out[1] = wave->k * (sh[0] * sin(theta) + 2 * sh[1] * sin(2 * theta));
}

/* Over density, by Bernoulli's equation, without the weight of the water; its constant, g k
 * a^2/(2 sinh 2kd), is what makes the mean over the surface vanish to second order. */
static double push(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  const double theta = phase(w, x, t);
  double ch[2], sh[2], u[2];
  profile(w, y, ch, sh);
  velocity(w, x, y, t, u);
  return wave->omega * (ch[0] * cos(theta) + 2 * ch[1] * cos(2 * theta)) -
         (u[0] * u[0] + u[1] * u[1]) / 2 +
         w->c->gravity * wave->k * pow(f->amplitude, 2) / (2 * sinh(2 * wave->k * f->depth));
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  if (y > elevation(w, x, t)) return 0;
  return push(w, x, y, t) + w->c->gravity * (wave->top - y);
}

/* What theory leaves over on the surface falls off towards the bed. */
static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const double g = w->c->gravity, eta = elevation(w, p->x, 0), bed = w->c->tank.min[1];
  const double over = pressure(w, p->x, eta, 0) / g;
  *out = p->y < eta ? pressure(w, p->x, p->y, 0) / g - over * (p->y - bed) / (eta - bed) : 0;
  return OK;
}

/* For each metre, to the order a^4 of this theory's own products. */
static double kinetic(const struct flow_water *w, double t) {
  enum { POINTS = 64 }; /* of a wave: exact for so few harmonics */
  const struct wave *wave = w->own;
  const double width = w->c->tank.max[0] - w->c->tank.min[0], length = 2 * M_PI / wave->k;
  double sum = 0;
  for (int i = 0; i < POINTS; i++) { /* half of phi times the flux through the surface */
    const double x = w->c->tank.min[0] + length * i / POINTS, theta = phase(w, x, t);
    const struct form *f = w->c->form;
    const double rise =
        wave->omega * (f->amplitude * sin(theta) + 2 * wave->second * sin(2 * theta));
    sum += potential(w, x, elevation(w, x, t), t) * rise / 2;
  }
  return sum / POINTS * width;
}

static double potential_energy(const struct flow_water *w, double t) {
  (void)t;
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  const double bed = w->c->tank.min[1], width = w->c->tank.max[0] - w->c->tank.min[0];
  return w->c->gravity * width / 2 *
         (wave->top * wave->top - bed * bed +
          (f->amplitude * f->amplitude + wave->second * wave->second) / 2);
}

/* The next term of a series that falls like the second harmonic, and the third order of the speed
 * in deep water. */
static double error(const struct flow_water *w, double end) {
  (void)end;
  const struct wave *wave = w->own;
  const struct form *f = w->c->form;
  return pow(wave->second / f->amplitude, 2) + pow(wave->k * f->amplitude, 2) / 2;
}

const struct flow flow_stokes = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: stokes, amplitude: 0.03, wavelength: 4, depth: 0.8}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .round = true,
    .elevation = elevation,
    .potential = potential,
    .velocity = velocity,
    .head = head,
    .pressure = pressure,
    .kinetic = kinetic,
    .potential_energy = potential_energy,
    .error = error,
};
