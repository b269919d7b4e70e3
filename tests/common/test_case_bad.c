/* Wrong case files, each with the exact messages it must get: those of tests/common/bad are listed,
 * in the order of the files, in its messages.txt; too large or too odd ones are made up here. */
#include <dirent.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "common/case/case.h"
#include "tests/common/case_registry.h"
#include "tests/test.h"

/* All messages that `path` gets, a line each, owned by the caller. */
static char *messages_of(const char *path) {
  struct problems problems;
  struct case_file *c;
  char *text = NULL;
  size_t n = 0;
  FILE *out = open_memstream(&text, &n);
  enum status status = case_load(path, 0, NULL, &fake_registry, &problems, &c);
  if (status != ERR_INPUT || c || !problems.n) TEST_FAIL("%s is accepted", path);
  for (size_t i = 0; i < problems.n; i++) fprintf(out, "%s\n", problems.text[i]);
  fclose(out);
  problems_destroy(&problems);
  case_destroy(c);
  return text;
}

/* The lines of `list` that are about `file`. */
static char *lines_about(const char *list, const char *file) {
  char *text = NULL;
  size_t n = 0, length = strlen(file);
  FILE *out = open_memstream(&text, &n);
  for (const char *line = list; *line;) {
    size_t end = strcspn(line, "\n") + 1;
    if (!strncmp(line, file, length) && line[length] == ':') fwrite(line, 1, end, out);
    line += end;
  }
  fclose(out);
  return text;
}

static int is_yaml(const struct dirent *entry) {
  const char *dot = strrchr(entry->d_name, '.');
  return dot && !strcmp(dot, ".yaml");
}

static void test_every_wrong_file_gets_exactly_its_messages(void) {
  struct dirent **files;
  char *list = calloc(1, 1 << 20);
  FILE *in = fopen("messages.txt", "r");
  int n = scandir(".", &files, is_yaml, alphasort);
  size_t used = 0;
  EXPECT(list && in && n >= 60);
  if (!list || !in || n < 0) return;
  size_t size = fread(list, 1, (1 << 20) - 1, in);
  fclose(in);
  for (int i = 0; i < n; i++) {
    char *found = messages_of(files[i]->d_name), *expected = lines_about(list, files[i]->d_name);
    if (strcmp(found, expected)) TEST_FAIL("got\n%sexpected\n%s", found, expected);
    used += strlen(expected);
    free(found);
    free(expected);
    free(files[i]);
  }
  EXPECT(used == size); /* no line of messages.txt is about a file that is not there */
  free(files);
  free(list);
}

/* ---- made up ---- */

static char scratch[] = "/tmp/plunge-case-XXXXXX"; /* wherever the test is started */

/* Expects `text` to be refused in well under a second with the one message `expected`. */
static void expect_refusal(const char *text, size_t n, const char *expected) {
  FILE *out = fopen("odd.yaml", "wb");
  if (!out || fwrite(text, 1, n, out) != n || fclose(out)) {
    TEST_FAIL("cannot write a scratch file");
    return;
  }
  clock_t start = clock();
  char *found = messages_of("odd.yaml");
  EXPECT((double)(clock() - start) / CLOCKS_PER_SEC < 10); /* a hang; sanitizers are slow */
  EXPECT_STR(found, expected);
  free(found);
}

static char *repeat(const char *piece, size_t times, size_t *n) {
  size_t length = strlen(piece);
  char *text = malloc(length * times + 1);
  for (size_t i = 0; text && i < times; i++) memcpy(text + i * length, piece, length);
  if (text) text[length * times] = 0;
  *n = length * times;
  return text;
}

static void expect_repeat_refusal(const char *piece, size_t times, const char *expected) {
  size_t n;
  char *text = repeat(piece, times, &n);
  expect_refusal(text, n, expected);
  free(text);
}

static void test_deep_nesting_is_refused_at_once(void) {
  expect_repeat_refusal("[", 1000000,
                        "odd.yaml:1: found lists and mappings more than 32 deep; allowed: 32; "
                        "close the brackets\n");
  expect_repeat_refusal("{a: ", 300000,
                        "odd.yaml:1: found lists and mappings more than 32 deep; allowed: 32; "
                        "close the brackets\n");
  expect_repeat_refusal("- ", 300000,
                        "odd.yaml:1: found lists and mappings more than 32 deep; allowed: 32; "
                        "close the brackets\n");
}

static void test_masses_of_keys_and_anchors_are_refused_at_once(void) {
  expect_repeat_refusal(
      "key: 1\n", 50000,
      "odd.yaml:1: found a mapping of 50000 keys; allowed: a mapping with the "
      "keys title, fluid, scales, tank, water, time, probes, gauges, points, runs, "
      "compare\n");
  expect_repeat_refusal("- &a 1\n", 300000,
                        "odd.yaml:1001: found more than 1000 anchors (&name); allowed: 1000; "
                        "write the values out\n");
}

/* Ten aliases of ten aliases ...: 10^12 items if they were written out. */
static void test_alias_bombs_do_not_go_off(void) {
  char *text = NULL;
  size_t n = 0;
  FILE *out = open_memstream(&text, &n);
  fputs("tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
        "water: {regions: [[[0, 0], [1, 0], [1, 1], [0, 1]]]}\n"
        "runs: [{solver: sph, resolution: 9}]\ntime:\n  end: &a 1\n",
        out);
  for (char c = 'b'; c < 'n'; c++) {
    fprintf(out, "  every: &%c [", c);
    for (int i = 0; i < 10; i++) fprintf(out, "*%c%s", c - 1, i < 9 ? ", " : "]\n");
  }
  fclose(out);
  FILE *file = fopen("odd.yaml", "w");
  fputs(text, file);
  fclose(file);
  char *found = messages_of("odd.yaml");
  EXPECT(strstr(found, "odd.yaml:6: time.every: found a list; allowed: a time above 0"));
  EXPECT(strstr(found, "odd.yaml:17: time.every: found the key a second time (first in line 6)"));
  free(found);
  free(text);
}

static void test_long_texts_are_shortened_in_messages(void) {
  size_t n, m;
  char *title = repeat("waves", 200000, &m), *text = malloc(m + 100);
  n = (size_t)sprintf(text, "title: %s\nwater: 1\ntank: 1\ntime: 1\nruns: 1\n", title);
  expect_refusal(
      text, n,
      "odd.yaml:1: title: found 'waveswaveswaveswaveswaveswaveswaveswaveswave...'; allowed: one "
      "line of text of at most 200 bytes\n"
      "odd.yaml:2: water: found '1'; allowed: a mapping with the keys regions, wave, body, "
      "velocity, "
      "pressure\n"
      "odd.yaml:3: tank: found '1'; allowed: a mapping with the keys walls, sides, bed, motions\n"
      "odd.yaml:4: time: found '1'; allowed: a mapping with the keys end, every, sample\n"
      "odd.yaml:5: runs: found '1'; allowed: a list of 1 to 1000 runs\n");
  free(title);
  free(text);
}

static void test_only_a_hundred_problems_are_listed(void) {
  size_t n, m;
  char *runs = repeat("- {name: a, solver: sph, resolution: 0}\n", 500, &m),
       *text = malloc(m + 200);
  n = (size_t)sprintf(text,
                      "tank: {walls: [[[0, 3], [0, 0], [4, 0], [4, 3]]]}\n"
                      "water: {regions: [[[0, 0], [1, 0], [1, 1]]]}\ntime: {end: 1}\nruns:\n%s",
                      runs);
  FILE *file = fopen("odd.yaml", "w");
  fwrite(text, 1, n, file);
  fclose(file);
  char *found = messages_of("odd.yaml");
  const char *last = "\nodd.yaml: 899 more problems are not listed\n"; /* 500 + 499 names - 100 */
  EXPECT(strlen(found) > strlen(last) && !strcmp(found + strlen(found) - strlen(last), last));
  free(found);
  free(runs);
  free(text);
}

static void test_files_that_cannot_be_read(void) {
  char *found = messages_of("nowhere.yaml");
  EXPECT_STR(found,
             "nowhere.yaml: found nothing to read (No such file or directory); allowed: a case "
             "file in YAML of at most 10 MB, or - for standard input; correct the path\n");
  EXPECT_STR(status_message(), "nowhere.yaml has 1 problem");
  free(found);
  static const char *const odd[][2] = {{"/tmp", "a directory"}, {"/dev/zero", "a device"}};
  for (size_t i = 0; i < 2; i++) {
    char expected[256];
    snprintf(
        expected, sizeof expected,
        "%s: found %s; allowed: a case file in YAML of at most 10 MB, or - for standard input; "
        "correct the path\n",
        odd[i][0], odd[i][1]);
    found = messages_of(odd[i][0]);
    EXPECT_STR(found, expected);
    free(found);
  }
  expect_repeat_refusal(
      "# a comment\n", 1000000,
      "odd.yaml: found more than 10 MB; allowed: a case file in YAML of at most 10 "
      "MB, or - for standard input; correct the path\n");
}

int main(void) {
  if (chdir(SOURCE_DIR "/tests/common/bad")) return 1;
  RUN(test_every_wrong_file_gets_exactly_its_messages);
  if (!mkdtemp(scratch) || chdir(scratch)) return 1;
  RUN(test_deep_nesting_is_refused_at_once);
  RUN(test_masses_of_keys_and_anchors_are_refused_at_once);
  RUN(test_alias_bombs_do_not_go_off);
  RUN(test_long_texts_are_shortened_in_messages);
  RUN(test_only_a_hundred_problems_are_listed);
  RUN(test_files_that_cannot_be_read);
  unlink("odd.yaml");
  if (chdir("/") == 0) rmdir(scratch);
  return TEST_RESULT;
}
