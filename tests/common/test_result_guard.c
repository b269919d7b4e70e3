/* The child that reads: whatever it does, the parent gets one status and one sentence. */
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/result/result_guard.h"
#include "tests/test.h"

static enum status carry_nothing(struct carrier *c, void *data) {
  (void)c, (void)data;
  return OK;
}

static enum status run(enum status (*read)(void *data),
                       enum status (*carry)(struct carrier *c, void *data), void *data) {
  return guard_run(&(struct guard){
      .name = {"a.h5", "b.h5"}, .size = 5, .data = data, .read = read, .carry = carry});
}

/* ---- what goes right ---- */

struct answer {
  size_t n, n_texts;
  double *array;
  char **text, *none;
};

static enum status read_answer(void *data) {
  struct answer *a = data;
  a->n = 300001; /* many times what a pipe holds */
  a->n_texts = 2;
  a->array = malloc(a->n * sizeof *a->array);
  a->text = calloc(2, sizeof *a->text);
  for (size_t i = 0; i < a->n; i++) a->array[i] = (double)i / 3;
  a->text[0] = strdup("");
  a->text[1] = strdup("H = 2.385 m");
  return OK;
}

static enum status carry_one_text(struct carrier *c, void *element) {
  return carry_text(c, element);
}

static enum status carry_answer(struct carrier *c, void *data) {
  struct answer *a = data;
  TRY(carry_text(c, &a->none));
  TRY(carry_array(c, &a->n, &a->array));
  return carry_each(c, &a->n_texts, &a->text, carry_one_text);
}

static void test_what_was_read_arrives(void) {
  struct answer a = {0};
  EXPECT_OK(run(read_answer, carry_answer, &a));
  EXPECT(a.n == 300001 && a.array && a.array[a.n - 1] == 300000 / 3.0 && !a.none);
  EXPECT(a.n_texts == 2);
  if (a.n_texts == 2) EXPECT_STR(a.text[0], "");
  if (a.n_texts == 2) EXPECT_STR(a.text[1], "H = 2.385 m");
  for (size_t i = 0; i < a.n_texts; i++) free(a.text[i]);
  free(a.text);
  free(a.array);
}

static enum status read_error(void *data) {
  (void)data;
  return status_raise(ERR_INPUT, "b.h5: row 7 is %g", 0.5);
}

static void test_errors_keep_their_words(void) {
  EXPECT(run(read_error, carry_nothing, NULL) == ERR_INPUT);
  EXPECT_STR(status_message(), "b.h5: row 7 is 0.5");
}

/* ---- what goes wrong ---- */

static enum status crash(void *data) {
  (void)data;
  guard_blame(1);
  raise(SIGSEGV);
  return OK;
}

static enum status spin(void *data) {
  for (volatile size_t *n = data; *n < 1; (void)*n) continue;
  return OK;
}

static enum status sleep_on(void *data) {
  (void)data;
  alarm(1); /* what the guard itself sets to longer */
  pause();
  return OK;
}

static enum status devour(void *data) {
  (void)data;
  for (int i = 0; i < 1000; i++) {
    char *block = malloc(1 << 20);
    CHECK(block, ERR_MEMORY, "no memory for a block");
    memset(block, 1, 1 << 20);
  }
  return OK;
}

static enum status be_stopped(void *data) {
  (void)data;
  raise(SIGTERM);
  return OK;
}

static enum status be_killed(void *data) {
  (void)data;
  raise(SIGKILL);
  return OK;
}

static void expect(enum status (*read)(void *data), enum status status, const char *message) {
  size_t zero = 0;
  EXPECT(run(read, carry_nothing, &zero) == status);
  EXPECT_STR(status_message(), message);
}

static void test_a_crash_is_put_down_to_the_file_that_is_read(void) {
  expect(crash, ERR_INPUT, "b.h5 is damaged beyond reading");
}

static void test_endless_work_is_ended(void) {
  const char *message = "a.h5 is damaged beyond reading: reading it never ends";
  expect(spin, ERR_INPUT, message);
  expect(sleep_on, ERR_INPUT, message);
}

static void test_memory_is_limited(void) {
#ifdef __SANITIZE_ADDRESS__
  printf("skip limits on memory: the sanitizer has reserved all addresses beforehand\n");
#else
  expect(devour, ERR_INPUT,
         "a.h5 is damaged: reading it takes more than 256 MB of memory, too much for a file of its "
         "size");
#endif
}

static void test_signals_are_told_apart(void) {
  expect(be_stopped, INTERRUPTED, "interrupted while reading a.h5");
  expect(be_killed, ERR_MEMORY, "no memory to read a.h5: the system ended the process");
}

/* Where the user allows less than a sound file may take, it is memory that lacks. */
static void test_the_users_own_limit_is_no_damage(void) {
#ifndef __SANITIZE_ADDRESS__
  pid_t child = fork();
  if (!child) {
    setrlimit(RLIMIT_AS, &(struct rlimit){150 << 20, 150 << 20});
    expect(devour, ERR_MEMORY, "no memory for a block");
    _exit(test_failed_here);
  }
  int outcome = 1;
  EXPECT(child > 0 && waitpid(child, &outcome, 0) == child && outcome == 0);
#endif
}

/* ---- a child that lies ---- */

static enum status read_nothing(void *data) {
  (void)data;
  return OK;
}

static enum status carry_too_much(struct carrier *c, void *data) {
  size_t n = (size_t)1 << 60;
  (void)data;
  if (c->sending) return carry_number(c, &n);
  void *array = NULL;
  enum status status = carry_elements(c, &n, &array, sizeof(double));
  EXPECT(status == ERR_INPUT && !array);
  free(array);
  return status;
}

static enum status carry_too_little(struct carrier *c, void *data) {
  char bytes[100];
  memset(bytes, 1, sizeof bytes);
  (void)data;
  return carry_bytes(c, bytes, c->sending ? 7 : sizeof bytes);
}

static void test_lies_are_refused(void) {
  EXPECT(run(read_nothing, carry_too_much, NULL) == ERR_INPUT);
  EXPECT_STR(status_message(), "a.h5 is damaged beyond reading");
  EXPECT(run(read_nothing, carry_too_little, NULL) == ERR_INPUT);
  EXPECT_STR(status_message(), "a.h5 is damaged beyond reading");
}

int main(void) {
  RUN(test_what_was_read_arrives);
  RUN(test_errors_keep_their_words);
  RUN(test_a_crash_is_put_down_to_the_file_that_is_read);
  RUN(test_endless_work_is_ended);
  RUN(test_memory_is_limited);
  RUN(test_the_users_own_limit_is_no_damage);
  RUN(test_signals_are_told_apart);
  RUN(test_lies_are_refused);
  return TEST_RESULT;
}
