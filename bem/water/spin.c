#include "bem/water/spin.h"

/* Integrals over the walls under water. */
struct walls {
  double own;                /* chi d psi of the known part */
  double inertia;            /* r^2/4 r dn */
  double momentum[2], swing; /* psi in the frame, less that of the first node, dz; r^2/2 u dn */
};

/* chi + i psi_chi of the tank that turns at the rate of one. */
static const struct bem_flux *unit_of(const struct bem_pressure *p, const struct bem_flow *f) {
  return f->motion.sides ? &p->unit : &f->through;
}

static enum status set_unit(struct bem_pressure *p, const struct bem_flow *f) {
  const struct bem_conformal *walls = f->surface.walls;
  struct bem_rigid body[BEM_MOST_BENDS + 1];
  if (!f->motion.sides) return OK;
  for (size_t i = 0; i <= walls->n; i++) body[i] = bem_motion_turn(&f->motion, 1);
  return bem_flux_set(&p->unit, walls, body, f->motion.top);
}

/* What sides that move have besides. psi: at the first node, in the frame. */
static void add_sides(const struct bem_flow *f, const struct bem_rule *wet, size_t j, double psi,
                      struct walls *sum) {
  const double complex r = wet->z[j] + f->motion.origin, dz = wet->weight[j] * wet->slope[j];
  const double half = 0.5 * creal(r * conj(r));
  const struct bem_rigid body = f->moving.body[wet->panel[j / BEM_RULE].side];
  double complex value, slope;
  bem_flux_at(&f->through, wet->xi[j], &value, &slope);
  const double here = cimag(value) + f->motion.turn * half - psi;
  sum->momentum[0] -= here * creal(dz);
  sum->momentum[1] -= here * cimag(dz);
  sum->swing += half * cimag(conj(bem_rigid_at(body, wet->z[j])) * dz);
}

static struct walls sum_walls(const struct bem_pressure *p, const struct bem_flow *f, double psi) {
  const struct bem_rule *wet = &p->wet;
  const struct bem_rigid unit = bem_motion_turn(&f->motion, 1);
  struct walls sum = {0};
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const double complex r = wet->z[j] + f->motion.origin, dz = wet->weight[j] * wet->slope[j];
    const struct bem_rigid body =
        f->motion.sides ? bem_flow_body(f, wet->panel[j / BEM_RULE].side) : unit;
    double complex value, slope;
    bem_flux_at(unit_of(p, f), wet->xi[j], &value, &slope);
    sum.own += creal(value) * cimag(conj(bem_rigid_at(body, wet->z[j])) * dz);
    sum.inertia += 0.25 * creal(r * conj(r)) * cimag(conj(r) * dz);
    if (f->motion.sides) add_sides(f, wet, j, psi, &sum);
  }
  if (!f->motion.sides) sum.own *= f->motion.turn;
  return sum;
}

/* r^2/2, and chi + i psi_chi, at the nodes. */
static void set_nodes(const struct bem_pressure *p, const struct bem_flow *f, const double *state) {
  const size_t n = f->surface.n;
  for (size_t k = 0; k < n; k++) {
    const double complex r = CMPLX(state[k], state[n + k]) + f->motion.origin;
    double complex unit = f->known[k].unit, slope;
    if (f->motion.sides) bem_flux_at(&p->unit, f->panels.zeta[k], &unit, &slope);
    f->q[k] = 0.5 * creal(r * conj(r));
    f->tx[k] = creal(unit);
    f->ty[k] = cimag(unit);
  }
}

enum status bem_spin_find(struct bem_pressure *p, struct bem_flow *f, const double *state,
                          double kinetic, struct bem_spin *out) {
  const struct bem_surface *s = &f->surface;
  const size_t n = s->n;
  const double *x = state, *y = x + n, *phi = y + n, turn = f->motion.turn;
  double *half = f->q, *a = f->tx, *b = f->ty;
  TRY(bem_pressure_wet(p, f));
  TRY(set_unit(p, f));
  set_nodes(p, f, state);
  const struct walls walls = sum_walls(p, f, f->psi[0] + turn * half[0]);
  const double carried = bem_surface_integral(s, phi, half);
  const double spin =
      carried + bem_surface_integral(s, phi, b) - bem_surface_integral(s, a, f->psi) + walls.own;
  if (!f->motion.sides)
    kinetic = 0.5 * (turn * (spin - carried) - bem_surface_integral(s, phi, f->psi));
  for (size_t k = 0; k < n; k++) { /* psi in the frame */
    b[k] = f->psi[k] + turn * half[k];
    a[k] = b[k] - (f->psi[0] + turn * half[0]);
  }
  out->momentum[0] = walls.momentum[0] + bem_surface_integral(s, a, x);
  out->momentum[1] = walls.momentum[1] + bem_surface_integral(s, a, y);
  out->swing = walls.swing - bem_surface_integral(s, half, b);
  for (size_t k = 0; k < n; k++) { /* r^2/4 r */
    a[k] = 0.5 * half[k] * (x[k] + creal(f->motion.origin));
    b[k] = 0.5 * half[k] * (y[k] + cimag(f->motion.origin));
  }
  out->inertia = walls.inertia - bem_surface_integral(s, a, y) + bem_surface_integral(s, b, x);
  out->spin = spin - turn * out->inertia;
  out->kinetic = kinetic - turn * spin + 0.5 * turn * turn * out->inertia;
  return OK;
}

/* That of the frame's acceleration, of its angular acceleration, and centrifugal. */
double bem_spin_power(const struct bem_flow *f, const struct bem_spin *s) {
  const struct bem_motion *m = &f->motion;
  return m->push[0] * s->momentum[0] + m->push[1] * s->momentum[1] - m->turning * s->spin +
         m->turn * m->turn * s->swing;
}
