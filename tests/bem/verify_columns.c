/* Columns that run into so little water, with so few nodes over its depth, that spray breaks from
 * it everywhere (no. 48 of columns.h): a run may end in a sentence, but no energy comes of it. */
#include "tests/bem/columns.h"
#include "tests/bem/run.h"

static void test_spray_of_shallow_water_makes_no_energy(void) {
  char with[sizeof column_text + 100];
  const struct column c = column_at(48);
  double worst = 0;
  column_write(with, &c, 15);
  struct result_file *f = run_bem(with);
  if (!f) return;
  for (size_t i = 0; i < f->n_energy; i++)
    worst = fmax(worst, fabs(result_energy_budget(&f->energy[i]) / f->energy->total - 1));
  printf("     energy off by %.1e, %.2g of it cut, t to %.3f: %s\n", worst,
         f->energy[f->n_energy - 1].removed / f->energy->total, f->energy[f->n_energy - 1].time,
         f->ended);
  EXPECT(worst < 0.1 && *f->ended);
  EXPECT(isfinite(run_statistic(f, "last_good_time")));
  result_file_destroy(f);
}

int main(void) {
  RUN(test_spray_of_shallow_water_makes_no_energy);
  return TEST_RESULT;
}
