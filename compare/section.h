/* The sections of the report that figures and measures have their place in: as they are called here,
 * and in the page and report.json. */
#pragma once

#define CMP_SECTIONS(X)                                                                            \
  X(CHECKS, checks) /* of a measure: shown where it has a limit, and in report.json */             \
  X(DISTANCE, distance)                                                                            \
  X(OVERLAY, overlays)                                                                             \
  X(JET, jet)                                                                                      \
  X(FRONT, front)                                                                                  \
  X(ENERGY, energy)                                                                                \
  X(PRESSURE, pressure)                                                                            \
  X(GAUGE, gauges)                                                                                 \
  X(SPECTRA, spectra)                                                                              \
  X(DIAGNOSTICS, diagnostics)                                                                      \
  X(CONVERGENCE, convergence)

enum cmp_section {
#define X(section, name) CMP_SECTION_##section,
  CMP_SECTIONS(X)
#undef X
};

static inline const char *cmp_section_name(enum cmp_section section) {
  static const char *const names[] = {
#define X(section, name) #name,
      CMP_SECTIONS(X)
#undef X
  };
  return names[section];
}
