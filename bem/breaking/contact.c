#include "bem/breaking/contact.h"

#include <math.h>

#include "bem/breaking/replace.h"
#include "bem/shape/sides.h"

static const double WORTH = 20;  /* of its thickness: the length of thin film that is cut */
static const double TIP = 0.06;  /* of the film, see struct bem_surface: a fifth of its thickness */
static const double BELOW = 0.1; /* H: of the top of the wall, where the cap of a film ends */
static const double REST = 2;    /* lengths of water at rest on a slope */
static const double SLIVER = 0.05; /* of its length: what is thinner is a tongue */
enum {
  CAP = 8,    /* points of the cap, and its length in film thicknesses */
  TONGUE = 12 /* nodes of one at most */
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
  s->length = s->tank - s->left;
  return bem_replace(f, keep, s->n, 1, end);
}

bool bem_contact_crosses_wall(const struct bem_surface *s) {
  return crossing(s, s->state) + 1 < s->n;
}

/* ---- films ---- */

/* A film on the wall that an end of the surface is on, as far as that is straight: node i, counted
 * from that end's other one, is so thick there, and so far up the wall. */
struct film {
  const struct bem_surface *s;
  const double *x, *y;
  bool right;
  double complex foot, up, in; /* of the wall; along it to the film's end; into the water */
  double length;               /* of the wall */
};

static struct film film_of(const struct bem_surface *s, bool right) {
  struct film f = {.s = s, .x = s->state, .y = s->state + s->n, .right = right};
  double complex a, b;
  bem_sides_wall(s, bem_sides_held(s, right), &a, &b);
  f.foot = right ? a : b;
  f.length = cabs(b - a);
  f.up = (right ? b - a : a - b) / f.length;
  f.in = right ? I * f.up : -I * f.up;
  return f;
}

static size_t film_node(const struct film *f, size_t i) {
  return f->right ? i : f->s->n - 1 - i;
}

static double complex film_place(const struct film *f, size_t i) {
  const size_t k = film_node(f, i);
  return CMPLX(f->x[k], f->y[k]) - f->foot;
}

static double film_thickness(const struct film *f, size_t i) {
  return creal(film_place(f, i) * conj(f->in));
}

static double film_height(const struct film *f, size_t i) {
  return creal(film_place(f, i) * conj(f->up));
}

/* Behind a step's riser, and above it, is other water. */
static bool film_is_beside(const struct film *f, size_t i) {
  const double height = film_height(f, i);
  return height > 0 && height < f->length;
}

static bool film_is_thin(const struct film *f, size_t i, double thin) {
  return film_is_beside(f, i) && fabs(film_thickness(f, i)) < thin;
}

/* The last node before the film becomes thinner than `thin` for the first time; spikes beyond it do
 * not make it thick again. */
static size_t film_begin(const struct film *f, double thin) {
  size_t i = 0;
  while (i + 1 < f->s->n && !film_is_thin(f, i + 1, thin)) i++;
  return i;
}

/* Water on a side that is flatter than 45 degrees rests there; on one that is not quite as flat a
 * film is cut to get on, where it is longer than water at rest would be as thin. */
static bool may_be_cut(const struct film *f, double length, double thin, bool rescue) {
  const double steep = cimag(f->up), flat = fabs(creal(f->up));
  if (steep > M_SQRT1_2) return length > WORTH * thin;
  return rescue && steep > 0 && steep * (length - WORTH * thin) > REST * thin * flat;
}

bool bem_contact_film_is_thin(const struct bem_surface *s, bool right, double coarse) {
  if (bem_surface_is_closed(s)) return false;
  const struct film f = film_of(s, right);
  const double thin = coarse * s->film;
  const size_t begin = film_begin(&f, thin);
  double length = 0;
  if (begin + 2 >= s->n) return false; /* an edge alone is none */
  for (size_t i = begin; i + 1 < s->n; i++)
    if (film_is_thin(&f, i + 1, thin)) length += cabs(film_place(&f, i + 1) - film_place(&f, i));
  return may_be_cut(&f, length, thin, coarse > 1);
}

/* The nodes whose polynomial gives the potential on a cap at node c: one before it, and three
 * spread over the length of the cap. */
static enum status choose_carriers(const struct film *f, size_t c, double length,
                                   size_t node[BEM_CARRIERS]) {
  const size_t n = f->s->n;
  CHECK(c >= 4 && c + 1 < n, ERR_SOLVER, "the film at the wall begins at node %zu of %zu", c, n);
  node[0] = c - 1;
  node[1] = c;
  for (size_t i = 2; i < BEM_CARRIERS; i++) {
    double above = film_height(f, c) + 0.5 * (double)(i - 1) * length;
    node[i] = node[i - 1] + 1;
    while (node[i] + BEM_CARRIERS - i < n && film_height(f, node[i]) < above) node[i]++;
  }
  CHECK(node[BEM_CARRIERS - 1] < n, ERR_SOLVER, "the film at the wall has too few nodes to be cut");
  for (int i = 0; i < BEM_CARRIERS; i++) node[i] = film_node(f, node[i]);
  return OK;
}

/* Cuts the film behind node c and caps it by a parabola that ends on the wall. */
static enum status cut_behind(struct bem_flow *f, const struct film *film, size_t c) {
  const struct bem_surface *s = &f->surface;
  double thickness = film_thickness(film, c), length = CAP * thickness;
  double point[CAP][BEM_FIELDS];
  size_t node[BEM_CARRIERS] = {0};
  TRY(choose_carriers(film, c, length, node));
  for (int i = 0; i < CAP; i++) {
    double at = (double)(i + 1) / CAP;
    const double complex z = film->foot + film->in * (thickness * (1 - at * at)) +
                             film->up * (film_height(film, c) + length * at);
    const int to = film->right ? i : CAP - 1 - i;
    point[to][0] = creal(z);
    point[to][1] = cimag(z);
    point[to][2] = bem_replace_potential(f, node, z);
  }
  return film->right ? bem_replace(f, c + 1, s->n, CAP, point)
                     : bem_replace(f, 0, s->n - 1 - c, CAP, point);
}

enum status bem_contact_cut_film(struct bem_flow *f, bool right, double coarse) {
  const struct film film = film_of(&f->surface, right);
  return cut_behind(f, &film, film_begin(&film, coarse * f->surface.film));
}

/* ---- tongues ---- */

/* Water at rest on a slope is no tongue. */
static double tongue_slope(const struct film *f) {
  const double steep = cimag(f->up), flat = fabs(creal(f->up));
  return steep > 0 && steep < flat ? fmin(SLIVER, 0.3 * steep / flat) : SLIVER;
}

size_t bem_contact_tongue(const struct bem_surface *s, bool right) {
  if (bem_surface_is_closed(s) || s->n < 2 * TONGUE) return 0;
  const struct film f = film_of(s, right);
  const size_t edge = s->n - 1;
  const double slope = tongue_slope(&f);
  size_t count = 0;
  for (size_t i = 1; i <= TONGUE && film_is_beside(&f, edge - i); i++)
    if (film_thickness(&f, edge - i) <
        slope * fabs(film_height(&f, edge) - film_height(&f, edge - i)))
      count = i;
  return count;
}

enum status bem_contact_cut_tongue(struct bem_flow *f, bool right) {
  const struct bem_surface *s = &f->surface;
  const struct film film = film_of(s, right);
  const size_t count = bem_contact_tongue(s, right), root = film_node(&film, s->n - 1 - count);
  const double complex foot = film.foot + film_height(&film, s->n - 1 - count) * film.up;
  double end[1][BEM_FIELDS] = {{creal(foot), cimag(foot), s->state[2 * s->n + root]}};
  return right ? bem_replace(f, root, s->n, 1, end) : bem_replace(f, 0, root + 1, 1, end);
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
  const struct film film = film_of(&f->surface, true);
  return cut_behind(f, &film, spill_begin(&f->surface, top));
}
