/* Treatments of solid walls. Each one makes wall particles and sets their states before every pair
 * loop; the loops know nothing else about walls. Adding one: one file, one line in this one. */
#pragma once
#include "sph/family.h"
#include "sph/sph.h"

struct sph_wall {
  /* Makes s->w.grid and .data, and what does not move: s->w.x, .y, .pack (positions and volumes)
   * and .n. */
  enum status (*create)(struct sph *s, const struct geo_lines *walls); /* without periodic ends */
  /* Lists what it needs of the water, for as long as none moves farther than s->wall_skin, or half
   * of that where wall particles move; makes what moves with the water. */
  enum status (*list)(struct sph *s);
  /* What walls hide from it, of what it has listed (sight.h); or NULL. */
  enum status (*look)(struct sph *s);
  void (*move)(struct sph *s); /* walls have moved: places follow; NULL: these cannot */
  void (*fill)(struct sph *s); /* what else is in s->w.pack */
  /* s->w.G, where the diffusion needs it: after that of the water, which needs s->w.pack; or NULL,
   * and then `fill` does it. */
  void (*fill_gradients)(struct sph *s);
  /* Where the density of wall particles evolves, else NULL: the start of a step; its rate, once the
   * packs of a stage are filled; and the state that is at the start, and dt times the weighted sum
   * of the rates of so many stages. */
  void (*begin)(struct sph *s);
  void (*rates)(struct sph *s, int stage);
  void (*advance)(struct sph *s, const double *weights, int stages, double dt);
  uint32_t (*motion)(const struct sph *s,
                     size_t k); /* (images.h) that wall particle k is made by */
  void (*destroy)(struct sph *s);
  double layer;    /* width of the meniscus beside it, particle spacings; see gauge.h */
  bool moving;     /* the wall particles, no faster than the water */
  bool undiffused; /* they take no part in the diffusion of the density */
};

/* X(variant, what a case calls it, help). */
#define SPH_WALLS(X)                                                                               \
  X(ghost, "ghost",                                                                                \
    "fixed ghost particles, with p + rho f.(r_g - r) fitted to the water at their mirror points "  \
    "(Marrone et al. 2011)")                                                                       \
  X(mirror, "mirror",                                                                              \
    "mirror images of the water, below the bed with p* = p + 2 d rho g, d the distance from it; "  \
    "rho g is what the momentum equation has, with momentum: reference rho0 g (thesis, eqs. "      \
    "(4.42) to (4.44))")                                                                           \
  X(mirror_plain, "mirror-plain",                                                                  \
    "mirror images of the water with p* = p (Colagrossi & Landrini 2003): the lowest row of "      \
    "water at rest starts to fall, by 0.56 g with the radial spline")                              \
  X(mirror_reference, "mirror-reference",                                                          \
    "mirror images of the water, below the bed with p* = p + 2 d rho0 g (thesis, eq. (4.44)) in "  \
    "any form: water that is heavier than rho0 at the bed does not rest on them")                  \
  X(mirror_exponential, "mirror-exponential",                                                      \
    "mirror images of the water, below the bed by dp/dy = -rho g and the equation of state: rho* " \
    "= rho exp(2 d g/c0^2) where that is linear")                                                  \
  X(dynamic, "dynamic",                                                                            \
    "fixed particles with a density by the continuity equation, p >= 0, from which water keeps "   \
    "a spacing or two away (Crespo et al. 2007)")

#define X(variant, name, help) extern const struct sph_wall sph_wall_##variant;
SPH_WALLS(X)
#undef X

#define SPH_SLIPS(X, ...)                                                                          \
  X(free, "wall particles move along the wall as the water does: no friction", ##__VA_ARGS__)      \
  X(no,                                                                                            \
    "in the viscous force alone wall particles move as -u, so that water stands at the wall; the " \
    "divergence keeps the mirrored velocity (Marrone et al. 2013)",                                \
    ##__VA_ARGS__)
SPH_FAMILY(sph_slip, SPH_SLIP, SPH_SLIPS);

extern const struct sph_wall *const sph_walls[];
extern const char *const sph_wall_names[]; /* NULL-terminated */
extern const char *const sph_wall_helps[]; /* what each is */

enum status sph_wall_create(struct sph *s, const struct geo_lines *walls);

/* Who sees whom past walls that have moved, for ways of the support and the walls' skin.
 * ERR_MEMORY.
 */
enum status sph_wall_see(struct sph *s);

/* Wall particles are filled. */
void sph_wall_fill(struct sph *s);

/* What its wall does to wall particle k, turned by `motion` from water at (x, y) that moves with
 * (u, v). */
static inline struct sph_drive sph_wall_drive(const struct sph *s, uint32_t motion, double x,
                                              double y, double u, double v) {
  if (!s->sides.move) return (struct sph_drive){0};
  return sph_sides_drive(s, motion, (const double[2]){x, y}, (const double[2]){u, v});
}

/* Makes s->w.pack, s->w.G and, where there is no slip, s->w.drag of n particles. ERR_MEMORY. */
enum status sph_wall_make_packs(struct sph *s, size_t n);

/* Walls without slip: where water at the mirror point of wall particle k has the velocity (u, v),
 * viscosity finds the opposite there. In the continuity equation wall particles keep the reflected
 * velocity R u, which pressure takes no work from (mirror.c): with -u, whose divergence along the
 * wall is the wrong way round, the two would exchange energy that is nobody's. Water that the wall
 * holds has that velocity at the wall, too, since u = 0 there. Where the wall moves, either
 * velocity is one against the wall. */
static inline void sph_wall_hold(const struct sph *s, size_t k, double u, double v,
                                 const struct sph_drive *d) {
  s->w.pack[k].u += 2 * d->V[0];
  s->w.pack[k].v += 2 * d->V[1];
  if (s->w.V) s->w.V[k] = (struct sph_vector){d->V[0], d->V[1]};
  if (!s->w.drag) return;
  s->w.drag[k] = s->w.pack[k];
  s->w.drag[k].u = 2 * d->held[0] - u;
  s->w.drag[k].v = 2 * d->held[1] - v;
}

/* The density of wall particles, where it evolves (above), goes with the water's. */
void sph_wall_begin(struct sph *s);
void sph_wall_rates(struct sph *s, int stage);
void sph_wall_advance(struct sph *s, const double *weights, int stages, double dt);

/* At the start of a step, and when lists are new: what walls hide, of water and wall particles.
 * ERR_MEMORY. */
enum status sph_wall_look(struct sph *s);

/* After a step, brings back water that crossed a wall, and marks that which went over the top. */
void sph_wall_confine(struct sph *s);

/* Whether particle i may not go straight to (x, y): through a wall, or over its top. */
bool sph_wall_stops(const struct sph *s, size_t i, double x, double y);

/* Water that has passed over a wall: whether it is below its top. */
bool sph_wall_has_lost(const struct sph *s, size_t i);
void sph_wall_destroy(struct sph *s);
