/* Sides of the tank that move: pistons and flaps. */
#include <omp.h>

#include "sph/domain/wall.h"
#include "sph/fluid/energy.h"
#include "sph/observe/probe.h"
#include "sph/pair/sums.h"
#include "tests/sph/pool.h"
#include "tests/test.h"

#define BASIN                                                                                      \
  "title: basin\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [2, 2]]], motions: "      \
  "[%s]}\n"                                                                                        \
  "water: {regions: [[[0, 0], [2, 0], [2, 1], [0, 1]]], pressure: hydrostatic}\n" POOL_TIMES

static struct case_file *basin_case(const char *motions, const char *run) {
  char head[1000];
  snprintf(head, sizeof head, BASIN, motions);
  return pool_case(head, run);
}

/* How far particles are from the walls where they are, m: the least. */
static double least_way(const struct sph *s) {
  double least = INFINITY;
  for (size_t i = 0; i < s->f.n; i++)
    for (size_t k = 0; k < s->faces.n; k++) {
      const struct face *f = &s->faces.face[k];
      const double at = face_along(f, s->f.w.x[i], s->f.w.y[i]);
      if (at < 0 || at > f->length) continue;
      least = fmin(least, face_distance(f, s->f.w.x[i], s->f.w.y[i]));
    }
  return least;
}

/* ---- the frame ---- */

#define SHIFT "amplitude: 0.15, period: 1.1, ramp: 0.8"

/* Where particles are by identity in the laboratory, m, [2 n]; the caller's. */
static double *places(const char *motions, double dt, const char *walls, size_t *n) {
  char run[200];
  snprintf(run, sizeof run,
           "resolution: 10, precision: double, integrator: rk4, alpha: 0.05, kernel: "
           "wendland_c2, dt: %g, walls: %s",
           dt, walls);
  struct case_file *c = basin_case(motions, run);
  struct sph *s = pool_create(c);
  struct tank_frame f = {0};
  const double before = sph_energy(s).total;
  EXPECT_OK(pool_march(s, 0.6));
  const struct result_energy e = sph_energy(s);
  EXPECT_NEAR((result_energy_budget(&e) - before) / e.kinetic, 0, 1e-4);
  EXPECT(least_way(s) > 0);
  tank_frame_at(c->motions, c->n_motions, s->t, &f);
  double *r = calloc(2 * s->f.n, sizeof *r);
  *n = s->f.n;
  for (size_t i = 0; i < s->f.n; i++) {
    r[2 * s->f.id[i]] = s->f.w.x[i] + f.at[0];
    r[2 * s->f.id[i] + 1] = s->f.w.y[i];
  }
  sph_destroy(s);
  case_destroy(c);
  return r;
}

static double off_frame(double dt, const char *walls) {
  static const char *const pistons =
      "{kind: piston, side: left, " SHIFT "}, {kind: piston, side: right, " SHIFT "}";
  size_t n, m;
  double *a = places("{kind: sway, " SHIFT "}", dt, walls, &n);
  double *b = places(pistons, dt, walls, &m), worst = 0;
  EXPECT(n == m && n == 200);
  for (size_t i = 0; i < 2 * n && n == m; i++) worst = fmax(worst, fabs(a[i] - b[i]));
  free(a);
  free(b);
  return worst;
}

/* Two pistons that move the whole tank, and a tank that sways: the same equations in two frames,
 * which steps of fourth order solve alike but for dt^4. With a kernel that is smooth at the end of
 * its support: the truncated Gaussian jumps there by 1e-4, where rounding decides what counts. */
static void test_pistons_that_move_the_tank_make_it_sway(void) {
  static const char *const walls[] = {"ghost", "mirror", "mirror-plain"};
  for (int k = 0; k < 3; k++) {
    const double coarse = off_frame(2e-3, walls[k]), fine = off_frame(1e-3, walls[k]);
    printf("     %s: off by %.1e and %.1e H in steps of 2 and 1 ms\n", walls[k], coarse, fine);
    EXPECT(coarse < 1e-7);
    EXPECT(fine < coarse / 8);
  }
}

/* ---- linear theory ---- */

/* A side that moves as q f(y), f = 1 for a piston and y - hinge above the hinge of a flap, in a
 * tank of length L and depth h: with Green's identity of phi and cos(k x) cosh(k y), k = n pi/L,
 *
 *   eta_n'' + g k tanh(k h) eta_n = 2/(L cosh k h) q'' int_0^h f cosh k y dy,
 *
 * and the mean surface rises by q/L int f dy. */
struct wavemaker {
  const char *motion;
  double hinge; /* m; below the bed: a piston */
};

static double depth_of_side(const struct wavemaker *w, double h) {
  return w->hinge < 0 ? h : (h - w->hinge) * (h - w->hinge) / 2;
}

static double flux_of_side(const struct wavemaker *w, double k, double h) {
  if (w->hinge < 0) return sinh(k * h) / k;
  return (h - w->hinge) * sinh(k * h) / k - (cosh(k * h) - cosh(k * w->hinge)) / (k * k);
}

/* Of the centre of the water from the middle of the tank at rest, m. */
static double linear_centre(const struct case_file *c, const struct wavemaker *w, double L,
                            double h, double end) {
  const int steps = 20000;
  double q[3];
  tank_motion_at(&c->motions[0], end, q);
  double sum = depth_of_side(w, h) * q[0] / L * L * L / 2;
  for (int n = 1; n < 40; n += 2) {
    const double k = n * M_PI / L, lift = k * tanh(k * h);
    const double drive = 2 / (L * cosh(k * h)) * flux_of_side(w, k, h);
    double eta = 0, rate = 0;
    for (int i = 0; i < steps; i++) { /* leapfrog */
      tank_motion_at(&c->motions[0], end * i / steps, q);
      rate += end / steps * (i ? 1 : 0.5) * (drive * q[2] - c->gravity * lift * eta);
      eta += end / steps * rate;
    }
    sum -= 2 * eta / (k * k);
  }
  return sum / (L * h);
}

/* How far the centre of the water is from linear theory within two periods, over the farthest that
 * it goes. */
static double off_theory(const struct wavemaker *w, const char *walls, double resolution) {
  const double L = 2, h = 1, period = 2.2;
  char run[100];
  snprintf(run, sizeof run, "resolution: %g, alpha: 0.005, walls: %s", resolution, walls);
  struct case_file *c = basin_case(w->motion, run);
  struct sph *s = pool_create(c);
  const double before = sph_energy(s).total;
  double worst = 0, most = 0;
  for (int i = 1; i <= 16; i++) {
    double x = 0, mass = 0;
    EXPECT_OK(pool_march(s, i * period / 8));
    for (size_t j = 0; j < s->f.n; j++) {
      x += s->f.m[j] * s->f.w.x[j];
      mass += s->f.m[j];
    }
    const double expected = linear_centre(c, w, L, h, s->t);
    worst = fmax(worst, fabs(x / mass - L / 2 - expected));
    most = fmax(most, fabs(expected));
  }
  const struct result_energy e = sph_energy(s);
  const double given = -e.term[SPH_TERM_sides];
  printf("     %s, H/dx = %g: centre off by %.2g of %.3g m; sides gave %.3g J/m, walls %.2g\n",
         walls, resolution, worst, most, given, -e.term[SPH_TERM_walls]);
  EXPECT(given > 0);
  EXPECT_NEAR((result_energy_budget(&e) - before) / given, 0, 1e-3);
  EXPECT_NEAR(e.term[SPH_TERM_walls] / given, 0, 10 / (resolution * resolution));
  EXPECT(least_way(s) > 0);
  sph_destroy(s);
  case_destroy(c);
  return worst / most;
}

/* The lattice and the viscosity, both of which fall with the spacing. With a fifth of the stroke
 * the disorder of the lattice keeps the centre 3 % off at any spacing. */
static void test_pistons_and_flaps_make_the_waves_of_linear_theory(void) {
  static const struct wavemaker makers[] = {
      {"{kind: piston, side: left, amplitude: 0.04, period: 2.2}", -1},
      {"{kind: flap, side: left, amplitude: 0.07, period: 2.2}", 0},
      {"{kind: flap, side: left, amplitude: 0.12, period: 2.2, hinge: 0.4}", 0.4}};
  double coarse = 0;
  for (int k = 2; k >= 0; k--) {
    coarse = off_theory(&makers[k], "ghost", 10);
    EXPECT(coarse < 0.1);
  }
  EXPECT(off_theory(&makers[0], "mirror", 10) < 0.1);
  EXPECT(off_theory(&makers[0], "ghost", 20) < 0.75 * coarse);
}

/* ---- where things are ---- */

static const char *const both =
    "{kind: piston, side: left, amplitude: 0.3, period: 1.6}, {kind: flap, side: right, amplitude: "
    "0.2, period: 1.1, hinge: 0.5}";

/* As beside walls that stand (test_tanks.c): the sum of W V of water and ghosts is 1, here at
 * points of a lattice that fills the tank as it is, but what a lattice that is stretched makes of
 * it, and cells of a corner that bends. */
static void test_ghosts_follow_their_walls(void) {
  struct case_file *c = basin_case(both, "resolution: 20, precision: double");
  struct sph *s = pool_create(c);
  sph_tank_set(s, 1);
  const double left = s->faces.face[0].b[0], bed = s->faces.face[1].length;
  EXPECT(fabs(left) > 0.1);
  for (size_t i = 0; i < s->f.n; i++) s->f.w.x[i] = left + s->f.w.x[i] / 2 * bed;
  for (size_t i = 0; i < s->f.n; i++) s->f.m[i] *= bed / 2;
  sph_particles_pad(&s->f);
  s->t = 1;
  s->force.motion = c->motions;
  EXPECT_OK(sph_neighbours_widen(s));
  EXPECT_OK(sph_rates(s, 0, true, true));
  double least = INFINITY, most = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const double x = s->f.w.x[i], y = s->f.w.y[i];
    if (y > 1 - s->support || (x > 2 - s->support && y > 0.5 - s->support)) continue;
    const struct sph_fit_sums a = sph_sums_around(s, i / SPH_LANES, SPH_OF_WATER | SPH_OF_WALLS);
    least = fmin(least, a.w[i % SPH_LANES] / M_PI);
    most = fmax(most, a.w[i % SPH_LANES] / M_PI);
  }
  printf("     bed %.3f m: sum of W V from %.4f to %.4f\n", bed, least, most);
  EXPECT(least > 0.98 && most < 1.025);
  sph_destroy(s);
  case_destroy(c);
}

/* A particle at rest that a piston passes comes out before it with twice its speed. */
static void test_a_piston_pushes_what_it_meets(void) {
  struct case_file *c =
      basin_case("{kind: piston, side: left, amplitude: 0.3, period: 1.6}", "resolution: 12");
  struct sph *s = pool_create(c);
  sph_tank_set(s, 0.5);
  sph_wall_begin(s);
  const double at = s->faces.face[0].b[0];
  sph_tank_set(s, 0.51);
  const double now = s->faces.face[0].b[0], speed = s->sides.v[1][0];
  for (size_t i = 0; i < s->f.n; i++) s->f.w0.x[i] = s->f.w.x[i] = 1.5;
  for (size_t i = 0; i < s->f.n; i++) s->f.w0.y[i] = s->f.w.y[i];
  s->f.w0.x[0] = s->f.w.x[0] = at + 0.1 * (now - at);
  s->f.w.y[0] = s->f.w0.y[0] = 0.4;
  sph_wall_confine(s);
  EXPECT(now > at && s->reflections == 1);
  EXPECT_NEAR(s->f.w.x[0], now + 0.9 * (now - at), 1e-12);
  EXPECT_NEAR(s->f.w.u[0], 2 * speed, 1e-12);
  EXPECT_NEAR(s->budget.sides, -2 * s->f.m[0] * speed * speed, 1e-12);
  sph_destroy(s);
  case_destroy(c);
}

/* A piston goes a tenth of the tank, slowly: the water stays water, and stands as high as it must.
 */
static void test_a_slow_piston_lifts_the_water(void) {
  struct case_file *c =
      basin_case("{kind: piston, side: left, amplitude: 0.2, period: 16, ramp: 4}",
                 "resolution: 16, alpha: 0.1");
  struct sph *s = pool_create(c);
  const double volume = sph_volume(s);
  EXPECT_OK(pool_march(s, 4));
  const double rest = 0.5 * s->rho0 * s->g * 4 / 1.8;
  printf("     volume %+.1e, potential energy %+.1e\n", sph_volume(s) / volume - 1,
         sph_energy(s).potential / rest - 1);
  EXPECT_NEAR(sph_volume(s) / volume, 1, 1e-3); /* depths are 11 % greater, and so are pressures */
  EXPECT_NEAR(sph_energy(s).potential / rest, 1, 5e-3);
  EXPECT(s->budget.removed_volume == 0 && least_way(s) > 0);
  sph_destroy(s);
  case_destroy(c);
}

/* The depth of an area A of water over a bed of length B, beside one upright side and one that
 * leans by `lean` to its height. */
static double depth_over(double A, double B, double lean) {
  return 2 * A / (B + sqrt(B * B + 2 * lean * A));
}

/* What a side that goes `way` towards the water does against the weight of that, which stays level:
 * int rho g h^2/2 dq, however it leans, J/m. */
static double work_against_weight(const struct sph *s, double A, double B, double lean,
                                  double way) {
  const int n = 1000;
  double sum = 0;
  for (int i = 0; i < n; i++) {
    const double h = depth_over(A, B - (i + 0.5) / n * way, lean);
    sum += s->rho0 * s->g * h * h / 2 * way / n;
  }
  return sum;
}

/* Of a slow piston that leans by `lean` to its height: how far what the budget says of its work is
 * from that, over that; and what the walls did. */
static double off_work(double lean, double resolution, double *walls) {
  char head[1000], run[100];
  snprintf(
      head, sizeof head,
      "title: basin\nscales: {H: 1}\ntank: {walls: [[[%g, 2], [0, 0], [2, 0], [2, 2]]], "
      "motions: [{kind: piston, side: left, amplitude: 0.2, period: 16, ramp: 4}]}\n"
      "water: {regions: [[[0, 0], [2, 0], [2, 1], [%g, 1]]], pressure: hydrostatic}\n" POOL_TIMES,
      -2 * lean, -lean);
  snprintf(run, sizeof run, "resolution: %g, alpha: 0.1", resolution);
  struct case_file *c = pool_case(head, run);
  struct sph *s = pool_create(c);
  EXPECT_OK(pool_march(s, 4));
  const double work = work_against_weight(s, 2 + lean / 2, 2, lean, 0.2);
  const struct result_energy e = sph_energy(s);
  const double given = -e.term[SPH_TERM_sides];
  *walls = e.term[SPH_TERM_walls] / work;
  printf("     leaning by %g, H/dx = %g: sides gave %.4g J/m, %+.1e of the work against weight "
         "more; walls took %+.1e of it\n",
         lean, resolution, given, given / work - 1, *walls);
  sph_destroy(s);
  case_destroy(c);
  return given / work - 1;
}

/* Within a quarter of a spacing of the depth (of still water a dynamic part of a few tenths of a
 * percent is left), and less with a finer one. */
static void test_a_slow_piston_works_against_the_weight(void) {
  for (double lean = 0; lean <= 1; lean += 0.5) {
    double walls;
    const double coarse = off_work(lean, 8, &walls);
    EXPECT_NEAR(coarse, 0, 0.25 / 8);
    EXPECT_NEAR(walls, 0, 0.01);
    EXPECT_NEAR(off_work(lean, 16, &walls), 0, fabs(coarse) / 1.5);
    EXPECT_NEAR(walls, 0, 0.01);
  }
}

/* ---- what is beside them ---- */

/* Of water at rest beside a piston that has gone 0.3 sin(0.5 2 pi/1.6) R(0.5/1.6) = 0.046 m. */
static void test_a_probe_behind_a_piston_reads_nothing(void) {
  struct case_file *c =
      basin_case("{kind: piston, side: left, amplitude: 0.3, period: 1.6}", "resolution: 12");
  struct sph *s = pool_create(c);
  static const struct {
    double x, y, size;
    bool hidden;
  } probe[] = {{0.02, 0, 0, true}, {0.06, 0, 0, false}, {0.09, 0, 0.1, true}, {0.2, 0, 0.1, false}};
  for (int k = 0; k < 8; k++) {
    const bool gone = k >= 4;
    double p;
    if (k == 4) sph_tank_set(s, 0.5);
    sph_pack_pressure_of_probes(s);
    const struct case_probe at = {
        .x = probe[k % 4].x, .y = probe[k % 4].y, .size = probe[k % 4].size};
    EXPECT_OK(sph_probe(s, &at, sph_sides_walls(s, &c->walls), &p));
    if (gone && probe[k % 4].hidden)
      EXPECT(isnan(p));
    else
      EXPECT_NEAR(p / (s->rho0 * s->g), 1, 0.05);
  }
  EXPECT(s->faces.face[0].b[0] > 0.04 && s->faces.face[0].b[0] < 0.06);
  sph_destroy(s);
  case_destroy(c);
}

/* Past the edge of a bed that a piston shortens as many ghosts as the support needs when they were
 * divided: else they change places while they follow. */
static void test_ghosts_past_an_edge_keep_their_places(void) {
  struct case_file *c = pool_case(
      "title: sill\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [2, 0], [0.5, -0.3], [0.5, "
      "-1], "
      "[4, -1], [4, 2]]], motions: [{kind: piston, side: left, amplitude: 0.15, period: 2}]}\n"
      "water: {regions: [[[2.5, -1], [4, -1], [4, 0], [2.5, 0]]], pressure: "
      "hydrostatic}\n" POOL_TIMES,
      "resolution: 10");
  struct sph *s = pool_create(c);
  double *was = calloc(2 * s->w.n, sizeof *was), most = 0;
  EXPECT(s->faces.face[1].end[1] == FACE_END_EDGE);
  for (int step = 0; step <= 70; step++) {
    sph_tank_set(s, 0.01 * step);
    for (size_t i = 0; i < s->w.n; i++) {
      if (step) most = fmax(most, hypot(s->w.x[i] - was[2 * i], s->w.y[i] - was[2 * i + 1]));
      was[2 * i] = s->w.x[i];
      was[2 * i + 1] = s->w.y[i];
    }
  }
  printf("     ghosts went at most %.3g m in a step, the piston %.3g m in all\n", most,
         s->faces.face[0].b[0]);
  EXPECT(most < 0.01 && s->faces.face[0].b[0] > 0.02);
  free(was);
  sph_destroy(s);
  case_destroy(c);
}

static double sum_with(int threads, const char *walls, const char *motions) {
  char run[100];
  snprintf(run, sizeof run, "resolution: 12, walls: %s", walls);
  struct case_file *c = basin_case(motions, run);
  const int most = omp_get_max_threads();
  omp_set_num_threads(threads);
  struct sph *s = pool_create(c);
  EXPECT_OK(pool_march(s, 0.3));
  omp_set_num_threads(most);
  double sum = s->budget.sides;
  for (size_t i = 0; i < s->f.n; i++) sum += s->f.w.x[i] * s->f.w.v[i];
  sph_destroy(s);
  case_destroy(c);
  return sum;
}

static void test_any_number_of_threads_gives_the_same_bits(void) {
  static const char *const piston = "{kind: piston, side: left, amplitude: 0.3, period: 1.6}";
  for (int threads = 2; threads <= 3; threads++) {
    EXPECT(sum_with(threads, "ghost", both) == sum_with(1, "ghost", both));
    EXPECT(sum_with(threads, "mirror", piston) == sum_with(1, "mirror", piston));
  }
}

int main(void) {
  RUN(test_pistons_that_move_the_tank_make_it_sway);
  RUN(test_pistons_and_flaps_make_the_waves_of_linear_theory);
  RUN(test_ghosts_follow_their_walls);
  RUN(test_a_piston_pushes_what_it_meets);
  RUN(test_a_slow_piston_lifts_the_water);
  RUN(test_a_slow_piston_works_against_the_weight);
  RUN(test_a_probe_behind_a_piston_reads_nothing);
  RUN(test_ghosts_past_an_edge_keep_their_places);
  RUN(test_any_number_of_threads_gives_the_same_bits);
  return TEST_RESULT;
}
