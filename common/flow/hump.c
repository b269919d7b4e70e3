/* A hump or a hollow of Gaussian shape on water at rest, that is let go: what Cauchy and Poisson
 * asked. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/flow/harmonic.h"

enum { IMAGES = 3, MOST_TERMS = 240 }; /* of the hump on either side of a periodic tank */

struct form {
  double height, width, depth, x; /* m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, height, -1e6,
                "of its middle above the water at rest; of a hollow below 0"),
    FLOW_LENGTH(struct form, width, PARAM_ABOVE_0,
                "way from its middle to where it is 1/e of the height"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "of the water at rest around it"),
    FLOW_LENGTH(struct form, x, -1e6, "where its middle is"),
};

static double width_of(const struct case_file *c) {
  return c->tank.max[0] - c->tank.min[0];
}

/* Above the water at rest. */
static double rise(const struct case_file *c, double x) {
  const struct form *f = c->form;
  const int images = c->periodic[0] ? IMAGES : 0;
  double sum = 0;
  for (int i = -images; i <= images; i++)
    sum += exp(-pow((x - f->x + i * width_of(c)) / f->width, 2));
  return f->height * sum;
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  const double left = (c->tank.min[0] - f->x) / f->width, right = left + width_of(c) / f->width;
  const double part = c->periodic[0] ? 2 : erf(right) - erf(left);
  const double area = f->height * f->width * sqrt(M_PI) / 2 * part;
  return (struct flow_scale){f->depth, f->depth + area / width_of(c), fmax(f->height, 0),
                             M_PI * f->width};
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const struct geo_box *tank = &c->tank;
  char found[96], allowed[128];
  if (f->height <= -f->depth || f->height == 0) {
    snprintf(found, sizeof found, "a height of %.6g m", f->height);
    snprintf(allowed, sizeof allowed, "a hump, or a hollow less deep than the water, %.6g m",
             f->depth);
    case_flow_problem(d, "height", found, allowed, "change it or the depth");
  }
  if (f->x < tank->min[0] || f->x > tank->max[0]) {
    snprintf(found, sizeof found, "a middle at %.6g m", f->x);
    snprintf(allowed, sizeof allowed, "one in the tank, from %.6g to %.6g m", tank->min[0],
             tank->max[0]);
    case_flow_problem(d, "x", found, allowed, "move it");
  }
  if (c->periodic[0] && f->width > width_of(c) / 4) {
    snprintf(found, sizeof found, "a width of %.6g m", f->width);
    snprintf(allowed, sizeof allowed, "up to a quarter of the periodic tank's, %.6g m",
             width_of(c) / 4);
    case_flow_problem(d, "width", found, allowed, "it would meet itself; make the tank longer");
  }
}

/* ---- the water ---- */

/* p/(rho g) + y just after it is let go, where the bed is flat and particles want it. */
static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  if (!(w->use.spacing > 0) || !w->c->rectangular) return OK;
  const double bend = (w->c->periodic[0] ? 2 : 1) * f->width; /* exp(-(k width)^2/4) is rounding */
  const size_t terms = (size_t)fmin(MOST_TERMS, ceil(12 * width_of(w->c) / (M_PI * bend)) + 4);
  return flow_harmonic_of_surface(w, terms, (struct flow_harmonic **)&w->own);
}

static void destroy(struct flow_water *w) {
  flow_harmonic_destroy(w->own);
}

static double elevation(const struct flow_water *w, double x, double t) {
  (void)t;
  const struct form *f = w->c->form;
  return w->c->tank.min[1] + f->depth + rise(w->c, x);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const double top = elevation(w, p->x, 0);
  if (!w->own || p->y >= top)
    *out = top - p->y;
  else
    *out = flow_harmonic_at(w->own, p->x, p->y, NULL) - p->y;
  return OK;
}

const struct flow flow_hump = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: hump, height: 0.2, width: 0.6, depth: 0.5, x: 1.7}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .elevation = elevation,
    .at_rest = true,
    .head = head,
};
