#include "bem/spin.h"

/* Integrals over the walls under water of chi d psi_chi, and of r^2/4 r dn. */
static void add_walls(const struct bem_flow *f, const struct bem_rule *wet, double *own,
                      double *inertia) {
  const struct bem_rigid unit = bem_motion_turn(&f->motion, 1);
  *own = *inertia = 0;
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const double complex r = wet->z[j] + f->motion.origin, dz = wet->weight[j] * wet->slope[j];
    double complex value, slope;
    bem_flux_at(&f->through, wet->xi[j], &value, &slope);
    *own += creal(value) * cimag(conj(bem_rigid_at(unit, wet->z[j])) * dz);
    *inertia += 0.25 * creal(r * conj(r)) * cimag(conj(r) * dz);
  }
}

void bem_spin_find(struct bem_flow *f, const double *state, const struct bem_rule *wet,
                   struct bem_spin *out) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  const double *x = state, *y = x + n, *phi = y + n, turn = f->motion.turn;
  double *half = f->q, *a = f->tx, *b = f->ty, own, inertia;
  add_walls(f, wet, &own, &inertia);
  for (size_t k = 0; k < n; k++) { /* r^2/2, and chi + i psi_chi */
    const double complex r = CMPLX(x[k], y[k]) + f->motion.origin;
    half[k] = 0.5 * creal(r * conj(r));
    a[k] = creal(f->known[k].unit);
    b[k] = cimag(f->known[k].unit);
  }
  const double carried = bem_surface_integral(s, phi, half);
  const double spin =
      carried + bem_surface_integral(s, phi, b) - bem_surface_integral(s, a, f->psi) + turn * own;
  const double kinetic = 0.5 * (turn * (spin - carried) - bem_surface_integral(s, phi, f->psi));
  for (size_t k = 0; k < n; k++) { /* psi in the frame */
    b[k] = f->psi[k] + turn * half[k];
    a[k] = b[k] - (f->psi[0] + turn * half[0]);
  }
  out->momentum[0] = bem_surface_integral(s, a, x);
  out->momentum[1] = bem_surface_integral(s, a, y);
  out->swing = -bem_surface_integral(s, half, b);
  for (size_t k = 0; k < n; k++) { /* r^2/4 r */
    a[k] = 0.5 * half[k] * (x[k] + creal(f->motion.origin));
    b[k] = 0.5 * half[k] * (y[k] + cimag(f->motion.origin));
  }
  out->inertia = inertia - bem_surface_integral(s, a, y) + bem_surface_integral(s, b, x);
  out->spin = spin - turn * out->inertia;
  out->kinetic = kinetic - turn * spin + 0.5 * turn * turn * out->inertia;
}

/* That of the frame's acceleration, of its angular acceleration, and centrifugal. */
double bem_spin_power(const struct bem_flow *f, const struct bem_spin *s) {
  const struct bem_motion *m = &f->motion;
  return m->push[0] * s->momentum[0] + m->push[1] * s->momentum[1] - m->turning * s->spin +
         m->turn * m->turn * s->swing;
}
