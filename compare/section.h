/* The sections of the report, in the order of its page. Figures and measures have their place in
 * one, and `name` is what it is called in the page and in report.json. X(section, name, title) */
#pragma once

#define CMP_SECTIONS(X)                                                                            \
  X(HEALTH, health, "Health")                                                                      \
  X(SUMMARY, summary, "Summary")                                                                   \
  X(CHECKS, checks, "Checks") /* of a measure: shown where it has a limit, and in report.json */   \
  X(CONVERGENCE, convergence, "Convergence")                                                       \
  X(DISTANCE, distance, "Distance against time")                                                   \
  X(OVERLAY, overlays, "Overlays")                                                                 \
  X(JET, jet, "Plunging jet")                                                                      \
  X(FRONT, front, "Front")                                                                         \
  X(ENERGY, energy, "Energy")                                                                      \
  X(PRESSURE, pressure, "Pressure")                                                                \
  X(GAUGE, gauges, "Water height")                                                                 \
  X(SPECTRA, spectra, "Spectra")                                                                   \
  X(DIAGNOSTICS, diagnostics, "Noise, momenta and forces")                                         \
  X(RUNS, runs, "Runs and provenance")                                                             \
  X(METHOD, method, "How it is measured")

enum cmp_section {
#define X(section, name, title) CMP_SECTION_##section,
  CMP_SECTIONS(X)
#undef X
      CMP_N_SECTIONS
};

static inline const char *cmp_section_name(enum cmp_section section) {
  static const char *const names[] = {
#define X(section, name, title) #name,
      CMP_SECTIONS(X)
#undef X
  };
  return names[section];
}

static inline const char *cmp_section_title(enum cmp_section section) {
  static const char *const titles[] = {
#define X(section, name, title) title,
      CMP_SECTIONS(X)
#undef X
  };
  return titles[section];
}
