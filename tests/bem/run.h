/* Runs a case text with solver bem into a temporary result file and reads it back. */
#pragma once
#include <stdlib.h>
#include <unistd.h>

#include "bem/solver.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"
#include "tests/test.h"

static const struct solver *const run_solvers[] = {&bem_solver};
static const struct registry run_registry = {.solvers = run_solvers, .n_solvers = 1};

/* NULL when the case is refused: the problems are then printed. */
static inline struct case_file *run_case(const char *text) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  if (case_parse("test", text, &run_registry, &problems, &c) != OK)
    for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  return c;
}

/* What else is to be read of a file, before it is gone. */
typedef void run_look(const char *path, void *with);

/* Destroys the case. look: or NULL. */
static inline struct result_file *run_bem_and(struct case_file *c, run_look *look, void *with) {
  char path[] = "/tmp/plunge-bem-XXXXXX.h5", xdmf[sizeof path + 2];
  int handle = mkstemps(path, 3);
  struct result *out = NULL;
  struct result_file *f = NULL;
  struct progress *progress = progress_create(PROGRESS_QUIET);
  EXPECT(handle >= 0 && c && progress);
  if (c && progress) {
    progress_begin(progress, "test", c->end, 1);
    EXPECT_OK(result_create(path, c, &c->runs[0], &out));
    EXPECT_OK(bem_solver.run(c, &c->runs[0], out, progress));
    EXPECT_OK(result_finish(out));
    result_destroy(out);
    EXPECT_OK(result_read(path, &f));
    if (look) look(path, with);
  }
  progress_destroy(progress);
  case_destroy(c);
  close(handle);
  unlink(path);
  snprintf(xdmf, sizeof xdmf, "%.*s.xdmf", (int)strlen(path) - 3, path);
  unlink(xdmf);
  return f;
}

static inline struct result_file *run_bem_case(struct case_file *c) {
  return run_bem_and(c, NULL, NULL);
}

static inline struct result_file *run_bem(const char *text) {
  return run_bem_case(run_case(text));
}

static inline double run_statistic(const struct result_file *f, const char *name) {
  for (size_t i = 0; i < f->n_statistics; i++)
    if (!strcmp(f->statistics[i].name, name)) return f->statistics[i].value;
  return NAN;
}

static inline struct result_event_read run_event(const struct result_file *f, const char *name) {
  for (size_t i = 0; i < f->n_events; i++)
    if (!strcmp(f->events[i].name, name)) return f->events[i];
  return (struct result_event_read){.time = NAN, .x = NAN, .y = NAN};
}
