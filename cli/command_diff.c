#include <argp.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/command.h"
#include "cli/settings.h"
#include "common/base/array.h"
#include "common/base/text.h"
#include "compare/diff/diff.h"
#include "compare/drawing.h"

struct diff_arguments {
  const char *file[2], *tolerances, *out;
  double rtol, atol;
  bool draft;
  int n;
};

static double parse_tolerance(struct argp_state *state, const char *name, const char *text) {
  char *end;
  double value = strtod(text, &end);
  if (end == text || *end || !(value >= 0) || isinf(value))
    argp_error(state, "--%s %s: give a number that is not negative", name, text);
  return value;
}

static error_t parse(int key, char *arg, struct argp_state *state) {
  struct diff_arguments *a = state->input;
  switch (key) {
  case 'r':
    a->rtol = parse_tolerance(state, "rtol", arg);
    return 0;
  case 'a':
    a->atol = parse_tolerance(state, "atol", arg);
    return 0;
  case 't':
    a->tolerances = arg;
    return 0;
  case 'd':
    a->draft = true;
    return 0;
  case 'o':
    if (!*arg) argp_error(state, "--out: the folder's name is empty");
    a->out = arg;
    return 0;
  case ARGP_KEY_ARG:
    if (a->n == 2) argp_error(state, "two files or folders are compared; %s is the third", arg);
    a->file[a->n++] = arg;
    return 0;
  case ARGP_KEY_END:
    if (a->n < 2) argp_error(state, "name two result files, or two folders of them");
    if (a->draft && a->out)
      argp_error(state, "--draft writes tolerances and --out a report: one at a time");
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

/* ---- what is printed ---- */

static void show(const struct cmp_diff *d, size_t k) {
  const struct cmp_diff_run *run = &d->run[k];
  char *text = NULL;
  size_t n;
  FILE *out = open_memstream(&text, &n);
  if (!out) return;
  if (run->trouble) command_warn("%s", run->trouble);
  if (!run->d && !run->trouble)
    fprintf(out, "%s: only in %s\n", run->name, d->path[run->outcome == CMP_DIFF_ONLY_B]);
  if (run->d && d->folders && run->d->n_differ) fprintf(out, "%s:\n", run->name);
  if (run->d && (!d->folders || run->d->n_differ)) result_diff_print(run->d, out);
  fclose(out);
  if (text) text_show(stdout, text, "\n");
  free(text);
}

static enum status draft(const struct cmp_diff *d, const struct result_tolerances *t) {
  struct result_diff **both;
  size_t n = 0;
  TRY(array_create(&both, d->n, "runs"));
  for (size_t k = 0; k < d->n; k++)
    if (d->run[k].d)
      both[n++] = d->run[k].d;
    else
      show(d, k);
  fputs("# worst differences between ", stdout);
  text_show(stdout, d->path[0], "");
  fputs(" and ", stdout);
  text_show(stdout, d->path[1], "");
  fputs(", and a tenth more\n", stdout);
  const enum status status = result_diff_draft(n, both, t, stdout);
  free(both);
  return status;
}

/* Rules of a file that are for nothing: a slip of the pen, or for another run. */
static void rules_warn(const struct cmp_diff *d, const struct result_tolerances *t,
                       const char *path) {
  bool any = false;
  for (size_t k = 0; k < d->n; k++) any = any || d->run[k].d;
  for (size_t i = 0; any && i < t->n; i++) {
    bool matched = !t->rule[i].line;
    for (size_t k = 0; k < d->n && !matched; k++) matched = d->run[k].d && d->run[k].d->matched[i];
    if (!matched)
      command_warn("%s:%d: %s is the rule of nothing in these results", path, t->rule[i].line,
                   t->rule[i].pattern);
  }
}

/* ---- the report ---- */

struct report {
  struct cmp_figures figures;
  struct progress *progress;
  int lock;
};

static enum status report_open(const char *out, struct report *r) {
  r->progress = progress_create(PROGRESS_AUTO);
  CHECK(r->progress, ERR_MEMORY, "no memory");
  TRY(command_lock_folder(out, COMMAND_ALONE, false, r->progress, &r->lock));
  return cmp_figures_open(out, &r->figures);
}

static void report_close(struct report *r) {
  cmp_figures_close(&r->figures);
  if (r->lock >= 0) close(r->lock);
  progress_destroy(r->progress);
}

static enum status picture(struct cmp_diff *d, size_t k, struct report *r) {
  int ignored;
  struct result_diff *both = d->run[k].d;
  struct case_file *settings =
      both && both->n_differ ? command_settings(NULL, 2, both->file, true, &ignored) : NULL;
  const enum status status = cmp_diff_picture(d, k, settings, &r->figures);
  case_destroy(settings);
  return status;
}

/* Pictures that cannot be drawn leave the report its numbers. */
static enum status report_write(const struct cmp_diff *d, const char *out, struct report *r) {
  progress_say(r->progress, "drawing %zu figures", r->figures.n);
  const enum status drawn = r->figures.n ? cmp_figures_draw(&r->figures, CMP_DRAWING_LIMITS) : OK;
  if (drawn == INTERRUPTED) return drawn;
  if (drawn != OK) command_warn("%s", status_message());
  TRY(cmp_diff_write(d, &r->figures, out));
  fputs("report: ", stdout);
  text_show(stdout, out, "");
  puts("/diff.html");
  return OK;
}

/* ---- all of it ---- */

static enum status compare(const struct diff_arguments *a, struct cmp_diff *d) {
  struct result_tolerances tolerances = {0};
  struct report report = {.figures = {.lock = -1}, .lock = -1};
  enum status status;
  ATTEMPT(result_tolerances_default(&tolerances, a->rtol, a->atol));
  if (a->tolerances) ATTEMPT(result_tolerances_read(&tolerances, a->tolerances));
  if (a->out) ATTEMPT(report_open(a->out, &report));
  for (size_t k = 0; k < d->n; k++) {
    ATTEMPT(cmp_diff_compare(d, k, &tolerances, a->out != NULL));
    if (!a->draft) show(d, k);
    if (a->out) ATTEMPT(picture(d, k, &report));
  }
  if (a->draft) ATTEMPT(draft(d, &tolerances));
  if (a->tolerances) rules_warn(d, &tolerances, a->tolerances);
  if (d->folders && !a->draft) {
    char *sentence = cmp_diff_sentence(d);
    printf("%s\n", sentence ? sentence : "");
    free(sentence);
  }
  if (a->out) ATTEMPT(report_write(d, a->out, &report));
done:
  report_close(&report);
  result_tolerances_destroy(&tolerances);
  return status;
}

int command_diff(int argc, char **argv) {
  static const struct argp_option options[] = {
      {"rtol", 'r', "R", 0, "relative to the largest magnitude in a dataset (default 0)", 0},
      {"atol", 'a', "A", 0, "absolute, in the dataset's units (default 0)", 0},
      {"tol", 't', "FILE", 0,
       "rules per dataset, one a line: PATTERN RELATIVE ABSOLUTE [t>T] [t<T]", 0},
      {"draft", 'd', NULL, 0, "print such rules, just wide enough for these results", 0},
      {"out", 'o', "DIR", 0,
       "also write a report there: diff.html, diff.json, diff.md (a summary in Markdown) and "
       "diff.xml (JUnit)",
       0},
      {0}};
  static const struct argp argp = {
      .options = options,
      .parser = parse,
      .args_doc = "A B",
      .doc = "Compares two result files dataset by dataset and locates the first and the worst "
             "differences; of two folders, each file with the one of the same name. Exit "
             "code: 0 the same within the tolerances, 1 different, 2 trouble.",
  };
  struct diff_arguments a = {0};
  argp_parse(&argp, argc, argv, 0, NULL, &a);
  struct cmp_diff *d = NULL;
  enum status status = cmp_diff_create(a.file[0], a.file[1], &d);
  if (status == OK) status = compare(&a, d);
  const enum cmp_diff_outcome outcome = d ? cmp_diff_outcome(d) : CMP_DIFF_TROUBLE;
  cmp_diff_destroy(d);
  if (status != OK) {
    const int code = command_fail(status);
    return status == INTERRUPTED ? code : EXIT_BAD_INPUT; /* trouble, of whatever kind */
  }
  return outcome == CMP_DIFF_SAME      ? EXIT_FINE
         : outcome == CMP_DIFF_TROUBLE ? EXIT_BAD_INPUT
                                       : EXIT_VERDICT;
}
