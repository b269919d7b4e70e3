/* Released columns at random, the same in every program: columns of 0.5 to 4 H in tanks of 1.2 to
 * 12 H, evenly in the logarithm, and a share of the way from the coarsest to the finest mesh. */
#pragma once
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct column {
  double wide, tank; /* H */
  double share;      /* 0 to 1 */
};

static const char column_text[] =
    "title: column\n"
    "fluid: {density: 1, gravity: 1}\n"
    "scales: {H: 1}\n"
    "tank: {walls: [[[0, 6], [0, 0], [%.6f, 0], [%.6f, 6]]]}\n"
    "water: {regions: [[[0, 0], [%.6f, 0], [%.6f, 1], [0, 1]]], pressure: released}\n"
    "time: {end: %.3f, every: 0.5, sample: 0.05}\n"
    "runs: [{name: bem, solver: bem, resolution: %.0f}]\n";

static inline double column_between(unsigned short seed[3], double least, double most) {
  return least * pow(most / least, erand48(seed));
}

/* The n-th column, from 0; there is a gap of at least a tenth of H. */
static inline struct column column_at(int n) {
  unsigned short seed[3] = {1, 2, 3};
  struct column c = {0};
  for (int i = 0; i <= n; i++) {
    do {
      c.wide = column_between(seed, 0.5, 4);
      c.tank = column_between(seed, 1.2, 12);
    } while (c.tank < c.wide + 0.1);
    c.share = erand48(seed);
  }
  return c;
}

/* The end leaves time for the front to come to the wall, the jet to fall, and waves to go to and
 * fro. */
static inline void column_write(char with[sizeof column_text + 100], const struct column *c,
                                double resolution) {
  snprintf(with, sizeof column_text + 100, column_text, c->tank, c->tank, c->wide, c->wide,
           8 + c->tank, resolution);
}
