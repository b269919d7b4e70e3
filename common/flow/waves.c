/* Standing waves. With C = cos kx, T = tanh kd, the first order is
 *     eta1 = a cos kx cos wt,   phi1 = -(a g/w) cos kx cosh k(z+d)/cosh kd sin wt,
 * z measured from still water. At second order the free-surface conditions at z = 0 read
 *     eta2_t - phi2_z   = eta1 phi1_zz - eta1_x phi1_x
 *                       = -(a^2 g k^2/2w) sin 2wt cos 2kx
 *     phi2_t + g eta2   = -eta1 phi1_zt - |grad phi1|^2/2
 *                       = (a^2 w^2/8) {[(1 + T^-2) + (3 - T^-2) cos 2wt] cos 2kx
 *                                      + (1 - T^-2) + (3 + T^-2) cos 2wt}
 * and are solved for the modes cos 2kx (bound and free waves) and 1 (no elevation; a pressure that
 * pulsates alike everywhere), with eta2 = phi2 = 0 at t = 0. */
#include "common/flow/waves.h"

#include <math.h>

double wave_frequency_linear(double k, double depth, double gravity) {
  return sqrt(gravity * k * tanh(k * depth));
}

double wave_frequency_shift(double k, double depth) {
  double s = tanh(k * depth); /* the square of their frequency, so what follows is over omega_0 */
  return (9 / (s * s * s * s) - 12 / (s * s) - 3 - 2 * s * s) / 64;
}

struct wave_standing wave_standing_create(double amplitude, double wavelength, double depth,
                                          double gravity, double left, double bed, int order) {
  double a = amplitude, k = 2 * M_PI / wavelength, g = gravity;
  double linear = wave_frequency_linear(k, depth, g);
  struct wave_standing w = {
      .amplitude = a,
      .wavelength = wavelength,
      .depth = depth,
      .gravity = g,
      .left = left,
      .bed = bed,
      .order = order,
      .k = k,
      .omega = linear,
  };
  if (order < 2) return w;
  w.omega *= 1 + k * k * a * a * wave_frequency_shift(k, depth);
  w.free_omega = wave_frequency_linear(2 * k, depth, g);
  double t2 = 1 / pow(tanh(k * depth), 2), q = a * a * linear * linear / 8;
  w.bound_mean = q * (1 + t2) / g;
  /* -2 w A - 2 k tanh(2kd) B = -a^2 g k^2/(2w),  g A + 2 w B = q (3 - T^-2) */
  double kt = k * tanh(2 * k * depth), kinematic = a * a * g * k * k / (4 * linear);
  double dynamic = q * (3 - t2);
  w.bound = (2 * linear * kinematic - kt * dynamic) / (2 * linear * linear - kt * g);
  w.bound_potential = (dynamic - g * w.bound) / (2 * linear);
  return w;
}

void wave_standing_bind(struct wave_standing *w) {
  w->bound_alone = true;
}

/* A mode cos(m k x) of the surface and of phi at still water, and their rates in time. */
struct mode {
  double eta, eta_t, phi, phi_t;
};

static void modes(const struct wave_standing *w, double t, struct mode m[2]) {
  double a = w->amplitude, g = w->gravity, o = w->omega, c = cos(o * t), s = sin(o * t);
  m[0] = (struct mode){a * c, -a * o * s, -a * g / o * s, -a * g * c};
  m[1] = (struct mode){0, 0, 0, 0};
  if (w->order < 2) return;
  double c2 = cos(2 * o * t), s2 = sin(2 * o * t), f = w->free_omega;
  double free = w->bound_alone ? 0 : -(w->bound_mean + w->bound), cf = cos(f * t), sf = sin(f * t);
  m[1].eta = w->bound_mean + w->bound * c2 + free * cf;
  m[1].eta_t = -2 * o * w->bound * s2 - f * free * sf;
  m[1].phi = w->bound_potential * s2 - free * g / f * sf;
  m[1].phi_t = 2 * o * w->bound_potential * c2 - free * g * cf;
}

/* phi of the mode 1, and its rate. */
static void mean_potential(const struct wave_standing *w, double t, double *phi, double *phi_t) {
  *phi = *phi_t = 0;
  if (w->order < 2) return;
  double t2 = 1 / pow(tanh(w->k * w->depth), 2), o = w->omega;
  double q = w->amplitude * w->amplitude * o * o / 8;
  *phi = q * ((1 - t2) * t + (3 + t2) * sin(2 * o * t) / (2 * o));
  *phi_t = q * ((1 - t2) + (3 + t2) * cos(2 * o * t));
}

double wave_standing_elevation(const struct wave_standing *w, double x, double t) {
  struct mode m[2];
  modes(w, t, m);
  double kx = w->k * (x - w->left);
  return w->bed + w->depth + m[0].eta * cos(kx) + m[1].eta * cos(2 * kx);
}

double wave_standing_slope(const struct wave_standing *w, double x, double t) {
  struct mode m[2];
  modes(w, t, m);
  double kx = w->k * (x - w->left);
  return -w->k * (m[0].eta * sin(kx) + 2 * m[1].eta * sin(2 * kx));
}

double wave_standing_rise(const struct wave_standing *w, double x, double t) {
  struct mode m[2];
  modes(w, t, m);
  double kx = w->k * (x - w->left);
  return m[0].eta_t * cos(kx) + m[1].eta_t * cos(2 * kx);
}

/* cosh and sinh of q (y - bed) over cosh(q d), q = k and 2k; in exponentials that do not overflow.
 */
static void profile(const struct wave_standing *w, double y, double ch[2], double sh[2]) {
  for (int i = 0; i < 2; i++) {
    double q = (i + 1) * w->k, d = w->depth, z = y - w->bed;
    double up = exp(q * (z - d)), down = exp(-q * (z + d)), scale = 1 / (1 + exp(-2 * q * d));
    ch[i] = (up + down) * scale;
    sh[i] = (up - down) * scale;
  }
}

double wave_standing_potential(const struct wave_standing *w, double x, double y, double t) {
  struct mode m[2];
  double ch[2], sh[2], mean, rate, kx = w->k * (x - w->left);
  modes(w, t, m);
  profile(w, y, ch, sh);
  mean_potential(w, t, &mean, &rate);
  return m[0].phi * cos(kx) * ch[0] + m[1].phi * cos(2 * kx) * ch[1] + mean;
}

void wave_standing_velocity(const struct wave_standing *w, double x, double y, double t,
                            double velocity[2]) {
  struct mode m[2];
  double ch[2], sh[2], k = w->k, kx = k * (x - w->left);
  modes(w, t, m);
  profile(w, y, ch, sh);
  velocity[0] = -k * (m[0].phi * sin(kx) * ch[0] + 2 * m[1].phi * sin(2 * kx) * ch[1]);
  velocity[1] = k * (m[0].phi * cos(kx) * sh[0] + 2 * m[1].phi * cos(2 * kx) * sh[1]);
}

double wave_standing_pressure(const struct wave_standing *w, double x, double y, double t) {
  if (y > wave_standing_elevation(w, x, t)) return 0;
  struct mode m[2];
  double ch[2], sh[2], u[2], mean, rate, kx = w->k * (x - w->left);
  modes(w, t, m);
  profile(w, y, ch, sh);
  mean_potential(w, t, &mean, &rate);
  rate += m[0].phi_t * cos(kx) * ch[0] + m[1].phi_t * cos(2 * kx) * ch[1];
  double p = -rate - w->gravity * (y - w->bed - w->depth);
  if (w->order < 2) return p;
  wave_standing_velocity(w, x, y, t, u);
  return p - (u[0] * u[0] + u[1] * u[1]) / 2;
}

double wave_standing_kinetic(const struct wave_standing *w, double width, double t) {
  /* half the integral of phi phi_n over the surface; the trapezoidal rule is exact for cosines */
  enum { PER_HALF_WAVE = 32 };
  int n = PER_HALF_WAVE * (int)lround(2 * width / w->wavelength);
  double sum = 0;
  for (int i = 0; i <= n; i++) {
    double x = w->left + width * i / n, y = wave_standing_elevation(w, x, t);
    double flux = wave_standing_potential(w, x, y, t) * wave_standing_rise(w, x, t);
    sum += (i == 0 || i == n ? 0.5 : 1) * flux;
  }
  return sum * width / n / 2;
}

double wave_standing_potential_energy(const struct wave_standing *w, double width, double t) {
  struct mode m[2];
  modes(w, t, m);
  double y = w->bed + w->depth;
  double square = y * y + (m[0].eta * m[0].eta + m[1].eta * m[1].eta) / 2;
  return w->gravity * width / 2 * (square - w->bed * w->bed);
}

/* Elevation of the second order over that of the first, at most, whatever order w has. */
static double ratio_of_orders(const struct wave_standing *w) {
  struct wave_standing second =
      wave_standing_create(w->amplitude, w->wavelength, w->depth, w->gravity, w->left, w->bed, 2);
  double free = second.bound_mean + second.bound; /* cancels them at t = 0 */
  return (fabs(second.bound_mean) + fabs(second.bound) + fabs(free)) / w->amplitude;
}

/* Of half a wavelength, which is like every other; over density. */
static double energy_above_rest(const struct wave_standing *w, double t) {
  double width = w->wavelength / 2;
  struct wave_standing from_bed = *w; /* without the digits that the level of the bed takes */
  from_bed.bed = 0;
  return wave_standing_kinetic(&from_bed, width, t) +
         wave_standing_potential_energy(&from_bed, width, t) -
         w->gravity * width * w->depth * w->depth / 2;
}

double wave_standing_error(const struct wave_standing *w, double end) {
  enum { PER_PERIOD = 32, PERIODS = 64 }; /* in which bound and free waves meet in every phase */
  double step = 2 * M_PI / w->omega / PER_PERIOD, worst = 0;
  double first = energy_above_rest(w, 0);
  for (int i = 1; i <= PER_PERIOD * PERIODS && i * step <= end; i++)
    worst = fmax(worst, fabs(energy_above_rest(w, i * step) / first - 1));
  double ratio = ratio_of_orders(w);
  return fmax(worst, w->order < 2 ? ratio : ratio * ratio);
}
