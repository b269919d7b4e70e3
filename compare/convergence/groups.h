/* Which runs of a comparison make a group. */
#pragma once
#include "compare/convergence/convergence.h"

/* Groups with their members, without rows. */
enum status cmp_groups_find(const struct comparison *c, struct cmp_convergence *v);
