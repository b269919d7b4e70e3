/* The water at t = 0. */
#pragma once
#include "common/case/case.h"
#include "sph/sph.h"

/* Fills s->f: positions, velocities, densities, masses.
 *
 * What the water is, is the flow's to say (common/flow/flow.h): its velocity and pressure
 * are taken at each particle. Each region is divided into cells (cells.h): its area is kept exactly
 * whatever its shape, and a rectangle gets an even lattice, half a spacing inside. A wave in a
 * rectangular tank is filled column by column, each stretched to the elevation, so that the surface
 * is followed to a fraction of dx; in any other it is one region whose rows end at its level at
 * rest.
 *
 * A small wave of linear theory moves the particles of a lattice instead, each with the velocity
 * and the pressure of its own; their masses are those at rest, so that in still water the sums over
 * neighbours start from equilibrium, to the order of the wave.
 *
 * The density follows from the pressure; the mass is the density times the cell, so that m/rho is
 * the cell exactly and the sums over neighbours start from an even lattice (equal masses would put
 * the compression of still water, g H / c0^2, into the volumes and set the water ringing). */
enum status sph_initial_fill(struct sph *s, const struct case_file *c);
