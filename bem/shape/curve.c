#include "bem/shape/curve.h"

#include <math.h>
#include <stdlib.h>

#include "bem/shape/spline.h"
#include "common/base/array.h"

static enum status reserve(struct bem_curve *c, size_t n) {
  if (n <= c->room) return OK;
  TRY(array_resize(&c->memory, 7 * n, "numbers of a curve"));
  c->room = n;
  c->arc = c->memory;
  c->second = c->memory + n;
  c->scratch = c->memory + (1 + BEM_FIELDS) * n;
  return OK;
}

void bem_curve_destroy(struct bem_curve *c) {
  free(c->memory);
  *c = (struct bem_curve){0};
}

enum status bem_curve_fit(struct bem_curve *c, const struct bem_surface *s, size_t a, size_t b,
                          double start) {
  TRY(reserve(c, b - a + 1));
  c->n = b - a + 1;
  c->from = 0;
  for (size_t field = 0; field < BEM_FIELDS; field++) c->value[field] = s->state + field * s->n + a;
  const double *x = c->value[0], *y = c->value[1];
  c->arc[0] = start;
  for (size_t k = 1; k < c->n; k++)
    c->arc[k] = c->arc[k - 1] + hypot(x[k] - x[k - 1], y[k] - y[k - 1]);
  return (bem_surface_is_closed(s) ? bem_spline_fit_round : bem_spline_fit)(
      c->n, c->arc, BEM_FIELDS, c->value, c->second, c->scratch);
}

double bem_curve_value(struct bem_curve *c, size_t field, double arc) {
  return bem_spline_value(c->n, c->arc, c->value[field], c->second + field * c->n, arc, &c->from);
}
