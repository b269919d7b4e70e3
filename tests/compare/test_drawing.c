/* Drawing figures with a made-up gnuplot in the PATH: it draws what is called good, fails at what
 * is called bad, and never comes to an end with what is called slow, which it hands to a child. */
#include "compare/drawing.h"

#include <errno.h>
#include <ftw.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "common/base/progress.h"
#include "compare/graph.h"
#include "compare/output.h"
#include "tests/test.h"

static char folder[] = "/tmp/plunge-drawing-XXXXXX";
static const struct cmp_drawing_limits ample = {60, 120};

static const char gnuplot[] = "#!/bin/sh\n"
                              "name=${2%.gp}\n"
                              "case $name in\n"
                              "bad*) echo '\"bad.gp\" line 7: undefined variable' >&2; exit 1;;\n"
                              "slow*) sleep 600 & echo $! > \"$PLUNGE_TEST/child\"; wait;;\n"
                              "esac\n"
                              "echo '                                  </svg>' > $name.svg\n"
                              "echo '                                  %%EOF' | tee $name.pdf > "
                              "$name-column.pdf\n"
                              "echo '                                  IEND' > $name.png\n";

static void path_in(const char *name, char *out) {
  if (cmp_path_join(folder, name, out) != OK) abort();
}

static bool is_there(const char *name) {
  char path[PATH_MAX];
  path_in(name, path);
  return access(path, F_OK) == 0;
}

static void file_make(const char *name, const char *text, mode_t mode) {
  char path[PATH_MAX];
  path_in(name, path);
  FILE *f = fopen(path, "w");
  if (!f || fputs(text, f) < 0 || fclose(f) != 0 || chmod(path, mode) != 0) abort();
}

static void figures_make(struct cmp_figures *f, size_t n, const char *const *name) {
  EXPECT_OK(cmp_figures_open(folder, f));
  for (size_t k = 0; k < n; k++) {
    struct cmp_figure *fig;
    EXPECT_OK(cmp_figure_begin(f, CMP_SECTION_ENERGY, false, 100, 100, &fig, "%s", name[k]));
    cmp_figure_formats(fig);
    EXPECT_OK(cmp_figure_end(fig));
  }
}

/* The child that a slow gnuplot has started is ended with it. */
static bool child_is_gone(void) {
  char path[PATH_MAX], *text;
  size_t n;
  path_in("child", path);
  if (cmp_file_read(path, &text, &n) != OK) return false;
  pid_t pid = (pid_t)atol(text);
  free(text);
  unlink(path);
  for (int k = 0; k < 200; k++) { /* until its new parent has taken notice */
    if (kill(pid, 0) != 0 && errno == ESRCH) return true;
    char state[64], line[256] = "";
    snprintf(state, sizeof state, "/proc/%d/stat", (int)pid);
    FILE *f = fopen(state, "r");
    bool dead = !f || !fgets(line, sizeof line, f) || strstr(line, ") Z ");
    if (f) fclose(f);
    if (dead) return true;
    usleep(5000);
  }
  return false;
}

/* One figure that cannot be drawn leaves the others alone; its script is there to be mended, an
 * earlier picture of it is not. */
static void test_failure_is_alone(void) {
  struct cmp_figures f;
  figures_make(&f, 3, (const char *const[]){"good-1", "bad", "good-2"});
  file_make("figures/bad.svg", "of an earlier report", 0666);
  EXPECT(cmp_figures_draw(&f, ample) == ERR_IO);
  EXPECT(strstr(status_message(), "1 of 3 figures could not be drawn; bad: "));
  EXPECT(strstr(f.figure[1].missing, "line 7: undefined variable"));
  EXPECT(!*f.figure[0].missing && !*f.figure[2].missing && cmp_figures_missing(&f) == 1);
  cmp_figures_close(&f);
  EXPECT(is_there("figures/good-1.svg") && is_there("figures/good-2.png"));
  EXPECT(is_there("figures/bad.gp") && !is_there("figures/bad.svg"));
}

static void test_slow_figure_is_stopped(void) {
  struct cmp_figures f;
  figures_make(&f, 3, (const char *const[]){"good-3", "slow", "good-4"});
  EXPECT(cmp_figures_draw(&f, (struct cmp_drawing_limits){2, 120}) == ERR_IO);
  EXPECT(strstr(f.figure[1].missing, "took longer than 2 s"));
  EXPECT(child_is_gone());
  cmp_figures_close(&f);
  EXPECT(is_there("figures/good-3.svg") && is_there("figures/good-4.svg"));
}

/* What there is no time for is left out with a word, and that is no failure. */
static void test_time_for_all_is_limited(void) {
  static const char *const name[] = {"good-5", "good-6", "good-7", "good-8"};
  struct cmp_figures f;
  figures_make(&f, 4, name);
  EXPECT_OK(cmp_figures_draw(&f, (struct cmp_drawing_limits){60, 1e-5}));
  size_t missing = cmp_figures_missing(&f);
  EXPECT(missing > 0 && missing < 4); /* two begin at once; the time is up when one has ended */
  for (size_t k = 0; k < 4; k++) {
    char file[64];
    snprintf(file, sizeof file, "figures/%s.svg", name[k]);
    EXPECT(is_there(file) == !*f.figure[k].missing);
    EXPECT(is_there(file) || strstr(f.figure[k].missing, "took more than 1e-05 s of processor"));
  }
  cmp_figures_close(&f);
}

/* One that hangs uses up its time of all. */
static void test_stopped_figure_counts(void) {
  struct cmp_figures f;
  figures_make(&f, 3, (const char *const[]){"slow-1", "slow-2", "good-9"});
  EXPECT(cmp_figures_draw(&f, (struct cmp_drawing_limits){1, 0.9}) == ERR_IO);
  EXPECT(strstr(f.figure[2].missing, "left out") && cmp_figures_missing(&f) == 3);
  EXPECT(child_is_gone());
  cmp_figures_close(&f);
}

static void test_leftovers_are_removed(void) {
  struct cmp_figures one, two;
  char path[PATH_MAX];
  EXPECT_OK(cmp_figures_open(folder, &one));
  path_in("figures/.drawing-abcdef", path);
  EXPECT(mkdir(path, 0777) == 0);
  file_make("figures/.drawing-abcdef/energy.gp", "", 0666);
  EXPECT_OK(cmp_figures_open(folder, &two));
  EXPECT(!is_there("figures/.drawing-abcdef"));
  EXPECT(access(one.temporary, F_OK) == 0); /* in use: of another report into the same folder */
  cmp_figures_close(&one);
  cmp_figures_close(&two);
}

/* A signal stops the drawing at once; nothing temporary stays. Last: the wish to stop stays. */
static void test_signal_stops(void) {
  struct cmp_figures f;
  figures_make(&f, 2, (const char *const[]){"slow", "good-10"});
  char temporary[PATH_MAX];
  snprintf(temporary, sizeof temporary, "%s", f.temporary);
  progress_catch_signals();
  pid_t self = getpid(), sender = fork();
  if (sender == 0) {
    char path[PATH_MAX];
    path_in("child", path);
    while (access(path, F_OK) != 0) usleep(10000);
    usleep(50000);
    kill(self, SIGTERM);
    _exit(0);
  }
  double began = progress_wall_clock();
  EXPECT(cmp_figures_draw(&f, ample) == INTERRUPTED);
  EXPECT(progress_wall_clock() - began < 30);
  EXPECT(child_is_gone());
  cmp_figures_close(&f);
  EXPECT(access(temporary, F_OK) != 0);
  waitpid(sender, NULL, 0);
}

static const double rows[] = {0, 1, NAN, 1, 10, 2, 2, 1000, 4};
static const struct cmp_graph_column columns[] = {
    {.head = "x [1]", .label = "x"},
    {.head = "y [1]", .label = "y", .log = true, .level = "10"},
    {.head = "it's [1]", .label = "it's", .points = true, .panel = 1}};
static const struct cmp_graph_curve curves[] = {{.name = "one", .n = 3, .row = rows},
                                                {.name = "other's", .n = 2, .row = rows}};

static enum status graph_draw(const char *name, const char *file) {
  const struct cmp_graph graph = {.name = name,
                                  .title = "Title",
                                  .n_columns = 3,
                                  .n_curves = 2,
                                  .column = columns,
                                  .curve = curves};
  struct cmp_figures f;
  char path[PATH_MAX];
  path_in(file, path);
  enum status status = cmp_figures_open_file(path, &f);
  if (status == OK) status = cmp_graph_write(&graph, &f);
  if (status == OK) status = cmp_figures_draw(&f, ample);
  cmp_figures_close(&f);
  return status;
}

/* One picture is all that is left of it; when it cannot be drawn, an earlier one stays. */
static void test_one_file(void) {
  EXPECT_OK(graph_draw("good", "it's.pdf"));
  EXPECT(is_there("it's.pdf") && !is_there("it's.svg") && !is_there("good.pdf"));
  EXPECT(!is_there("good.gp") && !is_there("good.csv") && !is_there("figures/good.pdf"));
  EXPECT(graph_draw("bad", "it's.pdf") == ERR_IO);
  EXPECT(strstr(status_message(), "line 7: undefined variable"));
  EXPECT(is_there("it's.pdf"));
  EXPECT(graph_draw("good", "it.s/picture.txt") == ERR_USAGE);
  EXPECT(graph_draw("good", "picture.") == ERR_USAGE);
  EXPECT(graph_draw("good", "nowhere/picture.svg") == ERR_IO);
}

static int entry_remove(const char *path, const struct stat *info, int kind, struct FTW *at) {
  (void)info, (void)kind, (void)at;
  return remove(path);
}

int main(void) {
  char path[2 * PATH_MAX];
  if (!mkdtemp(folder)) return 1;
  file_make("gnuplot", gnuplot, 0777);
  snprintf(path, sizeof path, "%s:%s", folder, getenv("PATH"));
  setenv("PATH", path, 1);
  setenv("PLUNGE_TEST", folder, 1);
  RUN(test_failure_is_alone);
  RUN(test_slow_figure_is_stopped);
  RUN(test_time_for_all_is_limited);
  RUN(test_stopped_figure_counts);
  RUN(test_leftovers_are_removed);
  RUN(test_one_file);
  RUN(test_signal_stops);
  nftw(folder, entry_remove, 16, FTW_DEPTH | FTW_PHYS);
  return TEST_RESULT;
}
