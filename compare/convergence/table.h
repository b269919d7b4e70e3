/* The numbers of all groups as one long table. */
#pragma once
#include "compare/convergence/convergence.h"

/* Writes the file `path`, a line for every run of every row; removes it when there are no groups. */
enum status cmp_convergence_table(const struct comparison *c, const struct cmp_convergence *v,
                                  const char *path);
