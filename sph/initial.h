/* The water at t = 0. */
#pragma once
#include "common/case.h"
#include "sph/sph.h"

/* Fills s->f: positions, velocities, densities, masses.
 *
 * Regions are filled with a lattice of spacing dx, half a spacing inside their bounding boxes,
 * stretched so that it divides the box evenly. A wave is filled column by column, each stretched to
 * the elevation, so that the surface is followed to a fraction of dx.
 * The density follows from the pressure; the mass is the density times the cell, so that m/rho is
 * the cell exactly and the sums over neighbours start from an even lattice (equal masses would put
 * the compression of still water, g H / c0^2, into the volumes and set the water ringing). */
enum status sph_initial_fill(struct sph *s, const struct case_file *c);

/* Pressure over rho g (m) in a column of width L and height H, x from the wall it stands at and y
 * from the bed, at the instant its other side is released: H - y minus a Fourier series that makes
 * the released side free of pressure. */
double sph_released_head(double x, double y, double L, double H);

/* The only region, when it is a rectangle that stands on the bed against one side wall. */
bool sph_initial_column(const struct case_file *c, struct geo_box *column);
