/* The exact solitary wave (crest.h) over a flat bed, to either side. Where the bed is not flat
 * there is nothing of it but its tail. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "common/case/case.h"
#include "common/flow/crest.h"
#include "common/flow/edges.h"
#include "common/flow/flow.h"

#define TAIL                                                                                       \
  1e-3 /* elevation at the flat bed's ends, at most, over the amplitude: what is wrong             \
        */

struct form {
  double amplitude, depth, x; /* m */
  int direction;
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, amplitude, PARAM_ABOVE_0,
                "height A of the crest above the water at rest, up to 0.8 depths"),
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0,
                "depth h of the water at rest; the wave's tails fall like exp(-k |x|), tan(k h) = "
                "F^2 k h, where F sqrt(g h) is its speed"),
    FLOW_LENGTH(struct form, x, -1e6, "where its crest is at t = 0"),
    FLOW_DIRECTION(struct form, direction),
};

/* A refused one is drawn all the same: as the highest. */
static double steepness_of_known(const struct form *f) {
  return fmin(f->amplitude / f->depth, CREST_HIGHEST);
}

static double steepness(const struct form *f) {
  return f->amplitude / f->depth;
}

/* What the walls cut off falls like the tail does. */
static double mean_depth(const struct case_file *c) {
  const struct form *f = c->form;
  struct crest w;
  double mass = 0;
  if (!(steepness(f) <= CREST_HIGHEST)) return f->depth;
  if (wave_crest_create(steepness(f), &w) == OK) {
    mass = w.mass;
    for (int side = 0; side < 2; side++) {
      const double *at = side ? c->tank.max : c->tank.min;
      mass -= wave_crest_elevation(&w, (at[0] - f->x) / f->depth) / w.decay;
    }
  }
  wave_crest_destroy(&w);
  return f->depth + mass * f->depth * f->depth / (c->tank.max[0] - c->tank.min[0]);
}

/* y of the bed below the crest. */
static double bed(const struct case_file *c) {
  const struct form *f = c->form;
  struct flow_flat flat;
  return flow_find_flat(c, f->x, &flat) ? flat.bed : c->tank.min[1];
}

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, mean_depth(c), f->amplitude,
                             2 * M_PI * f->depth / wave_crest_decay_about(steepness_of_known(f))};
}

/* ---- what it must be ---- */

static void check_place(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const char *end = c->rectangular ? "a wall" : "the end of the flat bed below it";
  struct flow_flat flat;
  struct crest w;
  char found[96], allowed[128];
  const bool over = flow_find_flat(c, f->x, &flat);
  const double near = over ? fmin(f->x - flat.left, flat.right - f->x) : 0;
  if (wave_crest_create(steepness(f), &w) == OK &&
      !(near > 0 && wave_crest_elevation(&w, near / f->depth) <= TAIL * w.height)) {
    double need = near > 0 ? near : 0;
    while (wave_crest_elevation(&w, need / f->depth) > TAIL * w.height) need += 0.01 * f->depth;
    if (over)
      snprintf(found, sizeof found, "a crest %.6g m from %s", near, end);
    else
      snprintf(found, sizeof found, "a crest above no flat bed");
    snprintf(allowed, sizeof allowed,
             "%.4g m and more%s, where its tail is a thousandth of its height", need,
             over ? "" : " of it to both sides");
    case_flow_problem(d, "x", found, allowed,
                      c->rectangular ? "move it, or make the tank longer"
                                     : "move it, or make the flat bed longer");
  }
  wave_crest_destroy(&w);
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  char found[96], allowed[128];
  if (c->periodic[0])
    case_flow_problem(d, "kind", "'solitary' between periodic sides", "one between walls",
                      "write tank.sides: walls");
  if (steepness(f) > CREST_HIGHEST) {
    snprintf(found, sizeof found, "an amplitude of %.6g m", f->amplitude);
    snprintf(allowed, sizeof allowed, "up to %g depths, here %.6g m", CREST_HIGHEST,
             CREST_HIGHEST * f->depth);
    case_flow_problem(d, "amplitude", found, allowed,
                      "the highest of all, which is not smooth, has 0.8332");
  } else {
    check_place(c, d);
  }
}

/* ---- the wave, at any time ---- */

struct wave {
  struct crest crest;
  double bed, speed; /* m, m/s */
};

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  struct wave *wave = w->own = calloc(1, sizeof *wave);
  CHECK(wave, ERR_MEMORY, "no memory for a solitary wave");
  TRY(wave_crest_create(steepness_of_known(f), &wave->crest));
  wave->bed = bed(w->c);
  wave->speed = wave->crest.speed * sqrt(w->c->gravity * f->depth);
  return OK;
}

static void destroy(struct flow_water *w) {
  struct wave *wave = w->own;
  if (wave) wave_crest_destroy(&wave->crest);
  free(wave);
}

static double sense(const struct flow_water *w) {
  const struct form *f = w->c->form;
  return f->direction == 0 ? 1 : -1;
}

/* Of x before the crest, in depths. */
static double ahead(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  return (sense(w) * (x - f->x) - wave->speed * t) / f->depth;
}

/* Of y above the level at rest, in depths. */
static double above(const struct flow_water *w, double y) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  return (y - wave->bed) / f->depth - 1;
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  return wave->bed + f->depth * (1 + wave_crest_elevation(&wave->crest, ahead(w, x, t)));
}

/* In a trench below the flat bed the motion that there is on its level. */
static struct crest_point at(const struct flow_water *w, double x, double y, double t) {
  const struct wave *wave = w->own;
  const double Y = above(w, y);
  struct crest_point p = wave_crest_at(&wave->crest, ahead(w, x, t), fmax(Y, -1));
  p.head -= fmin(Y + 1, 0);
  return p;
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  const struct form *f = w->c->form;
  return f->depth * sqrt(w->c->gravity * f->depth) * at(w, x, y, t).potential;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct form *f = w->c->form;
  const struct crest_point p = at(w, x, y, t);
  const double unit = sqrt(w->c->gravity * f->depth);
  out[0] = sense(w) * unit * p.u;
  out[1] = unit * p.v;
}

static double pressure(const struct flow_water *w, double x, double y, double t) {
  const struct form *f = w->c->form;
  return y > elevation(w, x, t) ? 0 : w->c->gravity * f->depth * at(w, x, y, t).head;
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct form *f = w->c->form;
  *out = p->y < elevation(w, p->x, 0) ? f->depth * at(w, p->x, p->y, 0).head : 0;
  return OK;
}

/* Energies are those of the whole wave, with its tails. */
static double kinetic(const struct flow_water *w, double t) {
  (void)t;
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  return w->c->gravity * pow(f->depth, 3) * wave->crest.kinetic;
}

static double potential_energy(const struct flow_water *w, double t) {
  (void)t;
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  const double bed = w->c->tank.min[1], top = bed + f->depth;
  const double width = w->c->tank.max[0] - w->c->tank.min[0];
  return w->c->gravity *
         (width * (top * top - bed * bed) / 2 + top * f->depth * f->depth * wave->crest.mass +
          pow(f->depth, 3) * wave->crest.potential);
}

/* The highest that it has stood at a wall, over its height. */
static double error(const struct flow_water *w, double end) {
  const struct form *f = w->c->form;
  const struct wave *wave = w->own;
  double worst = 0;
  for (int side = 0; side < 2; side++) {
    const double wall = side ? w->c->tank.max[0] : w->c->tank.min[0];
    const double first = ahead(w, wall, 0), last = ahead(w, wall, end);
    const double nearest = first * last < 0 ? 0 : fmin(fabs(first), fabs(last));
    worst = fmax(worst, wave_crest_elevation(&wave->crest, nearest) / steepness(f));
  }
  return worst;
}

const struct flow flow_solitary = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: solitary, amplitude: 0.08, depth: 0.2, x: 2.12, direction: left}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .elevation = elevation,
    .bed = bed,
    .potential = potential,
    .velocity = velocity,
    .head = head,
    .pressure = pressure,
    .kinetic = kinetic,
    .potential_energy = potential_energy,
    .error = error,
};
