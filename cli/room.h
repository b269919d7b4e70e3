/* Whether there is memory for what is to be done, asked before any of it is taken. */
#pragma once
#include "common/base/status.h"
#include "common/case/case.h"

/* Memory that this process may still take, bytes, and in words what sets that limit. */
double room_available(const char **limit);

/* Memory that this process and its children may still take together, bytes. */
double room_for_all(void);

/* Adds a problem when run `r` needs more than that. */
void room_check(const struct case_run *r, const struct solver_estimate *e,
                struct problems *problems);

/* Makes OpenBLAS take the buffer of 128 MB that it keeps for all its work: asked later, it would
 * ask a system without memory for ever. ERR_MEMORY when there is no room for it. */
enum status room_take_for_blas(void);
