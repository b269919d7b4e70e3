#include "cli/registry.h"

#include "bem/solver.h"
#include "common/wave_solver.h"
#include "sph/solver.h"

static const struct solver *const solvers[] = {&bem_solver, &sph_solver, &wave_solver};

const struct registry registry = {
    .solvers = solvers,
    .n_solvers = sizeof solvers / sizeof *solvers,
};
