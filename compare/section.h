/* The sections of the report that figures and measures have their place in. */
#pragma once

enum cmp_section {
  CMP_SECTION_CHECKS, /* of a measure: shown where it has a limit, and in report.json */
  CMP_SECTION_DISTANCE,
  CMP_SECTION_OVERLAY,
  CMP_SECTION_JET,
  CMP_SECTION_FRONT,
  CMP_SECTION_ENERGY,
  CMP_SECTION_PRESSURE,
  CMP_SECTION_GAUGE,
  CMP_SECTION_SPECTRA,
  CMP_SECTION_DIAGNOSTICS,
  CMP_SECTION_CONVERGENCE
};
