/* The free surface of regions of water at t = 0: the part of their outline that is not along the
 * walls, which has kinks where the outline bends. Where the water has more than half a turn at one,
 * as at the foot of a column that stands in shallower water, its acceleration has no bound at t =
 * 0+: kinks are rounded by arcs. */
#pragma once
#include "bem/water/flow.h"
#include "common/case/case.h"
#include "common/solver.h"

struct bem_outline {
  struct geo_lines chain; /* the kinked surface from left to right, one open piece, m; owned */
  bool toe[2];            /* its left and its right end stand on a wall that goes on dry before
                             them, where a front will run along */
};

/* *problem: what this solver does not take, or NULL. ERR_MEMORY; destroy *o even then. */
enum status bem_outline_find(const struct case_file *c, struct bem_outline *o,
                             const char **problem);
void bem_outline_destroy(struct bem_outline *o);

double bem_outline_length(const struct bem_outline *o); /* m */

/* Adds a problem for a surface that was found but begins or ends on a corner of a rectangular tank,
 * or bends where it touches a wall. */
void bem_outline_check(const struct bem_outline *o, const struct case_file *c,
                       const struct case_run *r, struct problems *problems);

/* Adds a problem for a surface, from the left to the right, that between its edges is nearer than a
 * panel to a bend of the walls towards the water, which flows round it without bound. length: of
 * what is given nodes, m. */
void bem_outline_check_crests(const struct geo_lines *surface, double length,
                              const struct case_file *c, const struct case_run *r,
                              struct problems *problems);

/* Says that a run cannot have an edge of the water there. */
void bem_outline_refuse_edge(const struct case_run *r, struct problems *problems);

/* Says that a run cannot have such water. */
void bem_outline_refuse(const struct case_run *r, struct problems *problems, const char *problem);

/* Sets the surface of f at rest, with kinks rounded and its right end a thin tip if that is a toe;
 * its walls must be set. ERR_MEMORY, ERR_SOLVER. */
enum status bem_outline_start(const struct bem_outline *o, const struct case_file *c,
                              const struct case_run *r, struct bem_flow *f);
