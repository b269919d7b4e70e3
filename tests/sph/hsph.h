/* An Airy wave by hSPH (thesis, 4.2), and what its linear equations on an undisturbed lattice say:
 * velocity and pressure with the derivatives of a plane fitted to nine particles, p = 0 kept on the
 * first row, projection on waves every so many steps. One wave to the tank, k a = 0.006; units L
 * and g, c0^2 = 10. Particles are known by the labels of their rows, y = -j/n below the surface,
 * the last half a spacing above the bed. */
#pragma once
#include <complex.h>

#include "sph/fluid/energy.h"
#include "sph/treat/treat.h"
#include "tests/sph/pool.h"

static const double k = 2 * M_PI, a = 0.006 / (2 * M_PI);

enum { QU, QV, QP, QAX, QAY, QUANTITIES };

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

/* ---- the lattice ---- */

enum { MOST_ROWS = 64 };

/* Of perturbations in proportion to e^{i k x}, row by row: displacements, velocities, and the
 * pressure over rho0 that a particle gains. */
struct lattice_state {
  double complex x[MOST_ROWS], y[MOST_ROWS], u[MOST_ROWS], v[MOST_ROWS], p[MOST_ROWS];
};

struct lattice {
  int n;
  double h, k, g, c2;
  struct lattice_state w, rates;
};

/* f in the row: below the last is its image. */
static inline double complex lattice_value(const struct lattice *l, const double complex *f, int j,
                                           double image) {
  return j < l->n ? f[j] : image * f[j - 1];
}

/* The slopes of the plane fitted to the rows on either side and three particles of each. */
static inline double complex lattice_along(const struct lattice *l, const double complex *f,
                                           int j) {
  double complex sum = 0;
  const int first = j > 0 ? j - 1 : 0;
  for (int row = first; row <= j + 1; row++) sum += lattice_value(l, f, row, 1);
  return I * sin(l->k * l->h) / l->h * sum / (j + 2 - first);
}

static inline double complex lattice_up(const struct lattice *l, const double complex *f, int j,
                                        double image) {
  const int first = j > 0 ? j - 1 : 0;
  const double mean = (1 + 2 * cos(l->k * l->h)) / 3;
  return mean * (f[first] - lattice_value(l, f, j + 1, image)) / ((j + 1 - first) * l->h);
}

/* The dynamic pressure p + g y drives, and only the first row's p stays what it is. */
static inline void lattice_rates(const struct lattice *l, const struct lattice_state *w,
                                 struct lattice_state *r) {
  double complex dynamic[MOST_ROWS];
  for (int j = 0; j < l->n; j++) dynamic[j] = w->p[j] + l->g * w->y[j];
  for (int j = 0; j < l->n; j++) {
    r->x[j] = w->u[j];
    r->y[j] = w->v[j];
    r->u[j] = -lattice_along(l, dynamic, j);
    r->v[j] = -lattice_up(l, dynamic, j, 1);
    r->p[j] = j == 0 ? 0 : -l->c2 * (lattice_along(l, w->u, j) + lattice_up(l, w->v, j, -1));
  }
}

static inline void lattice_add(const struct lattice *l, struct lattice_state *w, double dt,
                               const struct lattice_state *r) {
  for (int j = 0; j < l->n; j++) {
    w->x[j] += dt * r->x[j];
    w->y[j] += dt * r->y[j];
    w->u[j] += dt * r->u[j];
    w->v[j] += dt * r->v[j];
    w->p[j] += dt * r->p[j];
  }
}

/* Classic Runge-Kutta: w + dt/6 (r0 + 2 r1 + 2 r2 + r3). */
static inline void lattice_step(struct lattice *l, double dt) {
  static const double to[] = {0.5, 0.5, 1}, weight[] = {1. / 6, 1. / 3, 1. / 3, 1. / 6};
  const struct lattice_state start = l->w;
  struct lattice_state at = start, r;
  for (int stage = 0; stage < 4; stage++) {
    lattice_rates(l, &at, &r);
    lattice_add(l, &l->w, weight[stage] * dt, &r);
    if (stage == 3) break;
    at = start;
    lattice_add(l, &at, to[stage] * dt, &r);
  }
}

/* On the wave e^{k y} if that is kept, else on nothing: velocities, the pressures of a wave to the
 * right, and, if asked, the first row's height. The first row lies on the surface, and half of it
 * is water. */
static inline void lattice_project(struct lattice *l, bool kept, bool first_row) {
  double complex sum = 0;
  double norm = 0;
  for (int j = 0; j < l->n; j++) {
    const double E = exp(-l->k * j * l->h), weight = j > 0 ? 1 : 0.5;
    sum += weight * E * (l->w.v[j] - I * l->w.u[j]);
    norm += 2 * weight * E * E;
  }
  const double complex amplitude = kept ? sum / norm : 0;
  if (first_row && !kept) l->w.y[0] = 0;
  for (int j = 0; j < l->n; j++) {
    const double E = exp(-l->k * j * l->h);
    l->w.u[j] = I * amplitude * E;
    l->w.v[j] = amplitude * E;
    l->w.p[j] = j > 0 ? sqrt(l->g / l->k) * l->w.u[j] - l->g * l->w.y[j] : 0;
  }
}

/* A deep wave of amplitude 1, in its displaced particles. */
static inline struct lattice lattice_airy(int n, double g) {
  struct lattice l = {.n = n, .h = 1. / n, .k = k, .g = g, .c2 = 10 * g};
  const double omega = sqrt(k * g);
  for (int j = 0; j < n; j++) {
    const double E = exp(-k * j * l.h);
    l.w.x[j] = I * E;
    l.w.y[j] = E;
    l.w.u[j] = omega * E;
    l.w.v[j] = -I * omega * E;
  }
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

static inline double complex lattice_wave(const struct lattice *l) {
  double complex sum = 0;
  for (int j = 0; j < l->n; j++) sum += exp(-l->k * j * l->h) * (l->w.u[j] + I * l->w.v[j]);
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

/* The same of the lattice, whose errors are complex amplitudes: those of a label at its worst. */
static inline void lattice_compare(struct lattice *l, double t, struct airy_found *e) {
  const double omega = sqrt(l->k * l->g);
  lattice_rates(l, &l->w, &l->rates);
  for (int j = 0; j < 2; j++) {
    const double E = exp(-l->k * j * l->h);
    const double complex turn = cexp(-I * omega * t); /* of cos theta; -I turn of sin theta */
    const double complex off[QUANTITIES] = {
        l->w.u[j] / (E * omega) - turn, l->w.v[j] / (E * omega) + I * turn,
        (l->w.p[j] + l->g * l->w.y[j]) / (l->g * E) - turn,
        l->rates.u[j] / (E * omega * omega) + I * turn, l->rates.v[j] / (E * omega * omega) + turn};
    for (int q = 0; q < QUANTITIES; q++) e->row[j][q] = fmax(e->row[j][q], cabs(off[q]));
  }
}

/* Steps of h/c0 over `part`, projected every 15 of them. */
static inline struct airy_found lattice_march(int n, double g, double periods, int part) {
  struct lattice l = lattice_airy(n, g);
  struct airy_found e = {0};
  struct airy_turn turn = {0};
  const double omega = sqrt(k * g), dt = l.h / sqrt(l.c2) / part;
  const double end = periods * 2 * M_PI / omega;
  double t = 0;
  airy_turn_to(&turn, lattice_wave(&l));
  for (int step = 0; t + dt < end; step++, t += dt) {
    if (step > 0 && step % (15 * part) == 0) lattice_project(&l, true, true);
    lattice_compare(&l, t, &e);
    lattice_step(&l, dt);
    airy_turn_to(&turn, lattice_wave(&l));
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
