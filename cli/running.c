#include "cli/running.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>

#include "cli/command.h"
#include "cli/traps.h"
#include "common/result/health.h"

enum status running_path(const char *folder, const struct case_run *r, char path[PATH_MAX]) {
  int n = snprintf(path, PATH_MAX, "%s/%s.h5", folder, r->name);
  CHECK(n > 0 && n < PATH_MAX, ERR_USAGE, "--out %s: the path is too long", folder);
  return OK;
}

/* Keeps in the file how it ended, the message of a failure included, and whether it can be
 * believed. A file that cannot take it keeps what was flushed. */
static enum status end_result(struct result *out, enum status status, struct health *health) {
  char why[1024];
  snprintf(why, sizeof why, "%s", status_message());
  if (status == OK) {
    TRY(result_health(out, "", health));
    return result_finish(out);
  }
  (void)result_ended(out, why);
  (void)result_health(out, status == INTERRUPTED ? "" : why, health);
  return status_raise(status, "%s", why);
}

/* One line below a run's own: that it is sound, or why not. A run that ended well and still failed
 * is a failure. */
static enum status tell_health(const char *name, const struct health *h,
                               struct progress *progress) {
  if (h->verdict == HEALTH_SOUND)
    progress_say(progress, "%-10s sound: %s", name, *h->facts ? h->facts : "nothing to judge by");
  if (h->verdict == HEALTH_DOUBTFUL) command_warn("run %s is doubtful: %s", name, h->reasons);
  CHECK(h->verdict != HEALTH_FAILED, ERR_DIVERGED, "its result is not to be believed: %s",
        h->reasons);
  return OK;
}

static enum status run_one(const struct running *g, const struct case_run *r, const char *name) {
  struct result *out = NULL;
  struct health health = {0};
  char path[PATH_MAX];
  enum status status;
  progress_begin(g->progress, name, g->c->end, sqrt(g->c->H / g->c->g));
  ATTEMPT(running_path(g->folder, r, path));
  ATTEMPT(result_create(path, g->c, r, &out));
  traps_enable();
  status = r->solver->run(g->c, r, out, g->progress);
  traps_disable();
  status = end_result(out, status, &health);
done:
  result_destroy(out);
  if (status == OK) {
    progress_end(g->progress, "done");
    status = tell_health(name, &health, g->progress);
  } else if (status == INTERRUPTED)
    progress_end(g->progress, "stopped; its file holds every output so far");
  else
    progress_end(g->progress, "FAILED");
  return status;
}

int running_job(const struct running *g, const struct case_run *r, const char *name) {
  enum status status = run_one(g, r, name);
  if (status == OK || status == INTERRUPTED) return status_exit_code(status);
  return command_fail(status_context(status, "run %s: ", name));
}

int running_judge(const struct result_file *f) {
  struct health h;
  health_of_file(f, &h);
  return f->complete && h.verdict == HEALTH_FAILED ? EXIT_RUN_FAILED : EXIT_FINE;
}

int running_judge_file(const char *path) {
  struct result_file *file = NULL;
  const enum status status = result_read(path, &file);
  const int exit_code = status == OK ? running_judge(file) : command_fail(status);
  result_file_destroy(file);
  return exit_code;
}
