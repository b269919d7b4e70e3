/* Still water in tanks that are not rectangular: the walls, which are one piece, and the surface's
 * ends. */
#pragma once
#include <math.h>

#include "common/base/geometry.h"
#include "tests/sph/pool.h"

struct still_tank {
  const char *name;
  size_t n;
  double wall[10][2];
  double level;
};

static const struct still_tank still_tanks[] = {
    {"inclined",
     4,
     {{-0.647048, 2.414815}, {0, 0}, {2.897777, 0.776457}, {2.250730, 3.191271}},
     1.2},
    {"rotated", 4, {{-1.25, 2.165064}, {0, 0}, {2.598076, 1.5}, {1.348076, 3.665064}}, 1.6},
    {"wedge", 7, {{0, 2}, {0, 0}, {1, 0}, {1.3, 0.4}, {1.6, 0}, {2.6, 0}, {2.6, 2}}, 1},
    {"step", 6, {{0, 2}, {0, 0}, {1.5, 0}, {1.5, 0.5}, {3, 0.5}, {3, 2}}, 1},
    {"beach", 4, {{0, 2}, {0, 0}, {1.5, 0}, {4.5, 1.5}}, 1},
    {"bar", 8, {{0, 2}, {0, 0}, {1, 0}, {1.5, 0.5}, {2, 0.5}, {2.5, 0}, {3.5, 0}, {3.5, 2}}, 1},
};
enum { STILL_TANKS = sizeof still_tanks / sizeof *still_tanks };

static inline void still_tank_add(char *list, size_t size, double x, double y) {
  const size_t at = strlen(list);
  snprintf(list + at, size - at, "%s[%.9f, %.9f]", at ? ", " : "", x, y);
}

/* What of the walls is below the level. */
static inline struct case_file *still_tank_case(const struct still_tank *t, const char *run) {
  char walls[500] = "", water[500] = "", head[1500];
  for (size_t i = 0; i < t->n; i++) {
    const double *p = t->wall[i], *q = t->wall[(i + 1) % t->n];
    still_tank_add(walls, sizeof walls, p[0], p[1]);
    if (p[1] < t->level) still_tank_add(water, sizeof water, p[0], p[1]);
    const double part = (t->level - p[1]) / (q[1] - p[1]);
    if ((p[1] < t->level) != (q[1] < t->level))
      still_tank_add(water, sizeof water, p[0] + part * (q[0] - p[0]), t->level);
  }
  snprintf(head, sizeof head,
           "title: %s\nscales: {H: 1}\ntank: {walls: [[%s]]}\n"
           "water: {regions: [[%s]], pressure: hydrostatic}\n" POOL_TIMES,
           t->name, walls, water);
  return pool_case(head, run);
}

/* The largest speed, m/s. */
static inline double still_tank_speed(const struct sph *s) {
  double most = 0;
  for (size_t i = 0; i < s->f.n; i++) most = fmax(most, hypot(s->f.w.u[i], s->f.w.v[i]));
  return most;
}

/* How many particles are outside of the walls. */
static inline size_t still_tank_outside(const struct sph *s, const struct still_tank *t) {
  struct geo_lines room = {0};
  size_t out = 0;
  if (geo_lines_begin(&room, true) != OK) return SIZE_MAX;
  for (size_t i = 0; i < t->n; i++)
    if (geo_lines_add(&room, t->wall[i][0], t->wall[i][1]) != OK) return SIZE_MAX;
  for (size_t i = 0; i < s->f.n; i++) out += !geo_lines_contain(&room, s->f.w.x[i], s->f.w.y[i]);
  geo_lines_destroy(&room);
  return out;
}
