/* Points over time in the public VTKHDF layout (PolyData, version 2.0, temporal), which
 * ParaView 5.12 and later open as they are.
 * https://docs.vtk.org/en/latest/vtk_file_formats/vtkhdf_file_format/ */
#pragma once
#include <hdf5.h>

#include "common/base/status.h"
#include "common/result/result.h"
#include "common/result/result_column.h"

struct vtkhdf;

/* Creates /VTKHDF in `root` for points that carry these fields at every output; its datasets belong
 * to `columns`. */
enum status vtkhdf_create(hid_t root, struct hdf_columns *columns, enum result_cells cells,
                          size_t n_fields, const struct result_field *fields, struct vtkhdf **out);

/* One output; *first is the row of /VTKHDF/Points where it begins. */
enum status vtkhdf_step(struct vtkhdf *v, double time, size_t n, const double *x, const double *y,
                        const struct result_field *fields, size_t *first);
void vtkhdf_destroy(struct vtkhdf *v); /* NULL is fine */
