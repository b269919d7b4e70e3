/* What a file says of its run beside series: statistics, and what was measured of it elsewhere. */
#include <math.h>
#include <string.h>

#include "gallery/desk.h"
#include "gallery/source.h"

struct number_source {
  char *run, *statistic, *label;
};

/* ---- statistic ---- */

static const struct param statistic_params[] = {
    SOURCE_RUN(number_source),
    SOURCE_TEXT(number_source, statistic, NULL, "a statistic of the file by its name"),
};

static enum status statistic(struct gallery_desk *desk, const void *with,
                             struct gallery_curve *curve) {
  const struct number_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  for (size_t k = 0; k < f->n_statistics; k++)
    if (!strcmp(f->statistics[k].name, s->statistic))
      return gallery_curve_add(curve, 0, f->statistics[k].value);
  return status_raise(ERR_INPUT, "run %s has no statistic '%s'", s->run, s->statistic);
}

/* ---- experiment ---- */

static const struct param experiment_params[] = {
    SOURCE_RUN(number_source),
    SOURCE_TEXT(number_source, label, NULL, "the measured series of the run's case by its label"),
};

static bool is_of_probe(const struct result_file *f, const struct case_experiment *e) {
  for (size_t k = 0; k < f->n_probes; k++)
    if (!strcmp(f->probes[k].name, e->target)) return true;
  return false;
}

static enum status experiment(struct gallery_desk *desk, const void *with,
                              struct gallery_curve *curve) {
  const struct number_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  size_t k = 0;
  while (k < f->n_experiments && strcmp(f->experiments[k].label, s->label)) k++;
  CHECK(k < f->n_experiments, ERR_INPUT, "the case of run %s has no measured series '%s'", s->run,
        s->label);
  const struct case_experiment *e = &f->experiments[k];
  const double T = sqrt(f->H / f->g), unit = is_of_probe(f, e) ? f->density * f->g * f->H : f->H;
  for (size_t i = 0; i < e->n; i++) TRY(gallery_curve_add(curve, e->t[i] / T, e->value[i] / unit));
  return OK;
}

/* ---- the sources ---- */

#define NUMBERS(what, text)                                                                        \
  const struct gallery_source gallery_source_##what = {                                            \
      .name = #what,                                                                               \
      .help = text,                                                                                \
      .params = what##_params,                                                                     \
      .n_params = sizeof what##_params / sizeof *what##_params,                                    \
      .params_size = sizeof(struct number_source),                                                 \
      .evaluate = what,                                                                            \
  };
NUMBERS(statistic, "one point: a statistic of a run as its file has it, over 0")
NUMBERS(experiment, "a measured series of a run's case, H or rho g H, over t")
