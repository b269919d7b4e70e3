/* Initial states, walls, symmetry, and the same bits for any number of threads. */
#include "tests/test.h"

#include <omp.h>

#include "common/flow/release.h"
#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/observe/probe.h"
#include "sph/time/integrator.h"
#include "sph/time/timestep.h"
#include "tests/sph/pool.h"

static enum status march(struct sph *s, int steps) {
  for (int k = 0; k < steps; k++) {
    TRY(sph_rates(s, 0, true, true));
    TRY(sph_step(s, sph_timestep(s, 1e9)));
  }
  return OK;
}

/* Zero on both free sides, Laplace's equation inside (five-point stencil, error step^2), no flux
 * through the wall, and the known pressure in the corner of the column with L/H = 2. */
static void test_released_pressure_solves_its_problem(void) {
  const double L = 1.7, H = 0.85, d = 1e-3;
  for (double t = 0.05; t < 1; t += 0.1) {
    EXPECT_NEAR(release_head(L * t, H, L, H), 0, 1e-9);
    EXPECT_NEAR(release_head(L, H * t, L, H), 0, 2e-6); /* the series ends after 10^6 terms */
    double x = L * t * 0.9 + 0.05, y = H * t * 0.9 + 0.04;
    double middle = release_head(x, y, L, H);
    double around = release_head(x + d, y, L, H) + release_head(x - d, y, L, H) +
                    release_head(x, y + d, L, H) + release_head(x, y - d, L, H);
    EXPECT_NEAR((around - 4 * middle) / (d * d), 0, 1e-4);
    EXPECT_NEAR((release_head(d, y, L, H) - release_head(0, y, L, H)) / d, 0, 2e-3);
  }
  EXPECT_NEAR(release_head(0, 0, 2, 1), 0.930060, 5e-7);
}

/* The mass is that of the compressed water, the volume that of the region, to rounding. */
static void test_water_fills_its_region_exactly(void) {
  struct case_file *c = pool_case(POOL_DAM, "resolution: 23.85");
  struct sph *s = pool_create(c);
  EXPECT_NEAR(sph_volume(s), 2 * 0.36, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* The wall particles of still water continue its linear pressure through the wall. */
static void still_water_at(const char *walls) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 20, diffusion: antuono, walls: %s", walls);
  struct case_file *c = pool_case(POOL_STILL, run);
  struct sph *s = pool_create(c);
  EXPECT_OK(sph_rates(s, 0, true, true));
  double worst = 0, D = 0, away = 0;
  for (size_t k = 0; k < s->w.n; k++)
    if (s->w.y[k] < 1)
      worst = fmax(worst, fabs(s->w.pack[k].p / (s->rho0 * s->g) - (1 - s->w.y[k])));
  for (size_t i = 0; i < s->f.n; i++) {
    double ax = s->f.k[0].u[i], ay = s->f.k[0].v[i];
    bool near_wall_and_surface = s->f.w.y[i] > 1 - 3 * s->h;
    away = fmax(away, hypot(ax, ay) / s->g * !near_wall_and_surface);
    D = fmax(D, fabs(s->f.D[i]) * !near_wall_and_surface);
  }
  /* rho* f instead of rho0 f in their pressure: g depth / c0^2 = 1/400 of what is added, 2 supports
   */
  EXPECT_NEAR(worst, 0, 2 * (s->support + s->dx) / 400);
  /* the lattice sum's error at the edge of the support (test_rates.c: 4e-4 of p over h) */
  EXPECT_NEAR(away, 0, 4e-4 * 20 * 3 / 4 * 2);
  EXPECT_NEAR(D / (s->scheme.delta * s->c0 * s->rho0 * s->g / (s->c0 * s->c0)), 0, 5e-3);
  sph_destroy(s);
  case_destroy(c);
}

static void test_walls_continue_still_water_linearly(void) {
  for (size_t k = 0; sph_wall_names[k]; k++)
    if (pool_holds_still(sph_wall_names[k])) still_water_at(sph_wall_names[k]);
}

/* Free slip: water that slides along the bed and the walls' directions feels no drag, and wall
 * particles reflect. */
static void sliding_water_at(const char *walls) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 20, alpha: 0.5, walls: %s", walls);
  struct case_file *c = pool_case(POOL_STILL, run);
  struct sph *s = pool_create(c);
  for (size_t i = 0; i < s->f.n; i++) {
    s->f.w.u[i] = 0.3;
    s->f.w.v[i] = -0.7;
  }
  sph_particles_pad(&s->f);
  EXPECT_OK(sph_rates(s, 0, true, true));
  double worst = 0;
  for (size_t k = 0; k < s->w.n; k++) {
    if (s->w.y[k] > 1) continue;
    bool side = s->w.x[k] < 0 || s->w.x[k] > 2, bed = s->w.y[k] < 0;
    worst = fmax(worst, fabs(s->w.pack[k].u - (side ? -0.3 : 0.3)));
    worst = fmax(worst, fabs(s->w.pack[k].v - (bed ? 0.7 : -0.7)));
  }
  EXPECT_NEAR(worst, 0, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

static void test_walls_reflect_the_normal_velocity_and_keep_the_tangential(void) {
  for (size_t k = 0; sph_wall_names[k]; k++)
    if (pool_reflects(sph_wall_names[k])) sliding_water_at(sph_wall_names[k]);
}

/* The power that walls take out of noisy water against the right one, of which `water` gives left,
 * low and high edge, over what it would be if every term of the sum counted by its size. */
static double power_of_noise(const char *walls, const char *precision, double g,
                             const double water[3]) {
  char run[200], head[500];
  snprintf(run, sizeof run, "resolution: 20, diffusion: none, alpha: 0, walls: %s, precision: %s",
           walls, precision);
  snprintf(head, sizeof head,
           "title: sheet on a wall\nscales: {H: 1}\n"
           "tank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]]}\n"
           "water: {regions: [[[%g, %g], [1, %g], [1, %g], [%g, %g]]], "
           "pressure: hydrostatic}\n" POOL_TIMES,
           water[0], water[1], water[1], water[2], water[0], water[2]);
  struct case_file *c = pool_case(head, run);
  struct sph *s = pool_create(c);
  pool_set_gravity(s, g);
  pool_shake(s, 0.2, 1, s->rho0 * s->c0); /* the pressure of sound at this speed */
  EXPECT_OK(sph_rates(s, 0, true, true));
  double size = 0;
  for (size_t i = 0; i < s->f.n; i++)
    size += s->rho0 * s->c0 * pool_V(s, i) / s->h * (s->f.w.x[i] > 1 - 3 * s->h);
  double power = s->totals.walls / size;
  printf("     %s: power of the wall on noise %.1e\n", walls, power);
  sph_destroy(s);
  case_destroy(c);
  return power;
}

/* Upright walls do none; nor do, without weight, a bed and its corners. */
static void test_mirrors_do_no_work_on_noise(void) {
  const double clear_of_bed[3] = {0.7, 0.5, 1.5}, in_corner[3] = {0.7, 0, 1};
  power_of_noise("ghost", "double", 9.81, clear_of_bed);
  EXPECT_NEAR(power_of_noise("mirror", "double", 9.81, clear_of_bed), 0, 1e-12);
  EXPECT_NEAR(power_of_noise("mirror", "single", 9.81, clear_of_bed), 0, 1.2e-7);
  EXPECT_NEAR(power_of_noise("mirror", "double", 0, in_corner), 0, 1e-12);
  EXPECT(fabs(power_of_noise("mirror", "double", 9.81, in_corner)) > 1e-9);
}

static void by_id(const struct sph *s, double (*out)[5]) {
  for (size_t i = 0; i < s->f.n; i++) {
    double *o = out[s->f.id[i]];
    o[0] = s->f.w.x[i];
    o[1] = s->f.w.y[i];
    o[2] = s->f.w.u[i];
    o[3] = s->f.w.v[i];
    o[4] = s->f.w.rho[i];
  }
}

/* Walls that are drawn with further points along them are the same walls. */
static void test_mirrors_know_no_points_along_a_wall(void) {
  static double state[2][4000][5];
  size_t n = 0;
  for (int k = 0; k < 2; k++) {
    struct case_file *c = pool_case(POOL_DAM, "resolution: 20, walls: mirror, precision: double");
    if (k == 1) {
      const double H = c->H, W = 5.366 * H;
      const double p[][2] = {{0, 3 * H},   {0, 0.71 * H}, {0, 0.7 * H}, {0, 0},
                             {1.3 * H, 0}, {W, 0},        {W, 3 * H}};
      geo_lines_clear(&c->walls);
      EXPECT_OK(geo_lines_begin(&c->walls, false));
      for (size_t i = 0; i < sizeof p / sizeof *p; i++)
        EXPECT_OK(geo_lines_add(&c->walls, p[i][0], p[i][1]));
    }
    struct sph *s = pool_create(c);
    EXPECT_OK(march(s, 60));
    n = s->f.n;
    by_id(s, state[k]);
    sph_destroy(s);
    case_destroy(c);
  }
  double worst = 0;
  for (size_t i = 0; i < n; i++)
    for (int a = 0; a < 4; a++) worst = fmax(worst, fabs(state[1][i][a] - state[0][i][a]));
  EXPECT_NEAR(worst, 0, 1e-10); /* rounding of sums in another order, amplified by 60 steps */
}

/* A particle on its way through a wall is next to its own image, which must not stop the clock. */
static void test_mirrors_let_a_particle_touch_the_wall(void) {
  struct case_file *c = pool_case(POOL_STILL, "resolution: 20, walls: mirror");
  struct sph *s = pool_create(c);
  s->f.w.x[0] = 1e-9;
  s->f.w.u[0] = -1;
  EXPECT_OK(sph_neighbours_update(s));
  EXPECT_OK(sph_rates(s, 0, true, true));
  EXPECT(sph_timestep(s, 1) > 0.05 * s->h / s->c0);
  sph_destroy(s);
  case_destroy(c);
}

/* The dam break without viscosity and diffusion, in which nothing damps the noise that the impact
 * on the far wall leaves: what the bed does stays small, and energy does not grow. */
static void test_mirrors_do_not_pump_energy_into_the_dam_break(void) {
  struct case_file *c = pool_case(
      POOL_DAM, "resolution: 15, diffusion: none, alpha: 0, integrator: rk4, walls: mirror");
  struct sph *s = pool_create(c);
  double before = sph_energy(s).total, most = 0;
  const double end = 5 * sqrt(c->H / s->g);
  while (s->t < end) {
    EXPECT_OK(sph_remove_outside(s));
    EXPECT_OK(sph_rates(s, 0, true, true));
    if (sph_step(s, sph_timestep(s, end)) != OK) break;
    most = fmax(most, sph_energy(s).total / before - 1);
  }
  printf("     energy grew by %.1e at most, walls took %.1e\n", most, s->budget.walls / before);
  EXPECT(most < 1e-3);
  EXPECT_NEAR(s->budget.walls / before, 0, 3e-3);
  sph_destroy(s);
  case_destroy(c);
}

static double pressure(const struct sph *s, const struct case_probe *probe,
                       const struct case_file *c) {
  double p = NAN;
  EXPECT_OK(sph_probe(s, probe, &c->walls, &p));
  return p;
}

/* Hydrostatic pressure at the wall: linear, so the fit is exact up to the elastic part; the mean
 * over a size is that of the middle. */
static void test_probes_read_still_water(void) {
  struct case_file *c = pool_case(POOL_STILL, "resolution: 20");
  struct sph *s = pool_create(c);
  sph_pack_water(s);
  struct case_probe probe = {.x = 2, .y = 0.2385};
  double P = s->rho0 * s->g;
  EXPECT_NEAR(pressure(s, &probe, c) / P, 1 - 0.2385, 1e-9);
  probe.size = 0.1;
  EXPECT_NEAR(pressure(s, &probe, c) / P, 1 - 0.2385, 1e-9);
  probe = (struct case_probe){.x = 0.77, .y = 0, .size = 0.05};
  EXPECT_NEAR(pressure(s, &probe, c) / P, 1, 1e-9);
  probe = (struct case_probe){.x = 0, .y = 1.9};
  EXPECT(pressure(s, &probe, c) == 0); /* dry */
  sph_destroy(s);
  case_destroy(c);
}

static void march_with_threads_at(const char *walls) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 20, diffusion: antuono, walls: %s", walls);
  static double state[2][4000][5];
  int most = omp_get_max_threads();
  struct sph_budget budget[2];
  size_t n = 0;
  for (int k = 0; k < 2; k++) {
    omp_set_num_threads(1 + 2 * k);
    struct case_file *c = pool_case(POOL_DAM, run);
    struct sph *s = pool_create(c);
    EXPECT_OK(march(s, 60));
    n = s->f.n;
    by_id(s, state[k]);
    budget[k] = s->budget;
    sph_destroy(s);
    case_destroy(c);
  }
  omp_set_num_threads(most);
  EXPECT(n > 700);
  EXPECT(memcmp(state[0], state[1], n * sizeof *state[0]) == 0);
  EXPECT(memcmp(&budget[0], &budget[1], sizeof *budget) == 0);
}

static void test_bits_do_not_depend_on_the_number_of_threads(void) {
  for (size_t k = 0; sph_wall_names[k]; k++) march_with_threads_at(sph_wall_names[k]);
}

/* The dam at the right wall is the mirror image of the dam at the left one; sums run in another
 * order, so the difference is rounding, which 60 steps amplify a little. */
static void mirrored_case_at(const char *walls) {
  char run[200];
  snprintf(run, sizeof run, "resolution: 20, diffusion: antuono, precision: double, walls: %s",
           walls);
  struct case_file *c[2];
  struct sph *s[2];
  c[0] = pool_case(POOL_DAM, run);
  c[1] = pool_case("title: mirrored\nscales: {H: 0.6}\n"
                   "tank: {walls: [[[0, 3 H], [0, 0], [5.366 H, 0], [5.366 H, 3 H]]]}\n"
                   "water: {regions: [[[3.366 H, 0], [5.366 H, 0], [5.366 H, H], [3.366 H, H]]], "
                   "pressure: released}\n" POOL_TIMES,
                   run);
  for (int k = 0; k < 2; k++) {
    s[k] = pool_create(c[k]);
    EXPECT_OK(march(s[k], 60));
  }
  struct result_energy a = sph_energy(s[0]), b = sph_energy(s[1]);
  EXPECT_NEAR(b.kinetic / a.kinetic, 1, 1e-10);
  EXPECT_NEAR(b.total / a.total, 1, 1e-12);
  EXPECT_NEAR(s[1]->budget.viscosity / s[0]->budget.viscosity, 1, 1e-10);
  double front = 0, mirrored = 1e9, width = 5.366 * 0.6;
  for (size_t i = 0; i < s[0]->f.n; i++) {
    front = fmax(front, s[0]->f.w.x[i]);
    mirrored = fmin(mirrored, s[1]->f.w.x[i]);
  }
  EXPECT(front > 1.25);
  EXPECT_NEAR(width - mirrored, front, 1e-10);
  for (int k = 0; k < 2; k++) {
    sph_destroy(s[k]);
    case_destroy(c[k]);
  }
}

static void test_mirrored_case_gives_the_mirrored_result(void) {
  for (size_t k = 0; sph_wall_names[k]; k++) mirrored_case_at(sph_wall_names[k]);
}

/* d e = p/rho^2 d rho, zero at rho0. By a central difference, whose own error at x = rho/rho0 - 1
 * is (2/3) d^2/x of it with d = 1e-5, so 7e-9 at most. */
static void test_elastic_energy_is_the_work_of_the_pressure(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20");
  struct sph *s = pool_create(c);
  pool_set_gravity(s, 0);
  const double m = s->f.m[0], d = 1e-5 * s->rho0;
  s->f.w.rho[0] = s->rho0;
  EXPECT(sph_energy_of(s, 0) == 0);
  for (double x = -0.03; x < 0.04; x += 0.02) {
    double rho = s->rho0 * (1 + x), e[2];
    for (int k = 0; k < 2; k++) {
      s->f.w.rho[0] = rho + (k ? d : -d);
      e[k] = sph_energy_of(s, 0);
    }
    s->f.w.rho[0] = rho;
    EXPECT_NEAR((e[1] - e[0]) / (2 * d) / (m * pool_p(s, 0) / (rho * rho)), 1, 1e-8);
    EXPECT(sph_energy_of(s, 0) > 0);
  }
  sph_destroy(s);
  case_destroy(c);
}

/* Water thrown at a wall comes back with its energy. */
static void test_water_that_crosses_a_wall_is_reflected(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20");
  struct sph *s = pool_create(c);
  s->f.w.x[0] = -0.01;
  s->f.w.u[0] = -2;
  s->f.w.y[1] = -0.02;
  s->f.w.v[1] = -3;
  struct result_energy before = sph_energy(s);
  sph_wall_confine(s);
  struct result_energy after = sph_energy(s);
  EXPECT_NEAR(s->f.w.x[0], 0.01, 1e-15);
  EXPECT_NEAR(s->f.w.u[0], 2, 1e-15);
  EXPECT_NEAR(s->f.w.y[1], 0.02, 1e-15);
  EXPECT_NEAR(s->f.w.v[1], 3, 1e-15);
  EXPECT(s->reflections == 2);
  EXPECT_NEAR(result_energy_budget(&after), result_energy_budget(&before), 1e-10 * before.total);
  EXPECT(s->budget.walls != 0);
  sph_destroy(s);
  case_destroy(c);
}

/* A particle outside the tank is taken out, and its energy and volume are booked. */
static void test_water_outside_the_tank_is_removed_and_counted(void) {
  struct case_file *c = pool_case(POOL_DROP, "resolution: 20");
  struct sph *s = pool_create(c);
  size_t n = s->f.n;
  struct result_energy before = sph_energy(s);
  double volume = sph_volume(s);
  s->f.w.x[7] = -1;
  EXPECT_OK(sph_remove_outside(s));
  struct result_energy after = sph_energy(s);
  EXPECT(s->f.n == n - 1);
  EXPECT_NEAR(after.total + after.removed, before.total, 1e-12 * before.total);
  EXPECT_NEAR(sph_volume(s) + s->budget.removed_volume, volume, 1e-13);
  EXPECT_OK(march(s, 3));
  sph_destroy(s);
  case_destroy(c);
}

/* A step that starts again because the lists did not hold ends where it would have, beside both
 * kinds of walls and with the diffusion frozen: what was kept for the step is made anew. Rounding
 * of sums in another order. */
static void a_step_again_at(const char *walls) {
  char run[100];
  snprintf(run, sizeof run,
           "resolution: 12, alpha: 0.01, integrator: rk4-frozen, precision: double, walls: %s",
           walls);
  double x[2][1000], rho[2][1000];
  for (int k = 0; k < 2; k++) {
    struct case_file *c = pool_case(POOL_DAM, run);
    struct sph *s = pool_create(c);
    EXPECT_OK(march(s, 40));
    EXPECT_OK(sph_rates(s, 0, true, true));
    size_t rebuilds = s->rebuilds;
    if (k == 1) s->skin = 1e-6 * s->dx;
    EXPECT_OK(sph_step(s, sph_timestep(s, 1e9)));
    EXPECT(s->rebuilds == rebuilds + (size_t)k);
    for (size_t i = 0; i < s->f.n; i++) {
      x[k][s->f.id[i]] = s->f.w.x[i];
      rho[k][s->f.id[i]] = s->f.w.rho[i];
    }
    if (k == 1)
      for (size_t i = 0; i < s->f.n; i++) {
        EXPECT_NEAR(x[1][i], x[0][i], 1e-13);
        EXPECT_NEAR(rho[1][i], rho[0][i], 1e-10);
      }
    sph_destroy(s);
    case_destroy(c);
  }
}

static void test_a_step_starts_again_beside_walls(void) {
  a_step_again_at("ghost");
  a_step_again_at("mirror");
}

/* Lists are wider where the water is fast; how wide must not count. Water above the top of a wall
 * has an image in wide lists, without volume: the bound on the time step does not see it (an image
 * with volume would be the nearest thing that approaches the water below). A kicked particle widens
 * lists to 20 dx at most, and they are narrow again when it is gone. */
static void test_width_of_lists_changes_nothing(void) {
  double speed[2];
  for (int k = 0; k < 2; k++) {
    struct case_file *c = pool_case(
        "title: brim\nscales: {H: 1}\ntank: {walls: [[[0, 1], [0, 0], [1, 0], [1, 1]]]}\n"
        "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES,
        "resolution: 12, walls: mirror, precision: double");
    struct sph *s = pool_create(c);
    size_t last = s->f.n - 1, above = last - 1;
    s->f.w.x[last] = 1.5 * s->dx;
    s->f.w.y[last] = 1 - 0.05 * s->dx;
    s->f.w.x[above] = 0.1 * s->dx;
    s->f.w.y[above] = 1 + 0.65 * s->dx;
    s->f.w.u[last] = s->f.w.u[above] = -20;
    if (k == 1) s->dt = s->dx / 20 * 3; /* 3 dx in the last step */
    sph_particles_pad(&s->f);
    EXPECT_OK(sph_rates(s, 0, true, true));
    EXPECT((s->wall_skin > 6 * s->dx) == (k == 1));
    speed[k] = s->totals.speed;
    s->f.w.u[0] = 1e6;
    s->dt = 1;
    EXPECT_OK(sph_neighbours_update(s));
    EXPECT_NEAR(s->skin / s->dx, 20, 1e-9);
    for (size_t i = 0; i < s->f.n; i++) s->f.w.u[i] = 0;
    EXPECT_OK(sph_neighbours_update(s));
    EXPECT_NEAR(s->skin / s->dx, 0.4, 1e-9);
    sph_destroy(s);
    case_destroy(c);
  }
  EXPECT_NEAR(speed[1] / speed[0], 1, 1e-12);
}

/* What the pressure of let-go water takes before the first step, which threads do not share: more
 * than in proportion to the particles. */
static void test_estimates_count_the_start(void) {
  double more[2];
  for (int fine = 0; fine < 2; fine++) {
    struct solver_estimate e[2];
    for (int released = 0; released < 2; released++) {
      char head[500];
      snprintf(head, sizeof head,
               "title: column\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [3, 0], [3, 2]]]}\n"
               "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]], pressure: %s}\n" POOL_TIMES,
               released ? "released" : "hydrostatic");
      struct case_file *c = pool_case(head, fine ? "resolution: 320" : "resolution: 160");
      sph_solver.estimate(c, &c->runs[0], &e[released]);
      case_destroy(c);
    }
    EXPECT(e[0].shared == 1);
    more[fine] = e[1].seconds - e[0].seconds;
    EXPECT_NEAR(e[1].seconds * (1 - e[1].shared), more[fine], 1e-9 * e[1].seconds);
  }
  EXPECT(more[0] > 0.1 && more[1] > 4 * more[0]);
}

int main(void) {
  RUN(test_released_pressure_solves_its_problem);
  RUN(test_water_fills_its_region_exactly);
  RUN(test_walls_continue_still_water_linearly);
  RUN(test_walls_reflect_the_normal_velocity_and_keep_the_tangential);
  RUN(test_mirrors_do_no_work_on_noise);
  RUN(test_mirrors_know_no_points_along_a_wall);
  RUN(test_mirrors_let_a_particle_touch_the_wall);
  RUN(test_mirrors_do_not_pump_energy_into_the_dam_break);
  RUN(test_probes_read_still_water);
  RUN(test_bits_do_not_depend_on_the_number_of_threads);
  RUN(test_mirrored_case_gives_the_mirrored_result);
  RUN(test_elastic_energy_is_the_work_of_the_pressure);
  RUN(test_water_that_crosses_a_wall_is_reflected);
  RUN(test_water_outside_the_tank_is_removed_and_counted);
  RUN(test_a_step_starts_again_beside_walls);
  RUN(test_width_of_lists_changes_nothing);
  RUN(test_estimates_count_the_start);
  return TEST_RESULT;
}
