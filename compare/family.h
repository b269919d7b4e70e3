/* The same series of every run, of the reference and of experiments, in one panel or one for each
 * run. */
#pragma once
#include "compare/chart.h"

struct cmp_family {
  const struct cmp_series **run; /* [n_runs + 1]: the reference last; NULL: it has none */
  const char *label;             /* of the axis */
  struct cmp_chart_plan plan;    /* without a target no experiments are drawn */
  struct cmp_frame frame;
  bool cuts;        /* of an energy, in which marks show where water was cut away */
  bool raw, errors; /* any series has these: columns of the table, after the value */
};

bool cmp_family_empty(const struct comparison *c, const struct cmp_family *family);

/* All in one panel. */
enum status cmp_family_chart(const struct comparison *c, struct cmp_figures *f, const char *caption,
                             struct cmp_family *family);
/* A panel for every run, each with the reference: one full of noise would hide the others. What a
 * series is made of (raw) is drawn thin. */
enum status cmp_family_panels(const struct comparison *c, struct cmp_figures *f,
                              const char *caption, struct cmp_family *family);

/* Says of a figure of all runs what happens to those that it does not name. */
void cmp_family_caption_end(const struct comparison *c, struct cmp_figure *fig);
