/* The surface as our contract wants it: the water on the right of every piece. */
#pragma once
#include "common/base/geometry.h"
#include "import/table.h"

/* Pieces of a profile: points in a row, of one piece or, by the column `piece`, of several. One
 * whose last point is its first, to a thousandth of `spacing` (m), is closed. Open ones are turned
 * to run from left to right; closed ones below an odd number of other curves become cavities
 * (counter-clockwise), others drops. `name` and `time` are for messages. ERR_INPUT: points that are
 * not finite, a piece of one point or in one place. */
enum status import_profile(const char *name, double time, double spacing, size_t n, const double *x,
                           const double *y, const double *piece, struct geo_lines *out);

/* The contour of `field` at `level` on triangles: water is above it, or `below`. Curves end where
 * the mesh does. The longest open piece comes first. ERR_INPUT: values that are not finite, or
 * nowhere on one side of the level. */
enum status import_contour(const char *name, size_t n, const double *x, const double *y,
                           const double *field, const struct import_mesh *mesh, double level,
                           bool below, struct geo_lines *out);
