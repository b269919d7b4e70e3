/* Small bodies of water for the tests: cases written as text, as a user would. */
#pragma once
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "common/case/case.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/rates.h"
#include "sph/solver.h"
#include "sph/sph.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"

/* The case of a text whose run is made of `run` (what follows "solver: sph, "). */
static inline struct case_file *pool_case(const char *head, const char *run) {
  static const struct solver *const solvers[] = {&sph_solver};
  const struct registry registry = {.solvers = solvers, .n_solvers = 1};
  char text[4000];
  snprintf(text, sizeof text, "%s\nruns:\n  - {name: r, solver: sph, %s}\n", head, run);
  struct problems problems = {0};
  struct case_file *c = NULL;
  if (case_parse("pool", text, &registry, &problems, &c) != OK) {
    for (size_t k = 0; k < problems.n; k++) fprintf(stderr, "%s\n", problems.text[k]);
    fprintf(stderr, "%s\n", status_message());
    exit(1);
  }
  problems_destroy(&problems);
  return c;
}

static inline struct sph *pool_create(const struct case_file *c) {
  struct sph *s;
  if (sph_create(c, c->runs[0].resolution, c->runs[0].options, &s) != OK) {
    fprintf(stderr, "%s\n", status_message());
    exit(1);
  }
  return s;
}

/* Downwards, m s^-2. */
static inline void pool_set_gravity(struct sph *s, double g) {
  s->g = s->eos.g = g;
  s->force.g[1] = -g;
  sph_force_set(s, 0);
}

/* The next step on the way to t (s), without treatments. */
static inline enum status pool_step(struct sph *s, double t) {
  TRY(sph_remove_outside(s));
  TRY(sph_rates(s, 0, true, true));
  double dt = sph_timestep(s, t);
  TRY(sph_step(s, dt));
  if (t - s->t < 1e-9 * dt) s->t = t;
  return OK;
}

static inline enum status pool_march(struct sph *s, double t) {
  while (s->t < t) TRY(pool_step(s, t));
  return OK;
}

#define POOL_TIMES "time: {end: 1, every: 1, sample: 1}\n"

/* A square drop in the middle of a tank, more than 3h from every wall. */
#define POOL_DROP                                                                                  \
  "title: drop\nscales: {H: 1}\ntank: {walls: [[[0, 3], [0, 0], [3, 0], [3, 3]]]}\n"               \
  "water: {regions: [[[1, 1], [2, 1], [2, 2], [1, 2]]], pressure: hydrostatic}\n" POOL_TIMES

/* A tank two high and filled half. */
#define POOL_STILL                                                                                 \
  "title: still water\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]]}\n"        \
  "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES

/* Buchner's tank. */
#define POOL_DAM                                                                                   \
  "title: dam break\nscales: {H: 0.6}\n"                                                           \
  "tank: {walls: [[[0, 3 H], [0, 0], [5.366 H, 0], [5.366 H, 3 H]]]}\n"                            \
  "water: {regions: [[[0, 0], [2 H, 0], [2 H, H], [0, H]]], pressure: released}\n" POOL_TIMES

/* Whether wall particles have what the water has at their mirror points. */
static inline bool pool_reflects(const char *walls) {
  return strcmp(walls, "dynamic") != 0;
}

/* Whether they go on with the pressure of still water, so that it stays still. */
static inline bool pool_holds_still(const char *walls) {
  return pool_reflects(walls) && strcmp(walls, "mirror-plain") != 0;
}

static inline double pool_random(void) { /* in [-1, 1), the same at every run */
  static uint64_t state = 2385;
  state = state * 6364136223846793005u + 1442695040888963407u;
  return (double)(state >> 11) / 4503599627370496.0 - 1;
}

/* Moves every particle by up to `by` dx and gives it a random velocity (m/s) and pressure (Pa). */
static inline void pool_shake(struct sph *s, double by, double speed, double pressure) {
  for (size_t i = 0; i < s->f.n; i++) {
    s->f.w.x[i] += by * s->dx * pool_random();
    s->f.w.y[i] += by * s->dx * pool_random();
    s->f.w.u[i] += speed * pool_random();
    s->f.w.v[i] += speed * pool_random();
    s->f.w.rho[i] += pressure * pool_random() / (s->c0 * s->c0);
  }
  sph_particles_pad(&s->f);
}

static inline double pool_p(const struct sph *s, size_t i) {
  return s->c0 * s->c0 * (s->f.w.rho[i] - s->rho0);
}

static inline double pool_V(const struct sph *s, size_t i) {
  return s->f.m[i] / s->f.w.rho[i];
}
