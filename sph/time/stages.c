#include "sph/time/stages.h"

#include "sph/time/integrator.h"
#include "sph/time/rk.h"

static struct sph_row row_of(const double *weights, int n) {
  struct sph_row row = {.keep = 1};
  for (int l = 0; l < n; l++) row.x[l] = row.u[l] = row.rho[l] = weights[l];
  return row;
}

struct sph_stages sph_stages_of(const struct sph_integrator *method, double damping) {
  const struct rk_table *table = method->table;
  if (!table) return method->stages(damping);
  struct sph_stages s = {.n = table->stages};
  for (int r = 0; r < table->stages; r++) s.row[r] = row_of(table->a[r], r);
  s.row[table->stages] = row_of(table->b, table->stages);
  return s;
}
