/* Everything a case file may name: the one list of solvers, and the comparator's measures. */
#pragma once
#include "common/solver.h"

extern const struct registry registry;
