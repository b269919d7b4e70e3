/* Stand-ins for the solvers and measures, so that the case reader is tested by itself. */
#pragma once
#include <stddef.h>

#include "common/case/case.h"

struct fake_sph {
  int diffusion, order;
  double delta, alpha, c0;
  bool smooth;
  char *note;
};

static const char *const fake_diffusions[] = {"none", "molteni", "ferrari", "antuono", NULL};

static const struct param fake_sph_rows[] = {
    {.key = "diffusion",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct fake_sph, diffusion),
     .choices = fake_diffusions,
     .value = "antuono",
     .help = "diffusive term"},
    {.key = "order",
     .type = PARAM_INT,
     .offset = offsetof(struct fake_sph, order),
     .min = 1,
     .max = 8,
     .value = "4",
     .help = "order"},
    {.key = "delta",
     .type = PARAM_REAL,
     .offset = offsetof(struct fake_sph, delta),
     .min = 0,
     .max = 10,
     .value = "0.2",
     .help = "coefficient of diffusion"},
    {.key = "alpha",
     .type = PARAM_REAL,
     .offset = offsetof(struct fake_sph, alpha),
     .min = 0,
     .max = 1,
     .value = "0.01",
     .help = "artificial viscosity"},
    {.key = "c0",
     .type = PARAM_REAL,
     .quantity = QTY_VELOCITY,
     .offset = offsetof(struct fake_sph, c0),
     .min = PARAM_ABOVE_0,
     .max = 1e5,
     .value = "20 sqrt(gH)",
     .help = "speed of sound"},
    {.key = "smooth",
     .type = PARAM_BOOL,
     .offset = offsetof(struct fake_sph, smooth),
     .value = "true",
     .help = "smoothing"},
    {.key = "note",
     .type = PARAM_TEXT,
     .offset = offsetof(struct fake_sph, note),
     .max = 40,
     .value = "",
     .help = "a word"},
};

static const struct solver fake_solver_sph = {.name = "sph",
                                              .help = "a stand-in",
                                              .params = fake_sph_rows,
                                              .n_params =
                                                  sizeof fake_sph_rows / sizeof *fake_sph_rows,
                                              .options_size = sizeof(struct fake_sph)};

/* Can do nothing but rectangular tanks, as the boundary-element solver. */
static inline void fake_bem_check(const struct case_file *c, const struct case_run *r,
                                  struct problems *problems) {
  if (!c->rectangular)
    problems_add(problems, r->line, "runs.%s: found a tank that is not rectangular", r->name);
}

static const struct solver fake_solver_bem = {
    .name = "bem", .help = "another", .check = fake_bem_check};

static const struct solver *const fake_solvers[] = {&fake_solver_sph, &fake_solver_bem};
static const struct measure fake_measures[] = {{"front", "H", "front"}, {"area", "H^2", "area"}};
static const struct registry fake_registry = {fake_solvers, 2, fake_measures, 2};
