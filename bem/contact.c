#include "bem/contact.h"

#include <math.h>

#include "bem/replace.h"

static const double WORTH = 20;  /* of its thickness: the length of thin film that is cut */
static const double TIP = 0.06;  /* of the film, see struct bem_surface: a fifth of its thickness */
static const double BELOW = 0.1; /* H: of the top of the wall, where the cap of a film ends */
enum {
  CAP = 8 /* points of the cap, and its length in film thicknesses */
};

/* The first node beyond the wall, else the last node. */
static size_t crossing(const struct bem_surface *s, const double *state) {
  size_t k = 1;
  while (k + 1 < s->n && state[k] <= s->tank) k++;
  return k;
}

double bem_contact_height(const struct bem_surface *s, const double *state) {
  const double *x = state, *y = state + s->n;
  size_t k = crossing(s, state);
  if (x[k] <= s->tank) return 0;
  double a = (s->tank - x[k - 1]) / (x[k] - x[k - 1]);
  return y[k - 1] + a * (y[k] - y[k - 1]);
}

/* Where between two lengths the curve passes x. */
static double pass(struct bem_curve *c, double x, double low, double high) {
  for (int i = 0; i < 60; i++) { /* until there is no number between them */
    double middle = 0.5 * (low + high);
    if (bem_curve_value(c, 0, middle) < x)
      low = middle;
    else
      high = middle;
  }
  return low;
}

/* Where the surface meets the wall; *keep: how many nodes before it stay. */
static enum status meet(struct bem_curve *c, const struct bem_surface *s, double end[BEM_FIELDS],
                        size_t *keep) {
  TRY(bem_curve_fit(c, s, s->corner, s->n - 1, 0));
  *keep = crossing(s, s->state);
  const double *arc = c->arc + *keep - s->corner;
  double at = pass(c, s->tank, arc[-1], arc[0]);
  end[0] = s->tank;
  for (size_t field = 1; field < BEM_FIELDS; field++) end[field] = bem_curve_value(c, field, at);
  if (at - arc[-1] < 0.5 * (arc[0] - arc[-1])) --*keep; /* no splinter of a panel */
  return OK;
}

enum status bem_contact_meet_wall(struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  struct bem_curve curve = {0};
  double end[1][BEM_FIELDS];
  size_t keep;
  enum status status = meet(&curve, s, end[0], &keep);
  bem_curve_destroy(&curve);
  TRY(status);
  if (s->right == BEM_END_BED) s->tip = TIP;
  s->right = BEM_END_WALL;
  s->length = s->tank;
  return bem_replace(f, keep, s->n, 1, end);
}

bool bem_contact_crosses_wall(const struct bem_surface *s) {
  return crossing(s, s->state) + 1 < s->n;
}

/* The last node before the film becomes thinner than `film` for the first time; spikes beyond it do
 * not make it thick again. */
static size_t film_begin(const struct bem_surface *s, double film) {
  size_t k = 0;
  while (k + 1 < s->n && s->tank - s->state[k + 1] >= film) k++;
  return k;
}

bool bem_contact_film_is_thin(const struct bem_surface *s, double film) {
  const double *x = s->state, *y = x + s->n;
  double length = 0;
  for (size_t k = film_begin(s, film); k + 1 < s->n; k++)
    if (s->tank - x[k + 1] < film) length += hypot(x[k + 1] - x[k], y[k + 1] - y[k]);
  return length > WORTH * film;
}

/* The nodes whose polynomial gives the potential on a cap at node c: one before it, and three
 * spread over the length of the cap. */
static enum status choose_carriers(const struct bem_surface *s, size_t c, double length,
                                   size_t node[BEM_CARRIERS]) {
  const size_t n = s->n;
  const double *y = s->state + n;
  CHECK(c >= 4 && c + 1 < n, ERR_SOLVER, "the film at the wall begins at node %zu of %zu", c, n);
  node[0] = c - 1;
  node[1] = c;
  for (size_t i = 2; i < BEM_CARRIERS; i++) {
    double above = y[c] + 0.5 * (double)(i - 1) * length;
    node[i] = node[i - 1] + 1;
    while (node[i] + BEM_CARRIERS - i < n && y[node[i]] < above) node[i]++;
  }
  CHECK(node[BEM_CARRIERS - 1] < n, ERR_SOLVER, "the film at the wall has too few nodes to be cut");
  return OK;
}

/* Cuts the film behind node c and caps it by a parabola that ends on the wall. */
static enum status cut_behind(struct bem_flow *f, size_t c) {
  const struct bem_surface *s = &f->surface;
  double thickness = s->tank - s->state[c], length = CAP * thickness;
  double point[CAP][BEM_FIELDS];
  size_t node[BEM_CARRIERS] = {0};
  TRY(choose_carriers(s, c, length, node));
  for (int i = 0; i < CAP; i++) {
    double at = (double)(i + 1) / CAP;
    point[i][0] = s->tank - thickness * (1 - at * at);
    point[i][1] = s->state[s->n + c] + length * at;
    point[i][2] = bem_replace_potential(f, node, CMPLX(point[i][0], point[i][1]));
  }
  return bem_replace(f, c + 1, s->n, CAP, point);
}

enum status bem_contact_cut_film(struct bem_flow *f, double film) {
  return cut_behind(f, film_begin(&f->surface, film));
}

/* The last node from which a cap ends well below `top`. */
static size_t spill_begin(const struct bem_surface *s, double top) {
  const double *x = s->state, *y = x + s->n;
  size_t k = s->n - 1;
  while (k > 0 && y[k] + CAP * (s->tank - x[k]) > top - BELOW) k--;
  return k;
}

double bem_contact_thickness(const struct bem_surface *s, double top) {
  return s->tank - s->state[spill_begin(s, top)];
}

enum status bem_contact_cut_top(struct bem_flow *f, double top) {
  return cut_behind(f, spill_begin(&f->surface, top));
}
