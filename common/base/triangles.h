/* Triangles between points of the plane. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"

/* Their Delaunay triangulation, found by GEOS: a robust one, of as many equal distances as a
 * lattice has. Points are all different. *corner: three points each, counter-clockwise, the
 * caller's to free. Slivers along the hull of the points may be missing. ERR_MEMORY,
 * ERR_SOLVER. */
enum status geo_triangulate(size_t points, const double (*p)[2], size_t *triangles,
                            size_t (**corner)[3]);

/* Twice the area of a triangle, m^2, positive when counter-clockwise. */
static inline double geo_triangle_cross(const double a[2], const double b[2], const double c[2]) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}
