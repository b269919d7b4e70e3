/* The topics, in the order in which they are listed. */
#pragma once

#define THEORY_TOPICS(X)                                                                           \
  X(dispersion)                                                                                    \
  X(regime)                                                                                        \
  X(diffusion)                                                                                     \
  X(timestep)                                                                                      \
  X(stability)                                                                                     \
  X(amplification)                                                                                 \
  X(kernel)                                                                                        \
  X(surface)                                                                                       \
  X(formulations)                                                                                  \
  X(damping)                                                                                       \
  X(viscosity)                                                                                     \
  X(treatments)                                                                                    \
  X(derivatives)                                                                                   \
  X(densities)                                                                                     \
  X(growth)                                                                                        \
  X(oscillation)                                                                                   \
  X(hydrostatic)                                                                                   \
  X(spectrum)                                                                                      \
  X(smoothing)                                                                                     \
  X(rates)                                                                                         \
  X(hsph)                                                                                          \
  X(waves)                                                                                         \
  X(roots)                                                                                         \
  X(acoustic)                                                                                      \
  X(profiles)                                                                                      \
  X(potentials)                                                                                    \
  X(orthogonality)                                                                                 \
  X(projection)                                                                                    \
  X(filter)
