/* Error bars: a run held against a coarser one in memory has the difference over ratio^order - 1
 * beside each value, and NaN where the other has none. */
#include "tests/common/result_sample.h"
#include "tests/test.h"

static char path[128];

static const struct result_coarser how = {1.5, 2}; /* 1/(1.5^2 - 1) = 0.8 of a difference */

/* Rows and events whose values are off by `off`; the run ends after `rows` rows. The surface is a
 * parabola, whose points `shift` along it change nothing. */
static enum status write_run(struct result *w, size_t rows, double off, double shift) {
  for (size_t i = 0; i < rows; i++) {
    double t = 0.1 * (double)i;
    struct result_energy e = {
        .time = t, .kinetic = 3 + off, .total = 7 - 2 * off, .term = {0.5, 0.25 + off}};
    TRY(result_energy(w, &e));
    TRY(result_step(w, &(struct result_step){.time = t, .volume = 1}));
    TRY(result_probe(w, 0, t, 100 + 10 * off));
    TRY(result_probe(w, 1, t, 50));
    TRY(result_gauge(w, 0, t, i ? 0.6 - off : NAN));
  }
  struct geo_lines surface = {0};
  enum status status = OK;
  ATTEMPT(geo_lines_begin(&surface, false));
  for (int k = 0; k < 20; k++) {
    double x = 0.1 * k + (k && k < 19 ? shift : 0);
    ATTEMPT(geo_lines_add(&surface, x, 0.5 + 0.3 * (x - 1) * (x - 1) + off));
  }
  ATTEMPT(result_surface(w, 0.2, &surface));
  ATTEMPT(result_event(w, "impact", 0.25 + off, 3, 0.1 - off));
  ATTEMPT(result_event(w, "impact", 0.35, 3 + off, 0.1));
  if (rows > 4) ATTEMPT(result_event(w, "touchdown", 0.55, 2, 0.1));
  ATTEMPT(result_flush(w));
done:
  geo_lines_destroy(&surface);
  return status;
}

static struct result_file *held(double off, double shift) {
  struct case_file *c = sample_case();
  struct result *w = NULL, *coarser = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create_coarser(c, &c->runs[0], &coarser));
  EXPECT_OK(write_run(coarser, 3, off, shift));
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  EXPECT_OK(result_hold_against(w, coarser, &how));
  EXPECT_OK(write_run(w, 5, 0, 0));
  EXPECT_OK(result_finish(w));
  result_destroy(w);
  result_destroy(coarser);
  sample_case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  return f;
}

static void test_series_have_a_share_of_the_difference(void) {
  struct result_file *f = held(0.02, 0);
  if (!f) return;
  EXPECT_NEAR(f->coarser.ratio, 1.5, 0);
  EXPECT_NEAR(f->coarser.order, 2, 0);
  EXPECT(f->n_energy_errors == 5 && f->probes[0].n_errors == 5 && f->gauges[0].n_errors == 5);
  EXPECT_NEAR(f->energy_error[2].time, f->energy[2].time, 0);
  EXPECT_NEAR(f->energy_error[2].kinetic, 0.8 * 0.02, 1e-14);
  EXPECT_NEAR(f->energy_error[2].total, 0.8 * 0.04, 1e-14);
  EXPECT_NEAR(f->energy_error[2].term[0], 0, 0);
  EXPECT_NEAR(f->energy_error[2].term[1], 0.8 * 0.02, 1e-14);
  EXPECT_NEAR(f->probes[0].error[1], 0.8 * 0.2, 1e-12);
  EXPECT_NEAR(f->probes[1].error[1], 0, 0);
  EXPECT(isnan(f->gauges[0].error[0])); /* dry in both */
  EXPECT_NEAR(f->gauges[0].error[1], 0.8 * 0.02, 1e-14);
  EXPECT(isnan(f->energy_error[3].kinetic) && isnan(f->probes[1].error[4])); /* ended before */
  result_file_destroy(f);
}

static void test_events_are_held_against_those_of_their_name_and_number(void) {
  struct result_file *f = held(0.02, 0);
  if (!f) return;
  EXPECT(f->n_events == 3);
  EXPECT_NEAR(f->events[0].error[0], 0.8 * 0.02, 1e-14);
  EXPECT_NEAR(f->events[0].error[1], 0, 0);
  EXPECT_NEAR(f->events[0].error[2], 0.8 * 0.02, 1e-14);
  EXPECT_NEAR(f->events[1].error[0], 0, 0);
  EXPECT_NEAR(f->events[1].error[1], 0.8 * 0.02, 1e-14);
  for (int k = 0; k < 3; k++) EXPECT(isnan(f->events[2].error[k]));
  result_file_destroy(f);
}

/* Raised by 0.02 it is 0.02 away at the bottom of the parabola; moved along itself by a third of a
 * spacing it is no more than 1/256 of the 3.75e-4 that chords would be off. */
static void test_surfaces_are_measured_across(void) {
  struct result_file *f = held(0.02, 0), *along = held(0, 0.033);
  if (f && along) {
    EXPECT(f->n_surface_errors == 20 && along->n_surface_errors == 20);
    EXPECT_NEAR(f->surface_error[10], 0.8 * 0.02, 1e-6);
    for (size_t k = 4; k < 16; k++) EXPECT(along->surface_error[k] < 3e-6);
  }
  result_file_destroy(f);
  result_file_destroy(along);
}

static void test_without_a_coarser_run_there_are_none(void) {
  struct case_file *c = sample_case();
  struct result *w = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(result_create(path, c, &c->runs[0], &w));
  EXPECT_OK(write_run(w, 5, 0, 0));
  result_destroy(w);
  sample_case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  if (!f) return;
  EXPECT_NEAR(f->coarser.ratio, 0, 0);
  EXPECT(!f->n_energy_errors && !f->n_surface_errors && !f->probes[0].n_errors);
  EXPECT(isnan(f->events[0].error[0]));
  result_file_destroy(f);
}

int main(void) {
  snprintf(path, sizeof path, "/tmp/plunge-errors-%d.h5", (int)getpid());
  RUN(test_series_have_a_share_of_the_difference);
  RUN(test_events_are_held_against_those_of_their_name_and_number);
  RUN(test_surfaces_are_measured_across);
  RUN(test_without_a_coarser_run_there_are_none);
  unlink(path);
  strcpy(path + strlen(path) - 3, ".xdmf");
  unlink(path);
  return TEST_RESULT;
}
