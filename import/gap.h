/* Walls as the particles of another program keep away from them. */
#pragma once
#include "common/base/geometry.h"

/* The walls moved into the water by `gap` (m), parallel to themselves; `gap` 0: a copy. ERR_INPUT:
 * there is no such line. */
enum status import_gap(const struct geo_lines *walls, double gap, struct geo_lines *out);
