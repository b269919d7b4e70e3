/* The library that other programs write results with: what it refuses, and what is in the file. */
#include <stdlib.h>
#include <unistd.h>

#include "common/result/health.h"
#include "common/result/result.h"
#include "library/plunge_result.h"
#include "tests/common/result_water.h"
#include "tests/test.h"

static char folder[] = "/tmp/plunge-library-XXXXXX", path[128];
static const double tank[] = {0, 3, 0, 0, 4, 0, 4, 3}, flat[] = {0, 2, 4, 2};

static plunge_result *open_result(void) {
  plunge_result *r = plunge_result_open(path, 2, 9.81, 1000, 0.05);
  EXPECT(r && plunge_result_wall(r, 4, tank, 0) == 0);
  return r;
}

static void test_everything_comes_back(void) {
  const double drop[] = {1, 2.5, 1.1, 2.6, 1.2, 2.5},
               points[] = {0, 2, 4, 2, 1, 2.5, 1.1, 2.6, 1.2, 2.5}, p[] = {1, 2, 3},
               uv[] = {1, -1, 2, -2, 3, -3}, friction[] = {0.25, 0};
  struct result_file *f = NULL;
  plunge_result *r = open_result();
  EXPECT(plunge_result_names(r, "theirs", "run 1", "Two outputs") == 0);
  EXPECT(plunge_result_rest(r, 7) == 0);
  EXPECT(plunge_result_probe(r, "left/low", 0, 0.5, 0.1) == 0 &&
         plunge_result_probe(r, "P", 4, 1, 0) == 0);
  EXPECT(plunge_result_gauge(r, "G", 1.5) == 0);
  EXPECT(plunge_result_term(r, "friction", "what friction takes") == 0);
  EXPECT(plunge_result_term(r, "heat", NULL) == 0);
  EXPECT(plunge_result_surface(r, 0, 2, flat) == 0);
  EXPECT(plunge_result_pieces(r, 0.5, 2, (const int[]){0, 2, 5}, (const int[]){0, 1}, points) == 0);
  EXPECT(plunge_result_particles(r, 0.5, 3, drop, p, NULL, NULL, p, uv) == 0);
  EXPECT(plunge_result_energy(r, 0, 1, 8, 0.5, 0, friction) == 0);
  EXPECT(plunge_result_step(r, 0.5, 0.1, 8, 0.5, 100, 1.5) == 0);
  EXPECT(plunge_result_pressure(r, 1, 0.5, 99) == 0 && plunge_result_elevation(r, 0, 0.5, 2) == 0);
  EXPECT(plunge_result_event(r, "touchdown", 0.4, 1, 2) == 0);
  EXPECT(plunge_result_close(r, "the jet has landed") == 0);

  EXPECT_OK(result_read(path, &f));
  if (!f) return;
  EXPECT_STR(f->solver, "theirs");
  EXPECT_STR(f->run, "run 1");
  EXPECT_STR(f->ended, "the jet has landed");
  EXPECT(f->complete && f->H == 2 && fabs(f->spacing / 0.05 - 1) < 1e-15 && f->rest_potential == 7);
  EXPECT(f->walls.points == 4 && f->n_surfaces == 2 && f->surface[1].pieces == 2);
  EXPECT(f->surface[1].closed[1] && f->surface[1].p[4][0] == 1.2);
  EXPECT(f->n_energy == 1 && f->energy[0].total == 9.5 && f->n_terms == 2 &&
         f->energy[0].term[0] == 0.25);
  EXPECT(f->n_steps == 1 && f->steps[0].evaluations == 100 && f->steps[0].removed_volume == 0.5);
  EXPECT(f->n_probes == 2 && f->probes[0].n == 0 && f->probes[1].value[0] == 99);
  EXPECT_STR(f->probes[0].name, "left/low");
  EXPECT(f->n_gauges == 1 && f->gauges[0].x == 1.5 && f->gauges[0].value[0] == 2);
  EXPECT(f->n_events == 1 && f->events[0].time == 0.4 && f->n_outputs == 1 && f->n_fields == 3);
  struct result_water water;
  EXPECT_OK(water_read(path, "velocity", true, 0, &water));
  EXPECT(water.n == 3 && water.p[1][1] == 2.6 && water.value[0][5] == -3);
  result_water_free(&water);
  result_file_destroy(f);
}

/* A program may ask once, at the end: the first failure is the one that is told. */
static void test_a_failure_stays(void) {
  plunge_result *r = open_result();
  EXPECT(plunge_result_surface(r, 1, 2, flat) == 0);
  EXPECT(plunge_result_surface(r, 0.5, 2, flat) != 0);
  EXPECT(plunge_result_surface(r, 2, 2, flat) != 0 && plunge_result_event(r, "x", 1, 0, 0) != 0);
  EXPECT(plunge_result_close(r, NULL) != 0);
  EXPECT(strstr(plunge_result_message(),
                "the time of a surface is 0.5 s after 1 s; times must not fall"));
  struct result_file *f = NULL;
  EXPECT_OK(result_read(path, &f)); /* what came before it is there */
  EXPECT(f && !f->complete && f->n_surfaces == 1);
  result_file_destroy(f);
}

/* Each on a fresh result; those with `begun` after an output. */
enum wrong {
  LATE_WALL,
  SHORT_WALL,
  INFINITE_WALL,
  NO_NAME,
  LONG_NAME,
  TWICE,
  SLASH,
  NO_PROBE,
  NEGATIVE,
  NO_REST,
  OTHER_FIELDS,
  SHORT_PIECE,
  BACKWARDS,
  NAMELESS,
  WRONG
};

static int do_wrong(enum wrong what, plunge_result *r) {
  const double infinite[] = {0, 0, INFINITY, 0}, *none = NULL;
  char name[100];
  memset(name, 'n', sizeof name);
  name[sizeof name - 1] = 0;
  switch (what) {
  case LATE_WALL:
    return plunge_result_surface(r, 0, 2, flat) == 0 ? plunge_result_wall(r, 4, tank, 0) : 0;
  case SHORT_WALL:
    return plunge_result_wall(r, 1, tank, 0);
  case INFINITE_WALL:
    return plunge_result_wall(r, 2, infinite, 0);
  case NO_NAME:
    return plunge_result_gauge(r, "", 0);
  case LONG_NAME:
    return plunge_result_probe(r, name, 0, 0, 0);
  case TWICE:
    return plunge_result_gauge(r, "G", 0) == 0 ? plunge_result_gauge(r, "G", 1) : 0;
  case SLASH:
    return plunge_result_term(r, "a/b", NULL);
  case NO_PROBE:
    return plunge_result_pressure(r, 0, 0, 0);
  case NEGATIVE:
    return plunge_result_elevation(r, -1, 0, 0);
  case NO_REST:
    return plunge_result_energy(r, 0, 1, 1, 0, 0, NULL);
  case OTHER_FIELDS:
    return plunge_result_particles(r, 0, 2, flat, flat, none, none, none, none) == 0
               ? plunge_result_particles(r, 1, 2, flat, none, none, none, none, none)
               : 0;
  case SHORT_PIECE:
    return plunge_result_surface(r, 0, 1, flat);
  case BACKWARDS:
    return plunge_result_pieces(r, 0, 2, (const int[]){0, 2, 1}, NULL, flat);
  case NAMELESS:
    return plunge_result_event(r, NULL, 0, 0, 0);
  case WRONG:
    break;
  }
  return 0;
}

static void test_what_is_wrong_is_said(void) {
  static const char *const says[WRONG] = {
      [LATE_WALL] = "walls must be told before the first output",
      [SHORT_WALL] = "a wall of 1 points; it needs 2",
      [INFINITE_WALL] = "point 1 of a wall is not finite",
      [NO_NAME] = "a name among gauges has 0 bytes; it must have 1 to 64",
      [LONG_NAME] = "a name among probes has 99 bytes; it must have 1 to 64",
      [TWICE] = "there are two gauges 'G'",
      [SLASH] = "the term 'a/b' has a slash in its name",
      [NO_PROBE] = "there is no probe 0 among 0",
      [NEGATIVE] = "there is no gauge -1 among 0",
      [NO_REST] = "call plunge_result_rest first",
      [OTHER_FIELDS] = "particles have other fields than at the output before",
      [SHORT_PIECE] = "a surface of 1 points; it needs 2",
      [BACKWARDS] = "piece 1 of a surface begins at point 2 and ends at 1",
      [NAMELESS] = "an event without a name or a time"};
  for (int k = 0; k < WRONG; k++) {
    plunge_result *r = open_result();
    if (do_wrong((enum wrong)k, r) == 0) TEST_FAIL("not refused: %s", says[k]);
    EXPECT(plunge_result_close(r, NULL) != 0);
    if (!strstr(plunge_result_message(), says[k]) || !strstr(plunge_result_message(), path))
      TEST_FAIL("%s", plunge_result_message());
  }
  EXPECT(!plunge_result_open(path, 0, 9.81, 1000, 0.1) &&
         strstr(plunge_result_message(), "its H is 0; it must be positive"));
  EXPECT(!plunge_result_open(path, 1, 9.81, 1000, NAN) &&
         strstr(plunge_result_message(), "its spacing is nan"));
  EXPECT(plunge_result_surface(NULL, 0, 2, flat) != 0 && plunge_result_close(NULL, NULL) != 0);
  plunge_result *r =
      plunge_result_open("/nowhere/a.h5", 1, 1, 1, 1); /* found with the first output */
  EXPECT(r && plunge_result_surface(r, 0, 2, flat) != 0 &&
         strstr(plunge_result_message(), "/nowhere/a.h5"));
  EXPECT(plunge_result_close(r, NULL) != 0);
}

int main(void) {
  if (!mkdtemp(folder)) return 1;
  snprintf(path, sizeof path, "%s/theirs.h5", folder);
  RUN(test_everything_comes_back);
  RUN(test_a_failure_stays);
  RUN(test_what_is_wrong_is_said);
  char command[160];
  snprintf(command, sizeof command, "rm -rf '%s'", folder);
  return system(command) != 0 || TEST_RESULT;
}
