/* GEOS as one object, whose faults are kept until it ends. */
#pragma once
#include <geos_c.h>
#include <stdbool.h>

#include "common/base/status.h"

struct geo_geos {
  GEOSContextHandle_t h; /* owned; NULL: failed */
  bool failed;
  char message[160]; /* GEOS' own, of its first fault */
};

/* *g is not to be moved before it ends. */
void geo_geos_begin(struct geo_geos *g);

/* Frees it. If it failed: ERR_SOLVER, with what GEOS says of it, or ERR_MEMORY when it says
 * nothing. `task` is what it was to do. */
enum status geo_geos_end(struct geo_geos *g, const char *task);
