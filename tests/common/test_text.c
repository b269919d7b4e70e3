/* Texts from outside: what is read of them and what is refused; lines; control characters. */
#include "common/base/text.h"

#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/test.h"

static char path[] = "/tmp/plunge-text-XXXXXX";

static void write_text(const char *text, size_t n) {
  FILE *out = fopen(path, "wb");
  if (!out || fwrite(text, 1, n, out) != n || fclose(out)) TEST_FAIL("cannot write %s", path);
}

static void expect_refusal(const char *name, size_t most, const char *found) {
  char *text;
  size_t n;
  EXPECT(text_read(name, most, &text, &n) == ERR_INPUT && !text);
  EXPECT_STR(status_message(), found);
}

static void test_a_text_is_read_whole_and_without_its_mark(void) {
  char *text = NULL;
  size_t n = 0, long_one = 1200000; /* more than one piece */
  write_text("\xef\xbb\xbf"
             "a\n",
             5);
  EXPECT_OK(text_read(path, 100, &text, &n));
  EXPECT(n == 2);
  EXPECT_STR(text, "a\n");
  free(text);
  char *many = malloc(long_one);
  if (!many) return;
  memset(many, 'x', long_one);
  write_text(many, long_one);
  EXPECT_OK(text_read(path, 2 << 20, &text, &n));
  EXPECT(n == long_one && !memcmp(text, many, n) && !text[n]);
  free(text);
  expect_refusal(path, 1 << 20, "more than 1 MB");
  free(many);
}

static void test_what_is_no_text_is_named(void) {
  write_text("a\0b", 3);
  expect_refusal(path, 100, "a binary file");
  expect_refusal("/tmp", 100, "a directory");
  expect_refusal("/dev/zero", 100, "a device");
  expect_refusal("/nowhere/at.all", 100, "nothing to read (No such file or directory)");
  unlink(path);
  if (mkfifo(path, 0600) == 0) expect_refusal(path, 100, "a pipe");
}

static void test_lines_end_with_or_without_a_carriage_return(void) {
  char text[] = "one\r\n\ntwo", *rest = text;
  EXPECT_STR(text_line(&rest), "one");
  EXPECT_STR(text_line(&rest), "");
  EXPECT_STR(text_line(&rest), "two");
  EXPECT(!text_line(&rest) && !text_line(&rest));
}

static void test_control_characters_are_shown(void) {
  char *shown = NULL;
  size_t n = 0;
  FILE *out = open_memstream(&shown, &n);
  text_show(out, "\033[2J\tb\303\251\302\233m\177\n", "\n");
  fclose(out);
  EXPECT_STR(shown, "\\x1b[2J\\x09b\303\251\\xc2\\x9bm\\x7f\n");
  free(shown);
}

int main(void) {
  int fd = mkstemp(path);
  if (fd < 0) return 1;
  close(fd);
  RUN(test_a_text_is_read_whole_and_without_its_mark);
  RUN(test_what_is_no_text_is_named);
  RUN(test_lines_end_with_or_without_a_carriage_return);
  RUN(test_control_characters_are_shown);
  unlink(path);
  return TEST_RESULT;
}
