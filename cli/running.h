/* One run of a case: at work, and the file that it leaves. */
#pragma once
#include <limits.h>

#include "common/base/progress.h"
#include "common/case/case.h"
#include "common/result/result.h"

struct running {
  const struct case_file *c;
  const char *folder; /* of its file */
  struct progress *progress;
};

/* FOLDER/RUN.h5. ERR_USAGE when that is too long. */
enum status running_path(const char *folder, const struct case_run *r, char path[PATH_MAX]);

/* Makes the run, which is called `name` in what is said of it: the work of a process of its own.
 * Returns its exit code. */
int running_job(const struct running *g, const struct case_run *r, const char *name);

/* The exit code of a run whose file is there already: a finished one that failed is a failure then,
 * too. */
int running_judge(const struct result_file *f);
int running_judge_file(const char *path);
