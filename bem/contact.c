#include "bem/contact.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/spline.h"

static const double WORTH = 0.1; /* H: the length of thin film that is cut */
static const double TIP = 0.06;  /* of the film, see struct bem_surface: a fifth of its thickness */
static const double BELOW = 0.1; /* H: of the top of the wall, where the cap of a film ends */
enum { CAP = 8 };                /* points of the cap, and its length in film thicknesses */

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

/* Replaces the surface from node `keep` on by m points (x, y, phi) and regrids. */
static enum status replace_end(struct bem_flow *f, size_t keep, size_t m,
                               const double (*point)[3]) {
  struct bem_surface *s = &f->surface;
  struct bem_surface fresh = *s;
  fresh.state = NULL;
  fresh.room = 0;
  TRY(bem_surface_reserve(&fresh, keep + m));
  for (size_t field = 0; field < 3; field++) {
    double *to = fresh.state + field * fresh.n;
    memcpy(to, s->state + field * s->n, keep * sizeof *to);
    for (size_t i = 0; i < m; i++) to[keep + i] = point[i][field];
  }
  free(s->state);
  *s = fresh;
  return bem_mesh_regrid(&f->mesh, s);
}

enum status bem_contact_meet_wall(struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  const size_t n = s->n, begin = s->corner, nodes = n - begin;
  const double *x = s->state + begin;
  double *arc = malloc(5 * nodes * sizeof *arc);
  CHECK(arc, ERR_MEMORY, "no memory for %zu nodes at the wall", nodes);
  double *second = arc + nodes, *scratch = second + 3 * nodes;
  arc[0] = 0;
  for (size_t k = 1; k < nodes; k++)
    arc[k] = arc[k - 1] + hypot(x[k] - x[k - 1], x[n + k] - x[n + k - 1]);
  for (size_t field = 0; field < 3; field++)
    bem_spline_fit(nodes, arc, x + field * n, second + field * nodes, scratch);
  size_t k = crossing(s, s->state) - begin, from = k - 1;
  double low = arc[k - 1], high = arc[k];
  for (int i = 0; i < 60; i++) {
    double middle = 0.5 * (low + high);
    *(bem_spline_value(nodes, arc, x, second, middle, &from) < s->tank ? &low : &high) = middle;
  }
  double end[1][3] = {{s->tank, bem_spline_value(nodes, arc, x + n, second + nodes, low, &from),
                       bem_spline_value(nodes, arc, x + 2 * n, second + 2 * nodes, low, &from)}};
  size_t keep = begin + k;
  if (low - arc[k - 1] < 0.5 * (arc[k] - arc[k - 1])) keep--; /* no splinter of a panel */
  free(arc);
  if (s->right == BEM_END_BED) s->tip = TIP;
  s->right = BEM_END_WALL;
  s->length = s->tank;
  return replace_end(f, keep, 1, (const double(*)[3])end);
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
  return length > WORTH;
}

/* Cuts the film behind node c and caps it. */
static enum status cut_behind(struct bem_flow *f, size_t c) {
  struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  const double *x = s->state, *y = x + n, *phi = y + n;
  CHECK(c >= 4 && c + 1 < n, ERR_SOLVER, "the film at the wall begins at node %zu of %zu", c, n);
  double thickness = s->tank - x[c], length = CAP * thickness;

  size_t node[4] = {c - 1, c, c + 1, c + 2}; /* spread over the length of the cap */
  for (int i = 2; i < 4; i++) {
    node[i] = node[i - 1] + 1;
    while (node[i] + 4 - (size_t)i < n && y[node[i]] < y[c] + 0.5 * (i - 1) * length) node[i]++;
  }
  CHECK(node[3] < n, ERR_SOLVER, "the film at the wall has too few nodes to be cut");
  double point[CAP][3];
  for (int i = 0; i < CAP; i++) {
    double at = (double)(i + 1) / CAP;
    point[i][0] = s->tank - thickness * (1 - at * at);
    point[i][1] = y[c] + length * at;
    double complex z = CMPLX(point[i][0], point[i][1]), beta = 0;
    for (int a = 0; a < 4; a++) {
      double complex term = CMPLX(phi[node[a]], f->psi[node[a]]);
      for (int b = 0; b < 4; b++)
        if (b != a)
          term *= (z - CMPLX(x[node[b]], y[node[b]])) /
                  CMPLX(x[node[a]] - x[node[b]], y[node[a]] - y[node[b]]);
      beta += term;
    }
    point[i][2] = creal(beta);
  }
  return replace_end(f, c + 1, CAP, (const double(*)[3])point);
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
