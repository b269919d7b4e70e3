/* The .xdmf beside a result file: the same points for ParaView older than 5.12 and for VisIt. */
#pragma once
#include <stddef.h>

#include "common/base/status.h"
#include "common/result/result.h"

struct xdmf;

/* For the result file `h5_path`; removes what an earlier run left there. */
enum status xdmf_create(const char *h5_path, struct xdmf **out);

/* One output: rows [first, first + n) of /VTKHDF/Points and of the fields. */
enum status xdmf_step(struct xdmf *x, double time, size_t first, size_t n, enum result_cells cells,
                      size_t n_fields, const struct result_field *fields);

/* Replaces the file on disk in one go; skipped until enough is new unless `last`. ERR_IO. */
enum status xdmf_write(struct xdmf *x, bool last);
void xdmf_remove(struct xdmf *x);  /* from the disk, if it is there; NULL is fine */
void xdmf_destroy(struct xdmf *x); /* NULL is fine */
