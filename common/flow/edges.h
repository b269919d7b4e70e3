/* Where the surface of waves meets the walls of any tank of one wall, and where its bed is level.
 */
#pragma once
#include "common/flow/flow.h"

struct flow_edges {
  double at[2][2]; /* m: the left one and the right one */
  size_t side[2];  /* segments of the wall that they are on */
};

/* At t = 0. The problem, if the water is not one body below one surface, else NULL. */
const char *flow_find_edges(const struct flow_water *w, struct flow_edges *e);

/* The same of a surface that may hang over, whose ends are on `walls` within `near`, m. */
struct flow_line;
const char *flow_line_edges(const struct geo_lines *walls, const struct flow_line *line,
                            double near, struct flow_edges *e);

struct flow_flat {
  double left, right, bed; /* m */
};

/* The level piece of the bed below x, of all the walls' points in a row at one height. False: there
 * is none. */
bool flow_find_flat(const struct case_file *c, double x, struct flow_flat *f);
