/* The first run of a case, from its text to its result file, which is read and removed. */
#pragma once
#include <stdlib.h>
#include <unistd.h>

#include "cli/registry.h"
#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"
#include "tests/test.h"

/* The caller frees it. */
static struct result_file *run_text(const char *text) {
  char folder[] = "/tmp/plunge-run-XXXXXX", path[64];
  struct problems problems = {0};
  struct case_file *c = NULL;
  struct result *out = NULL;
  struct result_file *f = NULL;
  EXPECT_OK(case_parse("run.yaml", text, &registry, &problems, &c));
  for (size_t i = 0; i < problems.n; i++) fprintf(stderr, "%s\n", problems.text[i]);
  problems_destroy(&problems);
  if (!c || !mkdtemp(folder)) exit(1);
  struct progress *progress = progress_create(PROGRESS_QUIET);
  snprintf(path, sizeof path, "%s/run.h5", folder);
  EXPECT_OK(result_create(path, c, &c->runs[0], &out));
  EXPECT_OK(c->runs[0].solver->run(c, &c->runs[0], out, progress));
  EXPECT_OK(result_finish(out));
  result_destroy(out);
  progress_destroy(progress);
  case_destroy(c);
  EXPECT_OK(result_read(path, &f));
  unlink(path);
  snprintf(path, sizeof path, "%s/run.xdmf", folder);
  unlink(path);
  EXPECT(rmdir(folder) == 0);
  if (!f) exit(1);
  return f;
}
