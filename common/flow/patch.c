/* A square patch of water, free all round, that starts to turn like a rigid body: u = omega y,
 * v = -omega x from its middle (Colagrossi, thesis, Rome 2005; Le Touze, Colagrossi, Colicchio &
 * Greco, Int. J. Numer. Meth. Fluids 73, 2013). Nothing but suction would keep it together, and
 * that not as a square: laplace p = 2 rho omega^2, p = 0 on its sides (release.h). That is the
 * stress function of torsion: -0.1473 rho omega^2 side^2 in the middle, and the middle of a side is
 * drawn in by 0.6753 omega^2 side, more than the omega^2 side/2 that would turn it, while a corner
 * flies on straight (Timoshenko & Goodier, Theory of Elasticity, ch. 10). No theory follows it
 * farther, but energy, momenta and vorticity stay. */
#include <stdlib.h>

#include "common/flow/bodies.h"
#include "common/flow/release.h"

struct form {
  double side, rate; /* m, 1/s */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, side, PARAM_ABOVE_0, "side of the square"),
    BODY_RATE(struct form, rate, PARAM_ABOVE_0, NULL,
              "omega, at which it turns clockwise: u = omega y, v = -omega x"),
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return flow_body_scale(c, f->side, f->side * f->side);
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  flow_body_check_room(c, d, f->side / 2, "side");
}

static enum status outline(const struct case_file *c, struct geo_lines *water) {
  const struct form *f = c->form;
  double middle[2];
  flow_body_middle(c, middle);
  geo_lines_clear(water);
  TRY(geo_lines_begin(water, true));
  for (int k = 0; k < 4; k++) {
    const double right = k == 1 || k == 2 ? 0.5 : -0.5, up = k > 1 ? 0.5 : -0.5;
    TRY(geo_lines_add(water, middle[0] + right * f->side, middle[1] + up * f->side));
  }
  return OK;
}

/* d_i u_j d_j u_i = 2 du/dy dv/dx = -2 omega^2. */
static enum status create(struct flow_water *w) {
  const struct case_file *c = w->c;
  const struct form *f = c->form;
  const struct release_drive turning = {.source = -2 * f->rate * f->rate / c->g};
  struct release *r = NULL;
  if (w->use.spacing == 0) return OK;
  TRY(release_create(&c->water, &c->walls, w->use.spacing, case_near(c), &turning, &r));
  w->own = r;
  return OK;
}

static double seconds(const struct case_file *c, double spacing) {
  return release_seconds(&c->water, spacing);
}

static void destroy(struct flow_water *w) {
  release_destroy(w->own);
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  const struct form *f = w->c->form;
  double middle[2];
  (void)t;
  flow_body_middle(w->c, middle);
  out[0] = f->rate * (y - middle[1]);
  out[1] = -f->rate * (x - middle[0]);
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  *out = release_at(w->own, p->x, p->y);
  return OK;
}

const struct flow flow_patch = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "body: {kind: patch, side: 1, rate: 1}",
    .check = check,
    .create = create,
    .destroy = destroy,
    .seconds = seconds,
    .scale = scale,
    .outline = outline,
    .velocity = velocity,
    .head = head,
};
