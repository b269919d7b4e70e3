#include "sph/wall.h"

#include <stdlib.h>

#include "sph/ghost.h"

const struct sph_wall *const sph_walls[] = {&sph_wall_ghost};
const char *const sph_wall_names[] = {"ghost", NULL};

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls) {
  s->wall = sph_walls[s->o.walls];
  return s->wall->create(s, walls);
}

void sph_wall_destroy(struct sph *s) {
  if (s->wall) s->wall->destroy(s);
  free(s->w.x);
  free(s->w.y);
  free(s->w.pack);
  sph_grid_destroy(&s->w.grid);
  s->w = (struct sph_wall_particles){0};
}
