#include "cli/plan.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

#include "common/base/text.h"
#include "common/case/case.h"

const char *const plan_engines[PLAN_N_ENGINES] = {
#define X(name, help) #name,
    PLAN_ENGINES(X)
#undef X
};

/* ---- words ---- */

void plan_word(FILE *out, const char *text, bool make) {
  static const char plain[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-./=:,+@";
  const bool quoted = !*text || text[strspn(text, plain)];
  if (quoted) fputc('\'', out);
  for (const char *c = text; *c; c++) {
    if (*c == '\'')
      fputs("'\\''", out);
    else if (*c == '$' && make)
      fputs("$$", out);
    else
      fputc(*c, out);
  }
  if (quoted) fputc('\'', out);
}

static enum status check_word(const char *what, const char *text) {
  for (const char *c = text; *c; c++)
    CHECK(!iscntrl((unsigned char)*c), ERR_USAGE,
          "%s: found a control character in %s; allowed: any others, since a plan has a line for "
          "each run; rename it",
          what, text);
  return OK;
}

enum status plan_check(const struct plan *p) {
  TRY(check_word("the program", p->program));
  TRY(check_word("--results", p->folder));
  for (size_t i = 0; i < p->n_runs; i++) {
    TRY(check_word("the case", p->run[i].case_path));
    TRY(check_word("--results", p->run[i].folder));
    for (size_t k = 0; k < p->run[i].n_set; k++) TRY(check_word("--set", p->run[i].set[k]));
  }
  return OK;
}

/* ---- commands ---- */

static void run_command(FILE *out, const struct plan *p, const struct plan_run *r, bool make) {
  char only[CASE_LONGEST_NAME + 16], threads[16];
  snprintf(only, sizeof only, "--only=%s", r->only);
  snprintf(threads, sizeof threads, "%d", p->threads);
  plan_word(out, p->program, make);
  fputs(" run ", out);
  plan_word(out, r->case_path, make);
  fputc(' ', out);
  plan_word(out, only, make);
  fputs(" --no-report --quiet --threads ", out);
  plan_word(out, threads, make);
  fputs(" --out ", out);
  plan_word(out, r->folder, make);
  for (size_t i = 0; i < r->n_set; i++) {
    fputs(" --set ", out);
    plan_word(out, r->set[i], make);
  }
}

/* In the folder of results: a line with the paths of a thousand files would be longer than one may
 * be. */
static void last_command(FILE *out, const struct plan *p, bool make) {
  fputs("cd ", out);
  plan_word(out, p->folder, make);
  fputs(" && ", out);
  plan_word(out, p->program, make);
  for (size_t i = 0; i < p->n_words; i++) {
    fputc(' ', out);
    plan_word(out, p->word[i], make);
  }
}

/* ---- engines ---- */

struct needs {
  double seconds, bytes; /* of the longest, of the largest */
};

static struct needs needs_of(const struct plan *p) {
  struct needs n = {0};
  for (size_t i = 0; i < p->n_runs; i++) {
    n.seconds = fmax(n.seconds, solver_seconds(&p->run[i].estimate, p->threads));
    n.bytes = fmax(n.bytes, p->run[i].estimate.bytes);
  }
  return n;
}

/* Estimates of memory are right within a third or so. */
static double megabytes(double bytes) {
  return ceil(1.5 * bytes / 1e6);
}

static void comment(FILE *out, const char *lead, const char *text) {
  fprintf(out, "# %s", lead);
  text_show(out, text, "");
  fputc('\n', out);
}

static void write_make(const struct plan *p, FILE *out) {
  comment(out, "Runs of ", p->of);
  fprintf(
      out,
      "# make -j N -f THIS FILE: what is missing or changed, so many at a time, then the report.\n"
      "# After a run that failed: make -k, then make %s.\n"
      "SHELL = /bin/sh\n.PHONY: all %s",
      p->last, p->last);
  for (size_t i = 0; i < p->n_runs; i++) fprintf(out, " run-%s", p->run[i].name);
  fputs("\n\nall:", out);
  for (size_t i = 0; i < p->n_runs; i++) fprintf(out, " run-%s", p->run[i].name);
  fputc('\n', out);
  if (p->n_words) {
    fputc('\t', out);
    last_command(out, p, true);
    fprintf(out, "\n\n%s:\n\t", p->last);
    last_command(out, p, true);
    fputc('\n', out);
  } else
    fprintf(out, "\n%s:\n\t@echo nothing to %s\n", p->last, p->last);
  for (size_t i = 0; i < p->n_runs; i++) {
    fprintf(out, "\nrun-%s:\n\t%s", p->run[i].name, p->go_on ? "-" : "");
    run_command(out, p, &p->run[i], true);
    fputc('\n', out);
  }
}

static void write_slurm(const struct plan *p, FILE *out) {
  const struct needs needs = needs_of(p);
  fputs("#!/bin/bash\n#SBATCH --job-name=plunge\n", out);
  fprintf(out, "#SBATCH --array=0-%zu\n#SBATCH --ntasks=1\n#SBATCH --cpus-per-task=%d\n",
          p->n_runs - 1, p->threads);
  fprintf(out, "#SBATCH --mem=%.0fM\n", megabytes(needs.bytes));
  comment(out, "Runs of ", p->of);
  fprintf(out, "# The longest takes roughly %.0f s: add --time where the cluster wants one.\n",
          ceil(needs.seconds));
  fputs("# sbatch THIS FILE: the runs alone. bash THIS FILE: the runs, and the last step when all "
        "have ended.\n"
        "if [ -z \"${SLURM_ARRAY_TASK_ID:-}\" ]; then\n"
        "  job=$(sbatch --parsable \"$0\") || exit\n"
        "  echo \"runs: job ${job%%;*}\"\n",
        out);
  if (p->n_words) {
    fprintf(out,
            "  sbatch --job-name=plunge-%s --cpus-per-task=%d --mem=%.0fM "
            "--dependency=afterany:\"${job%%%%;*}\" <<'PLUNGE'\n#!/bin/bash\n",
            p->last, p->threads, fmax(1024, megabytes(needs.bytes)));
    last_command(out, p, false);
    fputs("\nPLUNGE\n", out);
  }
  fputs("  exit\nfi\ncase $SLURM_ARRAY_TASK_ID in\n", out);
  for (size_t i = 0; i < p->n_runs; i++) {
    fprintf(out, "%zu) exec ", i);
    run_command(out, p, &p->run[i], false);
    fputs(" ;;\n", out);
  }
  fputs("esac\n", out);
}

static void write_tsv(const struct plan *p, FILE *out) {
  fputs("step\trun\tseconds\tMB\tcommand\n", out);
  for (size_t i = 0; i < p->n_runs; i++) {
    const struct plan_run *r = &p->run[i];
    fprintf(out, "run\t%s\t%.3g\t%.0f\t", r->name, solver_seconds(&r->estimate, p->threads),
            megabytes(r->estimate.bytes));
    run_command(out, p, r, false);
    fputc('\n', out);
  }
  if (!p->n_words) return;
  fprintf(out, "%s\t\t\t\t", p->last);
  last_command(out, p, false);
  fputc('\n', out);
}

void plan_write(const struct plan *p, enum plan_engine engine, FILE *out) {
  switch (engine) {
  case PLAN_make:
    write_make(p, out);
    return;
  case PLAN_slurm:
    write_slurm(p, out);
    return;
  case PLAN_tsv:
    write_tsv(p, out);
    return;
  case PLAN_N_ENGINES:
    return;
  }
}
