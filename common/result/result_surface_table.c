#include "common/result/result_surface_table.h"

#include "common/result/result_hdf.h"
#include "common/result/result_table.h"

enum { POINT_ROWS = 4096 }; /* of a chunk */

enum status result_surface_table_create(struct hdf_columns *all, hid_t file,
                                        struct result_surface_table *s) {
  static const size_t zero = 0;
  const struct hdf_rows times = {H5T_NATIVE_DOUBLE, 0, RESULT_ROWS},
                        counts = {H5T_NATIVE_HSIZE, 0, RESULT_ROWS},
                        flags = {H5T_NATIVE_UCHAR, 0, RESULT_ROWS},
                        points = {H5T_NATIVE_DOUBLE, 2, POINT_ROWS};
  hid_t group = -1;
  enum status status = OK;
  ATTEMPT(hdf_group_create(file, "surface", &group));
  ATTEMPT(hdf_column_create(all, group, "time", &times, "s", "time of each surface", &s->time));
  ATTEMPT(hdf_column_create(all, group, "first_piece", &counts, "1",
                            "first piece of each surface, and the end of the last",
                            &s->first_piece));
  ATTEMPT(hdf_column_create(all, group, "first_point", &counts, "1",
                            "first row of points of each piece, and the end of the last",
                            &s->first_point));
  ATTEMPT(hdf_column_create(all, group, "closed", &flags, "1",
                            "1 where the last point of a piece joins its first", &s->closed));
  ATTEMPT(hdf_column_create(all, group, "points", &points, "m", "x, y; the water lies on the right",
                            &s->points));
  ATTEMPT(hdf_column_append(s->first_piece, 1, &zero));
  ATTEMPT(hdf_column_append(s->first_point, 1, &zero));
done:
  if (group >= 0) H5Gclose(group);
  return status;
}

enum status result_surface_table_add(struct result_surface_table *s, double time,
                                     const struct geo_lines *surface) {
  size_t n_pieces = hdf_column_length(s->closed);
  size_t n_points = hdf_column_length(s->points);
  TRY(hdf_column_append(s->points, surface->points, surface->p));
  TRY(hdf_column_append(s->closed, surface->pieces, surface->closed));
  for (size_t k = 0; k < surface->pieces; k++) {
    size_t end = n_points + surface->first[k + 1];
    TRY(hdf_column_append(s->first_point, 1, &end));
  }
  size_t end = n_pieces + surface->pieces;
  TRY(hdf_column_append(s->first_piece, 1, &end));
  return hdf_column_append(s->time, 1, &time);
}
