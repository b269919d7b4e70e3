/* What is written into a result file is what is read from it, to the last bit. */
#include <sys/stat.h>

#include "tests/common/result_sample.h"
#include "tests/common/result_water.h"
#include "tests/test.h"

static char path[128];

/* Equal bits, so that -0 and NaN count too. */
#define EXPECT_SAME(a, b)                                                                          \
  do {                                                                                             \
    double a_ = (a), b_ = (b);                                                                     \
    if (memcmp(&a_, &b_, sizeof a_)) TEST_FAIL("%s = %.17g, expected %.17g", #a, a_, b_);          \
  } while (0)

enum { OUTPUTS = 6, SCALE = 37 };

static struct result_file *round_trip(size_t outputs, size_t scale, bool finish) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  for (size_t k = 0; w && k < outputs; k++) EXPECT_OK(sample_output(w, k, scale));
  if (w && finish) EXPECT_OK(result_finish(w));
  result_destroy(w);
  sample_case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  return f;
}

static void test_header_comes_back(void) {
  struct case_file *c = sample_case();
  struct result_file *f = round_trip(1, SCALE, true);
  char fingerprint[33], water[33];
  if (!f) return;
  case_fingerprint(c, &c->runs[0], fingerprint);
  case_water_fingerprint(c, water);
  EXPECT_STR(f->title, c->title);
  EXPECT_STR(f->case_text, c->text);
  EXPECT_STR(f->solver, "sample");
  EXPECT_STR(f->run, "antuono");
  EXPECT_STR(f->fingerprint, fingerprint);
  EXPECT_STR(f->water_fingerprint, water);
  EXPECT(f->complete);
  EXPECT_SAME(f->H, c->H);
  EXPECT_SAME(f->g, c->gravity);
  EXPECT_SAME(f->density, c->density);
  EXPECT_SAME(f->spacing, c->H / c->runs[0].resolution);
  EXPECT_SAME(f->rest_potential, case_rest_potential(c));
  EXPECT(f->walls.pieces == 1 && f->walls.points == 4 && !f->walls.closed[0]);
  EXPECT(f->walls.points == 4 && !memcmp(f->walls.p, c->walls.p, 4 * sizeof *c->walls.p));
  EXPECT(f->n_experiments == 1 && f->experiments[0].n == 3);
  EXPECT_STR(f->experiments[0].label, sample_experiments[0].label);
  EXPECT_STR(f->experiments[0].source, sample_experiments[0].source);
  EXPECT_STR(f->experiments[0].target, "P/1");
  EXPECT(!memcmp(f->experiments[0].value, sample_value, sizeof sample_value));
  EXPECT(f->n_profiles == 1 && f->profiles[0].n == 2);
  EXPECT_STR(f->profiles[0].label, sample_profiles[0].label);
  EXPECT_STR(f->profiles[0].source, sample_profiles[0].source);
  EXPECT_SAME(f->profiles[0].time, sample_profiles[0].time);
  EXPECT(!memcmp(f->profiles[0].x, sample_profile_x, sizeof sample_profile_x));
  EXPECT(!memcmp(f->profiles[0].y, sample_profile_y, sizeof sample_profile_y));
  result_file_destroy(f);
  sample_case_destroy(c);
}

static void test_surfaces_come_back(void) {
  struct result_file *f = round_trip(OUTPUTS, SCALE, true);
  if (!f) return;
  EXPECT(f->n_surfaces == OUTPUTS);
  for (size_t k = 0; k < f->n_surfaces; k++) {
    const struct geo_lines *s = &f->surface[k];
    EXPECT_SAME(f->surface_time[k], sample_time(k));
    EXPECT(s->pieces == k % 4);
    for (size_t piece = 0; piece < s->pieces; piece++) {
      EXPECT(s->closed[piece] == (piece > 0));
      EXPECT(s->first[piece + 1] - s->first[piece] == k + piece + 1);
      EXPECT_SAME(s->p[s->first[piece]][0], sample_x(k, 0));
      EXPECT_SAME(s->p[s->first[piece + 1] - 1][0], sample_x(k, (k + piece) % sample_n(k, SCALE)));
    }
  }
  result_file_destroy(f);
}

static void test_series_come_back(void) {
  struct result_file *f = round_trip(OUTPUTS, SCALE, true);
  if (!f) return;
  EXPECT(f->n_energy == 10 * OUTPUTS && f->n_steps == 10 * OUTPUTS);
  for (size_t i = 0; i < f->n_energy; i++) {
    double t = sample_time(i / 10) + 0.01 * (double)(i % 10);
    EXPECT_SAME(f->energy[i].time, t);
    EXPECT_SAME(f->energy[i].internal, 1e-300);
    EXPECT_SAME(f->energy[i].removed, -0.0);
    EXPECT_SAME(f->energy[i].term[0], 5);
    EXPECT_SAME(f->energy[i].term[1], 6);
    EXPECT_SAME(f->energy[i].term[2], 0);
    EXPECT_SAME(f->energy[i].total, t * t);
    EXPECT_SAME(f->steps[i].time, t);
    EXPECT_SAME(f->steps[i].volume, 0.72);
  }
  EXPECT(f->n_terms == 2);
  EXPECT_STR(f->terms[0].name, "friction");
  EXPECT_STR(f->terms[1].help, "what else");
  EXPECT(!f->terms[0].outside && f->terms[1].outside);
  EXPECT(f->n_probes == 2 && f->n_gauges == 1);
  EXPECT_STR(f->probes[0].name, "P/1"); /* in the order of the case, with its exact name */
  EXPECT_STR(f->probes[1].name, "P0");
  EXPECT_SAME(f->probes[0].size, 0.09);
  EXPECT_SAME(f->probes[1].y, 1e-17);
  EXPECT(f->probes[0].n == 10 * OUTPUTS && f->probes[1].n == 0);
  EXPECT_SAME(f->probes[0].value[11], (sample_time(1) + 0.01) * 9810);
  EXPECT_STR(f->gauges[0].units, "m");
  EXPECT_SAME(f->gauges[0].x, sample_gauges[0].x);
  EXPECT(f->gauges[0].n == 10 * OUTPUTS && isnan(f->gauges[0].value[1]));
  EXPECT(f->n_points == 1); /* the other has no row */
  EXPECT_STR(f->points[0].name, "A");
  EXPECT_SAME(f->points[0].x, 2.385);
  EXPECT(f->points[0].n == 5 * OUTPUTS);
  EXPECT_SAME(f->points[0].t[5], sample_time(1) + 0.01);
  EXPECT_SAME(f->points[0].value[CASE_POINT_p][5], sample_time(1) + 0.01);
  EXPECT_SAME(f->points[0].value[CASE_POINT_u][0], -0.0);
  EXPECT(isnan(f->points[0].value[CASE_POINT_v][0]));
  EXPECT_SAME(f->points[0].value[CASE_POINT_cover][4], 0.5);
  result_file_destroy(f);
}

static void test_events_and_statistics_come_back(void) {
  struct result_file *f = round_trip(OUTPUTS, SCALE, true);
  if (!f) return;
  EXPECT(f->n_events == OUTPUTS); /* one name may happen many times */
  for (size_t k = 0; k < f->n_events; k++) {
    EXPECT_STR(f->events[k].name, "touchdown");
    EXPECT_SAME(f->events[k].time, sample_time(k));
    EXPECT_SAME(f->events[k].x, 2.385);
  }
  EXPECT(f->n_statistics == 1); /* the last value counts */
  EXPECT_STR(f->statistics[0].name, "steps");
  EXPECT_STR(f->statistics[0].help, "number of outputs so far");
  EXPECT_SAME(f->statistics[0].value, OUTPUTS - 1);
  result_file_destroy(f);
}

struct crossing {
  size_t many, seen;
  const size_t *output;
};

static enum status cross(void *data, size_t k, struct result_water *w) {
  struct crossing *q = data;
  EXPECT(k == q->seen++ && w->n == sample_n(q->output[k], q->many));
  for (size_t i = 0; i < w->n; i++) {
    EXPECT_SAME(w->p[i][0], sample_x(q->output[k], i));
    EXPECT_SAME(w->value[0][i], 1000 * w->p[i][1] / 7);
  }
  return OK;
}

/* Chunks hold 4096 points: 5000 of them cross chunks at every output. In any order, at once. */
static void test_points_come_back(void) {
  enum { MANY = 5000 };
  struct result_file *f = round_trip(OUTPUTS, MANY, true);
  if (!f) return;
  const struct result_wanted pressure = {.name = "pressure"};
  size_t output[OUTPUTS];
  struct crossing q = {MANY, 0, output};
  EXPECT(f->n_outputs == OUTPUTS);
  for (size_t k = 0; k < OUTPUTS; k++) {
    output[k] = OUTPUTS - 1 - k;
    EXPECT_SAME(f->output_time[k], sample_time(k));
  }
  EXPECT_OK(result_stream(path, 1, &pressure, OUTPUTS, output, cross, &q));
  EXPECT(q.seen == OUTPUTS);
  result_file_destroy(f);
}

static void test_wrong_points_are_refused(void) {
  struct result_water water;
  struct result_file *f = round_trip(2, SCALE, true);
  EXPECT(water_read(path, "pressure", false, 2, &water) == ERR_INPUT);
  EXPECT(water_read(path, "vorticity", false, 0, &water) == ERR_INPUT);
  EXPECT(water_read(path, "velocity", false, 0, &water) == ERR_INPUT); /* not a scalar */
  EXPECT(water_read(path, "pressure", true, 0, &water) == ERR_INPUT);  /* not a vector */
  EXPECT(!water.n && !water.p && !water.value[0]);
  result_file_destroy(f);
}

struct looks {
  size_t n, stop;
  const size_t *output;
};

static enum status look(void *data, size_t k, struct result_water *w) {
  struct looks *l = data;
  EXPECT(k == l->n);
  EXPECT(w->n == sample_n(l->output[k], SCALE) && w->p && w->value[0] && w->value[1]);
  EXPECT(!w->value[2]); /* no file has it */
  for (size_t i = 0; i < w->n; i++) {
    EXPECT_SAME(w->p[i][0], sample_x(l->output[k], i));
    EXPECT_SAME(w->value[0][2 * i], w->p[i][1]); /* the sample's velocity is (y, x) */
    EXPECT_SAME(w->value[0][2 * i + 1], w->p[i][0]);
    EXPECT_SAME(w->value[1][i], 1000 * w->p[i][1] / 7);
  }
  return ++l->n == l->stop ? status_raise(ERR_IO, "enough") : OK;
}

/* Several fields, output by output, until the one who takes them has had enough. */
static void test_points_come_one_output_at_a_time(void) {
  static const struct result_wanted wanted[] = {
      {"velocity", true, false}, {"pressure", false, false}, {"vorticity", false, true}};
  const size_t output[] = {3, 0, 5}, beyond[] = {1, OUTPUTS, 2};
  struct result_file *f = round_trip(OUTPUTS, SCALE, true);
  struct looks all = {0, 9, output}, two = {0, 2, output}, wrong = {0, 9, beyond};
  EXPECT_OK(result_stream(path, 3, wanted, 3, output, look, &all));
  EXPECT(all.n == 3);
  EXPECT(result_stream(path, 3, wanted, 3, output, look, &two) == ERR_IO && two.n == 2);
  EXPECT(!strcmp(status_message(), "enough"));
  EXPECT(result_stream(path, 3, wanted, 3, beyond, look, &wrong) == ERR_INPUT && wrong.n == 1);
  if (!strstr(status_message(), ", output 6: its dataset /VTKHDF/Steps/PointOffsets has 6 rows"))
    TEST_FAIL("the message is: %s", status_message());
  result_file_destroy(f);
}

struct part_look {
  size_t n;
  const size_t *output, *point;
};

static enum status look_at_part(void *data, size_t k, struct result_water *w) {
  struct part_look *l = data;
  EXPECT(w->n == 2 && !w->p);
  for (size_t i = 0; i < w->n; i++)
    EXPECT_SAME(w->value[0][2 * i + 1], sample_x(l->output[k], l->point[i]));
  l->n++;
  return OK;
}

static enum status look_at_places(void *data, size_t k, struct result_water *w) {
  struct part_look *l = data;
  for (size_t i = 0; i < w->n; i++) EXPECT_SAME(w->p[i][0], sample_x(l->output[k], l->point[i]));
  l->n += w->n;
  return OK;
}

/* Some points of outputs, with and without their places; one that an output does not have. */
static void test_points_come_in_part(void) {
  static const struct result_wanted wanted[] = {{"velocity", true, false}};
  const size_t output[] = {3, 0, 5}, point[] = {7, SCALE - 1}, beyond[] = {SCALE};
  const struct result_part part = {2, point, true}, places = {2, point, false};
  const struct result_part outside = {1, beyond, false};
  struct result_file *f = round_trip(OUTPUTS, SCALE, true);
  struct part_look look = {0, output, point};
  EXPECT(isnan(f->c0)); /* its solver knows of none */
  EXPECT_OK(result_stream_part(path, &part, 1, wanted, 3, output, look_at_part, &look));
  EXPECT(look.n == 3);
  look.n = 0;
  EXPECT_OK(result_stream_part(path, &places, 0, NULL, 3, output, look_at_places, &look));
  EXPECT(look.n == 6);
  EXPECT(result_stream_part(path, &outside, 0, NULL, 3, output, look_at_places, &look) ==
         ERR_INPUT);
  if (!strstr(status_message(), "points, and none of number"))
    TEST_FAIL("the message is: %s", status_message());
  result_file_destroy(f);
}

static void test_only_a_finished_file_is_current(void) {
  result_file_destroy(round_trip(2, SCALE, false));
  struct case_file *c = sample_case();
  char fingerprint[33];
  case_fingerprint(c, &c->runs[0], fingerprint);
  EXPECT(!result_is_current(path, fingerprint));
  struct result_file *f = round_trip(2, SCALE, true);
  EXPECT(result_is_current(path, fingerprint));
  EXPECT(!result_is_current(path, "0"));
  EXPECT(!result_is_current("/nonexistent/file.h5", fingerprint));
  result_file_destroy(f);
  sample_case_destroy(c);
}

/* Rows since the last flush reach the file when it is closed without an error (Ctrl-C). */
static void test_unfinished_file_is_complete_to_the_last_row(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  EXPECT_OK(sample_output(w, 0, SCALE));
  EXPECT_OK(result_probe(w, 1, 0.5, 42));
  result_destroy(w);
  EXPECT_OK(result_read(path, &f));
  EXPECT(f && !f->complete && f->probes[1].n == 1 && f->probes[1].value[0] == 42);
  result_file_destroy(f);
  sample_case_destroy(c);
}

static void test_nothing_is_left_beside_the_file(void) {
  result_file_destroy(round_trip(3, SCALE, true));
  char command[256];
  snprintf(command, sizeof command, "test \"$(ls -A %s)\" = \"sample.h5\nsample.xdmf\"",
           sample_folder());
  EXPECT(system(command) == 0);
}

int main(void) {
  snprintf(path, sizeof path, "%s/sample.h5", sample_folder());
  RUN(test_header_comes_back);
  RUN(test_surfaces_come_back);
  RUN(test_series_come_back);
  RUN(test_events_and_statistics_come_back);
  RUN(test_points_come_back);
  RUN(test_wrong_points_are_refused);
  RUN(test_points_come_one_output_at_a_time);
  RUN(test_points_come_in_part);
  RUN(test_only_a_finished_file_is_current);
  RUN(test_unfinished_file_is_complete_to_the_last_row);
  RUN(test_nothing_is_left_beside_the_file);
  sample_folder_remove();
  return TEST_RESULT;
}
