/* What small waves that run round a tank with periodic sides share. */
#pragma once
#include "common/case/case.h"
#include "common/flow/flow.h"
#include "common/flow/modes.h"

/* A whole number of wavelengths round the tank. */
void wave_round_check(const struct case_file *c, struct case_draft *d, double wavelength);

/* p/(rho g) where water at rest has the density rho0 exp(g depth/c^2), and the pressure over that
 * density is `push` (m^2 s^-2) more; or the depth and that, where the use is `even`. */
double wave_round_head(const struct flow_water *w, double depth, double push);

/* The linear wave of a mode (modes.h), in the
 * places of the case; and how a particle starts in it. */
struct wave_motion wave_round_motion(const struct flow_water *w, const struct wave_mode *m,
                                     double amplitude, double x, double y, double t);
void wave_round_start(const struct flow_water *w, const struct wave_mode *m, double amplitude,
                      double X, double Y, struct flow_start *start);
