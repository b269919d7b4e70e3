#include "sph/wall.h"

#include <stdlib.h>

#include "sph/ghost.h"
#include "sph/mirror.h"

const struct sph_wall *const sph_walls[] = {&sph_wall_ghost, &sph_wall_mirror};
const char *const sph_wall_names[] = {"ghost", "mirror", NULL};

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls) {
  s->wall = sph_walls[s->o.walls];
  s->wall_top[0] = walls->p[0][1];
  s->wall_top[1] = walls->p[walls->points - 1][1];
  return s->wall->create(s, walls);
}

void sph_wall_confine(struct sph *s) {
  const struct sph_state *w = &s->f.w;
  const struct geo_box *t = &s->tank;
  size_t reflections = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    if (w->x[i] < t->min[0] && w->y[i] < s->wall_top[0]) {
      w->x[i] = 2 * t->min[0] - w->x[i];
      w->u[i] = -w->u[i];
      reflections++;
    }
    if (w->x[i] > t->max[0] && w->y[i] < s->wall_top[1]) {
      w->x[i] = 2 * t->max[0] - w->x[i];
      w->u[i] = -w->u[i];
      reflections++;
    }
    if (w->y[i] < t->min[1] && w->x[i] > t->min[0] && w->x[i] < t->max[0]) {
      double lift = 2 * (t->min[1] - w->y[i]);
      w->y[i] += lift;
      w->v[i] = -w->v[i];
      s->budget.walls -= s->f.m[i] * s->g * lift;
      reflections++;
    }
  }
  s->reflections += reflections;
}

void sph_wall_destroy(struct sph *s) {
  if (s->wall) s->wall->destroy(s);
  free(s->w.x);
  free(s->w.y);
  free(s->w.pack);
  sph_grid_destroy(&s->w.grid);
  s->w = (struct sph_wall_particles){0};
}
