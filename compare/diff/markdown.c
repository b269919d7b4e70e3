#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/text.h"
#include "compare/diff/write.h"

enum { MOST_RUNS = 20, MOST_QUANTITIES = 8 }; /* a comment on GitHub holds 64 kB */
enum { LONGEST = 200 };                       /* bytes of a text from a file */

/* A text from a file as code, where nothing in it means anything: between more backticks than any
 * that it has. In a table a bar would end the cell all the same, and is written \|. */
static void code(FILE *out, const char *text, bool in_table) {
  char *shown = text_visible(text, "");
  size_t run = 0, longest = 0;
  if (!shown) return;
  if (strlen(shown) > LONGEST) {
    size_t n = LONGEST;
    while (n && (shown[n] & 0xc0) == 0x80) n--;
    shown[n] = 0;
  }
  for (const char *c = shown; *c; c++) {
    run = *c == '`' ? run + 1 : 0;
    if (run > longest) longest = run;
  }
  const size_t n = strlen(shown);
  const bool pad = !n || *shown == '`' || shown[n - 1] == '`' || *shown == ' ';
  for (size_t k = 0; k <= longest; k++) fputc('`', out);
  if (pad) fputc(' ', out);
  for (const char *c = shown; *c; c++) {
    if (*c == '|' && in_table) fputc('\\', out);
    fputc(*c, out);
  }
  if (pad) fputc(' ', out);
  for (size_t k = 0; k <= longest; k++) fputc('`', out);
  free(shown);
}

static void time_cell(FILE *out, double t, double scale) {
  if (isfinite(t))
    fprintf(out, " %.6g s (t* = %.4g) |", t, t / scale);
  else
    fputs(" - |", out);
}

static void number_cell(FILE *out, double value) {
  if (isfinite(value))
    fprintf(out, " %.3g |", value);
  else
    fputs(" - |", out);
}

static void summary_row(const struct cmp_diff_run *run, FILE *out) {
  fputs("| ", out);
  code(out, run->name, true);
  fprintf(out, " | %s |", cmp_diff_word(run->outcome));
  const struct result_quantity *first = run->d ? result_diff_first(run->d) : NULL;
  if (run->d)
    fprintf(out, " %zu of %zu |", run->d->n_differ, run->d->n_differ + run->d->n_same);
  else
    fputs(" - |", out);
  time_cell(out, first ? result_quantity_since(first) : NAN, run->d ? run->d->time_scale : 1);
  fputc(' ', out);
  if (first) code(out, first->name, true);
  if (run->trouble) code(out, run->trouble, true);
  fputs(" |\n", out);
}

static enum status details(const struct cmp_diff_run *run, FILE *out) {
  const struct result_quantity **q;
  size_t n;
  TRY(cmp_diff_order(run, &n, &q));
  fputs("\n### ", out);
  code(out, run->name, false);
  fputs("\n\n| quantity | since | A | B | difference | relative |\n|---|---|---|---|---|---|\n",
        out);
  for (size_t i = 0; i < n && i < MOST_QUANTITIES; i++) {
    fputs("| ", out);
    code(out, q[i]->name, true);
    fputs(" |", out);
    time_cell(out, result_quantity_since(q[i]), run->d->time_scale);
    if (q[i]->beyond) {
      fprintf(out, " %.10g | %.10g |", q[i]->worst.value[0], q[i]->worst.value[1]);
      number_cell(out, q[i]->worst.difference);
      number_cell(out, cmp_diff_relative(q[i]));
    } else {
      fputc(' ', out);
      if (q[i]->what) code(out, q[i]->what, true);
      fputs(" | | | |", out);
    }
    fputc('\n', out);
  }
  if (n > MOST_QUANTITIES) fprintf(out, "\nand %zu more\n", n - MOST_QUANTITIES);
  free(q);
  return OK;
}

enum status cmp_diff_markdown(const struct cmp_diff *d, FILE *out) {
  char *sentence = cmp_diff_sentence(d);
  size_t shown = 0;
  CHECK(sentence, ERR_MEMORY, "no memory for a summary");
  fprintf(out, "## plunge diff: %s\n\n", cmp_diff_word(cmp_diff_outcome(d)));
  fputs("A: ", out);
  code(out, d->path[0], false);
  fputs(", B: ", out);
  code(out, d->path[1], false);
  if (d->folders) fprintf(out, ". %s.", sentence);
  fputs("\n\n| run | outcome | differ | first at | first |\n|---|---|---|---|---|\n", out);
  free(sentence);
  for (int same = 0; same < 2; same++) /* what differs comes first */
    for (size_t i = 0; i < d->n; i++) {
      if ((d->run[i].outcome == CMP_DIFF_SAME) != same || shown == 5 * MOST_RUNS) continue;
      summary_row(&d->run[i], out);
      shown++;
    }
  if (shown < d->n) fprintf(out, "\nand %zu more\n", d->n - shown);
  shown = 0;
  for (size_t i = 0; i < d->n && shown < MOST_RUNS; i++) {
    if (d->run[i].outcome != CMP_DIFF_DIFFERS) continue;
    TRY(details(&d->run[i], out));
    shown++;
  }
  return OK;
}
