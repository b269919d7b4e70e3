/* Acoustic modes as a run shows them: a case as a user writes it, the series of its points in the
 * result file, and the comparator's spectra of them, against the law of the lattice (thesis, 2.4.3;
 * units g = H = rho0 = 1, c^2 = 10). */
#pragma once
#include "common/flow/modes.h"
#include "compare/spectrum.h"
#include "tests/cli/run_text.h"
#include "tests/test.h"

/* Two depths off any node, and all steps. */
static struct result_file *acoustic_run(int n, int resolution, double duration) {
  char text[1200];
  snprintf(
      text, sizeof text,
      "fluid: {density: 1, gravity: 1}\nscales: {H: 1}\n"
      "tank: {walls: [[[0, 1.5], [0, 0], [1, 0], [1, 1.5]]], sides: periodic}\n"
      "water: {wave: {kind: acoustic, amplitude: %.17g, number: %d, wavelength: 1, depth: 1}}\n"
      "points: [{name: high, at: [0.25, 0.7531]}, {name: low, at: [0.6, 0.2629]}]\n"
      "time: {end: %.17g, every: %.17g}\n"
      "runs: [{solver: sph, resolution: %d, kernel: tensor, h_over_dx: 1, precision: double, "
      "walls: mirror, diffusion: none, alpha: 0, integrator: rk4, c0: %.17g, cfl_acoustic: "
      "0.8}]\n",
      0.0006 / (2 * M_PI), n, duration, duration, resolution, sqrt(10));
  return run_text(text);
}

/* omega^2 = (c/h)^2 ([sin(nu h) Wx]^2 + [sin(kappa h) Wy]^2 + 8 theta sin^4(nu h/2)), W = 1 - (2/3)
 * sin^2 of half the other; theta = delta H is that of the middle. */
static double acoustic_law(int n, double h, double delta) {
  const double nu = (2 * n + 1) * M_PI / 2, kappa = 2 * M_PI, c = sqrt(10);
  const double wx = 1 - 2. / 3 * pow(sin(kappa * h / 2), 2),
               wy = 1 - 2. / 3 * pow(sin(nu * h / 2), 2);
  return c / h *
         sqrt(pow(sin(nu * h) * wx, 2) + pow(sin(kappa * h) * wy, 2) +
              8 * delta * pow(sin(nu * h / 2), 4));
}

/* The highest peak of pressure and vertical acceleration at both depths within `part` of the law.
 */
static void acoustic_expect(int n, int resolution, double duration, double part) {
  const struct wave_mode mode =
      wave_mode_acoustic(&(struct wave_column){1, sqrt(10), 1, 2 * M_PI}, n);
  const double law = acoustic_law(n, 1. / resolution, mode.delta);
  struct result_file *f = acoustic_run(n, resolution, duration);
  static const int fields[] = {CASE_POINT_p, CASE_POINT_a_y};
  EXPECT(f->n_points == 2);
  for (size_t i = 0; i < f->n_points; i++)
    for (int k = 0; k < 2; k++) {
      const struct result_point_read *p = &f->points[i];
      const struct cmp_signal s = {p->n, p->t, p->value[fields[k]]};
      struct cmp_spectrum spectrum;
      EXPECT_OK(cmp_spectrum_create(&s, 0, INFINITY, 1, &spectrum));
      EXPECT(spectrum.n_peaks == 1);
      const double omega = 2 * M_PI * spectrum.peak[0].frequency;
      printf(
          "     n = %d, H/h = %d, %s of %s: omega %.2f, lattice %.2f (%+.2f %%), continuum %.2f; "
          "bins %.2f\n",
          n, resolution, k ? "a_y" : "p", p->name, omega, law, 100 * (omega / law - 1), mode.omega,
          2 * M_PI * spectrum.step);
      EXPECT_NEAR(omega, law, part * law);
      cmp_spectrum_destroy(&spectrum);
    }
  result_file_destroy(f);
}
