/* A surface as a line in the plane, which may hang over: from the left to the right with the water
 * on its right hand. Cubic splines of x, y and the potential go through its rows; what they are
 * functions of is the way along the chords between the rows. */
#pragma once
#include "common/base/geometry.h"
#include "common/tank/motion.h"

struct flow_line {
  struct tank_record x, y, phi; /* m, m, m^2/s over the way, m; phi without rows: at rest */
  double from, to;              /* the way at either end, m; a period has rows beyond them */
};

void flow_line_destroy(struct flow_line *l);

/* Of n rows, from theirs on (each [n]; u NULL: at rest; v NULL: u is the potential, else the
 * velocity along which it is found), or, with `round`, of a period that goes on at either side.
 * ERR_MEMORY. */
struct flow_rows {
  size_t n;
  const double *x, *y, *u, *v; /* m, m, m^2/s or m/s, m/s */
};
enum status flow_line_create(const struct flow_rows *rows, bool round, struct flow_line *l);

/* Makes the period of `length` begin at x = left, wherever its rows began; false: it passes there
 * several times. */
bool flow_line_turn(struct flow_line *l, double left, double length);

/* A point of it, and the slopes of x, y and phi over the way. */
struct flow_line_point {
  double p[2], phi, slope[3]; /* m, m^2/s; -, -, m/s */
};
struct flow_line_point flow_line_at(const struct flow_line *l, double way);

/* The highest point above x; -INFINITY: there is none. */
double flow_line_top(const struct flow_line *l, double x);

/* Ways from end to end: those of the rows but for such as are nearer than `shortest` to the one
 * before, and of points between, none farther than `longest` from the next. *way is the caller's.
 * ERR_MEMORY. */
enum status flow_line_sample(const struct flow_line *l, double shortest, double longest, size_t *n,
                             double **way);

/* phi at rows over t along the surface (x, y), where u and v are the velocity, by Simpson's rule
 * between them: fourth order. What it gains in a period is an error of the rows or a current, and
 * spread evenly if it is little. */
struct flow_way {
  struct tank_record x, y, u, v;
};
void flow_way_integrate(const struct flow_way *w, bool round, double *phi);
