#include "cli/registry.h"

#include "bem/solver.h"
#include "compare/measure.h"
#include "exact/solver.h"
#include "sph/solver.h"

static const struct solver *const solvers[] = {&sph_solver, &bem_solver, &exact_solver};

const struct registry registry = {
    .solvers = solvers,
    .n_solvers = sizeof solvers / sizeof *solvers,
    .measures = cmp_measures,
    .n_measures = CMP_N_MEASURES,
};
