#include "bem/breaking/replace.h"

#include <string.h>

enum status bem_replace(struct bem_flow *f, size_t from, size_t to, size_t m,
                        double point[][BEM_FIELDS]) {
  struct bem_surface *s = &f->surface, fresh = {0};
  const size_t rest = s->n - to;
  TRY(bem_surface_follow(&fresh, s, from + m + rest));
  for (size_t field = 0; field < BEM_FIELDS; field++) {
    const double *is = s->state + field * s->n;
    double *becomes = fresh.state + field * fresh.n;
    memcpy(becomes, is, from * sizeof *is);
    for (size_t i = 0; i < m; i++) becomes[from + i] = point[i][field];
    memcpy(becomes + from + m, is + to, rest * sizeof *is);
  }
  if (s->corner >= from) fresh.corner = s->corner < to ? 0 : s->corner - (to - from) + m;
  bem_surface_replace(s, &fresh);
  return bem_mesh_regrid(&f->mesh, s);
}

double bem_replace_potential(const struct bem_flow *f, const size_t carrier[BEM_CARRIERS],
                             double complex z) {
  const double *x = f->surface.state, *y = x + f->surface.n, *phi = y + f->surface.n;
  double complex beta = 0;
  for (int a = 0; a < BEM_CARRIERS; a++) {
    double complex term = CMPLX(phi[carrier[a]], f->psi[carrier[a]]);
    for (int b = 0; b < BEM_CARRIERS; b++)
      if (b != a)
        term *= (z - CMPLX(x[carrier[b]], y[carrier[b]])) /
                CMPLX(x[carrier[a]] - x[carrier[b]], y[carrier[a]] - y[carrier[b]]);
    beta += term;
  }
  return creal(beta);
}
