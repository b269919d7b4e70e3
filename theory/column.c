#include "theory/column.h"

#include <math.h>
#include <stddef.h>

const char *const theory_reading_names[] = {"literal", "sign", "first", NULL};
const char *const theory_reading_helps[] = {
    "as it stands",
    "first entry of the third row with a plus: waves of 5 h grow most at mu_c = 0.5",
    "8/3 for 1/3 in the first entry: waves of 6 h grow most at mu_c = 0.8"};

struct theory_matrix theory_column_printed(double courant, double kh, enum theory_reading reading) {
  double m = courant * courant, s1 = sin(kh), s2 = pow(sin(kh / 2), 2);
  double a = m * s2, b = m * s1 * s1; /* (mu^2 s2), (mu s1)^2 */
  double first = reading == THEORY_FIRST ? 8. / 3 : 1. / 3;
  double sign = reading == THEORY_SIGN ? 1 : -1;
  return (struct theory_matrix){
      3,
      {{1 - 4 * a + first * a * a + a * b / 3, 1 - 4. / 3 * a - b / 6,
        I * m * s1 * (-0.5 + b / 24 + a / 3)},
       {8 * a * (-1 + 4. / 3 * a + b / 6),
        1 - 4 * a * s2 + 8. / 3 * a * a + 2. / 3 * a * b - b / 2 + b * b / 24,
        I * m * s1 * (4. / 3 * a - 1 + b / 6)},
       {sign * I * 8 * a * s1 * (0.5 - a / 3 - b / 24), -I * s1 * (1 + a / 6 + b / 6),
        1 - b / 2 + b * b / 24 - a * b / 3}}};
}

struct theory_matrix theory_column_rates(double courant, double kh, double theta, double slope) {
  double m = courant * courant, s1 = sin(kh), s2 = pow(sin(kh / 2), 2);
  return (struct theory_matrix){
      3,
      {{0, 1, 0}, {m * (-8 * theta * s2 + 2 * I * slope * s1), 0, -I * m * s1}, {0, -I * s1, 0}}};
}

struct theory_matrix theory_column_step(double courant, double kh, double theta, double slope) {
  struct theory_matrix z = theory_column_rates(courant, kh, theta, slope);
  return theory_step(&sph_rk4, &z, 0);
}

struct theory_matrix theory_column_stratified(double courant, double kh, double theta,
                                              double stratification) {
  double m = courant * courant, s1 = sin(kh), s2 = pow(sin(kh / 2), 2);
  double complex q =
      m * (-s1 * s1 - 8 * theta * s2 * s2 - 2 * I * stratification * s1 * (2 - cos(kh)));
  struct theory_matrix z = {2, {{0, 1}, {q, 0}}};
  return theory_step(&sph_rk4, &z, 0);
}
