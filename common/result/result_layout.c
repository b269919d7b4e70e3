#include "common/result/result_layout.h"

const struct result_column result_energy_columns[RESULT_ENERGY_COLUMNS] = {
    {"time", "s", "physical time"},
#define X(name, help) {#name, "J/m", help " per metre of width"},
    RESULT_ENERGY(X)
#undef X
};

double result_energy_budget(const struct result_energy *e) {
  double sum = e->kinetic + e->potential + e->internal + e->removed;
  for (int k = 0; k < RESULT_TERMS; k++) sum += e->term[k];
  return sum;
}

const struct result_column result_step_columns[RESULT_STEP_COLUMNS] = {
#define X(name, units, help) {#name, units, help},
    RESULT_STEP(X)
#undef X
};

const struct result_column result_point_columns[1 + CASE_POINT_FIELDS] = {
    {"time", "s", "physical time"},
#define X(name, units, help) {#name, units, help},
    CASE_POINT(X)
#undef X
};

const struct result_scale result_scales[RESULT_SCALES] = {
    {"H", "m", "scale of length", offsetof(struct result_file, H), false},
    {"g", "m/s^2", "that of the scales: gravity, or scales.g where there is none",
     offsetof(struct result_file, g), false},
    {"density", "kg/m^3", "density of the water at rest", offsetof(struct result_file, density),
     false},
    {"spacing", "m", "particle or node spacing", offsetof(struct result_file, spacing), false},
    {"rest_potential", "J/m", "potential energy of the same water at rest in the tank",
     offsetof(struct result_file, rest_potential), true},
};
