/* A smooth step between two levels that runs into water at rest, as an undular bore begins (D. H.
 * Peregrine, J. Fluid Mech. 25, 1966). Behind it the water follows with the velocity of a hydraulic
 * jump between the levels h0 and h1, U = c (1 - h0/h1), c^2 = g h1 (h0 + h1)/(2 h0).
 *
 * A step of the shape h(s) = h0 + (h1 - h0)/(1 + exp 2s), s = (x - x0)/width, that moved on as it
 * is would carry c (1 - h0/h) averaged over the depth; here the bed has that velocity, and the
 * water the harmonic flow above it, u - iv = c (1 - h0/h(z)), z = x + iY: its poles are pi width/2
 * above the bed. */
#include <complex.h>
#include <math.h>
#include <stdio.h>

#include "common/case/case.h"
#include "common/flow/edges.h"
#include "common/flow/flow.h"

static const double NARROWEST = 1.5; /* width over the greater depth: poles are 2.4 depths up */

struct form {
  double height, depth, width, x; /* m */
  int direction;
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, height, PARAM_ABOVE_0,
                "of the level behind it above the water at rest; it breaks from "
                "0.28 depths on, below it becomes undular"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "h0 of the water at rest ahead"),
    FLOW_LENGTH(
        struct form, width, PARAM_ABOVE_0,
        "of the step, at least 1.5 (depth + height): its height is height/(1 + exp(2 s)), s the "
        "way ahead over this"),
    FLOW_LENGTH(struct form, x, -1e6, "where half of its height is at t = 0"),
    FLOW_DIRECTION(struct form, direction),
};

static double sense(const struct case_file *c) {
  const struct form *f = c->form;
  return f->direction == 0 ? 1 : -1;
}

/* Ahead of its middle, in widths. */
static double ahead(const struct case_file *c, double x) {
  const struct form *f = c->form;
  return sense(c) * (x - f->x) / f->width;
}

static double rise(const struct form *f, double s) {
  return f->height / (1 + exp(2 * s));
}

/* The integral of the rise from far ahead, m^2. */
static double area(const struct form *f, double s) {
  return f->height * f->width / 2 * (s > -300 ? log1p(exp(-2 * s)) : -2 * s);
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  const double a = ahead(c, c->tank.min[0]), b = ahead(c, c->tank.max[0]);
  const double more = area(f, fmin(a, b)) - area(f, fmax(a, b));
  return (struct flow_scale){f->depth, f->depth + more / (c->tank.max[0] - c->tank.min[0]),
                             rise(f, fmin(a, b)), 2 * M_PI * f->width};
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double least = NARROWEST * (f->depth + f->height);
  const double room = fmin(f->x - c->tank.min[0], c->tank.max[0] - f->x);
  char found[96], allowed[128];
  if (c->periodic[0])
    case_flow_problem(d, "kind", "'bore' between periodic sides", "one between walls",
                      "write tank.sides: walls");
  if (!c->rectangular)
    case_flow_problem(d, NULL, "a bore in a tank that is not rectangular",
                      "upright sides on a flat bed", "change tank.walls");
  if (f->width < least * (1 - CASE_SAME)) {
    snprintf(found, sizeof found, "a width of %.6g m", f->width);
    snprintf(allowed, sizeof allowed, "at least 1.5 (depth + height), here %.6g m", least);
    case_flow_problem(d, "width", found, allowed,
                      "a steeper step is no flow of long waves; water.regions can let one go");
  } else if (c->rectangular && room < 3 * f->width) {
    snprintf(found, sizeof found, "a step %.6g m from a wall", room);
    snprintf(allowed, sizeof allowed,
             "3 widths and more, %.6g m, where it is a quarter of a percent of its height",
             3 * f->width);
    case_flow_problem(d, "x", found, allowed, "move it, or make the tank longer");
  }
}

/* ---- the water ---- */

static double elevation(const struct flow_water *w, double x, double t) {
  (void)t;
  const struct form *f = w->c->form;
  return w->c->tank.min[1] + f->depth + rise(f, ahead(w->c, x));
}

static double speed(const struct flow_water *w) {
  const struct form *f = w->c->form;
  const double h1 = f->depth + f->height;
  return sqrt(w->c->gravity * h1 * (f->depth + h1) / (2 * f->depth));
}

static double complex place(const struct flow_water *w, double x, double y) {
  const struct form *f = w->c->form;
  return ahead(w->c, x) + I * (y - w->c->tank.min[1]) / f->width;
}

/* The integral of 1 - h0/h = a/(h1 + h0 exp 2s), with E = exp -2s far ahead. */
static double potential(const struct flow_water *w, double x, double y, double t) {
  (void)t;
  const struct form *f = w->c->form;
  const double h1 = f->depth + f->height;
  const double complex s = place(w, x, y);
  const double complex sum = creal(s) > 0 ? -clog(f->depth + h1 * cexp(-2 * s))
                                          : 2 * s - clog(h1 + f->depth * cexp(2 * s));
  return speed(w) * f->height * f->width / (2 * h1) * creal(sum);
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  (void)t;
  const struct form *f = w->c->form;
  const double h1 = f->depth + f->height;
  const double complex s = place(w, x, y);
  const double complex u = speed(w) * f->height *
                           (creal(s) > 0 ? cexp(-2 * s) / (h1 * cexp(-2 * s) + f->depth)
                                         : 1 / (h1 + f->depth * cexp(2 * s)));
  out[0] = sense(w->c) * creal(u);
  out[1] = -cimag(u);
}

const struct flow flow_bore = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: bore, height: 0.04, depth: 0.3, width: 0.52, x: 2.1, direction: left}",
    .check = check,
    .scale = scale,
    .elevation = elevation,
    .potential = potential,
    .velocity = velocity,
};
