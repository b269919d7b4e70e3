/* A solitary wave over 20 depths of flat bed, against the exact one that viscosity takes energy
 * from. */
#include "tests/test.h"

#include "common/cloud/surface.h"
#include "common/flow/crest.h"
#include "sph/fluid/energy.h"
#include "tests/sph/pool.h"

/* The depth is 1 m. */
static const double amplitude = 0.3, way = 20, alpha = 0.01;

static struct crest crest_of(double a) {
  struct crest w;
  EXPECT_OK(wave_crest_create(a, &w));
  return w;
}

/* ---- the viscous estimate ---- */

/* Integral of 4 (u_x^2 + u_y^2) over the water: with a viscosity nu, an irrotational flow loses nu
 * times that, and density (2 nu e:e; Lamb, Hydrodynamics, art. 329), if neither bed nor sides hold
 * it. */
static double strain_of(const struct crest *w) {
  const double step = 0.1, near = 1e-4;
  const int rows = 12;
  double sum = 0;
  for (double x = -10; x < 10; x += step) {
    const double height = (1 + wave_crest_elevation(w, x)) / rows;
    for (int j = 0; j < rows; j++) {
      const double y = -1 + (j + 0.5) * height;
      const struct crest_point p = wave_crest_at(w, x, y), q = wave_crest_at(w, x + near, y);
      const double ux = (q.u - p.u) / near, vx = (q.v - p.v) / near; /* v_x = u_y */
      sum += 4 * (ux * ux + vx * vx) * height * step;
    }
  }
  return sum;
}

/* ---- the wave of the particles ---- */

/* Of the surface near the crest, as eta = exact wave of amplitude A at x, + level. */
struct seen {
  double amplitude, x, level;
};

struct waves {
  struct crest wave, less;
  double step; /* their amplitudes' difference */
};

/* Sums of the least squares for {amplitude, x, level}. */
struct squares {
  double a[3][3], b[3];
};

static void add_point(struct squares *q, const double row[3], double rest) {
  for (int i = 0; i < 3; i++) {
    q->b[i] += row[i] * rest;
    for (int j = 0; j < 3; j++) q->a[i][j] += row[i] * row[j];
  }
}

static void solve(struct squares *q, double out[3]) {
  for (int k = 0; k < 3; k++)
    for (int i = k + 1; i < 3; i++) {
      const double f = q->a[i][k] / q->a[k][k];
      for (int j = k; j < 3; j++) q->a[i][j] -= f * q->a[k][j];
      q->b[i] -= f * q->b[k];
    }
  for (int k = 2; k >= 0; k--) {
    out[k] = q->b[k];
    for (int j = k + 1; j < 3; j++) out[k] -= q->a[k][j] * out[j];
    out[k] /= q->a[k][k];
  }
}

static void correct(const struct waves *w, const struct geo_lines *surface, struct seen *at) {
  const double near = 1e-4, slope = (at->amplitude - amplitude) / w->step;
  struct squares q = {0};
  double by[3];
  for (size_t i = surface->first[0]; i < surface->first[1]; i++) {
    const double x = surface->p[i][0] - at->x;
    if (fabs(x) > 5) continue;
    const double eta = wave_crest_elevation(&w->wave, x);
    const double more = eta - wave_crest_elevation(&w->less, x);
    const double dx = (wave_crest_elevation(&w->wave, x + near) - eta) / near;
    add_point(&q, (double[]){more / w->step, -dx, 1},
              surface->p[i][1] - 1 - (eta + slope * more) - at->level);
  }
  solve(&q, by);
  at->amplitude += by[0];
  at->x += by[1];
  at->level += by[2];
}

/* Where the crest is, whose surface is fitted by waves of any amplitude and level: particles of one
 * that has just started, in stretched columns, show it lower than it is. */
static double crest_at(const struct case_file *c, const struct sph *s, double about) {
  const double step = 0.02;
  struct waves w = {crest_of(amplitude), crest_of(amplitude - step), step};
  struct cloud_surface *extractor = NULL;
  struct geo_lines surface = {0};
  const struct cloud cloud = {s->f.n, s->f.w.x, s->f.w.y, NULL, s->dx, &s->tank};
  struct seen at = {amplitude, about, 0};
  EXPECT_OK(cloud_surface_create(&extractor));
  EXPECT_OK(cloud_surface_extract(extractor, &cloud, &c->walls, &surface));
  for (int k = 0; k < 8; k++) correct(&w, &surface, &at);
  cloud_surface_destroy(extractor);
  geo_lines_destroy(&surface);
  wave_crest_destroy(&w.wave);
  wave_crest_destroy(&w.less);
  return at.x;
}

/* ---- what 20 depths do ---- */

/* Of a wave that has this kinetic energy (over density, gravity and depth), near `amplitude`. */
static double amplitude_of(double kinetic) {
  const double step = 0.02;
  struct crest w = crest_of(amplitude), less = crest_of(amplitude - step);
  const double power = log(w.kinetic / less.kinetic) / log(amplitude / (amplitude - step));
  const double a = amplitude * pow(kinetic / w.kinetic, 1 / power);
  wave_crest_destroy(&w);
  wave_crest_destroy(&less);
  return a;
}

/* How far the crest is ahead of the exact one, over the way; amplitude at the end; energy lost,
 * over that of the wave; over the estimate what of that viscosity took, less what walls gave, what
 * diffusion took, and all. */
struct travel {
  double ahead, amplitude, lost, viscosity, walls, diffusion, all;
};

static struct travel measure(const struct case_file *c, struct sph *s, const struct crest *w) {
  const double end = way / w->speed, unit = s->rho0 * s->g;
  const double nu = alpha * s->c0 * s->h / 8; /* Monaghan, Rep. Prog. Phys. 68, 2005 */
  const double estimate = s->rho0 * sqrt(s->g) * nu * strain_of(w) * end;
  const struct result_energy from = sph_energy(s);
  const double x = crest_at(c, s, 0);
  EXPECT_OK(pool_march(s, end / sqrt(s->g)));
  const struct result_energy to = sph_energy(s);
  const double lost = from.total - to.total;
  return (struct travel){(crest_at(c, s, way) - x) / way - 1,
                         amplitude_of(to.kinetic / unit),
                         lost / unit / (w->kinetic + w->potential),
                         to.term[SPH_TERM_viscosity] / estimate,
                         to.term[SPH_TERM_walls] / estimate,
                         to.term[SPH_TERM_diffusion] / estimate,
                         lost / estimate};
}

static struct travel travel_with(double resolution, const char *walls) {
  char run[100];
  snprintf(run, sizeof run, "resolution: %g, alpha: %g, walls: %s", resolution, alpha, walls);
  struct case_file *c =
      pool_case("title: solitary wave\nscales: {H: 1}\n"
                "tank: {walls: [[[-11, 2], [-11, 0], [31, 0], [31, 2]]]}\n"
                "water: {wave: {kind: solitary, amplitude: 0.3, depth: 1, x: 0}}\n" POOL_TIMES,
                run);
  struct sph *s = pool_create(c);
  struct crest w = crest_of(amplitude);
  const struct travel t = measure(c, s, &w);
  printf("     %s, h/dx = %g: amplitude %.4f, %.2f %% of the energy lost, %.3f of the estimate, by "
         "viscosity %.3f, walls %.3f, diffusion %.3f; %.2f %% ahead\n",
         walls, resolution, t.amplitude, 100 * t.lost, t.all, t.viscosity, t.walls, t.diffusion,
         100 * t.ahead);
  wave_crest_destroy(&w);
  sph_destroy(s);
  case_destroy(c);
  return t;
}

/* Of the viscosity that plane shear on a lattice has, over the estimate's alpha c0 h/8. */
static const double on_lattice = 0.1173 * 8;

/* The estimate falls with h as the viscosity does, so that viscosity keeps its share of it: 1.02 as
 * long as the particles stand on their lattice, 1.12 once they do not. Ghosts make noise, more of
 * it with smaller particles, which viscosity damps: what it takes rises with the resolution by as
 * much as walls give. Mirrors, which do no work, show what is left without it. The diffusion is of
 * higher order in h: its share falls at least with h. */
static void test_a_solitary_wave_loses_what_viscosity_takes(void) {
  const struct travel coarse = travel_with(10, "ghost"), fine = travel_with(20, "ghost");
  const struct travel mirrored = travel_with(10, "mirror");
  const double held = coarse.viscosity + coarse.walls;
  EXPECT_NEAR(coarse.ahead, 0, 0.01);
  EXPECT(fabs(fine.ahead) < fabs(coarse.ahead) / 2);
  EXPECT(fine.viscosity + fine.walls > on_lattice && fine.viscosity + fine.walls < held);
  EXPECT(fine.diffusion < coarse.diffusion / 2);
  EXPECT(fine.all > on_lattice && fine.all < held + coarse.diffusion / 2);
  EXPECT(fine.lost < coarse.lost / 2); /* viscosity and diffusion go with h */
  EXPECT_NEAR(mirrored.walls, 0, 0.01);
  EXPECT_NEAR(mirrored.viscosity / held, 1, 0.05);
}

int main(void) {
  RUN(test_a_solitary_wave_loses_what_viscosity_takes);
  return TEST_RESULT;
}
