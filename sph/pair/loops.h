/* The pair loops. A cluster of SPH_LANES targets i stands in the lanes of vector registers and
 * meets the sources j of its list; each i sums over its own j and writes only itself, so the bits
 * do not depend on the number of threads.
 *
 * Sums are made in the precision of the scheme, and all else is double: what enters a sum is the
 * difference of positions and of velocities, taken in double from a particle of the cluster and
 * then rounded. Single precision so rounds places to 2.4e-7 h within 8h of that particle, and a
 * pair's contribution by up to 1e-6 of what neighbours contribute, wherever the water is and
 * however fast; a cluster whose particles are farther apart (the last of one body of water and the
 * first of the next, or spray) is summed in doubles. Two things remain. Pressures are counted from
 * 0, so that the diffusion, which takes their differences, is off by 6e-8 p: of a difference
 * between neighbours, rho0 g dx, that is 6e-8 times the depth over dx. And the slope of the
 * Gaussian is exp(-9) at the edge of its support, not 0: a pair that is there within 2e-6 of its
 * distance may count in one precision and not in the other, at most 1.3e-4 (p_i + p_j)/(rho0 h) of
 * acceleration (at H/dx = 100 that is up to 0.2 m/s^2 at the bed, H = 1 m), as it comes and goes
 * when the particle crosses the edge. Within the loops units are h, c0 and rho0. */
#pragma once
#include "sph/domain/wall.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/kernel.h"
#include "sph/sph.h"

/* The points that sums are made for: particles of water, or nodes of ghosts (x and y alone). */
struct sph_targets {
  double x[SPH_LANES], y[SPH_LANES], u[SPH_LANES], v[SPH_LANES]; /* m, m/s */
  double p[SPH_LANES], rho[SPH_LANES];                           /* Pa, kg m^-3 */
  double Gx[SPH_LANES], Gy[SPH_LANES];                           /* Pa/m */
};

/* The sources of one kind. */
struct sph_near {
  size_t n, n_ahead;
  const uint32_t *list;
  const uint32_t *ahead; /* the next cluster's: asked of the memory while this one's are summed */
  const struct sph_pack *pack;
  const struct sph_vector *G;  /* their gradients, for a loop that needs them */
  const unsigned char *hidden; /* of each a bit for every target that does not see it, or NULL */
};

/* What the loop of the rates is asked for. */
struct sph_rates_how {
  enum sph_diffusion diffusion; /* that these sources take part in */
  bool bounds;                  /* pi_most too */
  double soft2;                 /* added to q^2 in it */
};

/* With e = slope V_j (kernel.h), units h, c0, rho0. */
struct sph_rates_sums {
  double px[SPH_LANES], py[SPH_LANES]; /* sum momentum_pressure x e */
  double div[SPH_LANES];               /* sum continuity_flux */
  double vx[SPH_LANES], vy[SPH_LANES]; /* sum viscosity_drag x e */
  double D[SPH_LANES];                 /* sum psi e */
  double pi_most[SPH_LANES];           /* max |pi_ij| */
};

struct sph_gradient_sums {
  double xx[SPH_LANES], xy[SPH_LANES], yy[SPH_LANES]; /* sum x x e ... */
  double x[SPH_LANES], y[SPH_LANES];                  /* sum (p_j - p_i) x e ... */
};

struct sph_diffusion_sums {
  double D[SPH_LANES];      /* sum psi e */
  double weight[SPH_LANES]; /* sum diffusion_weight V_j, the particle itself included */
};

/* Weighted with w = value V_j, with slope V_j, or with 1 within the scheme's derivative_radius.
 * Velocities and pressures are those of the sources less those of the first one. */
struct sph_fit_sums {
  double w[SPH_LANES], x[SPH_LANES], y[SPH_LANES], xx[SPH_LANES], xy[SPH_LANES], yy[SPH_LANES];
  double p[SPH_LANES], px[SPH_LANES], py[SPH_LANES], u[SPH_LANES], ux[SPH_LANES], uy[SPH_LANES];
  double v[SPH_LANES], vx[SPH_LANES], vy[SPH_LANES], speed2[SPH_LANES];
};

/* The loops of one kernel in one precision. Sums are set, not added to. */
struct sph_loops {
  void (*rates)(const struct sph *s, const struct sph_rates_how *how, const struct sph_targets *i,
                const struct sph_near *near, struct sph_rates_sums *sums);
  void (*gradient)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                   struct sph_gradient_sums *sums);
  void (*diffusion)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                    struct sph_diffusion_sums *sums);
  void (*fit)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
              struct sph_fit_sums *sums);
  void (*slope_fit)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                    struct sph_fit_sums *sums);
  void (*hat_fit)(const struct sph *s, const struct sph_targets *i, const struct sph_near *near,
                  struct sph_fit_sums *sums);
};
extern const struct sph_loops sph_loops_single[SPH_KERNEL_COUNT],
    sph_loops_double[SPH_KERNEL_COUNT];

/* In h. A cluster of water that hangs together is up to 4.2 h wide: two columns of the sort. */
enum { SPH_WIDE = 6 };

/* Whether the sums around these targets are made in doubles: where the scheme says so, and where
 * rounded places would have too few digits. */
static inline bool sph_takes_doubles(const struct sph *s, const struct sph_targets *i) {
  double far = 0;
  for (size_t l = 0; l < SPH_LANES; l++)
    far = larger(larger(fabs(i->x[l] - i->x[0]), fabs(i->y[l] - i->y[0])), far);
  return s->scheme.precision == SPH_PRECISION_double || far > SPH_WIDE * s->h;
}

static inline const struct sph_loops *sph_loops_for(const struct sph *s,
                                                    const struct sph_targets *i) {
  return (sph_takes_doubles(s, i) ? sph_loops_double : sph_loops_single) + s->scheme.kernel;
}

/* Clusters whose sources stay in the caches, so that asking for them ahead only costs. */
enum { SPH_CACHED_CLUSTERS = 4000 };

static inline struct sph_near sph_near_of(const struct sph_lists *lists, size_t cluster,
                                          const struct sph_pack *pack) {
  struct sph_near a = {.pack = pack};
  a.list = sph_lists_of(lists, cluster, &a.n);
  if (lists->n_clusters > SPH_CACHED_CLUSTERS && cluster + 1 < lists->n_clusters)
    a.ahead = sph_lists_of(lists, cluster + 1, &a.n_ahead);
  a.hidden = sph_lists_hidden(lists, cluster);
  return a;
}

/* The water of one cluster, and the wall particles near it. */
struct sph_targets sph_targets_of(const struct sph *s, size_t cluster);
struct sph_near sph_near_walls(const struct sph *s, size_t cluster);
