/* Distances between the free surfaces of the runs and of the reference. */
#pragma once
#include "compare/comparison.h"

/* How far the reference's surface moves: comparison.motion. */
enum status cmp_surfaces_motion(struct comparison *c);

/* run[].at of every run, as far as it says which outputs are compared. */
enum status cmp_surfaces_choose(struct comparison *c);

/* The distances in run[].at, and run[].evolution, of every run. */
enum status cmp_surfaces_measure(struct comparison *c);
