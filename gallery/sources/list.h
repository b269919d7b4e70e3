/* The sources of curves, in the order in which they are listed. */
#pragma once

#define GALLERY_SOURCES(X)                                                                         \
  X(theory)                                                                                        \
  X(formula)                                                                                       \
  X(energy)                                                                                        \
  X(probe)                                                                                         \
  X(gauge)                                                                                         \
  X(point)                                                                                         \
  X(diagnostic)
