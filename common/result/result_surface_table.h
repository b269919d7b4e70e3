/* The datasets of the surfaces of a result file that is being written. Internal. */
#pragma once
#include <hdf5.h>

#include "common/base/geometry.h"
#include "common/result/result_column.h"

struct result_surface_table {
  struct hdf_column *time, *first_piece, *first_point, *closed, *points;
};

/* In a new group, /surface. */
enum status result_surface_table_create(struct hdf_columns *all, hid_t file,
                                        struct result_surface_table *s);
enum status result_surface_table_add(struct result_surface_table *s, double time,
                                     const struct geo_lines *surface);
