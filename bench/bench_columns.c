/* How runs of the boundary-element solver end, and how exact they are until then: released columns
 * at random (tests/bem/columns.h), 15 to 80 nodes per H, evenly in the logarithm.
 *
 *   bench_columns [runs, default 60] [most nodes per H, default 80] [the first run, default 0]
 * [slopes]
 *
 * With the last word, columns on and before slopes, steps and bars (tests/bem/slopes.h). The n-th
 * run is the same in every call. A line a run: column and tank (H), gap between them, or kind of
 * bed, column, slope and rounding; nodes per H, largest relative errors of volume and energy with
 * all that was taken away, removed volume and energy, last time, seconds of the processor, and how
 * it ended. A run that takes longer than ten minutes of it is given up. */
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "bem/solver.h"
#include "bench/bench.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"
#include "tests/bem/columns.h"
#include "tests/bem/slopes.h"

static const struct rlimit patience = {600, 600}; /* s */

static const struct solver *const solvers[] = {&bem_solver};
static const struct registry registry = {.solvers = solvers, .n_solvers = 1};

static enum status compute(const struct case_file *c, const char *path) {
  struct result *out = NULL;
  struct progress *progress = progress_create(PROGRESS_QUIET);
  TRY(result_create(path, c, &c->runs[0], &out));
  progress_begin(progress, "column", c->end, 1);
  enum status status = bem_solver.run(c, &c->runs[0], out, progress);
  if (status != OK) result_ended(out, status_message());
  status = result_finish(out);
  result_destroy(out);
  progress_destroy(progress);
  return status;
}

static void print_errors(const struct result_file *f) {
  double volume = 0, energy = 0;
  const struct result_step *first = f->steps, *last = f->steps + f->n_steps - 1;
  for (size_t i = 0; i < f->n_energy; i++) {
    energy = fmax(energy, fabs(result_energy_budget(&f->energy[i]) / f->energy[0].total - 1));
    volume =
        fmax(volume, fabs((f->steps[i].volume + f->steps[i].removed_volume) / first->volume - 1));
  }
  printf(" %7.1e %7.1e %7.1e %7.1e %6.2f", volume, energy, last->removed_volume / first->volume,
         f->energy[f->n_energy - 1].removed / f->energy[0].total, last->time);
}

static void print_end(const struct result_file *f) {
  for (size_t i = 0; i < f->n_events; i++)
    printf(" %s %.3f (%.3f, %.3f);", f->events[i].name, f->events[i].time, f->events[i].x,
           f->events[i].y);
  printf(" %s\n", *f->ended ? f->ended : "end of the case");
}

/* In a process of its own: whatever happens there, the others are run. */
static void run(const char *with, const char *path) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  struct result_file *f = NULL;
  setrlimit(RLIMIT_CPU, &patience);
  if (case_parse("bench", with, &registry, &problems, &c) != OK || compute(c, path) != OK ||
      result_read(path, &f) != OK) {
    printf(" %s\n", problems.n ? problems.text[0] : status_message());
    exit(1);
  }
  print_errors(f);
  printf(" %6.1f", (double)clock() / CLOCKS_PER_SEC);
  print_end(f);
  exit(0);
}

static void write_column(int n, double most, struct slope_text *t) {
  const struct column c = column_at(n);
  const double resolution = floor(15 * pow(most / 15, c.share) + 0.5);
  column_write(t->text, &c, resolution);
  printf("%3d %5.2f %6.2f %6.2f %3.0f", n, c.wide, c.tank, c.tank - c.wide, resolution);
}

static void write_slope(int n, double most, struct slope_text *t) {
  static const char *const kind[] = {"beach", "falling", "rising", "step", "bar"};
  const struct slope s = slope_at(n);
  const double resolution = floor(15 * pow(most / 15, s.share) + 0.5);
  slope_write(t, &s, resolution, 0);
  printf("%3d %-7s %5.2f 1:%-5.2f %5.3f %3.0f", n, kind[s.kind], s.wide, s.cot, s.rounding,
         resolution);
}

int main(int argc, char **argv) {
  const int runs = argc > 1 ? atoi(argv[1]) : 60, first = argc > 3 ? atoi(argv[3]) : 0;
  const double most = argc > 2 ? atof(argv[2]) : 80;
  const bool slopes = argc > 4 && !strcmp(argv[4], "slopes");
  for (int n = first; n < first + runs; n++) {
    struct slope_text with;
    char path[64];
    int state = 0;
    (slopes ? write_slope : write_column)(n, most, &with);
    snprintf(path, sizeof path, "/tmp/bench-columns-%d-%d.h5", (int)getpid(), n);
    fflush(stdout);
    const pid_t child = fork();
    if (child == 0) run(with.text, path);
    if (child < 0 || waitpid(child, &state, 0) < 0) return 1;
    if (WIFSIGNALED(state)) printf(" stopped by signal %d\n", WTERMSIG(state));
    fflush(stdout);
    unlink(path);
    memcpy(strrchr(path, '.'), ".xdmf", sizeof ".xdmf");
    unlink(path);
  }
  return 0;
}
