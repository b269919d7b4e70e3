/* An Airy wave by hSPH (thesis, 4.2), and what its linear equations on an undisturbed lattice say
 * (sph/theory/rows.h): planes fitted to nine particles, p = 0 kept on the first row, projection on
 * waves every so many steps. One wave to the tank, k a = 0.006; units L
 * and g, c0^2 = 10. Particles are known by the labels of their rows, y = -j/n below the surface,
 * the last half a spacing above the bed. */
#pragma once
#include <complex.h>

#include "sph/fluid/energy.h"
#include "sph/theory/rows.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

static const double k = 2 * M_PI, a = 0.006 / (2 * M_PI);

enum { QUANTITIES = SPH_ROWS_AY + 1 };

/* ---- the solver ---- */

static inline struct sph *airy_create(int n, int projection, struct case_file **c) {
  char head[500], run[500];
  snprintf(head, sizeof head,
           "title: Airy\nscales: {H: 1}\ntank: {walls: [[[0, 2], [0, 0], [1, 0], [1, 2]]], sides: "
           "periodic}\nwater: {wave: {kind: airy, profile: deep, amplitude: %.17g, wavelength: 1, "
           "depth: %.17g}}\n" POOL_TIMES,
           a, 1 - 0.5 / n);
  snprintf(run, sizeof run,
           "resolution: %d, scheme: hsph, projection: %d, c0: 3.1622776601683795 sqrt(gH), "
           "precision: double",
           n, projection);
  *c = pool_case(head, run);
  return pool_create(*c);
}

/* Where particles rest. */
struct label {
  double x, y;
  int row;
};

static inline struct label label_of(const struct sph *s, size_t i, int n) {
  const uint32_t id = s->f.id[i];
  const int row = n - 1 - (int)(id % (uint32_t)n);
  return (struct label){((double)(id / (uint32_t)n) + 0.5) / n, -(double)row / n, row};
}

/* The lattice of the same wave, its amplitude 1. */
static inline struct sph_rows lattice_airy(int n, double g) {
  struct sph_rows l = sph_rows_at_rest(n, k, g, 10 * g, 1.5, true);
  sph_rows_airy(&l);
  return l;
}

/* ---- both against linear theory ---- */

/* Largest errors of the first two rows, of the local amplitude. Of the wave in the velocities of
 * all rows: its amplitude at the end over that at the start, how far behind theory it is (rad), and
 * its mean frequency over the theory's. */
struct airy_found {
  double row[2][QUANTITIES], amplitude, lag, frequency;
};

/* A complex amplitude that turns by less than pi a step. */
struct airy_turn {
  double complex last;
  double turned, start;
};

static inline void airy_turn_to(struct airy_turn *t, double complex now) {
  if (t->start == 0) t->start = cabs(now);
  if (t->last != 0) t->turned -= carg(now / t->last);
  t->last = now;
}

static inline void airy_finish(const struct airy_turn *t, double omega, double time,
                               struct airy_found *e) {
  e->amplitude = cabs(t->last) / t->start;
  e->lag = omega * time - t->turned;
  e->frequency = t->turned / (omega * time);
}

static inline double complex airy_wave(const struct sph *s, int n) {
  double complex sum = 0;
  for (size_t i = 0; i < s->f.n; i++) {
    const struct label l = label_of(s, i, n);
    sum += exp(k * l.y) * (s->f.w.u[i] + I * s->f.w.v[i]) * cexp(-I * k * l.x);
  }
  return sum;
}

static inline void airy_compare(const struct sph *s, int n, double omega, struct airy_found *e) {
  const double g = s->g;
  for (size_t i = 0; i < s->f.n; i++) {
    const struct label l = label_of(s, i, n);
    const double E = a * exp(k * l.y), theta = k * l.x - omega * s->t;
    if (l.row > 1) continue;
    /* the dynamic pressure where the particle is */
    const double p =
        s->c0 * s->c0 * (s->f.w.rho[i] - s->rho0) / s->rho0 - g * (s->eos.level - s->f.w.y[i]);
    const double off[QUANTITIES] = {
        s->f.w.u[i] / (E * omega) - cos(theta), s->f.w.v[i] / (E * omega) - sin(theta),
        p / (g * E) - cos(theta), s->f.k[0].u[i] / (E * omega * omega) - sin(theta),
        s->f.k[0].v[i] / (E * omega * omega) + cos(theta)};
    for (int q = 0; q < QUANTITIES; q++) e->row[l.row][q] = fmax(e->row[l.row][q], fabs(off[q]));
  }
}

/* The same of the lattice. */
static inline void lattice_compare(const struct sph_rows *l, double t, struct airy_found *e) {
  struct sph_rows_state rates;
  double complex off[SPH_ROWS_QUANTITIES];
  sph_rows_rates(l, &l->w, &rates);
  for (int row = 0; row < 2; row++) {
    sph_rows_off(l, &rates, t, row, off);
    for (int q = 0; q < QUANTITIES; q++) e->row[row][q] = fmax(e->row[row][q], cabs(off[q]));
  }
}

/* Steps of h/c0 over `part`, projected every 15 of them. */
static inline struct airy_found lattice_march(int n, double g, double periods, int part) {
  struct sph_rows l = lattice_airy(n, g);
  struct airy_found e = {0};
  struct airy_turn turn = {0};
  const double omega = sqrt(k * g), dt = l.h / sqrt(l.c2) / part;
  const double end = periods * 2 * M_PI / omega;
  double t = 0;
  airy_turn_to(&turn, sph_rows_wave(&l));
  for (int step = 0; t + dt < end; step++, t += dt) {
    if (step > 0 && step % (15 * part) == 0) sph_rows_project(&l, true, true);
    lattice_compare(&l, t, &e);
    sph_rows_step(&l, dt);
    airy_turn_to(&turn, sph_rows_wave(&l));
  }
  airy_finish(&turn, omega, t, &e);
  return e;
}

/* What the budget is off by at the end goes to *closure, in energies of the wave, rho0 g a^2/2 for
 * its metre. */
static inline struct airy_found airy_march(int n, double periods, int part, double *closure) {
  struct case_file *c;
  struct sph *s = airy_create(n, 15 * part, &c);
  struct airy_found e = {0};
  struct airy_turn turn = {0};
  const double omega = sqrt(k * s->g), dt = s->h / s->c0 / part;
  const double end = periods * 2 * M_PI / omega, before = sph_energy(s).total;
  airy_turn_to(&turn, airy_wave(s, n));
  while (s->t + dt < end) {
    if (sph_treat(s) != OK || sph_rates(s, 0, true, true) != OK) break;
    airy_compare(s, n, omega, &e);
    if (sph_step(s, dt) != OK) break;
    airy_turn_to(&turn, airy_wave(s, n));
  }
  EXPECT(s->t + dt >= end);
  airy_finish(&turn, omega, s->t, &e);
  const struct result_energy after = sph_energy(s);
  *closure = (result_energy_budget(&after) - before) / (s->rho0 * s->g * a * a / 2);
  sph_destroy(s);
  case_destroy(c);
  return e;
}

static inline void airy_print(const char *name, const struct airy_found *e) {
  printf("     %s: w/w0 %.4f, amplitude %.3f, lag %.3f, row 0", name, e->frequency, e->amplitude,
         e->lag);
  for (int row = 0; row < 2; row++)
    for (int q = 0; q < QUANTITIES; q++)
      printf("%s %.3f", row && !q ? ", row 1" : "", e->row[row][q]);
  printf("\n");
}
