/* How many runs side by side: the plan alone, no processes. */
#include "cli/jobs.h"

#include <stdint.h>

#include "tests/test.h"

/* A particle run of `seconds` on one thread; small ones lose as much by a second thread as they
 * gain (sph/estimate.c: 5,000 particles take 16 s on one thread, 11 s on two). */
static struct job particles(size_t item, double seconds, double joining) {
  return (struct job){
      .name = "sph",
      .item = item,
      .estimate = {.bytes = 100, .seconds = seconds, .shared = 1, .joining = joining}};
}

static struct job elements(size_t item, double seconds) {
  return (struct job){.name = "bem", .item = item, .estimate = {.bytes = 100, .seconds = seconds}};
}

static struct job_plan threads(int n) {
  return (struct job_plan){.threads = n, .room = 1e9, .most = SIZE_MAX};
}

static void test_small_runs_go_side_by_side(void) {
  struct job job[5] = {elements(0, 7)};
  for (size_t i = 1; i < 5; i++) job[i] = particles(i, 15 + (double)i, 3);
  struct job_plan plan = threads(2);
  jobs_plan(5, job, &plan);
  EXPECT(plan.jobs == 2 && jobs_threads(&plan, 0) == 1 && jobs_threads(&plan, 1) == 1);
  for (size_t i = 0; i < 5; i++) EXPECT(job[i].item == 4 - i); /* the longest first */
}

/* H/dx = 25, 50, 100: the last takes eight times as long as the second. */
static void test_convergence_study_is_not_slower(void) {
  struct job job[3] = {particles(0, 2, 1.5), particles(1, 16, 3), particles(2, 128, 6)};
  struct job_plan plan = threads(2);
  jobs_plan(3, job, &plan);
  EXPECT(plan.jobs == 1 && jobs_threads(&plan, 0) == 2);
  for (size_t i = 0; i < 3; i++) EXPECT(job[i].item == i); /* as they stand in the case */
}

static void test_memory_limits(void) {
  for (size_t fit = 0; fit <= 4; fit++) {
    struct job job[4];
    for (size_t i = 0; i < 4; i++) job[i] = particles(i, 16, 8);
    struct job_plan plan = threads(4);
    plan.room = 100 * (double)fit + 50;
    jobs_plan(4, job, &plan);
    EXPECT(plan.jobs == (fit ? fit : 1) || (fit == 3 && plan.jobs == 2)); /* 2 + 2 or 3 + 1 */
  }
}

static void test_number_asked_for(void) {
  struct job job[4];
  for (size_t i = 0; i < 4; i++) job[i] = particles(i, 16, 0);
  struct job_plan plan = threads(2);
  plan.most = 3;
  plan.exactly = true;
  jobs_plan(4, job, &plan);
  EXPECT(plan.jobs == 3 && jobs_threads(&plan, 2) == 1);
  plan.room = 250;
  jobs_plan(4, job, &plan);
  EXPECT(plan.jobs == 2);
  plan = threads(2);
  plan.most = 1;
  jobs_plan(4, job, &plan);
  EXPECT(plan.jobs == 1);
}

static void test_threads_are_shared_out(void) {
  for (int n = 1; n <= 9; n++)
    for (size_t jobs = 1; jobs <= (size_t)n; jobs++) {
      struct job_plan plan = {.threads = n, .jobs = jobs};
      int sum = 0;
      for (size_t k = 0; k < jobs; k++) sum += jobs_threads(&plan, k);
      EXPECT(sum == n);
    }
}

static void test_one_thread_or_run(void) {
  struct job job[2] = {particles(0, 16, 3), particles(1, 17, 3)};
  struct job_plan plan = threads(1);
  jobs_plan(2, job, &plan);
  EXPECT(plan.jobs == 1);
  plan = threads(8);
  jobs_plan(1, job, &plan);
  EXPECT(plan.jobs == 1 && jobs_threads(&plan, 0) == 8);
  jobs_plan(0, job, &plan);
  EXPECT(plan.jobs == 1);
}

int main(void) {
  RUN(test_small_runs_go_side_by_side);
  RUN(test_convergence_study_is_not_slower);
  RUN(test_memory_limits);
  RUN(test_number_asked_for);
  RUN(test_threads_are_shared_out);
  RUN(test_one_thread_or_run);
  return TEST_RESULT;
}
