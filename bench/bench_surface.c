/* Cost of finding the free surface of a column (2 H wide, H high) in its tank, the whole of it and
 * the strip for a gauge, with as many threads as OMP_NUM_THREADS says. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "bench/bench.h"
#include "common/cloud/surface.h"

static enum status measure(int k) {
  enum status status = OK;
  struct cloud_surface *s = NULL;
  struct geo_lines walls = {0}, out = {0};
  double dx = 1.0 / k, best[2] = {1e9, 1e9};
  size_t n = 0, room = 2 * (size_t)k * (size_t)k;
  double *x = malloc(room * sizeof *x), *y = malloc(room * sizeof *y);
  if (!x || !y) {
    status = status_raise(ERR_MEMORY, "no memory for %zu particles", room);
    goto done;
  }
  for (int i = 0; i < 2 * k; i++)
    for (int j = 0; j < k; j++) {
      x[n] = (i + 0.5) * dx;
      y[n++] = (j + 0.5) * dx;
    }
  ATTEMPT(geo_lines_begin(&walls, false));
  for (int i = 0; i < 4; i++) ATTEMPT(geo_lines_add(&walls, i < 2 ? 0 : 5.366, i % 3 ? 0 : 3));
  ATTEMPT(cloud_surface_create(&s));
  const struct cloud cloud = {n, x, y, NULL, dx, NULL};
  const double strip[2] = {1 - 6 * dx, 1 + 6 * dx};
  for (int run = 0; run < 10; run++) {
    double start = bench_seconds();
    ATTEMPT(cloud_surface_extract(s, &cloud, &walls, &out));
    double middle = bench_seconds();
    ATTEMPT(cloud_surface_strip(s, &cloud, &walls, strip, &out));
    double end = bench_seconds();
    best[0] = fmin(best[0], middle - start);
    best[1] = fmin(best[1], end - middle);
  }
  printf("%6d %8zu %10.3f %10.1f %10.3f\n", k, n, best[0] * 1e3, best[0] * 1e9 / (double)n,
         best[1] * 1e3);
done:
  cloud_surface_destroy(s);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&out);
  free(x);
  free(y);
  return status;
}

int main(void) {
  printf("%6s %8s %10s %10s %10s\n", "H/dx", "n", "ms", "ns/particle", "gauge, ms");
  for (int k = 25; k <= 400; k *= 2)
    if (measure(k) != OK) {
      fprintf(stderr, "bench_surface: %s\n", status_message());
      return 1;
    }
  return 0;
}
