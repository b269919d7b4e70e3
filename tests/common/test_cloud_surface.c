#include "common/cloud/surface.h"

#include <omp.h>

#include "common/base/gauge.h"
#include "tests/common/swarm.h"

/* F of the header comment of surface.c by direct summation, without walls. */
static double fraction(const struct swarm *c, double x, double y) {
  double f = 0;
  for (size_t i = 0; i < c->n; i++)
    f += exp(-((x - c->x[i]) * (x - c->x[i]) + (y - c->y[i]) * (y - c->y[i])) / (dx * dx)) / M_PI;
  return f;
}

static void test_still_water_has_its_surface_and_ends_on_the_walls(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 60 * dx, 50 * dx);
  swarm_block(&c, 0, 0, 60 * dx, 20 * dx, dx);
  extract(&c, NULL, dx, &walls, &l);
  EXPECT(l.pieces == 1 && !l.closed[0]);
  EXPECT(l.p[0][0] == 0 && l.p[l.points - 1][0] == 60 * dx);
  for (size_t i = 0; i < l.points; i++) {
    EXPECT_NEAR(l.p[i][1], 20 * dx, LATTICE_NOISE);
    if (i) EXPECT(l.p[i][0] > l.p[i - 1][0]);
  }
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* The radius is short by s^2/(4R), so the order is 2; the interpolation on the grid adds 5 % of it.
 */
static void test_disc_is_a_clockwise_drop_and_its_radius_converges_at_second_order(void) {
  struct geo_lines none = {0}, l = {0};
  double before = 0;
  for (int k = 10; k <= 80; k *= 2) {
    struct swarm c = {0};
    double d = 1.0 / k, *volume = malloc(sizeof *volume * 4 * (size_t)(k * k)), mean = 0;
    swarm_disc(&c, 0.3, 0.7, 0, 1, d, volume);
    extract(&c, volume, d, &none, &l);
    EXPECT(l.pieces == 1 && l.closed[0] && geo_piece_area(&l, 0) < 0);
    for (size_t i = 0; i < l.points; i++)
      mean += (hypot(l.p[i][0] - 0.3, l.p[i][1] - 0.7) - 1) / (double)l.points;
    EXPECT_NEAR(mean, -d * d / 4, 0.05 * d * d / 4);
    if (before != 0) EXPECT_NEAR(log2(before / mean), 2, 0.05);
    before = mean;
    free(volume);
    swarm_destroy(&c);
  }
  geo_lines_destroy(&l);
}

static void test_ring_has_a_counter_clockwise_cavity_in_it(void) {
  struct swarm c = {0};
  struct geo_lines none = {0}, l = {0};
  double volume[10000];
  swarm_disc(&c, 0, 0, 20 * dx, 50 * dx, dx, volume);
  extract(&c, volume, dx, &none, &l);
  EXPECT(l.pieces == 2 && l.closed[0] && l.closed[1]);
  for (size_t k = 0; k < l.pieces; k++) {
    double area = geo_piece_area(&l, k), r = area > 0 ? 20 * dx : 50 * dx;
    /* both lie dx^2/(4 r) towards the centre; the polygon is a little smaller than its circle */
    EXPECT_NEAR(fabs(area), M_PI * pow(r - dx * dx / (4 * r), 2), 5e-4 * M_PI * r * r);
  }
  EXPECT(geo_piece_area(&l, 0) * geo_piece_area(&l, 1) < 0);
  swarm_destroy(&c);
  geo_lines_destroy(&l);
}

/* Area below an open piece that starts on the left wall, with the bed and the wall. */
static double area_under(const struct geo_lines *l) {
  double area = 0;
  for (size_t i = l->first[0]; i + 1 < l->first[1]; i++)
    area += (l->p[i + 1][0] - l->p[i][0]) * (l->p[i + 1][1] + l->p[i][1]) / 2;
  return area;
}

/* What is cut off the edge of the column is a fixed number of dx^2. */
static void test_column_runs_from_its_wall_to_the_bed_and_its_area_converges(void) {
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 5.366, 3);
  double before = 0;
  for (int k = 10; k <= 40; k *= 2) {
    struct swarm c = {0};
    swarm_block(&c, 0, 0, 2, 1, 1.0 / k);
    extract(&c, NULL, 1.0 / k, &walls, &l);
    EXPECT(l.pieces == 1 && !l.closed[0]);
    EXPECT(l.p[0][0] == 0 && l.p[l.points - 1][1] == 0);
    EXPECT_NEAR(l.p[0][1], 1, 4e-4 / k);
    EXPECT_NEAR(l.p[l.points - 1][0], 2, 4e-4 / k);
    EXPECT_NEAR(gauge_front(&l, 0, 0.3), 2, 4e-4 / k);
    double error = 2 - area_under(&l);
    EXPECT(error > 0);
    if (before != 0) EXPECT_NEAR(log2(before / error), 2, 0.1);
    before = error;
    swarm_destroy(&c);
  }
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* Particles displaced by at most a in x and y: F varies by sum_j V^2 |grad W|^2 a^2/3, which over
 * half a plane is a^2/(6 pi dx^2), so the surface by a/sqrt(6) rms; 25 % for the size of the
 * sample. */
static void test_jitter_moves_the_surface_by_less_than_itself(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 300 * dx, 50 * dx);
  swarm_block(&c, 0, 0, 300 * dx, 20 * dx, dx);
  swarm_jitter(&c, 0.1 * dx);
  extract(&c, NULL, dx, &walls, &l);
  double square = 0;
  for (size_t i = 0; i < l.points; i++) square += pow(l.p[i][1] - 20 * dx, 2) / (double)l.points;
  EXPECT(l.pieces == 1);
  EXPECT_NEAR(sqrt(square), 0.1 * dx / sqrt(6), 0.25 * 0.1 * dx / sqrt(6));
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

static void test_two_drops_are_two_pieces_and_one_particle_is_none(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 60 * dx, 50 * dx);
  swarm_block(&c, 10 * dx, 20 * dx, 14 * dx, 24 * dx, dx);
  swarm_block(&c, 16 * dx, 20 * dx, 20 * dx, 24 * dx, dx);
  swarm_add(&c, 40 * dx, 20 * dx);
  swarm_add(&c, 50 * dx, dx / 2);
  extract(&c, NULL, dx, &walls, &l);
  EXPECT(l.pieces == 2 && l.closed[0] && l.closed[1]);
  EXPECT(geo_piece_area(&l, 0) < 0 && geo_piece_area(&l, 1) < 0);
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* A square of k x k particles is missing, inside the water and on the bed. */
static void test_pocket_of_air_is_seen_when_it_is_more_than_a_gap_between_particles(void) {
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 60 * dx, 50 * dx);
  for (int k = 1; k <= 8; k++)
    for (int on_bed = 0; on_bed < 2; on_bed++) {
      struct swarm c = {0};
      int low = on_bed ? 0 : 10;
      for (int j = 0; j < 30; j++)
        for (int i = 0; i < 60; i++)
          if (i < 20 || i >= 20 + k || j < low || j >= low + k)
            swarm_add(&c, (i + 0.5) * dx, (j + 0.5) * dx);
      extract(&c, NULL, dx, &walls, &l);
      EXPECT(l.pieces == (k <= 2 ? 1 : 2) || k == 3);
      if (l.pieces == 2) {
        EXPECT(l.closed[1] == !on_bed);
        EXPECT(geo_piece_area(&l, 1) > 0); /* counter-clockwise: air inside */
        EXPECT_NEAR(geo_piece_area(&l, 1), k * k * dx * dx, 0.2 * k * k * dx * dx + dx * dx);
      }
      swarm_destroy(&c);
    }
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* A tongue of thickness h that ends at x = L: F = erfc((x - L)/dx) (erf((h - y)/dx) + erf((h +
 * y)/dx))/4. Far from the end its height follows from the second factor, on the bed the toe from
 * the first. */
static void test_thin_tongue_on_the_bed_is_seen_and_ends_on_the_bed(void) {
  struct geo_lines walls = {0}, l = {0};
  tank(&walls, 60 * dx, 50 * dx);
  for (int rows = 1; rows <= 3; rows++) {
    struct swarm c = {0};
    swarm_block(&c, 0, 0, 40 * dx, rows * dx, dx);
    extract(&c, NULL, dx, &walls, &l);
    EXPECT(l.pieces == 1 && !l.closed[0] && l.p[0][0] == 0 && l.p[l.points - 1][1] == 0);
    double height = rows, toe = 0; /* in dx; solved by fixed-point iteration and bisection */
    for (int k = 0; k < 50; k++)
      height += (erf(rows - height) + erf(rows + height) - 1) * sqrt(M_PI) / 2;
    for (double step = 1; step > 1e-9; step /= 2) toe += erfc(toe) * erf(rows) > 1 ? step : -step;
    /* a sheet that is just seen has a flat F, in which d is not linear: 5 % of dx at worst */
    EXPECT_NEAR(gauge_elevation(&l, 20 * dx, 0) / dx, height, 0.01);
    EXPECT_NEAR(l.p[l.points - 1][0] / dx, 40 + toe, rows == 1 ? 0.05 : 0.01);
    swarm_destroy(&c);
  }
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
}

/* Ragged clusters with holes, contacts at corners and sheets: every curve must lie on F = 1/2 and
 * have more water on its right than on its left. */
static void test_water_is_on_the_right_of_every_step(void) {
  struct swarm c = {0};
  struct geo_lines none = {0}, l = {0};
  for (int j = 0; j < 40; j++)
    for (int i = 0; i < 80; i++) { /* water with holes for i < 40, drops beyond */
      bool bump = sin(0.5 * i) * cos(0.4 * j) > 0.4 + 0.3 * noise();
      if (bump != (i < 40)) swarm_add(&c, i * dx, j * dx);
    }
  swarm_block(&c, 90 * dx, 0, 95 * dx, 5 * dx, dx);
  swarm_block(&c, 95 * dx, 5 * dx, 100 * dx, 10 * dx, dx);
  swarm_jitter(&c, 0.2 * dx);
  extract(&c, NULL, dx, &none, &l);
  size_t drops = 0, cavities = 0;
  double square = 0;
  for (size_t k = 0; k < l.pieces; k++) {
    EXPECT(l.closed[k]);
    *(geo_piece_area(&l, k) < 0 ? &drops : &cavities) += 1;
    for (size_t i = l.first[k]; i < l.first[k + 1]; i++) {
      const double *p = l.p[i], *q = l.p[i + 1 < l.first[k + 1] ? i + 1 : l.first[k]];
      double tx = q[0] - p[0], ty = q[1] - p[1], t = hypot(tx, ty);
      double mx = (p[0] + q[0]) / 2, my = (p[1] + q[1]) / 2, off = 0.05 * dx / t;
      EXPECT(t < 0.75 * dx * 1.2);
      /* usually 0.056; in the middle of a neck it may be nothing */
      EXPECT(fraction(&c, mx + off * ty, my - off * tx) -
                 fraction(&c, mx - off * ty, my + off * tx) >
             -0.01);
      double deviation = fraction(&c, p[0], p[1]) - 0.5;
      square += deviation * deviation;
      EXPECT_NEAR(deviation, 0, 0.05); /* the largest are in necks and slits, where F is flat */
    }
  }
  EXPECT(drops >= 10 && cavities >= 5);
  EXPECT(sqrt(square / (double)l.points) < 0.01); /* 0.02 dx where F is steep */
  swarm_destroy(&c);
  geo_lines_destroy(&l);
}

static void test_escaped_particles_change_nothing(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l = {0}, again = {0};
  struct cloud_surface *s = NULL;
  tank(&walls, 60 * dx, 50 * dx);
  swarm_block(&c, 0, 0, 30 * dx, 20 * dx, dx);
  EXPECT_OK(cloud_surface_create(&s));
  EXPECT_OK(cloud_surface_extract(s, &(struct cloud){c.n, c.x, c.y, NULL, dx, NULL}, &walls, &l));
  swarm_add(&c, NAN, dx);
  swarm_add(&c, dx, INFINITY);
  swarm_add(&c, -1e30, 1e30);
  EXPECT_OK(
      cloud_surface_extract(s, &(struct cloud){c.n, c.x, c.y, NULL, dx, NULL}, &walls, &again));
  EXPECT(l.points == again.points && l.pieces == again.pieces);
  EXPECT(memcmp(l.p, again.p, l.points * sizeof *l.p) == 0);
  EXPECT_OK(cloud_surface_extract(s, &(struct cloud){.dx = dx}, &walls, &again));
  EXPECT(again.pieces == 0 && again.points == 0);
  swarm_destroy(&c);
  swarm_add(&c, 0, 0);
  swarm_add(&c, 1e9 * dx, 1e9 * dx);
  struct geo_lines none = {0};
  EXPECT(cloud_surface_extract(s, &(struct cloud){c.n, c.x, c.y, NULL, dx, NULL}, &none, &again) ==
         ERR_INPUT);
  cloud_surface_destroy(s);
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l);
  geo_lines_destroy(&again);
}

/* Water with a wavy surface, with drops above it, and with holes of all sizes in it. */
static void swarm_breaker(struct swarm *c, double width, double depth) {
  struct swarm full = {0};
  double hole[40][3];
  for (int k = 0; k < 40; k++) {
    hole[k][0] = width * (0.5 + 0.5 * noise());
    hole[k][1] = 1.2 * depth * (0.5 + 0.5 * noise());
    hole[k][2] = dx * (1.5 + 1.5 * noise());
  }
  swarm_block(&full, 0, 0, width, 1.5 * depth, dx);
  for (size_t i = 0; i < full.n; i++) {
    double x = full.x[i], y = full.y[i], top = depth * (1 + 0.15 * sin(9 * x / width));
    bool gone = false, drop = false;
    for (int k = 0; k < 40; k++) {
      bool near = hypot(x - hole[k][0], y - hole[k][1]) < hole[k][2];
      gone |= near;
      drop |= near;
    }
    if (y < top ? !gone : drop) swarm_add(c, x, y);
  }
  swarm_jitter(c, 0.3 * dx);
  swarm_destroy(&full);
}

/* Away from its edges: the elevations that a gauge reads. */
static void test_strip_is_the_same_as_the_whole_to_the_last_bit(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, whole = {0}, part = {0};
  struct cloud_surface *s = NULL;
  const double width = 120 * dx;
  tank(&walls, width, 90 * dx);
  swarm_breaker(&c, width, 40 * dx);
  const struct cloud cloud = {c.n, c.x, c.y, NULL, dx, NULL};
  EXPECT_OK(cloud_surface_create(&s));
  EXPECT_OK(cloud_surface_extract(s, &cloud, &walls, &whole));
  EXPECT(whole.pieces > 10);
  int wet = 0;
  for (int k = 0; k <= 200; k++) {
    double x = width * k / 200;
    EXPECT_OK(cloud_surface_strip(s, &cloud, &walls, (double[]){x - 6 * dx, x + 6 * dx}, &part));
    double right = gauge_elevation(&whole, x, 0), read = gauge_elevation(&part, x, 0);
    EXPECT(read == right || (isnan(read) && isnan(right)));
    wet += isfinite(right);
  }
  EXPECT(wet > 150);
  EXPECT_OK(cloud_surface_strip(s, &cloud, &walls, (double[]){-9, -8}, &part));
  EXPECT(part.pieces == 0);
  cloud_surface_destroy(s);
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&whole);
  geo_lines_destroy(&part);
}

static void test_any_number_of_threads_finds_the_same_bits(void) {
  struct swarm c = {0};
  struct geo_lines walls = {0}, l[2] = {0};
  tank(&walls, 150 * dx, 90 * dx);
  swarm_breaker(&c, 150 * dx, 50 * dx);
  for (int k = 0; k < 2; k++) {
    omp_set_num_threads(k ? 3 : 1);
    extract(&c, NULL, dx, &walls, &l[k]);
  }
  omp_set_num_threads(1);
  EXPECT(l[0].points > 300 && l[0].points == l[1].points && l[0].pieces == l[1].pieces);
  EXPECT(memcmp(l[0].p, l[1].p, l[0].points * sizeof *l[0].p) == 0);
  swarm_destroy(&c);
  geo_lines_destroy(&walls);
  geo_lines_destroy(&l[0]);
  geo_lines_destroy(&l[1]);
}

int main(void) {
  RUN(test_still_water_has_its_surface_and_ends_on_the_walls);
  RUN(test_disc_is_a_clockwise_drop_and_its_radius_converges_at_second_order);
  RUN(test_ring_has_a_counter_clockwise_cavity_in_it);
  RUN(test_column_runs_from_its_wall_to_the_bed_and_its_area_converges);
  RUN(test_jitter_moves_the_surface_by_less_than_itself);
  RUN(test_two_drops_are_two_pieces_and_one_particle_is_none);
  RUN(test_pocket_of_air_is_seen_when_it_is_more_than_a_gap_between_particles);
  RUN(test_thin_tongue_on_the_bed_is_seen_and_ends_on_the_bed);
  RUN(test_water_is_on_the_right_of_every_step);
  RUN(test_escaped_particles_change_nothing);
  RUN(test_strip_is_the_same_as_the_whole_to_the_last_bit);
  RUN(test_any_number_of_threads_finds_the_same_bits);
  return TEST_RESULT;
}
