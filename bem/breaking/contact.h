/* What happens where the thin end of the sheet meets a wall: the first impact, and the film that
 * runs up the wall and is cut before it becomes thinner than anything that matters. */
#pragma once
#include "bem/water/flow.h"

/* Height of the surface where it crosses x = tank for the first time, 0 while it has not come
 * there. */
double bem_contact_height(const struct bem_surface *s, const double *state);

/* Cuts the water beyond x = tank, which it has entered freely (it could not feel the wall before),
 * and lets the surface end on the wall. */
enum status bem_contact_meet_wall(struct bem_flow *f);

/* Whether nodes of the film have gone through the wall; bem_contact_meet_wall then puts its end
 * where it first met the wall. */
bool bem_contact_crosses_wall(const struct bem_surface *s);

/* Whether the film on the wall that an end of the surface is on is thinner than `coarse` times
 * s->film over a length worth cutting. Water that rests on a slope has no film. */
bool bem_contact_film_is_thin(const struct bem_surface *s, bool right, double coarse);

/* Cuts that film and caps it: the cap lies where the film was, so the potential on it is that of
 * the water there, interpolated by the complex polynomial of neighbouring nodes. */
enum status bem_contact_cut_film(struct bem_flow *f, bool right, double coarse);

/* Of how many nodes the tongue is that the water at an end of the surface has put out along the
 * wall, thinner than anything that panels can follow, or even through it; 0: there is none. */
size_t bem_contact_tongue(const struct bem_surface *s, bool right);

/* Lets the surface end on the wall where that tongue begins. */
enum status bem_contact_cut_tongue(struct bem_flow *f, bool right);

/* Thickness (H) of the film on the right wall where it would be cut to end below `top`. */
double bem_contact_thickness(const struct bem_surface *s, double top);

/* Cuts that film below `top`, by somewhat more than the length of the cap, so that it takes a while
 * until it passes again. */
enum status bem_contact_cut_top(struct bem_flow *f, double top);
