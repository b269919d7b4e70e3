#include "compare/convergence/table.h"

#include <stdint.h>
#include <unistd.h>

#include "compare/chart.h"
#include "compare/output.h"
#include "compare/text.h"

/* NaN leaves the field empty. */
static void number_write(FILE *out, double value) {
  fputc(',', out);
  if (isfinite(value)) fprintf(out, "%.17g", value);
}

static void text_write(FILE *out, const char *text) {
  fputc(',', out);
  cmp_csv_string(out, text);
}

/* What three runs say stands in the line of the finest of them. */
static const struct cmp_neighbours *triple_at(const struct cmp_row_of_group *row, size_t i) {
  for (size_t k = 0; k < row->n_triples; k++)
    if (row->triple[k].member[2] == i) return &row->triple[k];
  return NULL;
}

static void line_write(FILE *out, const struct comparison *c, const struct cmp_group *g,
                       const struct cmp_row_of_group *row, size_t i) {
  const struct cmp_neighbours *n = triple_at(row, i);
  const struct cmp_triple none = {.order = NAN, .limit = NAN, .gci = NAN, .bar = NAN};
  const struct cmp_triple *t = n ? &n->triple : &none;
  cmp_csv_string(out, g->name);
  text_write(out, row->name);
  text_write(out, row->of ? row->of : "");
  text_write(out, row->units);
  number_write(out, row->time == SIZE_MAX ? NAN : c->times[row->time]);
  text_write(out, cmp_run_or_ref(c, g->member[i])->data.label);
  number_write(out, g->spacing[i]);
  number_write(out, row->value[i].value);
  number_write(out, row->error[i]);
  number_write(out, i ? cmp_error_order(&g->spacing[i - 1], &row->error[i - 1]) : NAN);
  text_write(out, n ? cmp_trend_names[t->trend] : "");
  number_write(out, t->order);
  number_write(out, t->limit);
  number_write(out, t->gci);
  number_write(out, t->bar);
  number_write(out, cmp_member_seconds(c, g->member[i]));
  number_write(out, cmp_member_evaluations(c, g->member[i]));
  fputc('\n', out);
}

enum status cmp_convergence_table(const struct comparison *c, const struct cmp_convergence *v,
                                  const char *path) {
  struct cmp_output out = {0};
  enum status status = OK;
  if (!v->n) {
    (void)unlink(path); /* of an earlier report */
    return OK;
  }
  ATTEMPT(cmp_output_open(path, &out));
  fputs("group,quantity,of,units,t_star [sqrt(H/g)],run,spacing [H],value,error,error order,trend,"
        "order,richardson,gci,error bar,wall time [s],evaluations\n",
        out.stream);
  for (size_t k = 0; k < v->n; k++)
    for (size_t r = 0; r < v->group[k].n_rows; r++)
      for (size_t i = 0; i < v->group[k].n; i++)
        line_write(out.stream, c, &v->group[k], &v->group[k].row[r], i);
  status = cmp_output_commit(&out);
done:
  cmp_output_abandon(&out);
  return status;
}
