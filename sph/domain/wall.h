/* Treatments of solid walls. Each one makes wall particles and sets their states before every pair
 * loop; the loops know nothing else about walls. Adding one: one file, one line in wall.c. */
#pragma once
#include "sph/pair/vec.h"
#include "sph/sph.h"

struct sph_wall {
  const char *name;
  /* Makes s->w.grid and .data, and what does not move: s->w.x, .y, .pack (positions and volumes)
   * and .n. */
  enum status (*create)(struct sph *s, const struct geo_lines *walls);
  /* After the water was sorted anew, lists anything it needs; makes what moves with the water. */
  enum status (*list)(struct sph *s);
  void (*fill)(struct sph *s); /* pressures, velocities and gradients into s->w.pack */
  /* Gradients, if they need those of the water, which need the rest of s->w.pack; or NULL. */
  void (*fill_gradients)(struct sph *s);
  void (*destroy)(struct sph *s);
  double layer; /* width of the meniscus beside it, particle spacings; see gauge.h */
  bool moving;  /* the wall particles, no faster than the water */
};

/* Water at the top of a wall sees the wall particles behind it only through the wall: those towards
 * which the line of sight meets it below its top (the visibility criterion of Belytschko, Lu & Gu,
 * Int. J. Numer. Meth. Engng 37, 1994, for cracks). So what a wall does fades as the water rises
 * above it and vanishes where the water passes over. Water that has passed over sees no wall.
 * Lanes are particles of water. */
struct sph_lip {
  vec wall, top; /* of the nearer side, m */
  vec outwards;  /* 1 at the right wall, -1 at the left one */
  vec rise;      /* above the top, or 0, m */
  vec inside;    /* way to the wall, m; where there is no rise its size, so that all is seen */
};

/* Whether any lane is above the top of its wall; if so, *lip is filled. */
SPECIALISE bool sph_lip_at(const struct sph *s, vec x, vec y, vec over, struct sph_lip *lip) {
  const struct tank *t = &s->tank;
  bool any = false;
  for (size_t l = 0; l < SPH_LANES; l++) any |= over[l] != 0 || y[l] > s->tank.lowest_top;
  if (!any) return false;
  for (size_t l = 0; l < SPH_LANES; l++) {
    int side = tank_nearer(t, x[l]);
    lip->wall[l] = tank_wall(t, side);
    lip->top[l] = t->top[side];
    lip->outwards[l] = side == TANK_RIGHT ? 1 : -1;
    lip->rise[l] = fmax(y[l] - lip->top[l], 0);
    double way = lip->outwards[l] * (lip->wall[l] - x[l]);
    lip->inside[l] = over[l] != 0 ? -1 : lip->rise[l] > 0 ? way : fabs(way);
  }
  return true;
}

/* r2, or a distance beyond the support for the lanes that do not see the wall particle at (x, y).
 */
SPECIALISE vec sph_lip_hide(const struct sph_lip *lip, double x, double y, vec r2, double far2) {
  const vec zero = {0};
  vec behind = vec_max(lip->outwards * (x - lip->wall), zero);
  vec below = vec_max(lip->top - y, zero);
  vec seen = below * lip->inside - lip->rise * behind;
  return r2 + vec_where_less(zero + far2, seen, zero);
}

extern const struct sph_wall *const sph_walls[];
extern const char *const sph_wall_names[]; /* NULL-terminated */
extern const char *const sph_wall_helps[]; /* what each is */

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls);

/* After a step, brings back water that crossed a wall, and marks that which went over the top. */
void sph_wall_confine(struct sph *s);
void sph_wall_destroy(struct sph *s);
