/* A small test harness: `RUN(test_name)` in main, EXPECT_* inside. A failed expectation prints where
 * and what, and the program's exit code counts the failed tests. */
#pragma once
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "common/base/status.h"

static int test_failures, test_failed_here;

#define TEST_FAIL(...)                                                                             \
  do {                                                                                             \
    test_failed_here = 1;                                                                          \
    fprintf(stderr, "%s:%d: ", __FILE__, __LINE__);                                                \
    fprintf(stderr, __VA_ARGS__);                                                                  \
    fputc('\n', stderr);                                                                           \
  } while (0)

#define EXPECT(cond)                                                                               \
  do {                                                                                             \
    if (!(cond)) TEST_FAIL("expected %s", #cond);                                                  \
  } while (0)

/* |a - b| <= tol; the tolerance is absolute, and the comment beside the call says where it comes from */
#define EXPECT_NEAR(a, b, tol)                                                                     \
  do {                                                                                             \
    double a_ = (a), b_ = (b), t_ = (tol);                                                         \
    if (!(fabs(a_ - b_) <= t_)) TEST_FAIL("%s = %.10g, expected %.10g +- %.3g", #a, a_, b_, t_);   \
  } while (0)

#define EXPECT_STR(a, b)                                                                           \
  do {                                                                                             \
    const char *a_ = (a), *b_ = (b);                                                               \
    if (!a_ || strcmp(a_, b_)) TEST_FAIL("%s is\n  %s\nexpected\n  %s", #a, a_ ? a_ : "NULL", b_); \
  } while (0)

#define EXPECT_OK(call)                                                                            \
  do {                                                                                             \
    if ((call) != OK) TEST_FAIL("%s: %s", #call, status_message());                                \
  } while (0)

#define RUN(test)                                                                                  \
  do {                                                                                             \
    test_failed_here = 0;                                                                          \
    test();                                                                                        \
    printf("%s %s\n", test_failed_here ? "FAIL" : "ok  ", #test);                                  \
    fflush(stdout);                                                                                \
    test_failures += test_failed_here;                                                             \
  } while (0)

#define TEST_RESULT (test_failures != 0)
