/* The sources of curves, in the order in which they are listed. */
#pragma once

#define GALLERY_SOURCES(X)                                                                         \
  X(theory)                                                                                        \
  X(formula)                                                                                       \
  X(energy)                                                                                        \
  X(probe)                                                                                         \
  X(gauge)                                                                                         \
  X(point)                                                                                         \
  X(diagnostic)                                                                                    \
  X(particle)                                                                                      \
  X(particles)                                                                                     \
  X(row)                                                                                           \
  X(cut)                                                                                           \
  X(surface)                                                                                       \
  X(elevation)                                                                                     \
  X(distance)                                                                                      \
  X(front)                                                                                         \
  X(jet)                                                                                           \
  X(event)                                                                                         \
  X(statistic)                                                                                     \
  X(experiment)                                                                                    \
  X(spectrum)                                                                                      \
  X(without)                                                                                       \
  X(lowpass)                                                                                       \
  X(average)                                                                                       \
  X(highpass)                                                                                      \
  X(derivative)                                                                                    \
  X(integral)
