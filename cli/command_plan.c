/* plunge plan: the runs of a case as a Makefile, a job array or a table. */
#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/plan.h"
#include "compare/output.h"

struct plan_arguments {
  const char *case_path, *engine, *out, *results;
  char *only;
  struct command_set set;
  int threads;
};

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct plan_arguments *a = state->input;
  switch (key) {
  case 'f':
    a->engine = arg;
    return 0;
  case 'o':
    a->out = arg;
    return 0;
  case 'd':
    a->results = arg;
    return 0;
  case 'r':
    a->only = arg;
    return 0;
  case 's':
    return command_set_add(&a->set, arg, state);
  case 't':
    a->threads = command_parse_count("threads", arg, state);
    return 0;
  case ARGP_KEY_ARG:
    if (a->case_path) argp_error(state, "one case file at a time; %s is the second", arg);
    a->case_path = arg;
    return 0;
  case ARGP_KEY_END:
    if (!a->case_path) argp_error(state, "name a case file");
    if (!a->engine) argp_error(state, "say what the plan is for: --for make, slurm or tsv");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

static enum status find_engine(const char *name, enum plan_engine *engine) {
  for (int k = 0; k < PLAN_N_ENGINES; k++)
    if (!strcmp(name, plan_engines[k])) {
      *engine = (enum plan_engine)k;
      return OK;
    }
  const char *near = param_nearest(name, PLAN_N_ENGINES, plan_engines);
  return status_raise(ERR_USAGE, "--for: found '%s'; allowed: one of make, slurm, tsv%s%s%s", name,
                      near ? "; did you mean '" : "", near ? near : "", near ? "'?" : "");
}

/* `path` from the root, which need not exist. */
static enum status make_absolute(const char *what, const char *path, char out[PATH_MAX]) {
  char here[PATH_MAX] = "";
  CHECK(*path, ERR_USAGE, "%s: found ''; allowed: a folder", what);
  if (*path != '/')
    CHECK(getcwd(here, sizeof here), ERR_IO, "cannot tell the current folder: %s", strerror(errno));
  const int n = snprintf(out, PATH_MAX, "%s%s%s", here, *here ? "/" : "", path);
  CHECK(n > 0 && n < PATH_MAX, ERR_USAGE,
        "%s: found a path of more than %d bytes; allowed: a shorter one", what, PATH_MAX - 1);
  return OK;
}

static enum status find_program(char out[PATH_MAX]) {
  const ssize_t n = readlink("/proc/self/exe", out, PATH_MAX - 1);
  CHECK(n > 0, ERR_IO, "cannot tell where this program is: %s", strerror(errno));
  out[n] = 0;
  return OK;
}

/* Into a file that appears whole, or to standard output. */
static enum status put(const struct plan *p, enum plan_engine engine, const char *path) {
  struct cmp_output out = {0};
  if (!path) {
    plan_write(p, engine, stdout);
    return OK;
  }
  enum status status = OK;
  ATTEMPT(cmp_output_open(path, &out));
  plan_write(p, engine, out.stream);
  status = cmp_output_commit(&out);
done:
  cmp_output_abandon(&out);
  return status;
}

static enum status check_out(const struct plan_arguments *a) {
  struct stat in, out;
  CHECK(!a->out || stat(a->out, &out) || stat(a->case_path, &in) || in.st_dev != out.st_dev ||
            in.st_ino != out.st_ino,
        ERR_USAGE, "--out: found the case itself; allowed: another file, which the plan replaces");
  return OK;
}

static enum status plan_case(const struct plan_arguments *a, const struct case_file *c) {
  char program[PATH_MAX], case_path[PATH_MAX], folder[PATH_MAX], results[PATH_MAX];
  enum plan_engine engine = PLAN_make;
  bool *chosen = NULL;
  enum status status;
  ATTEMPT(find_engine(a->engine, &engine));
  chosen = calloc(c->n_runs, sizeof *chosen);
  ATTEMPT(chosen ? OK : status_raise(ERR_MEMORY, "no memory for %zu runs", c->n_runs));
  ATTEMPT(command_choose_runs(c, a->only, chosen));
  command_name_folder(NULL, c, results);
  ATTEMPT(find_program(program));
  ATTEMPT(make_absolute("the case", a->case_path, case_path));
  ATTEMPT(make_absolute("--results", a->results ? a->results : results, folder));
  const struct plan plan = {.program = program,
                            .case_path = case_path,
                            .folder = folder,
                            .c = c,
                            .chosen = chosen,
                            .n_set = a->set.n,
                            .set = a->set.item,
                            .threads = a->threads};
  ATTEMPT(plan_check(&plan));
  ATTEMPT(check_out(a));
  status = put(&plan, engine, a->out);
done:
  free(chosen);
  return status;
}

int command_plan(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"for", 'f', "ENGINE", 0, "make, slurm or tsv", 0},
      {"out", 'o', "FILE", 0, "where the plan goes (default: standard output)", 0},
      {"results", 'd', "DIR", 0, "folder of results and report (default: out/ and the case's name)",
       0},
      {"only", 'r', "RUN[,RUN]", 0, "only these runs of the case", 0},
      {"set", 's', "PATH=VALUE", 0, "override a value, as in runs.NAME.alpha=0 or time.end=1.2", 0},
      {"threads", 't', "N", 0, "threads of each run (default: 1)", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "CASE.yaml",
      .doc = "Writes the runs of a case as a Makefile, a Slurm job array or a table, for engines "
             "that do them side by side on one machine or many; their results come together in "
             "one folder, which the last step compares. Paths are absolute, and every machine must "
             "see the same ones.",
  };
  struct plan_arguments a = {.threads = 1};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  int exit_code = EXIT_FINE;
  struct case_file *c = NULL;
  if (!strcmp(a.case_path, "-"))
    exit_code = command_fail(status_raise(
        ERR_USAGE, "found '-'; allowed: a case in a file, which each run reads again; save it"));
  else
    c = command_load_case(a.case_path, a.set.n, a.set.item, &exit_code);
  if (c) {
    const enum status status = plan_case(&a, c);
    exit_code = status == OK ? EXIT_FINE : command_fail(status);
  }
  case_destroy(c);
  free(a.set.item);
  return exit_code;
}
