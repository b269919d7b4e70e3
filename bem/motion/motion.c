#include "bem/motion/motion.h"

#include <math.h>
#include <string.h>

#include "common/tank/tank.h"

static const double TOP = 2; /* of the walls' height: far enough above water in them */

struct bem_motion bem_motion_create(const struct case_file *c) {
  struct bem_motion m = {.c = c, .scale = sqrt(c->H / c->gravity)};
  for (size_t i = 0; i < c->n_motions; i++)
    if (tank_motion_is_of_side(&c->motions[i]))
      m.sides = true;
    else
      m.frame = true, m.rolls |= c->motions[i].kind == TANK_MOTION_roll;
  m.rest = (c->tank.max[0] - c->tank.min[0]) / c->H;
  m.side[TANK_RIGHT][0] = m.rest;
  m.origin = CMPLX(c->tank.min[0], c->tank.min[1]) / c->H;
  m.top = TOP * (c->tank.max[1] - c->tank.min[1]) / c->H;
  return m;
}

static void frame_at(struct bem_motion *m, double time) {
  struct tank_frame frame;
  tank_frame_at(m->c->motions, m->c->n_motions, time * m->scale, &frame);
  for (int axis = 0; axis < 2; axis++) m->push[axis] = -frame.acceleration[axis] / m->c->gravity;
  if (!m->rolls) return;
  const double complex felt = CMPLX(m->push[0], m->push[1] - 1) * cexp(-I * frame.angle);
  m->push[0] = creal(felt);
  m->push[1] = cimag(felt) + 1;
  m->turn = frame.rate * m->scale;
  m->turning = frame.turning * m->scale * m->scale;
}

void bem_motion_at(struct bem_motion *m, double time) {
  const struct case_file *c = m->c;
  if (m->frame) frame_at(m, time);
  for (int side = 0; m->sides && side < 2; side++) {
    double q[3];
    tank_side_at(c->motions, c->n_motions, TANK_MOTION_piston, side, time * m->scale, q);
    m->side[side][0] = (side == TANK_RIGHT ? m->rest : 0) + q[0] / c->H;
    m->side[side][1] = q[1] * m->scale / c->H;
    m->side[side][2] = q[2] / c->gravity;
  }
}

void bem_motion_stop_short(struct bem_motion *m) {
  const double beyond[3] = {2 * m->rest};
  memcpy(m->side[TANK_RIGHT], beyond, sizeof beyond);
}

void bem_motion_velocity(const struct bem_motion *m, double time, double velocity[2]) {
  struct tank_frame frame;
  tank_frame_at(m->c->motions, m->c->n_motions, time * m->scale, &frame);
  const double complex along = CMPLX(frame.velocity[0], frame.velocity[1]) * cexp(-I * frame.angle);
  velocity[0] = creal(along) * m->scale / m->c->H;
  velocity[1] = cimag(along) * m->scale / m->c->H;
}

struct bem_part bem_motion_part(const struct bem_motion *m, double complex z) {
  const double *left = m->side[TANK_LEFT], *right = m->side[TANK_RIGHT];
  const double length = right[0] - left[0], growth = right[1] - left[1];
  const double complex a = right[0] - z, b = z - left[0];
  return (struct bem_part){
      .beta = (right[1] * b * b - left[1] * a * a) / (2 * length),
      .w = (left[1] * a + right[1] * b) / length,
      .rate = (right[2] * b * b - left[2] * a * a) / (2 * length) -
              right[1] * left[1] * (a + b) / length +
              growth * (left[1] * a * a - right[1] * b * b) / (2 * length * length),
  };
}

/* On a side phi is that at its foot and a square of the height, and dphi/dn the side's speed. */
double bem_motion_kinetic(const struct bem_motion *m, const double height[2]) {
  double sum = 0;
  for (int side = 0; side < 2; side++) {
    const double out = side == TANK_RIGHT ? m->side[side][1] : -m->side[side][1];
    const double h = height[side], foot = m->side[side][0];
    /* by Simpson's rule, exact for a square */
    const double low = creal(bem_motion_part(m, foot).beta),
                 middle = creal(bem_motion_part(m, CMPLX(foot, h / 2)).beta),
                 high = creal(bem_motion_part(m, CMPLX(foot, h)).beta);
    sum += 0.5 * out * h * (low + 4 * middle + high) / 6;
  }
  return sum;
}
