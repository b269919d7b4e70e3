/* What is taken away anywhere on the surface: sheets that have become thinner than the panels
 * resolve, drops that have come off, bubbles too small to follow; and wrinkles, which are smoothed.
 */
#pragma once
#include "bem/shape/sides.h"
#include "bem/water/flow.h"

/* The nodes between `first` and `last` go. */
struct bem_piece {
  size_t first, last;
  double x, y; /* where, H */
};

/* The first sheet from the left that is thinner than the panels are long, times `coarse`, or than
 * the film, and how much of it is to be cut: up to where it is twice as thick. A tip that is about
 * to land is none, unless the run does not get on (coarse > 1). *w: of this surface. */
bool bem_cuts_find_sheet(const struct bem_sides *w, const struct bem_surface *s, double coarse,
                         struct bem_piece *p);

/* The first drop that has come off, or bubble. */
bool bem_cuts_find_loop(const struct bem_sides *w, const struct bem_surface *s,
                        struct bem_piece *p);

/* Where the flow strains most, and its surroundings. */
struct bem_piece bem_cuts_find_wrinkle(const struct bem_flow *f);

/* Cuts a sheet and rounds its end; the potential there is that of the water which was there. */
enum status bem_cuts_sheet(struct bem_flow *f, const struct bem_piece *p);
enum status bem_cuts_loop(struct bem_flow *f, const struct bem_piece *p);

/* Smooths by the five-point formula (Longuet-Higgins & Cokelet 1976). */
enum status bem_cuts_wrinkle(struct bem_flow *f, const struct bem_piece *p);
