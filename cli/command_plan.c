/* plunge plan: the runs of a case, or of the gallery, as a Makefile, a job array or a table. */
#include <argp.h>
#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/gallery_runs.h"
#include "cli/plan.h"
#include "common/base/array.h"
#include "compare/output.h"
#include "gallery/choice.h"

struct plan_arguments {
  const char *case_path, *engine, *out, *results;
  char *only;
  struct command_set set;
  int threads;
  bool gallery, quick;
  const char **entries; /* of the gallery, [n_entries]; owned; the strings are argv's */
  size_t n_entries;
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
  case 'k':
    a->quick = true;
    return 0;
  case ARGP_KEY_ARG:
    if (a->gallery) {
      if (array_resize(&a->entries, a->n_entries + 1, "entries") != OK) return ENOMEM;
      a->entries[a->n_entries++] = arg;
      return 0;
    }
    if (a->case_path) argp_error(state, "one case file at a time; %s is the second", arg);
    a->case_path = arg;
    a->gallery = !strcmp(arg, "gallery");
    return 0;
  case ARGP_KEY_END:
    if (!a->case_path) argp_error(state, "name a case file");
    if (!a->engine) argp_error(state, "say what the plan is for: --for make, slurm or tsv");
    if (a->quick && !a->gallery) argp_error(state, "--quick is for plunge plan gallery");
    if (a->gallery && a->only) argp_error(state, "of the gallery, name entries in place of --only");
    if (a->gallery && a->set.n)
      argp_error(state, "--set is for cases; the gallery's overrides are its entries'");
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

/* The words of the command that compares what was run, in the folder of results; none where there
 * is nothing to compare. They and what they name are the caller's to free. */
struct comparison {
  size_t n;
  const char **word;
  char (*file)[CASE_LONGEST_NAME + 8];
};

static enum status compare_chosen(const struct case_file *c, const bool *chosen,
                                  struct comparison *words) {
  const size_t ref = c->compare.reference;
  bool any = false;
  for (size_t i = 0; i < c->n_runs; i++) any |= chosen[i] && i != ref;
  if (!any || ref >= c->n_runs) return OK;
  TRY(array_create(&words->file, c->n_runs, "names of files"));
  TRY(array_create(&words->word, c->n_runs + 4, "words"));
  static const char *const begin[] = {"compare", "--out", ".", "--"};
  for (size_t i = 0; i < c->n_runs; i++)
    snprintf(words->file[i], sizeof words->file[i], "%s.h5", c->runs[i].name);
  while (words->n < sizeof begin / sizeof *begin)
    words->word[words->n] = begin[words->n], words->n++;
  words->word[words->n++] = words->file[ref];
  for (size_t i = 0; i < c->n_runs; i++)
    if (chosen[i] && i != ref) words->word[words->n++] = words->file[i];
  return OK;
}

/* The runs of a case that are chosen, and what compares them. */
static enum status plan_case(const struct plan_arguments *a, const struct case_file *c,
                             struct plan *plan, enum plan_engine engine) {
  char case_path[PATH_MAX], folder[PATH_MAX], results[PATH_MAX];
  struct comparison words = {0};
  struct plan_run *run = NULL;
  bool *chosen = NULL;
  enum status status;
  ATTEMPT(array_create(&chosen, c->n_runs, "runs"));
  ATTEMPT(array_create(&run, c->n_runs, "runs"));
  ATTEMPT(command_choose_runs(c, a->only, chosen));
  command_name_folder(NULL, c, results);
  ATTEMPT(make_absolute("the case", a->case_path, case_path));
  ATTEMPT(make_absolute("--results", a->results ? a->results : results, folder));
  ATTEMPT(compare_chosen(c, chosen, &words));
  plan->of = case_path;
  plan->run = run;
  plan->last = "compare";
  plan->folder = folder;
  plan->n_words = words.n;
  plan->word = words.word;
  for (size_t i = 0; i < c->n_runs; i++) {
    if (!chosen[i]) continue;
    struct plan_run *r = &run[plan->n_runs++];
    *r = (struct plan_run){.name = c->runs[i].name,
                           .case_path = case_path,
                           .only = c->runs[i].name,
                           .folder = folder,
                           .n_set = a->set.n,
                           .set = a->set.item};
    c->runs[i].solver->estimate(c, &c->runs[i], &r->estimate);
  }
  ATTEMPT(plan_check(plan));
  ATTEMPT(check_out(a));
  status = put(plan, engine, a->out);
done:
  free(words.word);
  free(words.file);
  free(run);
  free(chosen);
  return status;
}

static int plan_file(const struct plan_arguments *a, struct plan *plan, enum plan_engine engine) {
  int exit_code = EXIT_FINE;
  if (!strcmp(a->case_path, "-"))
    return command_fail(status_raise(
        ERR_USAGE, "found '-'; allowed: a case in a file, which each run reads again; save it"));
  struct case_file *c = command_load_case(a->case_path, a->set.n, a->set.item, &exit_code);
  if (c) {
    const enum status status = plan_case(a, c, plan, engine);
    exit_code = status == OK ? EXIT_FINE : command_fail(status);
  }
  case_destroy(c);
  return exit_code;
}

/* ---- the gallery ---- */

static enum status list_runs(const struct gallery_runs *runs, struct plan *plan,
                             struct plan_run *run) {
  for (size_t k = 0; k < runs->n; k++) {
    const struct gallery_run *r = &runs->run[k];
    const struct gallery_runs_case *c = &runs->cases[r->of];
    CHECK(r->r, ERR_INPUT, "%s", r->why);
    run[plan->n_runs++] = (struct plan_run){.name = r->name,
                                            .case_path = c->path,
                                            .only = r->r->name,
                                            .folder = c->folder,
                                            .n_set = c->n_set,
                                            .set = c->set,
                                            .estimate = gallery_runs_estimate(runs, k)};
  }
  return OK;
}

/* What makes the entries of their runs, in the folder of the gallery. */
static enum status make_entries(const struct plan_arguments *a, size_t *n, const char ***words) {
  TRY(array_create(words, a->n_entries + 5, "words"));
  const char **word = *words;
  word[(*n)++] = "gallery";
  word[(*n)++] = "--out";
  word[(*n)++] = ".";
  if (a->quick) word[(*n)++] = "--quick";
  for (size_t i = 0; i < a->n_entries; i++) word[(*n)++] = a->entries[i];
  return OK;
}

static enum status plan_book(const struct plan_arguments *a, const struct gallery_book *book,
                             struct plan *plan, enum plan_engine engine) {
  const char *usual = a->quick ? GALLERY_QUICK_FOLDER : GALLERY_FOLDER;
  char folder[PATH_MAX];
  struct gallery_runs runs = {0};
  struct plan_run *run = NULL;
  const char **words = NULL;
  bool *chosen = NULL, left = false;
  enum status status;
  ATTEMPT(array_create(&chosen, book->n_entries, "entries"));
  ATTEMPT(gallery_choose(book, a->n_entries, a->entries, chosen));
  ATTEMPT(make_absolute("--results", a->results ? a->results : usual, folder));
  for (size_t i = 0; i < book->n_entries; i++) {
    left |= chosen[i] && a->quick && !book->entries[i].quick;
    chosen[i] &= !a->quick || book->entries[i].quick;
  }
  ATTEMPT(gallery_runs_gather(book, chosen, folder, a->quick, &runs));
  if (!runs.n)
    ATTEMPT(status_raise(ERR_USAGE, "these entries need no runs%s; allowed: entries that have some, "
                                    "as `plunge gallery` makes the others at once",
                         left ? ", or are left out by --quick" : ""));
  ATTEMPT(array_create(&run, runs.n, "runs"));
  ATTEMPT(list_runs(&runs, plan, run));
  ATTEMPT(make_entries(a, &plan->n_words, &words));
  plan->of = "the gallery";
  plan->run = run;
  plan->last = "gallery";
  plan->folder = folder;
  plan->word = words;
  plan->go_on = true;
  ATTEMPT(plan_check(plan));
  status = put(plan, engine, a->out);
done:
  gallery_runs_free(&runs);
  free(words);
  free(run);
  free(chosen);
  return status;
}

static int plan_gallery(const struct plan_arguments *a, struct plan *plan,
                        enum plan_engine engine) {
  int exit_code = EXIT_FINE;
  struct gallery_book *book = gallery_runs_book(&exit_code);
  if (book) {
    const enum status status = plan_book(a, book, plan, engine);
    exit_code = status == OK ? EXIT_FINE : command_fail(status);
  }
  gallery_book_destroy(book);
  return exit_code;
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
      {"quick", 'k', NULL, 0, "of the gallery, what takes minutes in all", 0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "CASE.yaml\ngallery [ID...]",
      .doc = "Writes the runs of a case, or those that the gallery needs, as a Makefile, a Slurm "
             "job array or a table, for engines "
             "that do them side by side on one machine or many; their results come together in "
             "one folder, which the last step compares. Paths are absolute, and every machine must "
             "see the same ones.",
  };
  struct plan_arguments a = {.threads = 1};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  char program[PATH_MAX];
  enum plan_engine engine = PLAN_make;
  struct plan plan = {.program = program, .threads = a.threads};
  enum status status = find_engine(a.engine, &engine);
  if (status == OK) status = find_program(program);
  const int exit_code = status != OK ? command_fail(status)
                        : a.gallery  ? plan_gallery(&a, &plan, engine)
                                     : plan_file(&a, &plan, engine);
  free(a.entries);
  free(a.set.item);
  return exit_code;
}
