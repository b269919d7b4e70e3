#include "common/result/result_lines.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/geometry_check.h"
#include "common/result/result_hdf.h"
#include "common/result/result_series.h"

static const double MOSTLY = 0.5; /* of the width that a surface has */

/* `first` must rise from 0 to `end`. */
static enum status check_offsets(const char *what, size_t n, const size_t *first, size_t end) {
  bool good = n >= 1 && first[0] == 0 && first[n - 1] == end;
  for (size_t i = 1; good && i < n; i++) good = first[i] >= first[i - 1];
  CHECK(good, ERR_INPUT, "its dataset %s is inconsistent", what);
  return OK;
}

static enum status check_points(const char *what, size_t n, double (*p)[2]) {
  for (size_t i = 0; i < n; i++)
    CHECK(isfinite(p[i][0]) && isfinite(p[i][1]), ERR_INPUT,
          "its dataset %s is not finite at row %zu", what, i);
  return OK;
}

/* How far a piece gets to the right from its first point to its last. */
static double way_of(const struct geo_lines *l, size_t k) {
  return l->p[l->first[k + 1] - 1][0] - l->p[l->first[k]][0];
}

/* All that is measured takes the water of a surface, and the room of walls, to lie on one side. A
 * bed alone may have its chord on either. */
static enum status check_vessel(const struct geo_lines *walls) {
  const size_t k = geo_lines_vessel(walls);
  CHECK(k == walls->pieces || geo_piece_area(walls, k) > 0 || way_of(walls, k) > 0, ERR_INPUT,
        "its wall %zu of /walls has the tank on its right: a wall goes down the left side, along "
        "the bed, "
        "and up the right side",
        k);
  return OK;
}

/* A piece that is alone and goes from one side to the other; others may turn any way. */
static enum status check_side(const struct geo_lines *surface, size_t k) {
  if (surface->pieces != 1 || surface->closed[0] || surface->first[1] < 2) return OK;
  const struct geo_box box = geo_lines_box(surface);
  CHECK(-way_of(surface, 0) < MOSTLY * (box.max[0] - box.min[0]) || box.max[0] == box.min[0],
        ERR_INPUT,
        "its surface %zu goes from the right to the left: a surface has its water on its right", k);
  return OK;
}

/* Results of other programs may have none. */
static enum status read_walls(hid_t file, struct geo_lines *walls) {
  hid_t group = -1;
  size_t n = 0;
  enum status status = OK;
  if (!hdf_is_there(file, "walls")) return OK;
  ATTEMPT(hdf_open_group(file, "walls", &group));
  ATTEMPT(hdf_get_all(group, "points", H5T_NATIVE_DOUBLE, 2, &walls->points, &walls->p));
  ATTEMPT(hdf_get_all(group, "closed", H5T_NATIVE_UCHAR, 0, &walls->pieces, &walls->closed));
  ATTEMPT(hdf_get_all(group, "first_point", H5T_NATIVE_HSIZE, 0, &n, &walls->first));
  walls->piece_room = walls->pieces;
  walls->point_room = walls->points;
  if (n != walls->pieces + 1) {
    status = status_raise(ERR_INPUT, "its dataset /walls/first_point is inconsistent");
    goto done;
  }
  ATTEMPT(check_offsets("/walls/first_point", n, walls->first, walls->points));
  ATTEMPT(check_points("/walls/points", walls->points, walls->p));
  ATTEMPT(check_vessel(walls));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

/* Pieces [a, b) of the file's arrays as one container. */
static enum status cut_surface(const size_t *first_point, const unsigned char *closed,
                               double (*points)[2], size_t a, size_t b, struct geo_lines *out) {
  for (size_t k = a; k < b; k++) {
    TRY(geo_lines_begin(out, closed[k] != 0));
    for (size_t i = first_point[k]; i < first_point[k + 1]; i++)
      TRY(geo_lines_add(out, points[i][0], points[i][1]));
  }
  return OK;
}

/* Where there is one piece a surface, results of other programs need not say so. */
static enum status read_first_piece(hid_t group, size_t n_time, size_t *n, size_t **first) {
  if (hdf_is_there(group, "first_piece"))
    return hdf_get_all(group, "first_piece", H5T_NATIVE_HSIZE, 0, n, first);
  TRY(array_create(first, n_time + 1, "surfaces"));
  for (size_t k = 0; k <= n_time; k++) (*first)[k] = k;
  *n = n_time + 1;
  return OK;
}

/* Nor that all of them are open. */
static enum status read_closed(hid_t group, size_t pieces, size_t *n, unsigned char **closed) {
  if (hdf_is_there(group, "closed"))
    return hdf_get_all(group, "closed", H5T_NATIVE_UCHAR, 0, n, closed);
  *n = pieces;
  return array_create(closed, pieces, "surfaces");
}

static enum status read_surface(hid_t file, struct result_file *f) {
  hid_t group = -1;
  size_t n_time = 0, n_piece = 0, n_first_point = 0, pieces = 0, points = 0;
  size_t *first_piece = NULL, *first_point = NULL;
  unsigned char *closed = NULL;
  double(*p)[2] = NULL;
  enum status status = OK;
  if (!hdf_is_there(file, "surface") && hdf_is_there(file, "VTKHDF")) return OK;
  ATTEMPT(hdf_open_group(file, "surface", &group));
  ATTEMPT(hdf_get_all(group, "time", H5T_NATIVE_DOUBLE, 0, &n_time, &f->surface_time));
  ATTEMPT(read_first_piece(group, n_time, &n_piece, &first_piece));
  ATTEMPT(hdf_get_all(group, "first_point", H5T_NATIVE_HSIZE, 0, &n_first_point, &first_point));
  ATTEMPT(read_closed(group, n_first_point ? n_first_point - 1 : 0, &pieces, &closed));
  ATTEMPT(hdf_get_all(group, "points", H5T_NATIVE_DOUBLE, 2, &points, &p));
  if (n_piece != n_time + 1 || n_first_point != pieces + 1) {
    status =
        status_raise(ERR_INPUT, "its datasets in /surface have lengths that do not fit together");
    goto done;
  }
  ATTEMPT(result_check_times("/surface", n_time, f->surface_time));
  ATTEMPT(check_offsets("/surface/first_piece", n_piece, first_piece, pieces));
  ATTEMPT(check_offsets("/surface/first_point", n_first_point, first_point, points));
  ATTEMPT(check_points("/surface/points", points, p));
  f->surface = calloc(n_time + 1, sizeof *f->surface);
  if (!f->surface) {
    status = status_raise(ERR_MEMORY, "no memory for %zu surfaces", n_time);
    goto done;
  }
  f->n_surfaces = n_time;
  for (size_t k = 0; k < n_time; k++) {
    ATTEMPT(
        cut_surface(first_point, closed, p, first_piece[k], first_piece[k + 1], &f->surface[k]));
    ATTEMPT(check_side(&f->surface[k], k));
  }
done:
  free(first_piece);
  free(first_point);
  free(closed);
  free(p);
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_lines_read(hid_t file, struct result_file *f) {
  TRY(read_walls(file, &f->walls));
  return read_surface(file, f);
}
