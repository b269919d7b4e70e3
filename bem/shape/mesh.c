#include "bem/shape/mesh.h"

#include <assert.h>
#include <lapack.h>
#include <math.h>
#include <stdlib.h>

#include "bem/shape/cyclic.h"
#include "bem/shape/smooth.h"
#include "common/base/array.h"

/* The wanted number of nodes per H, divided by the resolution, is the root of the sum of squares of
 * 1, curvature/BEND and 1/(tip + GROWTH d), d the distance along the surface to the thin tip (and,
 * in tanks that are not rectangular, of one that grows as the depth falls below H): a function of
 * the shape alone, so refining the resolution refines everything alike. */
static const double BEND = 4, SHARPEST = 60; /* 1/H; curvature beyond SHARPEST asks for no more */
static const double FAINT = 0.7;       /* what curvature still counts where it is unimportant */
static const double GROWTH = 6;        /* 1/H */
static const double SHALLOWEST = 0.03; /* H: water below it asks for no more nodes */
static const double SPREAD = 3;        /* implicit smoothing, over about sqrt(3) panels */
static const double RELAX = 0.06;      /* sqrt(H/g), in which misplaced nodes drift home */
/* The same on smooth surfaces, whose bends grow slowly: what is faster only shortens the steps. */
static const double CALM = 0.1;
static const double OPEN = 0.15; /* rad: a kink that turns less is not one any more */
static const size_t FEWEST = 7;  /* nodes of a piece */

enum status bem_mesh_reserve(struct bem_mesh *m, size_t n) {
  double **array[] = {&m->work.rho,      &m->work.share,  &m->work.growth, &m->work.dx,
                      &m->work.dy,       &m->work.ddx,    &m->work.ddy,    &m->work.bend,
                      &m->work.diagonal, &m->work.beside, &m->work.round};
  enum { ARRAYS = sizeof array / sizeof *array };
  if (n <= m->work.room) return OK;
  TRY(array_resize(&m->work.memory, ARRAYS * n, "numbers of a mesh"));
  m->work.room = n;
  for (size_t i = 0; i < ARRAYS; i++) *array[i] = m->work.memory + i * n;
  return OK;
}

void bem_mesh_destroy(struct bem_mesh *m) {
  free(m->work.memory);
  bem_curve_destroy(&m->curve);
  *m = (struct bem_mesh){0};
}

/* Square of the curvature that counts at every node, and the differences it is made of. */
static void measure_bend(struct bem_mesh *m, const struct bem_surface *s, const double *x,
                         const double *y) {
  const double *dx = m->work.dx, *dy = m->work.dy, *ddx = m->work.ddx, *ddy = m->work.ddy;
  if (s->smooth) {
    bem_smooth_differences(s, x, BEM_ODD, m->work.dx, m->work.ddx);
    bem_smooth_differences(s, y, BEM_EVEN, m->work.dy, m->work.ddy);
  } else {
    bem_surface_differences(s, x, m->work.dx, m->work.ddx);
    bem_surface_differences(s, y, m->work.dy, m->work.ddy);
  }
  for (size_t k = 0; k < s->n; k++) {
    double speed = hypot(dx[k], dy[k]);
    double c = (dx[k] * ddy[k] - dy[k] * ddx[k]) / (speed * speed * speed);
    c *= fmax(FAINT, bem_surface_importance(s, x[k], y[k]));
    m->work.bend[k] = c * c / (1 + c * c / (SHARPEST * SHARPEST));
  }
}

/* Solves (1 - SPREAD delta^2) smooth = rough in place; nothing is lost at the ends, and a closed
 * chain has none. The matrix is positive definite: there is always a solution. */
static void spread(struct bem_mesh *m, size_t panels, bool closed) {
  double *rho = m->work.rho, *diagonal = m->work.diagonal, *beside = m->work.beside;
  for (size_t j = 0; j < panels; j++) {
    bool end = !closed && (j == 0 || j + 1 == panels);
    diagonal[j] = 1 + (end ? 1 : 2) * SPREAD;
    beside[j] = -SPREAD;
  }
  if (closed) {
    bem_cyclic_solve(panels, diagonal, beside, 1, panels, rho, m->work.round);
    return;
  }
  lapack_int n = (lapack_int)panels, one = 1, failed;
  LAPACK_dptsv(&n, &one, diagonal, beside, rho, &n, &failed);
  assert(failed == 0);
}

/* What shallow water adds to the square of the density: waves are as long as the root of its depth
 * there, and break in proportion to it. */
static double shallow(const struct bem_surface *s, double x, double y) {
  if (!s->walls) return 0;
  const double depth = bem_conformal_depth(s->walls, CMPLX(x, y));
  return depth < 1 ? 1 / fmax(depth, SHALLOWEST) - 1 : 0;
}

/* Density of nodes wanted on every panel, and how many it is worth. */
static void measure_density(struct bem_mesh *m, const struct bem_surface *s, const double *state) {
  const size_t n = s->n;
  const double *x = state, *y = state + n, *bend = m->work.bend;
  double *rho = m->work.rho, *share = m->work.share, distance = 0;
  measure_bend(m, s, x, y);
  for (size_t j = n - 1; j-- > 0;) {
    double l = share[j] = hypot(x[j + 1] - x[j], y[j + 1] - y[j]);
    double near = s->tip > 0 ? 1 / (s->tip + GROWTH * (distance + 0.5 * l)) : 0;
    rho[j] = sqrt(1 + 0.5 * (bend[j] + bend[j + 1]) / (BEND * BEND) + near * near +
                  shallow(s, 0.5 * (x[j] + x[j + 1]), 0.5 * (y[j] + y[j + 1])));
    distance += l;
  }
  spread(m, n - 1, bem_surface_is_closed(s));
  for (size_t j = 0; j + 1 < n; j++) {
    rho[j] *= m->resolution;
    share[j] *= rho[j];
  }
}

/* The last node of the piece that begins at node a. */
static size_t piece_end(const struct bem_surface *s, size_t a) {
  return a < s->corner ? s->corner : s->n - 1;
}

/* Rate at which the water stretches every panel, in nodes. */
static void measure_growth(struct bem_mesh *m, const struct bem_surface *s, const double *state,
                           const double *u, const double *v) {
  const double *x = state, *y = state + s->n;
  for (size_t j = 0; j + 1 < s->n; j++) {
    double lx = x[j + 1] - x[j], ly = y[j + 1] - y[j];
    double stretch = (lx * (u[j + 1] - u[j]) + ly * (v[j + 1] - v[j])) / (lx * lx + ly * ly);
    m->work.growth[j] = m->work.share[j] * stretch;
  }
}

/* On the piece from node a to node b: keeps the number of nodes up to each point, counted by
 * density, at its share of the whole. */
static void piece_velocity(const struct bem_mesh *m, double relax, size_t a, size_t b, double *q) {
  const double *rho = m->work.rho;
  double whole = 0, growth = 0, count = 0, stretch = 0;
  for (size_t j = a; j < b; j++) {
    whole += m->work.share[j];
    growth += m->work.growth[j];
  }
  q[a] = q[b] = 0;
  for (size_t j = a; j + 1 < b; j++) {
    count += m->work.share[j];
    stretch += m->work.growth[j];
    double share = (double)(j + 1 - a) / (double)(b - a);
    q[j + 1] = (share * growth - stretch + (share * whole - count) / relax) /
               (0.5 * (rho[j] + rho[j + 1]));
  }
}

void bem_mesh_velocity(struct bem_mesh *m, const struct bem_surface *s, const double *state,
                       const double *u, const double *v, double *tx, double *ty, double *q) {
  const double *dx = m->work.dx, *dy = m->work.dy;
  const double relax = s->smooth ? CALM : RELAX;
  measure_density(m, s, state);
  measure_growth(m, s, state, u, v);
  for (size_t k = 0; k < s->n; k++) {
    double speed = hypot(dx[k], dy[k]);
    tx[k] = dx[k] / speed;
    ty[k] = dy[k] / speed;
  }
  for (size_t a = 0, b; a + 1 < s->n; a = b) {
    b = piece_end(s, a);
    piece_velocity(m, relax, a, b, q);
  }
}

static double kink(const struct bem_surface *s) {
  const double *x = s->state + s->corner, *y = x + s->n;
  return fabs(
      remainder(atan2(y[1] - y[0], x[1] - x[0]) - atan2(y[0] - y[-1], x[0] - x[-1]), 2 * M_PI));
}

bool bem_mesh_is_poor(struct bem_mesh *m, const struct bem_surface *s) {
  if (s->corner && kink(s) < OPEN) return true;
  measure_density(m, s, s->state);
  for (size_t a = 0, b; a + 1 < s->n; a = b) {
    b = piece_end(s, a);
    double whole = 0, most = 0;
    for (size_t j = a; j < b; j++) {
      whole += m->work.share[j];
      most = fmax(most, m->work.share[j]);
    }
    double ratio = whole / (double)(b - a);
    if (ratio > 1.25 || (ratio < 0.6 && b - a >= FEWEST) || most > 2.5) return true;
  }
  return false;
}

/* Panels for the piece from node a to node b. */
static enum status count_panels(const struct bem_mesh *m, size_t a, size_t b, size_t *panels) {
  double whole = 0;
  for (size_t j = a; j < b; j++) whole += m->work.share[j];
  CHECK(whole < BEM_MOST_NODES, ERR_SOLVER,
        "the surface asks for %.3g nodes, more than %d: it has become too rough, or the "
        "resolution is too high",
        whole, BEM_MOST_NODES);
  *panels = (size_t)fmax(ceil(whole), (double)FEWEST);
  return OK;
}

/* Puts so many panels on the curve, whose nodes ask for rho: each is worth the same. to: the first
 * of the fresh surface's nodes on it. */
static void place_nodes(struct bem_curve *c, const double *rho, size_t panels,
                        struct bem_surface *fresh, size_t to) {
  const double *arc = c->arc;
  double *out = fresh->state + to, whole = 0, count = 0;
  size_t j = 0, last = c->n - 1;
  for (size_t k = 0; k < last; k++) whole += rho[k] * (arc[k + 1] - arc[k]);
  for (size_t k = 1; k < panels; k++) {
    double wanted = whole * (double)k / (double)panels, here;
    while (count + (here = rho[j] * (arc[j + 1] - arc[j])) < wanted && j + 1 < last) {
      count += here;
      j++;
    }
    for (size_t field = 0; field < BEM_FIELDS; field++)
      out[field * fresh->n + k] = bem_curve_value(c, field, arc[j] + (wanted - count) / rho[j]);
  }
  for (size_t field = 0; field < BEM_FIELDS; field++) {
    out[field * fresh->n] = c->value[field][0];
    out[field * fresh->n + panels] = c->value[field][last];
  }
}

/* The number of nodes up to each place is as smooth as the surface, and so are the places where it
 * is what it should be. */
static void place_smooth(struct bem_mesh *m, const struct bem_surface *s, size_t panels,
                         struct bem_surface *fresh) {
  double *count = m->work.growth;
  count[0] = 0;
  for (size_t j = 0; j + 1 < s->n; j++) count[j + 1] = count[j] + m->work.share[j];
  for (size_t k = 0, j = 0; k <= panels; k++) {
    const double wanted = count[s->n - 1] * (double)k / (double)panels;
    while (j + 2 < s->n && count[j + 1] < wanted) j++;
    const double at = k < panels ? bem_smooth_find(s, count, j, wanted) : (double)(s->n - 1);
    for (size_t field = 0; field < BEM_FIELDS; field++)
      fresh->state[field * fresh->n + k] =
          bem_smooth_value(s, s->state + field * s->n, field == 0 ? BEM_ODD : BEM_EVEN, at);
  }
}

static enum status regrid_smooth(struct bem_mesh *m, struct bem_surface *s) {
  size_t panels = 0;
  struct bem_surface fresh = {0};
  measure_density(m, s, s->state);
  TRY(count_panels(m, 0, s->n - 1, &panels));
  TRY(bem_surface_follow(&fresh, s, panels + 1));
  place_smooth(m, s, panels, &fresh);
  bem_surface_replace(s, &fresh);
  return bem_mesh_reserve(m, s->n);
}

enum status bem_mesh_regrid(struct bem_mesh *m, struct bem_surface *s) {
  if (s->corner && kink(s) < OPEN) s->corner = 0;
  TRY(bem_mesh_reserve(m, s->n));
  if (s->smooth) return regrid_smooth(m, s);
  measure_density(m, s, s->state);
  size_t panels[2] = {0}, pieces = 0; /* two at most: there is one kink */
  for (size_t a = 0; a + 1 < s->n; a = piece_end(s, a))
    TRY(count_panels(m, a, piece_end(s, a), &panels[pieces++]));

  struct bem_surface fresh = {0};
  TRY(bem_surface_follow(&fresh, s, panels[0] + panels[1] + 1));
  enum status status = OK;
  double arc = 0;
  for (size_t i = 0, a = 0, to = 0; i < pieces; to += panels[i++], a = piece_end(s, a)) {
    ATTEMPT(bem_curve_fit(&m->curve, s, a, piece_end(s, a), arc));
    arc = m->curve.arc[m->curve.n - 1];
    place_nodes(&m->curve, m->work.rho + a, panels[i], &fresh, to);
  }
  fresh.corner = s->corner ? panels[0] : 0;
  bem_surface_replace(s, &fresh);
  return bem_mesh_reserve(m, s->n);
done:
  bem_surface_destroy(&fresh);
  return status;
}
