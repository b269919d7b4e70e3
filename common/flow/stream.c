/* Steady waves of any height (crest.h), often called those of the stream function, round a tank
 * with periodic sides, to the right, with a crest at its left side. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "common/flow/crest.h"
#include "common/flow/round.h"

#define DEEPEST                                                                                    \
  6 /* wavelengths: below, exp(-2 pi 6) of the velocity at the surface is rounding                 \
     */

struct form {
  double height, wavelength, depth; /* m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, height, PARAM_ABOVE_0,
                "height of the crest above the trough, up to 98 % of the highest"),
    FLOW_LENGTH(struct form, wavelength, PARAM_ABOVE_0, "wavelength, up to 50 depths"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "mean depth"),
};

/* Of the water that the wave moves, m. */
static double moving_depth(const struct form *f) {
  return fmin(f->depth, DEEPEST * f->wavelength);
}

static bool known(const struct form *f) {
  const double h = moving_depth(f), length = f->wavelength / h;
  return length <= CREST_LONGEST && f->height <= CREST_STEEPEST * wave_crest_limit(length) * h;
}

/* A refused one is drawn all the same: as a low cosine. */
static enum status solve(const struct form *f, struct crest *w) {
  const double h = moving_depth(f);
  *w = (struct crest){0};
  return known(f) ? wave_crest_create_periodic(f->height / h, f->wavelength / h, w) : OK;
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  struct crest w;
  double amplitude = f->height / 2;
  if (solve(f, &w) == OK && w.n) amplitude = moving_depth(f) * wave_crest_elevation(&w, 0);
  wave_crest_destroy(&w);
  return (struct flow_scale){f->depth, f->depth, amplitude, f->wavelength};
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double h = moving_depth(f), limit = h * wave_crest_limit(f->wavelength / h);
  char found[96], allowed[128];
  wave_round_check(c, d, f->wavelength);
  if (f->wavelength > CREST_LONGEST * f->depth) {
    snprintf(found, sizeof found, "a wavelength of %.6g m", f->wavelength);
    snprintf(allowed, sizeof allowed, "up to %d depths, here %.6g m", CREST_LONGEST,
             CREST_LONGEST * f->depth);
    case_flow_problem(d, "wavelength", found, allowed,
                      "take solitary waves, which the crests of longer ones are");
  } else if (!known(f)) {
    snprintf(found, sizeof found, "a height of %.6g m", f->height);
    snprintf(allowed, sizeof allowed,
             "up to 98 %% of the highest wave's of this length and depth, %.4g m", limit);
    case_flow_problem(d, "height", found, allowed, "a higher wave breaks");
  }
}

/* ---- the wave, at any time ---- */

struct wave {
  struct crest crest;
  double depth, unit; /* m; m/s */
};

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  struct wave *wave = w->own = calloc(1, sizeof *wave);
  CHECK(wave, ERR_MEMORY, "no memory for a steady wave");
  wave->depth = moving_depth(f);
  wave->unit = sqrt(w->c->gravity * wave->depth);
  return solve(f, &wave->crest);
}

static void destroy(struct flow_water *w) {
  struct wave *wave = w->own;
  if (wave) wave_crest_destroy(&wave->crest);
  free(wave);
}

static double top(const struct flow_water *w) {
  const struct form *f = w->c->form;
  return w->c->tank.min[1] + f->depth;
}

/* Of x before a crest, in depths. */
static double ahead(const struct flow_water *w, double x, double t) {
  const struct wave *wave = w->own;
  return (x - w->c->tank.min[0] - wave->unit * wave->crest.speed * t) / wave->depth;
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  const double X = ahead(w, x, t);
  if (!wave->crest.n)
    return top(w) + f->height / 2 * cos(2 * M_PI * X * wave->depth / f->wavelength);
  return top(w) + wave->depth * wave_crest_elevation(&wave->crest, X);
}

/* Below the water that moves there is only its weight. */
static struct crest_point at(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  const double Y = (y - top(w)) / wave->depth;
  struct crest_point p = wave_crest_at(&wave->crest, ahead(w, x, t), fmax(Y, -1));
  p.head -= fmin(Y + 1, 0);
  return p;
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  return wave->depth * wave->unit * at(w, x, y, t).potential;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct wave *wave = w->own;
  const struct crest_point p = at(w, x, y, t);
  out[0] = wave->unit * p.u;
  out[1] = wave->unit * p.v;
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  return y > elevation(w, x, t) ? 0 : w->c->gravity * wave->depth * at(w, x, y, t).head;
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct wave *wave = w->own;
  *out = p->y < elevation(w, p->x, 0) ? wave->depth * at(w, p->x, p->y, 0).head : 0;
  return OK;
}

/* Of all waves in the tank, from that of one over rho g h^3. */
static double energy(const struct flow_water *w, double of_one) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  const double waves = (w->c->tank.max[0] - w->c->tank.min[0]) / f->wavelength;
  return waves * w->c->gravity * pow(wave->depth, 3) * of_one;
}

static double kinetic(const struct flow_water *w, double t) {
  (void)t;
  const struct wave *wave = w->own;
  return energy(w, wave->crest.kinetic);
}

static double potential_energy(const struct flow_water *w, double t) {
  (void)t;
  const struct wave *wave = w->own;
  const double bed = w->c->tank.min[1], level = top(w);
  const double width = w->c->tank.max[0] - w->c->tank.min[0];
  return w->c->gravity * width * (level * level - bed * bed) / 2 + energy(w, wave->crest.potential);
}

/* What is missing of 2 T = c I, which the exact wave has; not less than rounding. */
static double error(const struct flow_water *w, double end) {
  (void)end;
  const struct wave *wave = w->own;
  const struct crest *c = &wave->crest;
  return fmax(fabs(c->speed * c->impulse / (2 * c->kinetic) - 1), DBL_EPSILON);
}

const struct flow flow_stream = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: stream, height: 0.1, wavelength: 4, depth: 0.8}",
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
