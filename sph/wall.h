/* Treatments of solid walls. Each one makes wall particles at creation and sets their states before
 * every pair loop; the loops know nothing else about walls. Adding one: one file, one line in
 * wall.c. */
#pragma once
#include "sph/sph.h"

struct sph_wall {
  const char *name, *help;
  /* Makes s->w.x, .y, .pack (positions and volumes), .n and .data. */
  enum status (*create)(struct sph *s, const struct geo_lines *walls);
  enum status (*list)(struct sph *s); /* after the water was sorted anew, lists anything it needs */
  void (*fill)(struct sph *s);        /* pressures, velocities and gradients into s->w.pack */
  void (*confine)(struct sph *s);     /* after a step, brings back water that crossed a wall */
  void (*destroy)(struct sph *s);
};

extern const struct sph_wall *const sph_walls[];
extern const char *const sph_wall_names[]; /* NULL-terminated */

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls);
void sph_wall_destroy(struct sph *s);
