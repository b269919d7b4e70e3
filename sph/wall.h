/* Treatments of solid walls. Each one makes wall particles and sets their states before every pair
 * loop; the loops know nothing else about walls. Adding one: one file, one line in wall.c. */
#pragma once
#include "sph/sph.h"

struct sph_wall {
  const char *name, *help;
  /* Makes s->w.grid and .data, and what does not move: s->w.x, .y, .pack (positions and volumes)
   * and .n. */
  enum status (*create)(struct sph *s, const struct geo_lines *walls);
  /* After the water was sorted anew, lists anything it needs; makes what moves with the water. */
  enum status (*list)(struct sph *s);
  void (*fill)(struct sph *s); /* pressures, velocities and gradients into s->w.pack */
  /* Gradients, if they need those of the water, which need the rest of s->w.pack; or NULL. */
  void (*fill_gradients)(struct sph *s);
  void (*destroy)(struct sph *s);
  bool moving; /* the wall particles, no faster than the water */
};

extern const struct sph_wall *const sph_walls[];
extern const char *const sph_wall_names[]; /* NULL-terminated */

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls);
void sph_wall_confine(struct sph *s); /* after a step, brings back water that crossed a wall */
void sph_wall_destroy(struct sph *s);
