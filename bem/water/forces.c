#include "bem/water/forces.h"

#include <math.h>
#include <string.h>

#include "common/tank/tank.h"

/* Gauss's formula on so many cells of a side, and on those of the bed, so many for each length H or
 * depth of water: pressure on walls is smooth, and what is left of a wave there is longer. */
enum { SIDE = 8, BED = 4, LEAST = 16, POINTS = 4 };

static const double point[POINTS] = {0.06943184420297371, 0.33000947820757187, 0.66999052179242813,
                                     0.93056815579702629};
static const double weight[POINTS] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307,
                                      0.17392742256872693};

/* Integrals of p ds and s p ds along a wall, s the way from where it begins to z. */
struct load {
  double force, moment;
};

static enum status load_of(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                           double complex from, double complex to, size_t cells, struct load *out) {
  const double h = cabs(to - from) / (double)cells;
  *out = (struct load){0};
  for (size_t i = 0; i < cells; i++)
    for (int q = 0; q < POINTS; q++) {
      const double at = ((double)i + point[q]) / (double)cells;
      const double complex z = from + at * (to - from);
      double pressure;
      TRY(bem_pressure_on(p, f, state, z, &pressure));
      out->force += weight[q] * h * pressure;
      out->moment += weight[q] * h * pressure * at * cabs(to - from);
    }
  return OK;
}

static bool ends_on_bed(const struct bem_surface *s) {
  return s->right == BEM_END_BED;
}

/* Left and right side. */
static enum status sides(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                         struct load side[2]) {
  const struct bem_surface *s = &f->surface;
  side[TANK_LEFT] = side[TANK_RIGHT] = (struct load){0};
  if (bem_surface_is_closed(s)) return OK;
  const double x[2] = {s->left, s->tank}, y[2] = {state[s->n], state[2 * s->n - 1]};
  for (int i = 0; i < (ends_on_bed(s) ? 1 : 2); i++)
    TRY(load_of(p, f, state, x[i], CMPLX(x[i], y[i]), SIDE, &side[i]));
  return OK;
}

enum status bem_forces_on_sides(struct bem_pressure *p, const struct bem_flow *f,
                                const double *state, double force[2]) {
  struct load side[2];
  TRY(sides(p, f, state, side));
  force[TANK_LEFT] = -side[TANK_LEFT].force;
  force[TANK_RIGHT] = side[TANK_RIGHT].force;
  return OK;
}

static enum status find_in_box(struct bem_pressure *p, const struct bem_flow *f,
                               const double *state, struct bem_forces *out) {
  const struct bem_surface *s = &f->surface;
  const double end = ends_on_bed(s) ? state[s->n - 1] : s->tank, length = end - s->left;
  const double middle = 0.5 * f->motion.rest;
  const size_t cells = (size_t)fmax(LEAST, ceil(BED * length * fmax(1, 1 / f->level)));
  struct load side[2], bed;
  TRY(sides(p, f, state, side));
  TRY(load_of(p, f, state, s->left, end, cells, &bed));
  out->force_left = -side[TANK_LEFT].force;
  out->force_right = side[TANK_RIGHT].force;
  out->force_x = out->force_left + out->force_right;
  out->force_y = -bed.force;
  out->moment = side[TANK_LEFT].moment - side[TANK_RIGHT].moment - bed.moment -
                (s->left - middle) * bed.force;
  return OK;
}

/* Of walls of any shape: the pressure along the outward normal, which is to the right of the way
 * along them. */
static enum status find_on_walls(struct bem_pressure *p, const struct bem_flow *f,
                                 const double *state, struct bem_forces *out) {
  const struct bem_surface *s = &f->surface;
  const struct bem_rule *wet = &p->wet;
  TRY(bem_pressure_wet(p, f));
  TRY(bem_pressure_wet_sweep(p, f));
  *out = (struct bem_forces){0};
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const size_t side = wet->panel[j / BEM_RULE].side;
    const struct bem_seen at = bem_pressure_wet_point(p, f, j);
    const double pressure = bem_pressure_seen(p, f, state, &at);
    const double complex force = -I * pressure * wet->weight[j] * wet->slope[j];
    out->force_x += creal(force);
    out->force_y += cimag(force);
    out->moment += cimag(conj(wet->z[j] - 0.5 * f->motion.rest) * force);
    if (side == s->side[0]) out->force_left += creal(force);
    if (side == s->side[1]) out->force_right += creal(force);
  }
  return OK;
}

enum status bem_forces_power(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                             double *power) {
  const struct bem_rule *wet = &p->wet;
  TRY(bem_pressure_wet(p, f));
  TRY(bem_pressure_wet_sweep(p, f));
  *power = 0;
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const struct bem_rigid body = f->moving.body[wet->panel[j / BEM_RULE].side];
    const double complex dz = wet->weight[j] * wet->slope[j];
    const double out = cimag(conj(bem_rigid_at(body, wet->z[j])) * dz);
    if (out == 0) continue;
    const struct bem_seen at = bem_pressure_wet_point(p, f, j);
    *power += out * bem_pressure_seen(p, f, state, &at);
  }
  return OK;
}

void bem_forces_of_known(const struct bem_flow *f, const struct bem_rule *wet, double *kinetic,
                         double momentum[2]) {
  *kinetic = momentum[0] = momentum[1] = 0;
  for (size_t j = 0; j < BEM_RULE * wet->panels; j++) {
    const struct bem_rigid body = bem_flow_body(f, wet->panel[j / BEM_RULE].side);
    const double complex dz = wet->weight[j] * wet->slope[j];
    double complex value, slope;
    bem_flux_at(&f->through, wet->xi[j], &value, &slope);
    *kinetic += 0.5 * creal(value) * cimag(conj(bem_rigid_at(body, wet->z[j])) * dz);
    momentum[0] -= cimag(value) * creal(dz);
    momentum[1] -= cimag(value) * cimag(dz);
  }
}

enum status bem_forces_find(struct bem_pressure *p, const struct bem_flow *f, const double *state,
                            const double momentum[2], struct bem_forces *out) {
  TRY((f->surface.walls ? find_on_walls(p, f, state, out) : find_in_box(p, f, state, out)));
  out->momentum_x = momentum[0];
  out->momentum_y = momentum[1];
  return OK;
}

void bem_forces_turn(struct bem_forces *f) {
  const double left = f->force_left;
  f->force_left = -f->force_right;
  f->force_right = -left;
  f->force_x = -f->force_x;
  f->moment = -f->moment;
  f->momentum_x = -f->momentum_x;
}

/* u = d psi/dy and v = -d psi/dx; on the sides psi is their speed times the height. */
void bem_forces_momentum(const struct bem_flow *f, const double *state, double momentum[2]) {
  const struct bem_surface *s = &f->surface;
  const double *x = state, *y = x + s->n, left = y[0], right = y[s->n - 1];
  momentum[0] = bem_surface_integral(s, f->psi, x);
  momentum[1] = bem_surface_integral(s, f->psi, y);
  if (!f->motion.sides || s->walls) return;
  momentum[1] += 0.5 * (f->motion.side[TANK_LEFT][1] * left * left -
                        f->motion.side[TANK_RIGHT][1] * right * right);
}

const struct solver_diagnostic bem_force_columns[BEM_FORCE_COUNT] = {
#define X(name, units, help) {#name, units, help},
    BEM_FORCES(X)
#undef X
};

void bem_forces_in_si(const struct case_file *c, const struct bem_forces *f,
                      double value[BEM_FORCE_COUNT]) {
  const double newton = c->density * c->gravity * c->H * c->H,
               momentum = c->density * c->H * c->H * sqrt(c->gravity * c->H);
  const struct bem_forces si = {
      .force_x = newton * f->force_x,
      .force_y = newton * f->force_y,
      .moment = newton * c->H * f->moment,
      .force_left = newton * f->force_left,
      .force_right = newton * f->force_right,
      .momentum_x = momentum * f->momentum_x,
      .momentum_y = momentum * f->momentum_y,
  };
  memcpy(value, &si, sizeof si);
}
