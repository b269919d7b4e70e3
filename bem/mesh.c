#include "bem/mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "bem/spline.h"

/* The wanted number of nodes per H, divided by the resolution, is the root of the sum of squares of
 * 1, curvature/BEND and 1/(tip + GROWTH d), d the distance along the surface to the thin tip: a
 * function of the shape alone, so refining the resolution refines everything alike. */
static const double BEND = 4, SHARPEST = 60; /* 1/H; curvature beyond SHARPEST asks for no more */
static const double GROWTH = 6;              /* 1/H */
static const double SPREAD = 3;              /* implicit smoothing, over about sqrt(3) panels */
static const double RELAX = 0.1;             /* sqrt(H/g), in which misplaced nodes drift home */
static const double OPEN = 0.15;             /* rad: a kink that turns less is not one any more */
static const size_t FEWEST = 7;              /* nodes of a piece */

enum status bem_mesh_reserve(struct bem_mesh *m, size_t n) {
  if (n <= m->room) return OK;
  double *scratch = malloc(10 * n * sizeof *scratch);
  CHECK(scratch, ERR_MEMORY, "no memory for a mesh of %zu nodes", n);
  free(m->scratch);
  m->scratch = scratch;
  m->room = n;
  return OK;
}

void bem_mesh_destroy(struct bem_mesh *m) {
  free(m->scratch);
  *m = (struct bem_mesh){0};
}

/* Density of nodes wanted on every panel, 1/H. dx, dy: d/di; work: [3n]. */
static void density(const struct bem_mesh *m, const struct bem_surface *s, const double *x,
                    const double *y, double *dx, double *dy, double *work, double *rho) {
  const size_t n = s->n;
  double *ddx = work, *ddy = work + n, *upper = work + 2 * n;
  bem_surface_differences(n, s->corner, x, dx, ddx);
  bem_surface_differences(n, s->corner, y, dy, ddy);
  double *bend = ddx; /* squared curvature, overwrites what it is made of */
  for (size_t k = 0; k < n; k++) {
    double speed = hypot(dx[k], dy[k]);
    double c = (dx[k] * ddy[k] - dy[k] * ddx[k]) / (speed * speed * speed);
    c *= bem_surface_importance(s, x[k], y[k]);
    bend[k] = c * c / (1 + c * c / (SHARPEST * SHARPEST));
  }
  double distance = 0;
  for (size_t j = n - 1; j-- > 0;) {
    double l = hypot(x[j + 1] - x[j], y[j + 1] - y[j]);
    double near = s->tip > 0 ? 1 / (s->tip + GROWTH * (distance + 0.5 * l)) : 0;
    rho[j] = sqrt(1 + 0.5 * (bend[j] + bend[j + 1]) / (BEND * BEND) + near * near);
    distance += l;
  }
  for (size_t j = 0; j + 1 < n;
       j++) { /* (1 - SPREAD delta^2) smooth = rough, nothing lost at ends */
    double side = (j > 0 ? SPREAD : 0) + (j + 2 < n ? SPREAD : 0), low = j > 0 ? SPREAD : 0;
    double pivot = 1 + side - (j > 0 ? low * upper[j - 1] : 0);
    upper[j] = SPREAD / pivot;
    rho[j] = (rho[j] + (j > 0 ? low * rho[j - 1] : 0)) / pivot;
  }
  for (size_t j = n - 2; j-- > 0;) rho[j] += upper[j] * rho[j + 1];
  for (size_t j = 0; j + 1 < n; j++) rho[j] *= m->resolution;
}

/* On the piece from node a to node b: keeps the number of nodes up to each point, counted by
 * density, at its share of the whole. */
static void piece_velocity(size_t a, size_t b, const double *x, const double *y, const double *u,
                           const double *v, const double *rho, double *q) {
  double whole = 0, growth = 0;
  for (size_t j = a; j < b; j++) {
    double lx = x[j + 1] - x[j], ly = y[j + 1] - y[j], l = hypot(lx, ly);
    whole += rho[j] * l;
    growth += rho[j] * (lx * (u[j + 1] - u[j]) + ly * (v[j + 1] - v[j])) / l;
  }
  double count = 0, stretch = 0;
  q[a] = q[b] = 0;
  for (size_t j = a; j + 1 < b; j++) {
    double lx = x[j + 1] - x[j], ly = y[j + 1] - y[j], l = hypot(lx, ly);
    count += rho[j] * l;
    stretch += rho[j] * (lx * (u[j + 1] - u[j]) + ly * (v[j + 1] - v[j])) / l;
    double share = (double)(j + 1 - a) / (double)(b - a);
    q[j + 1] = (share * growth - stretch + (share * whole - count) / RELAX) /
               (0.5 * (rho[j] + rho[j + 1]));
  }
}

void bem_mesh_velocity(struct bem_mesh *m, const struct bem_surface *s, const double *state,
                       const double *u, const double *v, double *tx, double *ty, double *q) {
  const size_t n = s->n;
  const double *x = state, *y = state + n;
  double *rho = m->scratch;
  density(m, s, x, y, tx, ty, m->scratch + n, rho);
  for (size_t k = 0; k < n; k++) {
    double speed = hypot(tx[k], ty[k]);
    tx[k] /= speed;
    ty[k] /= speed;
  }
  if (s->corner) piece_velocity(0, s->corner, x, y, u, v, rho, q);
  piece_velocity(s->corner, n - 1, x, y, u, v, rho, q);
}

static double kink(const struct bem_surface *s) {
  const double *x = s->state + s->corner, *y = x + s->n;
  return fabs(
      remainder(atan2(y[1] - y[0], x[1] - x[0]) - atan2(y[0] - y[-1], x[0] - x[-1]), 2 * M_PI));
}

bool bem_mesh_is_poor(struct bem_mesh *m, const struct bem_surface *s) {
  const size_t n = s->n;
  const double *x = s->state, *y = x + n;
  double *rho = m->scratch;
  if (s->corner && kink(s) < OPEN) return true;
  density(m, s, x, y, m->scratch + 4 * n, m->scratch + 5 * n, m->scratch + n, rho);
  for (size_t a = 0; a < n - 1;) {
    size_t b = s->corner > a ? s->corner : n - 1;
    double whole = 0, most = 0;
    for (size_t j = a; j < b; j++) {
      double share = rho[j] * hypot(x[j + 1] - x[j], y[j + 1] - y[j]);
      whole += share;
      most = fmax(most, share);
    }
    double ratio = whole / (double)(b - a);
    if (ratio > 1.25 || (ratio < 0.6 && b - a >= FEWEST) || most > 2.5) return true;
    a = b;
  }
  return false;
}

enum status bem_mesh_regrid(struct bem_mesh *m, struct bem_surface *s) {
  if (s->corner && kink(s) < OPEN) s->corner = 0;
  const size_t n = s->n;
  TRY(bem_mesh_reserve(m, n));
  double *rho = m->scratch, *arc = rho + n, *second = arc + n, *work = second + 2 * n;
  const double *x = s->state, *y = x + n;
  density(m, s, x, y, second, second + n, work, rho);

  size_t end[2] = {s->corner ? s->corner : n - 1, n - 1}, pieces = s->corner ? 2 : 1;
  size_t fresh[2] = {0, 0}, total = 1;
  arc[0] = 0;
  for (size_t i = 0, a = 0; i < pieces; a = end[i++]) {
    double whole = 0;
    for (size_t j = a; j < end[i]; j++) {
      double l = hypot(x[j + 1] - x[j], y[j + 1] - y[j]);
      arc[j + 1] = arc[j] + l;
      whole += rho[j] * l;
    }
    CHECK(whole < BEM_MOST_NODES, ERR_SOLVER,
          "the surface asks for %.3g nodes, more than %d: it has become too rough, or the "
          "resolution is too high",
          whole, BEM_MOST_NODES);
    fresh[i] = (size_t)fmax(ceil(whole), (double)FEWEST);
    total += fresh[i];
  }
  struct bem_surface old = *s;
  s->state = NULL;
  s->room = 0;
  enum status status = bem_surface_reserve(s, total + total / 4);
  if (status != OK) {
    *s = old;
    return status;
  }
  s->n = total;
  for (size_t i = 0, a = 0, to = 0; i < pieces; to += fresh[i], a = end[i++]) {
    size_t nodes = end[i] - a + 1;
    double whole = 0;
    for (size_t j = a; j < end[i]; j++) whole += rho[j] * (arc[j + 1] - arc[j]);
    for (int field = 0; field < 3; field++) {
      const double *f = old.state + (size_t)field * n + a;
      double *out = s->state + (size_t)field * total + to;
      bem_spline_fit(nodes, arc + a, f, second, work);
      double count = 0;
      size_t j = a, from = 0;
      for (size_t k = 1; k < fresh[i]; k++) {
        double wanted = whole * (double)k / (double)fresh[i], here;
        while (count + (here = rho[j] * (arc[j + 1] - arc[j])) < wanted && j + 1 < end[i]) {
          count += here;
          j++;
        }
        out[k] =
            bem_spline_value(nodes, arc + a, f, second, arc[j] + (wanted - count) / rho[j], &from);
      }
      out[0] = f[0];
      out[fresh[i]] = f[nodes - 1];
    }
  }
  if (s->corner) s->corner = fresh[0];
  free(old.state);
  return bem_mesh_reserve(m, total);
}
