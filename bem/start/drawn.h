/* A surface that the flow draws as a line, which may hang over: nodes on it. */
#pragma once
#include "bem/water/flow.h"
#include "common/case/case.h"
#include "common/flow/line.h"

/* Sets the nodes of f->surface, whose tank, ends and period are known, where the mesh wants them.
 */
enum status bem_drawn_start(const struct case_file *c, const struct flow_line *line,
                            struct bem_flow *f);
