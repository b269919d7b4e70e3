#include "bem/start/drawn.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"

enum { REPEATS = 4 }; /* of placing the nodes, of which each depends on its neighbours */

/* Nodes at ways along the line (m, [n]); in the place of the potential they carry the way. */
static void set_nodes(const struct case_file *c, const struct flow_line *line, const double *way,
                      struct bem_surface *s) {
  double *x = s->state, *y = x + s->n, *carried = y + s->n;
  for (size_t k = 0; k < s->n; k++) {
    const struct flow_line_point at = flow_line_at(line, way[k]);
    x[k] = (at.p[0] - c->tank.min[0]) / c->H;
    y[k] = (at.p[1] - c->tank.min[1]) / c->H;
    carried[k] = way[k];
  }
}

/* Gives them their potential instead. */
static void finish(const struct case_file *c, const struct flow_line *line, struct bem_surface *s) {
  double *x = s->state, *y = x + s->n, *phi = y + s->n;
  for (size_t k = 0; k < s->n; k++)
    phi[k] = flow_line_at(line, phi[k]).phi / (c->H * sqrt(c->gravity * c->H));
  if (!bem_surface_is_closed(s)) return;
  x[s->n - 1] = x[0] + s->period.length;
  y[s->n - 1] = y[0];
  phi[s->n - 1] = phi[0];
}

enum status bem_drawn_start(const struct case_file *c, const struct flow_line *line,
                            struct bem_flow *f) {
  struct bem_surface *s = &f->surface;
  double *way = NULL;
  size_t n;
  enum status status = flow_line_sample(line, 0, c->H / f->mesh.resolution, &n, &way);
  ATTEMPT(status);
  ATTEMPT(bem_surface_reserve(s, n));
  set_nodes(c, line, way, s);
  for (int i = 0; i < REPEATS; i++) {
    ATTEMPT(bem_mesh_regrid(&f->mesh, s));
    ATTEMPT(array_resize(&way, s->n, "nodes of a surface"));
    for (size_t k = 0; k < s->n; k++) way[k] = s->state[2 * s->n + k];
    set_nodes(c, line, way, s);
  }
  finish(c, line, s);
done:
  free(way);
  return status;
}
