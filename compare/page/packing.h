/* What the parts of the packed data share. */
#pragma once
#include "compare/chart.h"
#include "compare/json_maker.h"
#include "compare/page/planes.h"

enum { CMP_SERIES_ROWS = 1200 }; /* of a curve, about twice as many at most */

struct pack {
  const struct comparison *c;
  struct cmp_packer *packer;
  size_t surface_stride, point_stride, point_every;
  size_t rows_thinned; /* series */
  FILE *remarks;       /* sentences about particles that are not in the page */
  struct cmp_json_maker m;
};

static const uint16_t cmp_fine[3] = {65534, 65534, 65534};

/* The reference, and then the runs. */
static inline const struct cmp_run *cmp_packed_run(const struct pack *p, size_t i) {
  return cmp_run_or_ref(p->c, i ? i - 1 : SIZE_MAX);
}

/* The series of every run, and of experiments, as charts. */
enum status cmp_charts_pack(struct pack *p, json_t *charts);
