/* Water at rest, in any tank. */
#include "common/case/case.h"
#include "common/flow/flow.h"

struct form {
  double depth; /* m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0,
                "of the water above the lowest point of the walls"),
};

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  return (struct flow_scale){f->depth, f->depth, 0, c->tank.max[0] - c->tank.min[0]};
}

static double level(const struct flow_water *w) {
  const struct form *f = w->c->form;
  return w->c->tank.min[1] + f->depth;
}

static double elevation(const struct flow_water *w, double x, double t) {
  (void)x, (void)t;
  return level(w);
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  (void)w, (void)x, (void)y, (void)t;
  return 0;
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  (void)w, (void)x, (void)y, (void)t;
  out[0] = out[1] = 0;
}

const struct flow flow_still = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: still, depth: 1}",
    .scale = scale,
    .elevation = elevation,
    .at_rest = true,
    .potential = potential,
    .velocity = velocity,
};
