/* Treatments of solid walls. Each one makes wall particles and sets their states before every pair
 * loop; the loops know nothing else about walls. Adding one: one file, one line in wall.c. */
#pragma once
#include "sph/sph.h"

struct sph_wall {
  /* Makes s->w.grid and .data, and what does not move: s->w.x, .y, .pack (positions and volumes)
   * and .n. */
  enum status (*create)(struct sph *s, const struct geo_lines *walls); /* without periodic ends */
  /* Lists what it needs of the water, for as long as none moves farther than s->wall_skin, or half
   * of that where wall particles move; makes what moves with the water. */
  enum status (*list)(struct sph *s);
  void (*fill)(struct sph *s); /* what else is in s->w.pack */
  /* s->w.G, where the diffusion needs it: after that of the water, which needs s->w.pack; or NULL,
   * and then `fill` does it. */
  void (*fill_gradients)(struct sph *s);
  void (*destroy)(struct sph *s);
  double layer; /* width of the meniscus beside it, particle spacings; see gauge.h */
  bool moving;  /* the wall particles, no faster than the water */
};

/* Water at the top of a wall sees the wall particles behind it only through the wall: those towards
 * which the line of sight meets it below its top (the visibility criterion of Belytschko, Lu & Gu,
 * Int. J. Numer. Meth. Engng 37, 1994, for cracks). So what a wall does fades as the water rises
 * above it and vanishes where the water passes over. Water that has passed over sees no wall. */
struct sph_lip {
  double wall[SPH_LANES], top[SPH_LANES]; /* of the nearer side, m */
  double outwards[SPH_LANES];             /* 1 at the right wall, -1 at the left one */
  double rise[SPH_LANES];                 /* above the top, or 0, m */
  double inside[SPH_LANES]; /* way to the wall, m; without a rise its size, so that all is seen */
};

/* Whether any of the points is above the top of its wall, or has passed over it; if so, *lip is
 * filled. Arrays are [SPH_LANES]. */
bool sph_lip_at(const struct sph *s, const double *x, const double *y, const double *over,
                struct sph_lip *lip);

/* X(variant, help). */
#define SPH_WALLS(X)                                                                               \
  X(ghost, "fixed ghost particles with free slip (Marrone et al. 2011)")                           \
  X(mirror, "mirror images of the water with free slip (Colagrossi & Landrini 2003)")

#define X(variant, help) extern const struct sph_wall sph_wall_##variant;
SPH_WALLS(X)
#undef X

extern const struct sph_wall *const sph_walls[];
extern const char *const sph_wall_names[]; /* NULL-terminated */
extern const char *const sph_wall_helps[]; /* what each is */

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls);

/* After a step, brings back water that crossed a wall, and marks that which went over the top. */
void sph_wall_confine(struct sph *s);
void sph_wall_destroy(struct sph *s);
