#include "sph/observe/probe.h"

#include <math.h>
#include <string.h>

#include "sph/domain/mls.h"

/* A point on a wall has d^2 = 2.4, the corner of a tank 4.8 (mls.h). */
static const double farthest2 = 5;

/* Unit vector along the wall segment nearest to the probe. */
static void wall_direction(const struct geo_lines *walls, double x, double y, double t[2]) {
  double nearest = INFINITY;
  t[0] = 0;
  t[1] = 1;
  for (size_t piece = 0; piece < walls->pieces; piece++)
    for (size_t k = 0; k < geo_piece_segments(walls, piece); k++) {
      const double *a = walls->p[walls->first[piece] + k], *b = geo_segment_end(walls, piece, k);
      double ex = b[0] - a[0], ey = b[1] - a[1], l2 = ex * ex + ey * ey;
      if (l2 == 0) continue;
      double foot[2];
      geo_segment_foot(a, b, (double[2]){x, y}, foot);
      double away = hypot(x - foot[0], y - foot[1]);
      if (away >= nearest) continue;
      nearest = away;
      t[0] = ex / sqrt(l2);
      t[1] = ey / sqrt(l2);
    }
}

/* At SPH_LANES points. The lists' own grid finds the water near them. */
static enum status pressure_at(const struct sph *s, const struct sph_targets *at,
                               double p[SPH_LANES]) {
  struct sph_lists lists = {0};
  struct sph_mls fit;
  enum status status = OK;
  const struct sph_sources water = sph_sources_of_water(s);
  ATTEMPT(sph_lists_build(&lists, SPH_LANES, at->x, at->y, &water, s->support));
  ATTEMPT(sph_sight_mark(&s->sight, &lists, SPH_LANES, at->x, at->y, &water, NULL, s->support));
  const struct sph_near near = sph_near_of(&lists, 0, s->pack);
  sph_mls_at(s, &sph_loops_double[s->scheme.kernel], farthest2 * s->scale.wall, at, &near, &fit);
  memcpy(p, fit.p, sizeof fit.p);
done:
  sph_lists_destroy(&lists);
  return status;
}

enum status sph_probe(const struct sph *s, const struct case_probe *probe,
                      const struct geo_lines *walls, double *pressure) {
  double t[2];
  wall_direction(walls, probe->x, probe->y, t);
  size_t groups = probe->size > 0 ? (size_t)ceil(probe->size / (0.5 * s->dx * SPH_LANES)) : 1;
  double points = (double)(groups * SPH_LANES), sum = 0;
  bool hidden = false;
  for (size_t k = 0; k < groups; k++) {
    struct sph_targets at = {0};
    double p[SPH_LANES];
    for (size_t l = 0; l < SPH_LANES; l++) {
      double along = (((double)(k * SPH_LANES + l) + 0.5) / points - 0.5) * probe->size;
      at.x[l] = probe->x + along * t[0];
      at.y[l] = probe->y + along * t[1];
      hidden |= sph_sides_hide(s, (double[]){at.x[l], at.y[l]});
    }
    TRY(pressure_at(s, &at, p));
    for (size_t l = 0; l < SPH_LANES; l++) sum += p[l];
  }
  *pressure = hidden ? NAN : sum / points;
  return OK;
}
