/* What the axes of charts leave out is what must be left out, and is known. */
#include "compare/frame.h"

#include <stdlib.h>

#include "tests/test.h"

enum { ROWS = 1001 };
static const double end = 4;

static struct cmp_series wave(double level, double amplitude) {
  struct cmp_series s = {.name = "wave", .n = ROWS};
  s.t = calloc(ROWS, sizeof *s.t);
  s.value = calloc(ROWS, sizeof *s.value);
  if (!s.t || !s.value) abort();
  for (int i = 0; i < ROWS; i++) {
    s.t[i] = end * i / (ROWS - 1);
    s.value[i] = level + amplitude * cos(2.385 * s.t[i]);
  }
  return s;
}

static void series_free(struct cmp_series *s) {
  free(s->t);
  free(s->value);
}

static struct cmp_frame frame_of(size_t n, const struct cmp_series *s, double most) {
  const struct cmp_series *list[8] = {NULL};
  for (size_t k = 0; k < n; k++) list[k + 1] = &s[k]; /* the first has none */
  return cmp_frame_choose(n + 1, list, end, most);
}

/* Energies of which one is 7.59 times the others' are all inside. */
static void test_far_curve_is_inside(void) {
  struct cmp_series s[] = {wave(1, 1e-3), wave(1, 1e-5), wave(7.59, 0.1)};
  struct cmp_frame frame = frame_of(3, s, 8);
  for (int k = 0; k < 3; k++) EXPECT(cmp_frame_beyond(&frame, &s[k], end).outside == 0);
  EXPECT(frame.high < 9 && frame.low > 0);
  for (int k = 0; k < 3; k++) series_free(&s[k]);
}

/* One that has blown up leaves the frame, does not flatten the others, and is known to be out. */
static void test_blown_up_curve_is_beyond(void) {
  struct cmp_series s[] = {wave(0.5, 0.5), wave(0.5, 0.4), wave(1e8, 1e7)};
  struct cmp_frame frame = frame_of(3, s, 8);
  EXPECT(frame.low < 0 && frame.low > -0.2 && frame.high > 1 && frame.high < 1.2);
  struct cmp_beyond in = cmp_frame_beyond(&frame, &s[0], end);
  EXPECT(in.n == ROWS && in.outside == 0 && !in.above.found && !in.below.found);
  struct cmp_beyond out = cmp_frame_beyond(&frame, &s[2], end);
  EXPECT(out.n == ROWS && out.outside == ROWS && out.above.found && !out.below.found);
  EXPECT_NEAR(out.above.value, 1.1e8, 1e-6); /* the first row: exact but for rounding */
  EXPECT_NEAR(out.above.t, 0, 0);
  for (int k = 0; k < 3; k++) series_free(&s[k]);
}

/* A peak twice as high as the rest is inside; one thirty times as high is named with its time. */
static void test_peaks(void) {
  struct cmp_series s[] = {wave(0.5, 0.5), wave(0.5, 0.5)};
  s[1].value[400] = 1.9;
  struct cmp_frame frame = frame_of(2, s, 2.5);
  EXPECT(frame.high > 1.9 && cmp_frame_beyond(&frame, &s[1], end).outside == 0);
  s[1].value[400] = 30;
  s[1].value[401] = -20;
  s[1].value[402] = NAN;
  frame = frame_of(2, s, 2.5);
  EXPECT(frame.high < 2 && frame.low > -2);
  struct cmp_beyond b = cmp_frame_beyond(&frame, &s[1], end);
  EXPECT(b.n == ROWS - 1 && b.outside == 2);
  EXPECT(b.above.found && b.above.value == 30 && b.above.t == s[1].t[400]);
  EXPECT(b.below.found && b.below.value == -20 && b.below.t == s[1].t[401]);
  for (int k = 0; k < 2; k++) series_free(&s[k]);
}

/* gnuplot refuses an empty range. */
static void test_frames_are_never_empty(void) {
  struct cmp_series flat[] = {wave(0, 0), wave(1e6, 0), wave(0, NAN)};
  for (int k = 0; k < 3; k++) {
    struct cmp_frame frame = frame_of(1, &flat[k], 8);
    EXPECT(frame.low < frame.high);
    series_free(&flat[k]);
  }
  struct cmp_frame none = frame_of(0, NULL, 8);
  EXPECT(none.low < none.high);
}

int main(void) {
  RUN(test_far_curve_is_inside);
  RUN(test_blown_up_curve_is_beyond);
  RUN(test_peaks);
  RUN(test_frames_are_never_empty);
  return TEST_RESULT;
}
