/* A topic of plunge theory as a figure. */
#pragma once
#include "compare/figure.h"
#include "theory/theory.h"

/* Writes the figure of a result: panels, labels and scales are those of its topic. */
enum status gallery_topic_draw(const struct theory_result *r, const char *name,
                               struct cmp_figures *f);
