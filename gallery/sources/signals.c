/* Curves made of another curve: its spectrum, some of its points, filters, derivative, integral. */
#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "compare/spectrum.h"
#include "gallery/desk.h"
#include "gallery/source.h"

struct signal_source {
  char *curve;
  double start, to, period, over;
};

#define SIGNAL_CURVE SOURCE_TEXT(signal_source, curve, NULL, "a curve of the entry")

/* The curve, whose abscissas ascend. */
static enum status signal_of(struct gallery_desk *desk, const char *name,
                             struct cmp_signal *signal) {
  const struct gallery_curve *c;
  TRY(gallery_desk_curve(desk, name, &c));
  for (size_t i = 1; i < c->n; i++)
    CHECK(c->x[i] > c->x[i - 1], ERR_INPUT, "curve '%s' goes from x = %g to %g; it must ascend",
          name, c->x[i - 1], c->x[i]);
  *signal = (struct cmp_signal){c->n, c->x, c->y};
  return OK;
}

/* ---- spectrum ---- */

static const struct param spectrum_params[] = {
    SIGNAL_CURVE,
    SOURCE_REAL(signal_source, start, -1e9, 1e9, "-1e9", "of the curve from this x on"),
    SOURCE_REAL(signal_source, to, -1e9, 1e9, "1e9", "to this one"),
};

static enum status spectrum(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  const struct signal_source *s = with;
  struct cmp_signal signal = {0};
  struct cmp_spectrum found;
  enum status status = OK;
  TRY(signal_of(desk, s->curve, &signal));
  TRY(cmp_spectrum_create(&signal, s->start, s->to, 1, &found));
  if (!cmp_known(&found.interval))
    status = status_raise(ERR_INPUT, "there is no spectrum of curve '%s': %s", s->curve,
                          found.interval.why);
  for (size_t k = 0; k < found.n && status == OK; k++)
    status = gallery_curve_add(curve, 2 * M_PI * (double)k * found.step, found.amplitude[k]);
  cmp_spectrum_destroy(&found);
  return status;
}

/* ---- fewer points ---- */

static const struct param without_params[] = {
    SIGNAL_CURVE,
    SOURCE_REAL(signal_source, period, PARAM_ABOVE_0, 1e9, NULL,
                "points at its multiples go, but for the one at 0"),
};

#define HAIR 1e-3 /* of the period */

static enum status without(struct gallery_desk *desk, const void *with,
                           struct gallery_curve *curve) {
  const struct signal_source *s = with;
  struct cmp_signal signal = {0};
  TRY(signal_of(desk, s->curve, &signal));
  for (size_t i = 0; i < signal.n; i++) {
    const double multiple = rint(signal.t[i] / s->period);
    if (multiple != 0 && fabs(signal.t[i] / s->period - multiple) < HAIR) continue;
    TRY(gallery_curve_add(curve, signal.t[i], signal.value[i]));
  }
  return OK;
}

/* ---- with the same abscissas ---- */

/* A function of a signal at its rows. */
static enum status transformed(struct gallery_desk *desk, const struct signal_source *s,
                               enum status (*f)(const struct signal_source *s,
                                                const struct cmp_signal *signal, double *out),
                               struct gallery_curve *curve) {
  struct cmp_signal signal = {0};
  double *y;
  TRY(signal_of(desk, s->curve, &signal));
  TRY(array_create(&y, signal.n, "a curve"));
  enum status status = f(s, &signal, y);
  for (size_t i = 0; i < signal.n && status == OK; i++)
    status = gallery_curve_add(curve, signal.t[i], y[i]);
  free(y);
  return status;
}

static const struct param lowpass_params[] = {
    SIGNAL_CURVE,
    SOURCE_REAL(signal_source, period, PARAM_ABOVE_0, 1e9, NULL, "what is much shorter goes"),
};

static enum status pass_low(const struct signal_source *s, const struct cmp_signal *signal,
                            double *out) {
  for (size_t i = 0; i < signal->n; i++)
    CHECK(isfinite(signal->value[i]), ERR_INPUT, "curve '%s' has a gap at x = %g", s->curve,
          signal->t[i]);
  return cmp_signal_low_pass(signal, s->period, out);
}

static enum status lowpass(struct gallery_desk *desk, const void *with,
                           struct gallery_curve *curve) {
  return transformed(desk, with, pass_low, curve);
}

static const struct param average_params[] = {
    SIGNAL_CURVE,
    SOURCE_REAL(signal_source, over, PARAM_ABOVE_0, 1e9, NULL, "width of the window"),
};

static enum status take_average(const struct signal_source *s, const struct cmp_signal *signal,
                                double *out) {
  return cmp_signal_average(signal, s->over, out);
}

static enum status average(struct gallery_desk *desk, const void *with,
                           struct gallery_curve *curve) {
  return transformed(desk, with, take_average, curve);
}

static const struct param highpass_params[] = {
    SIGNAL_CURVE,
    SOURCE_REAL(signal_source, over, PARAM_ABOVE_0, 1e9, NULL, "width of the window"),
};

static enum status take_rest(const struct signal_source *s, const struct cmp_signal *signal,
                             double *out) {
  TRY(cmp_signal_average(signal, s->over, out));
  for (size_t i = 0; i < signal->n; i++) out[i] = signal->value[i] - out[i];
  return OK;
}

static enum status highpass(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  return transformed(desk, with, take_rest, curve);
}

static const struct param derivative_params[] = {SIGNAL_CURVE};

/* The slope at t of the parabola through rows i, i + 1 and i + 2. */
static double slope_at(const struct cmp_signal *s, size_t i, double t) {
  const double *x = s->t + i, *y = s->value + i;
  const double first = (y[1] - y[0]) / (x[1] - x[0]), second = (y[2] - y[1]) / (x[2] - x[1]);
  return first + (second - first) * (2 * t - x[0] - x[1]) / (x[2] - x[0]);
}

static enum status differentiate(const struct signal_source *s, const struct cmp_signal *signal,
                                 double *out) {
  const size_t n = signal->n;
  CHECK(n >= 3, ERR_INPUT, "curve '%s' has %zu points; its derivative needs 3", s->curve, n);
  for (size_t i = 0; i < n; i++)
    out[i] = slope_at(signal, i == 0 ? 0 : i + 1 == n ? n - 3 : i - 1, signal->t[i]);
  return OK;
}

static enum status derivative(struct gallery_desk *desk, const void *with,
                              struct gallery_curve *curve) {
  return transformed(desk, with, differentiate, curve);
}

static const struct param integral_params[] = {SIGNAL_CURVE};

static enum status integrate(const struct signal_source *s, const struct cmp_signal *signal,
                             double *out) {
  (void)s;
  cmp_signal_integrate(signal, out);
  return OK;
}

static enum status integral(struct gallery_desk *desk, const void *with,
                            struct gallery_curve *curve) {
  return transformed(desk, with, integrate, curve);
}

/* ---- the sources ---- */

#define SIGNAL(what, text)                                                                         \
  const struct gallery_source gallery_source_##what = {                                            \
      .name = #what,                                                                               \
      .help = text,                                                                                \
      .params = what##_params,                                                                     \
      .n_params = sizeof what##_params / sizeof *what##_params,                                    \
      .params_size = sizeof(struct signal_source),                                                 \
      .evaluate = what,                                                                            \
  };
SIGNAL(spectrum, "amplitudes of the sines of a curve, by a Hann window, over angular frequency")
SIGNAL(without, "a curve without its points at multiples of a period, over its x")
SIGNAL(lowpass, "a curve without its cosines that are much shorter than a period, over its x")
SIGNAL(average, "the running mean of a curve, over its x")
SIGNAL(highpass, "a curve less its running mean, over its x")
SIGNAL(derivative, "dy/dx of a curve by parabolas through three points, over its x")
SIGNAL(integral, "the integral of a curve from its first point on by trapezia, over its x")
