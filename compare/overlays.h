/* Pictures at the comparison times: particles coloured by pressure under the reference's free
 * surface, a panel for every run; and the plunging jet close up. */
#pragma once
#include "compare/cloud.h"
#include "compare/comparison.h"
#include "compare/figure.h"
#include "compare/panes.h"

enum status cmp_overlays_write(const struct comparison *c, struct cmp_figures *f);

/* How the panels of an overlay are drawn. */
struct cmp_shades {
  enum cmp_field field;
  double low, high; /* of the colours */
  bool alone;       /* each run with its own surface, without the reference's */
  bool film;        /* titles say the time, and no distance */
};

/* The colours that fit all runs at n comparison times; `any`: whether there are points at all. */
enum status cmp_shades_choose(const struct comparison *c, size_t n, const size_t *time,
                              struct cmp_shades *shades, bool *any);

struct cmp_overlay { /* at one comparison time */
  size_t figure;     /* index of, begun, with the table of surfaces; SIZE_MAX: none */
  struct geo_box view;
  struct cmp_layout layout;
};

/* Draws it with the points that cmp_clouds_write has written, cloud [n_runs]. */
enum status cmp_overlay_draw(const struct comparison *c, struct cmp_figures *f, size_t time,
                             const struct cmp_overlay *o, const struct cmp_shades *shades,
                             const struct cmp_cloud *cloud);
