/* How a tank and its walls move. Everything else - walls, water, surfaces, probes - is in the frame
 * of the tank, where it stands at rest; at t = 0 the walls are where the case draws them. */
#pragma once
#include <stdbool.h>

#include "common/base/geometry.h"
#include "common/base/status.h"

/* X(name, help); of the whole tank first, then of one of its sides. */
#define TANK_MOTIONS(X)                                                                            \
  X(sway, "of the whole tank, to the right")                                                       \
  X(heave, "of the whole tank, upwards")                                                           \
  X(roll, "of the whole tank about a point of it, anticlockwise, rad")                             \
  X(piston, "of one side as it is, to the right; the next piece of the bed is level, and gets "    \
            "shorter or longer")                                                                   \
  X(flap, "of what is above the hinge of one side, its top to the right, rad")

enum tank_motion_kind {
#define X(name, help) TANK_MOTION_##name,
  TANK_MOTIONS(X)
#undef X
};

/* Times and places, between which a cubic spline goes on with continuous acceleration; its end
 * conditions are those of no knot at the second row and the last but one. */
struct tank_record {
  size_t n;      /* 0, or at least TANK_LEAST_ROWS */
  double *t, *q; /* s, which increase, and m or rad, [n], owned */
  double *q_t;   /* dq/dt, m/s or rad/s, [n], owned */
};
enum { TANK_LEAST_ROWS = 4 };

struct tank_motion {
  enum tank_motion_kind kind;
  int side;        /* TANK_LEFT or TANK_RIGHT, of piston and flap */
  double about[2]; /* m, of roll, in the frame of the tank */
  double hinge;    /* m: y of the vertex that a flap turns about */
  struct {
    double amplitude, period, phase, ramp; /* m or rad; s; rad; s. An amplitude of 0: at rest */
  } sine;
  struct tank_record file; /* in place of the sine, if it has rows */
};

const char *tank_motion_name(const struct tank_motion *m);
static inline bool tank_motion_is_of_side(const struct tank_motion *m) {
  return m->kind == TANK_MOTION_piston || m->kind == TANK_MOTION_flap;
}

/* Displacement, velocity, acceleration: m or rad, and per s and s^2. A sine is
 * amplitude R(t/ramp) sin(2 pi t/period + phase) with R(s) = s^3 (10 - 15 s + 6 s^2) from 0 to 1,
 * the shortest polynomial whose first two derivatives are zero at both ends: with a ramp the motion
 * has a continuous acceleration at t = 0, before which it is at rest, and at t = ramp. */
void tank_motion_at(const struct tank_motion *m, double t, double q[3]);

/* q_t from t and q. ERR_MEMORY. */
enum status tank_record_finish(struct tank_record *r);
/* q and its first two derivatives; needs rows. */
void tank_record_at(const struct tank_record *r, double t, double q[3]);
void tank_record_destroy(struct tank_record *r);

/* Where the tank is in the frame of the laboratory: its point p is at `at` + R(angle) p, R turning
 * anticlockwise. Several sways, heaves and rolls (about one point) add up. */
struct tank_frame {
  double at[2], velocity[2], acceleration[2]; /* m, m/s, m/s^2: of the tank's origin */
  double angle, rate, turning;                /* rad, rad/s, rad/s^2 */
};
void tank_frame_at(const struct tank_motion *motions, size_t n, double t, struct tank_frame *f);

/* The acceleration that water feels in the frame of the tank at a point p that moves in it with
 * velocity u: that of gravity, turned into the frame, less those of its origin, of its turning, the
 * centrifugal and Coriolis's, m/s^2. Without motions: (0, -g). */
void tank_frame_force(const struct tank_frame *f, double gravity, const double p[2],
                      const double u[2], double force[2]);

/* The vertices of the walls at t (m, in the frame of the tank), and their velocities and
 * accelerations unless those are NULL, each [walls->points]. */
void tank_vertices_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                      double t, double (*p)[2], double (*v)[2], double (*a)[2]);

/* Where a point is at t that is on the walls at rest, within `near` (m): one of a side goes with
 * it.
 */
void tank_point_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                   double t, double near, double p[2]);

/* Whether a point, as the one that tank_point_at finds, is at t behind a side that moves, farther
 * than `near` (m). */
bool tank_hides_at(const struct geo_lines *walls, const struct tank_motion *motions, size_t n,
                   double t, double near, const double p[2]);

/* The vertices of a side: from first to last in the order of the walls, along the first or the last
 * straight stretch of the vessel. One of them is its top, the other is on the bed. False where
 * there is no vessel. */
struct tank_side {
  size_t top, foot; /* indices of vertices */
  size_t next;      /* the vertex of the bed beyond the foot; the foot itself where there is none */
};
bool tank_find_side(const struct geo_lines *walls, int side, struct tank_side *s);

/* Displacement, velocity and acceleration of a side by all motions of a kind. */
void tank_side_at(const struct tank_motion *motions, size_t n, enum tank_motion_kind kind, int side,
                  double t, double q[3]);

/* The height of the hinge of a side's flaps, which have one, m; INFINITY: there are none. */
double tank_hinge(const struct tank_motion *motions, size_t n, int side);

/* What `piston` and `flap` (displacement, velocity, acceleration each) make of the vertices of a
 * side: v and a may be NULL. */
struct tank_shift {
  double piston[3], flap[3], hinge; /* m; rad; m */
};
void tank_side_move(const struct geo_lines *walls, const struct tank_side *side,
                    const struct tank_shift *shift, double (*p)[2], double (*v)[2], double (*a)[2]);
