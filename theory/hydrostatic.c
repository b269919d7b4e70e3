/* Growth of sound in a column at rest with RK4 (T, figure 2-33): the largest |lambda| - 1 of a
 * step, by
 *
 *     printed     the matrix (2.273) as it stands, which has five misprinted entries
 *     equations   RK4 of the equations (2.270)-(2.272) as printed: neutral or damped for mu_c <= 1,
 *                 since 8 s2 + s1^2 <= 8 and z = mu_c sqrt(8 s2 + s1^2) <= 2 sqrt(2)
 *     stratified  RK4 of the equations with the masses that rest needs:
 *                 y'' = (c/h)^2 {-s1^2 - 8 theta s2^2 - 2 i delta h s1 (2 - cos kh)} y
 *
 * The growth of the last is that of the amplitude of sound that travels into lighter water; the
 * bounded column is neutral. Units: g = H = 1. */
#include <math.h>

#include "theory/column.h"
#include "theory/theory.h"

static const char *const layer_names[] = {"printed", "equations", "stratified", NULL};
static const char *const layer_helps[] = {"the matrix (2.273) as printed",
                                          "RK4 of the printed equations (2.270)-(2.272)",
                                          "RK4 of the corrected equations"};
enum { PRINTED, EQUATIONS, STRATIFIED };

struct hydrostatic {
  double courant, beta, spacing, depth;
  int layer, reading, points;
};

static const struct param params[] = {
    THEORY_CHOICE(hydrostatic, layer, layer_names, layer_helps, "printed", "which equations"),
    THEORY_CHOICE(hydrostatic, reading, theory_reading_names, theory_reading_helps, "sign",
                  "how the printed matrix is read"),
    THEORY_REAL(hydrostatic, courant, PARAM_ABOVE_0, 4, "1, 0.8, 0.5, 0.1", "mu_c = c dt/h"),
    THEORY_REAL(hydrostatic, beta, PARAM_ABOVE_0, 1e6, "20", "c^2/(g H), of stratified"),
    THEORY_REAL(hydrostatic, spacing, PARAM_ABOVE_0, 1, "0.02", "dx = h over H, of stratified"),
    THEORY_REAL(hydrostatic, depth, 0, 1, "0.5", "|y|/H of the particles, of stratified"),
    THEORY_POINTS(hydrostatic),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "k h", .help = "wavenumber times h"},
    {.key = "growth",
     .unit = "1",
     .label = "|λ| − 1",
     .axis = "|λ| − 1 of a step",
     .level = "0",
     .help = "growth in a step"},
};
enum { WORST, WORST_AT };
static const struct theory_value values[] = {
    [WORST] = {"growth_most", "1", "largest growth in a step"},
    [WORST_AT] = {"kh_most", "1", "k h of that"},
};

static enum status growth(const struct hydrostatic *p, double kh, double *excess) {
  double delta = 1 / (2 * p->beta);
  struct theory_matrix m =
      p->layer == PRINTED ? theory_column_printed(p->courant, kh, (enum theory_reading)p->reading)
      : p->layer == EQUATIONS
          ? theory_column_step(p->courant, kh, 1, 0)
          : theory_column_stratified(p->courant, kh, 2 * delta * p->depth, delta * p->spacing);
  TRY(theory_radius(&m, excess));
  *excess -= 1;
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct hydrostatic *p = with;
  for (int i = 1; i <= p->points; i++) {
    double kh = M_PI * i / p->points, excess;
    TRY(growth(p, kh, &excess));
    TRY(THEORY_ROW(curve, kh, excess));
    if (excess <= curve->value[WORST]) continue; /* NaN at first */
    curve->value[WORST] = excess;
    curve->value[WORST_AT] = kh;
  }
  return OK;
}

const struct theory_topic theory_hydrostatic = {
    .name = "hydrostatic",
    .help =
        "growth of sound in a column at rest in a step of RK4 (T, eqs 2.270-2.273, figure 2-33)",
    .params_size = sizeof(struct hydrostatic),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
