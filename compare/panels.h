/* Panels above each other on one page, with one key below the last: where they are, and how their
 * axes are labelled. */
#pragma once
#include "compare/figure.h"
#include "compare/frame.h"

struct cmp_key { /* [0] as usual, [1] in one column */
  int columns[2];
  int height[2]; /* px: of it, and of tick labels and the axis label above */
};

struct cmp_panels {
  struct cmp_figure *fig;
  size_t n;
  struct cmp_key key;
};

/* Of a key of n labels, the longest of `longest` characters. */
struct cmp_key cmp_key_of(size_t n, size_t longest);
/* Puts it at the foot of the figure. */
void cmp_key_place(const struct cmp_figure *fig, const struct cmp_key *key);

/* px of the figure: [0] as usual, [1] in one column. */
void cmp_panels_heights(size_t n, int panel_height, const struct cmp_key *key, int height[2]);
double cmp_panels_width(bool narrow); /* px between the sides of one */
double cmp_panel_height(const struct cmp_panels *p); /* px of one */

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
