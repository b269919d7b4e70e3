/* Panels above each other on one page, with one key below the last: where they are, and how their
 * axes are labelled. */
#pragma once
#include "compare/figure.h"
#include "compare/frame.h"

enum { CMP_PANELS_WIDTH = 900, CMP_PANELS_NARROW = 426 }; /* px of a page; of a column of it */

struct cmp_panels {
  struct cmp_figure *fig;
  size_t n;
  int bottom, columns; /* px below the last; of the key */
};

/* Columns that a key of n labels, the longest of `longest` characters, takes in `width` px; and the
 * height (px) below the panels that holds it, tick labels and the axis label. */
int cmp_key_columns(size_t longest, int width);
int cmp_key_height(size_t n, int columns);

int cmp_panels_height(size_t n, int panel_height, int bottom); /* px of the page */
double cmp_panel_height(const struct cmp_panels *p);           /* px of one */

/* Margins of panel k from the top; the last has the tick labels of the axis `x_label` and the key.
 */
void cmp_panel_place(const struct cmp_panels *p, size_t k, const char *x_label);

/* The label of the y axis, and a title in the panel's corner (NULL: none). Call it after whatever
 * unsets labels. */
void cmp_panel_labels(const struct cmp_panels *p, const char *label, const char *title);

/* About five ticks, at 1, 2 or 5 times a power of ten. */
double cmp_tick_step(const struct cmp_frame *frame);

/* A label short enough for a key, as a string of gnuplot's; the characters that it takes. */
void cmp_key_string(FILE *script, const char *label, const char *note);
size_t cmp_key_length(const char *label);
