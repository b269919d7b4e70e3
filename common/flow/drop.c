/* A disc of water of radius R that starts with u = A x, v = -A y in a force -Omega^2 r to its
 * middle (Monaghan & Rafiee, Int. J. Numer. Meth. Fluids 71, 2013; Antuono, Marrone, Colagrossi &
 * Bouscasse, Comput. Methods Appl. Mech. Engrg. 289, 2015; without the force Monaghan, J. Comput.
 * Phys. 110, 1994). The velocity keeps its form, so that the disc becomes an ellipse with the
 * semi-axes a = R e^s and b = R e^-s, ds/dt = A, and with the pressure p = rho (A^2 + Omega^2) a^2
 * b^2/(a^2 + b^2) (1 - x^2/a^2 - y^2/b^2), exactly, in incompressible water: the two components of
 * Euler's equation are dA/dt = -(A^2 + Omega^2) tanh 2s, whose first integral, (A^2 + Omega^2) cosh
 * 2s, is the energy. In sigma = sinh s = S sin(theta), S^2 = A^2/(2 Omega^2) at the start, d
 * theta/dt = Omega sqrt(2 (1 + sigma^2)/(1 + 2 sigma^2)). */
#include <math.h>
#include <stdlib.h>

#include "common/flow/bodies.h"

struct form {
  double radius, strain, pull; /* m, 1/s, 1/s */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, radius, PARAM_ABOVE_0, "radius of the disc"),
    BODY_RATE(struct form, strain, PARAM_ABOVE_0, NULL,
              "A at t = 0, which draws it out along x: u = A x, v = -A y"),
    BODY_RATE(struct form, pull, 0, "0",
              "Omega, of the acceleration -Omega^2 r to the middle; 0: none"),
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return flow_body_scale(c, f->radius, M_PI * f->radius * f->radius);
}

/* The half axis a has at most sinh s = A/(Omega sqrt 2), and grows by no more than sqrt(2) R A, as
 * it does in the end without the force. */
static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double S = f->strain / (f->pull * sqrt(2)); /* infinite without */
  const double drawn = 1 + sqrt(2) * f->strain * c->end;
  flow_body_check_room(c, d, f->radius * fmin(S + sqrt(1 + S * S), drawn), "radius");
}

static struct flow_pull pull(const struct case_file *c) {
  const struct form *f = c->form;
  double middle[2];
  flow_body_middle(c, middle);
  return (struct flow_pull){middle[0], middle[1], f->pull};
}

/* A polygon of the disc's area. */
static enum status outline(const struct case_file *c, struct geo_lines *water) {
  enum { CORNERS = 720 };
  const struct form *f = c->form;
  const double step = 2 * M_PI / CORNERS, R = f->radius * sqrt(step / sin(step));
  double middle[2];
  flow_body_middle(c, middle);
  geo_lines_clear(water);
  TRY(geo_lines_begin(water, true));
  for (int k = 0; k < CORNERS; k++)
    TRY(geo_lines_add(water, middle[0] + R * cos(step * k), middle[1] + R * sin(step * k)));
  return OK;
}

/* ---- the drop at any time ---- */

struct drop {
  double middle[2]; /* m */
  double period;    /* s; infinite without the force */
  struct motion {
    double t, s, A; /* s; a = R e^s; 1/s */
  } last;           /* that was asked for */
};

/* The time for which theta goes once round, by the trapezoidal rule, which is exact but for
 * exp(-points/S) where a function is periodic. */
static double period_of(const struct form *f) {
  const double S = f->strain / (f->pull * sqrt(2));
  const int n = (int)fmin(64 * (1 + S), 1e6);
  double sum = 0;
  if (f->pull == 0) return INFINITY;
  for (int k = 0; k < n; k++) {
    const double sigma = S * sin(2 * M_PI * k / n), sigma2 = sigma * sigma;
    sum += sqrt((1 + 2 * sigma2) / (2 * (1 + sigma2)));
  }
  return 2 * M_PI / n * sum / f->pull;
}

static double decline(const struct form *f, double s, double A) {
  return -(A * A + f->pull * f->pull) * tanh(2 * s);
}

/* By the classical Runge-Kutta method, with an error below 1e-10. */
static struct motion move(const struct form *f, double t) {
  const double rate = hypot(f->strain, f->pull);
  const size_t n = (size_t)ceil(rate * t / 0.005);
  const double dt = n ? t / (double)n : 0;
  double s = 0, A = f->strain;
  for (size_t k = 0; k < n; k++) {
    const double s1 = A, A1 = decline(f, s, A);
    const double s2 = A + dt / 2 * A1, A2 = decline(f, s + dt / 2 * s1, A + dt / 2 * A1);
    const double s3 = A + dt / 2 * A2, A3 = decline(f, s + dt / 2 * s2, A + dt / 2 * A2);
    const double s4 = A + dt * A3, A4 = decline(f, s + dt * s3, A + dt * A3);
    s += dt / 6 * (s1 + 2 * s2 + 2 * s3 + s4);
    A += dt / 6 * (A1 + 2 * A2 + 2 * A3 + A4);
  }
  return (struct motion){t, s, A};
}

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  struct drop *drop = w->own = malloc(sizeof *drop);
  CHECK(drop, ERR_MEMORY, "no memory for a drop");
  flow_body_middle(w->c, drop->middle);
  drop->period = period_of(f);
  drop->last = (struct motion){0, 0, f->strain};
  return OK;
}

static void destroy(struct flow_water *w) {
  free(w->own);
}

/* At time t in its first period; every point of the water asks for the same. */
static const struct drop *drop_at(const struct flow_water *w, double t) {
  struct drop *drop = w->own;
  if (t == drop->last.t) return drop;
  drop->last = move(w->c->form, isinf(drop->period) ? t : fmod(t, drop->period));
  drop->last.t = t;
  return drop;
}

static double half_axis(const struct flow_water *w, const struct drop *drop, int axis) {
  const struct form *f = w->c->form;
  return f->radius * exp(axis == 0 ? drop->last.s : -drop->last.s);
}

static void rim(const struct flow_water *w, double part, double t, double p[2]) {
  const struct drop *drop = drop_at(w, t);
  p[0] = drop->middle[0] - half_axis(w, drop, 0) * cos(2 * M_PI * part);
  p[1] = drop->middle[1] + half_axis(w, drop, 1) * sin(2 * M_PI * part);
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  const struct drop *drop = drop_at(w, t);
  const double X = x - drop->middle[0], Y = y - drop->middle[1];
  return drop->last.A * (X * X - Y * Y) / 2;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct drop *drop = drop_at(w, t);
  out[0] = drop->last.A * (x - drop->middle[0]);
  out[1] = -drop->last.A * (y - drop->middle[1]);
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  const struct form *f = w->c->form;
  const struct drop *drop = drop_at(w, t);
  const double a2 = pow(half_axis(w, drop, 0), 2), b2 = pow(half_axis(w, drop, 1), 2);
  const double X = x - drop->middle[0], Y = y - drop->middle[1];
  const double held = drop->last.A * drop->last.A + f->pull * f->pull;
  return held * a2 * b2 / (a2 + b2) * fmax(1 - X * X / a2 - Y * Y / b2, 0);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  *out = pressure(w, p->x, p->y, 0) / w->c->g;
  return OK;
}

/* The mean of r^2 over an ellipse is (a^2 + b^2)/4. */
static double spread(const struct flow_water *w, const struct drop *drop) {
  const double a = half_axis(w, drop, 0), b = half_axis(w, drop, 1);
  return M_PI * a * b * (a * a + b * b) / 4;
}

static double kinetic(const struct flow_water *w, double t) {
  const struct drop *drop = drop_at(w, t);
  return drop->last.A * drop->last.A / 2 * spread(w, drop);
}

static double potential_energy(const struct flow_water *w, double t) {
  const struct form *f = w->c->form;
  return f->pull * f->pull / 2 * spread(w, drop_at(w, t));
}

static double error(const struct flow_water *w, double end) {
  (void)w, (void)end;
  return 0; /* of incompressible water */
}

const struct flow flow_drop = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "body: {kind: drop, radius: 0.4, strain: 1, pull: 1}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .outline = outline,
    .rim = rim,
    .pull = pull,
    .potential = potential,
    .velocity = velocity,
    .head = head,
    .pressure = pressure,
    .kinetic = kinetic,
    .potential_energy = potential_energy,
    .error = error,
};
