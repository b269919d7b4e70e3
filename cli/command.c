#include "cli/command.h"

#include <argp.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/registry.h"
#include "cli/room.h"
#include "common/base/array.h"
#include "common/base/text.h"
#include "compare/output.h"

static void print_line(const char *text) {
  fputs("plunge: ", stderr);
  text_show(stderr, text, "");
  fputc('\n', stderr);
}

void command_warn(const char *format, ...) {
  char text[2 * PATH_MAX];
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  print_line(text);
}

int command_fail(enum status status) {
  print_line(status_message());
  return status_exit_code(status);
}

enum status command_find_surfaces(size_t n, struct result_file *const *files,
                                  struct progress *progress) {
  TRY(result_find_all_surfaces(n, files));
  for (size_t i = 0; i < n; i++)
    if (files[i]->surfaces_found)
      progress_say(progress, "the surface of %s is found from its particles", files[i]->run);
  return OK;
}

int command_finish(int exit_code) {
  struct stat out;
  if (!fflush(stdout) && !ferror(stdout)) return exit_code;
  if (!fstat(STDOUT_FILENO, &out) && S_ISFIFO(out.st_mode))
    return exit_code; /* a reader that has had enough, as in `plunge list | head` */
  fputs("plunge: cannot write the output; is the disk full?\n", stderr);
  return exit_code == EXIT_BAD_INPUT ? exit_code : EXIT_RUN_FAILED;
}

void command_list_problems(const struct problems *problems) {
  for (size_t i = 0; i < problems->n; i++) {
    text_show(stderr, problems->text[i], "");
    fputc('\n', stderr);
  }
}

int command_set_add(struct command_set *set, const char *assignment, struct argp_state *state) {
  if (!strchr(assignment, '='))
    argp_error(state, "--set %s: write PATH=VALUE, as in runs.NAME.alpha=0", assignment);
  if (array_resize(&set->item, set->n + 1, "words of --set") != OK) return ENOMEM;
  set->item[set->n++] = assignment;
  return 0;
}

int command_parse_count(const char *option, const char *arg, struct argp_state *state) {
  char *end;
  long n = strtol(arg, &end, 10);
  if (end == arg || *end || n < 1 || n > 1024)
    argp_error(state, "--%s %s: give a whole number from 1 to 1024", option, arg);
  return (int)n;
}

static enum status complain_unknown_run(const struct case_file *c, const char *name) {
  char names[512] = "";
  for (size_t i = 0; i < c->n_runs; i++) {
    size_t at = strlen(names);
    snprintf(names + at, sizeof names - at, "%s%s", i ? ", " : "", c->runs[i].name);
  }
  return status_raise(ERR_USAGE, "--only %s: %s has no run of that name; its runs are %s", name,
                      c->path, names);
}

enum status command_choose_runs(const struct case_file *c, char *only, bool *chosen) {
  for (size_t i = 0; i < c->n_runs; i++) chosen[i] = !only;
  if (!only) return OK;
  for (char *rest = only, *name; (name = strsep(&rest, ","));) {
    size_t i = 0;
    while (i < c->n_runs && strcmp(c->runs[i].name, name)) i++;
    if (i == c->n_runs) return complain_unknown_run(c, name);
    chosen[i] = true;
  }
  return OK;
}

void command_name_folder(const char *out, const struct case_file *c, char *folder) {
  const char *slash = strrchr(c->path, '/'), *name = slash ? slash + 1 : c->path;
  const char *dot = strrchr(name, '.');
  if (out)
    snprintf(folder, PATH_MAX, "%s", out);
  else
    snprintf(folder, PATH_MAX, "out/%.*s", dot > name ? (int)(dot - name) : (int)strlen(name),
             name);
}

struct case_file *command_load_case(const char *path, size_t n_set, const char *const *set,
                                    int *exit_code) {
  struct problems problems = {0};
  struct case_file *c = NULL;
  enum status status = case_load(path, n_set, set, &registry, &problems, &c);
  command_list_problems(&problems);
  *exit_code = status_exit_code(status);
  if (status != OK && (!problems.n || status != ERR_INPUT)) command_fail(status);
  problems_destroy(&problems);
  return c;
}

int command_check_room(const struct case_file *c, const bool *chosen, size_t n_set,
                       const char *const *set) {
  struct problems problems = {0};
  for (size_t i = 0; i < c->n_runs; i++) {
    struct solver_estimate e = {0};
    if (chosen && !chosen[i]) continue;
    c->runs[i].solver->estimate(c, &c->runs[i], &e);
    room_check(&c->runs[i], &e, &problems);
  }
  problems_finish(&problems, c->path, n_set, set);
  command_list_problems(&problems);
  int exit_code = problems.n ? EXIT_BAD_INPUT : EXIT_FINE;
  problems_destroy(&problems);
  return exit_code;
}

/* The process that holds a lock on file `inode`, as the kernel lists it: "1: FLOCK ADVISORY WRITE
 * PID MAJOR:MINOR:INODE 0 EOF"; 0 when it cannot be told. */
static long lock_holder(unsigned long long inode) {
  FILE *locks = fopen("/proc/locks", "r");
  char line[256];
  long found = 0;
  while (locks && !found && fgets(line, sizeof line, locks)) {
    long pid;
    unsigned long long locked;
    if (sscanf(line, "%*d: FLOCK %*s %*s %ld %*[^:]:%*[^:]:%llu", &pid, &locked) == 2 &&
        locked == inode && pid > 0)
      found = pid;
  }
  if (locks) fclose(locks);
  return found;
}

enum status command_lock_folder(const char *folder, enum command_lock how, bool wait,
                                struct progress *progress, int *fd) {
  const int lock = how == COMMAND_SHARED ? LOCK_SH : LOCK_EX;
  TRY(cmp_directory_make(folder));
  *fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  CHECK(*fd >= 0, ERR_IO, "cannot read the folder %s: %s", folder, strerror(errno));
  if (!flock(*fd, lock | LOCK_NB) || errno != EWOULDBLOCK)
    return OK; /* some file systems cannot lock: the result files have locks of their own */
  struct stat info;
  char who[64] = "";
  long pid = fstat(*fd, &info) ? 0 : lock_holder(info.st_ino);
  if (pid) snprintf(who, sizeof who, " (process %ld)", pid);
  CHECK(wait, ERR_IO,
        "another plunge%s is at work in %s: wait for it (--wait), or choose another --out", who,
        folder);
  progress_say(progress, "waiting for another plunge%s at work in %s", who, folder);
  while (flock(*fd, lock) && errno == EINTR) continue;
  return OK;
}
