/* Every initial state of the lists is what its struct says. */
#include "common/flow/flow.h"

#include <stdlib.h>

#include "common/case/case.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

/* The case of a flow's example; NULL, with a failure, when it is refused. */
static struct case_file *example(const struct flow *f) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  char text[2000];
  snprintf(text, sizeof text,
           "tank: {walls: [[[0, 2], [0, 0], [4, 0], [4, 2]]]}\nwater: {%s}\ntime: {end: 1}\n"
           "runs: [{solver: sph, resolution: 20}]\n",
           f->example);
  if (case_parse("example", text, &fake_registry, &problems, &c) != OK)
    TEST_FAIL("%s: %s", flow_name(f), problems.n ? problems.text[0] : status_message());
  problems_destroy(&problems);
  return c;
}

static void for_each(const struct flow_list *list, void (*test)(const struct case_file *c)) {
  for (size_t i = 0; i < list->n; i++) {
    struct case_file *c = example(list->flow[i]);
    if (c) test(c);
    case_destroy(c);
  }
}

static void expect_listed(const struct case_file *c) {
  const struct flow_list *list = flow_is_wave(c->flow) ? &flow_waves : &flow_regions;
  EXPECT(list->flow[flow_place(c->flow)] == c->flow);
  if (!strstr(c->text, flow_name(c->flow)) && flow_place(c->flow) > 0)
    TEST_FAIL("the example of %s does not name it", flow_name(c->flow));
}

static void test_example_of_a_flow_is_that_flow(void) {
  for_each(&flow_regions, expect_listed);
  for_each(&flow_waves, expect_listed);
}

/* The outline is a trapezoidal rule with 256 points a length: it misses at most (length/256)^2/12
 * of the largest curvature by width, and a wave is no more curved than twice a cosine. */
static void expect_scale(const struct case_file *c) {
  const struct flow_scale s = c->flow->scale(c);
  double width = c->tank.max[0] - c->tank.min[0], crest = -INFINITY;
  for (int i = 0; i <= 4000; i++) {
    double x = c->tank.min[0] + width * i / 4000;
    crest = fmax(crest, c->flow->elevation(c, x) - c->tank.min[1] - s.depth);
  }
  double curvature = 2 * s.amplitude * pow(2 * M_PI / s.length, 2);
  EXPECT_NEAR(crest, s.amplitude, curvature * pow(width / 8000, 2) / 2 + 1e-14);
  EXPECT_NEAR(geo_piece_area(&c->water, 0), case_water_area(c),
              curvature * width * pow(s.length / 256, 2) / 12 + 1e-13);
}

static void test_scales_of_a_wave_are_those_of_its_elevation(void) {
  for_each(&flow_waves, expect_scale);
}

/* By central differences over h: their error is h^2/6 of a third derivative, here at most twice
 * (2 pi/length)^2 of the velocity; and rounding over h. */
static void expect_gradient(const struct case_file *c) {
  const struct flow_scale s = c->flow->scale(c);
  const double h = 1e-4 * s.length;
  double left = c->tank.min[0], right = c->tank.max[0];
  for (double x = left + 2 * h; x < right; x += 0.0731 * (right - left))
    for (double part = 0.05; part < 1; part += 0.19) {
      double y = c->tank.min[1] + part * (c->flow->elevation(c, x) - c->tank.min[1]), u[2];
      flow_velocity(c, x, y, u);
      double allowed = 1e-7 * sqrt(c->gravity * s.depth);
      EXPECT_NEAR((flow_potential(c, x + h, y) - flow_potential(c, x - h, y)) / (2 * h), u[0],
                  allowed);
      EXPECT_NEAR((flow_potential(c, x, y + h) - flow_potential(c, x, y - h)) / (2 * h), u[1],
                  allowed);
    }
}

static void test_velocity_of_a_wave_is_the_gradient_of_its_potential(void) {
  for_each(&flow_waves, expect_gradient);
}

/* No suction, none on the surface of a wave, and no more than the weight of what stands above, or
 * under a wave of what its highest crest has more. */
static void expect_pressure(const struct case_file *c) {
  void *prepared = NULL;
  struct geo_cut cut = {0};
  const bool wave = flow_is_wave(c->flow);
  const struct flow_scale s = wave ? c->flow->scale(c) : (struct flow_scale){0};
  if (c->flow->prepare) EXPECT_OK(c->flow->prepare(c, 0.05, &prepared));
  for (double x = 0.013; x < 4; x += 0.0917) {
    EXPECT_OK(geo_lines_cut(&c->water, 0, x, case_near(c), &cut));
    for (size_t k = 0; k < cut.n; k++)
      for (int i = 0; i <= 8; i++) {
        double bottom = cut.span[k][0], top = cut.span[k][1], y = bottom + (top - bottom) * i / 8;
        double rest = wave ? bottom + s.depth * i / 8 : y, head = NAN;
        if (wave) y = i < 8 ? y : c->flow->elevation(c, x);
        EXPECT_OK(flow_head(c, prepared, &(struct flow_point){x, y, rest}, &head));
        EXPECT(head >= -1e-15 * top && head <= (top - y + s.amplitude) * (1 + 1e-12));
        if (wave && i == 8) EXPECT_NEAR(head, 0, 1e-15 * top);
      }
  }
  geo_cut_destroy(&cut);
  if (c->flow->finish) c->flow->finish(prepared);
}

static void test_pressure_ends_at_the_surface(void) {
  for_each(&flow_regions, expect_pressure);
  for_each(&flow_waves, expect_pressure);
}

/* At t = 0 a theory of any order says what every solver starts from; the potential up to a
 * constant. Rounding. */
static void expect_theory(const struct case_file *c) {
  const struct flow_theory *theory = c->flow->theory;
  const double x0 = 0.37, speed = sqrt(c->gravity * c->H);
  if (!theory) return;
  for (int order = 1; order <= 2; order++) {
    void *w = theory->create(c, order);
    double y0 = c->flow->elevation(c, x0);
    double constant = theory->potential(w, x0, y0, 0) - flow_potential(c, x0, y0);
    for (double x = 0.01; x < 4; x += 0.0791) {
      double y = c->flow->elevation(c, x), u[2], v[2];
      EXPECT_NEAR(theory->elevation(w, x, 0), y, 1e-14 * c->H);
      EXPECT_NEAR(theory->potential(w, x, y, 0), flow_potential(c, x, y) + constant,
                  1e-13 * c->H * speed);
      theory->velocity(w, x, y, 0, u);
      flow_velocity(c, x, y, v);
      EXPECT_NEAR(u[0], v[0], 1e-13 * speed);
      EXPECT_NEAR(u[1], v[1], 1e-13 * speed);
      EXPECT(theory->pressure(w, x, y + 0.01 * c->H, 0) == 0);
    }
    double error = theory->error(w, c->end);
    double first = theory->kinetic(w, 0) + theory->potential_energy(w, 0);
    double last = theory->kinetic(w, c->end) + theory->potential_energy(w, c->end);
    double above_rest = first - case_rest_potential(c) / c->density;
    EXPECT(error > 0 && error < 0.5 && above_rest > 0);
    EXPECT_NEAR(last, first, error * above_rest);
    free(w);
  }
}

static void test_theory_starts_from_the_flow_and_knows_its_error(void) {
  for_each(&flow_waves, expect_theory);
}

int main(void) {
  RUN(test_example_of_a_flow_is_that_flow);
  RUN(test_scales_of_a_wave_are_those_of_its_elevation);
  RUN(test_velocity_of_a_wave_is_the_gradient_of_its_potential);
  RUN(test_pressure_ends_at_the_surface);
  RUN(test_theory_starts_from_the_flow_and_knows_its_error);
  return TEST_RESULT;
}
