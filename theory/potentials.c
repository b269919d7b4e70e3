/* Whether the entries of T's table 2.1, unit potentials phi = psi(y) e^(i (kappa x - omega t)), are
 * what they are said to be:
 *
 *     horizontal, vertical  u - phi_x, v - phi_y     over kappa |psi| + |psi'| at its most
 *     pressure              P_d/rho + phi_t          over omega |psi| at its most
 *     equation              psi'' - 2 delta psi' + (omega^2/c^2 - kappa^2) psi  (2.25), over the
 *                           size of its first and last terms at their most
 *     surface, bed          psi'' - kappa^2 psi at y = 0 (2.28), psi' at y = -H (2.29), likewise
 *
 * Derivatives are those of the printed expressions, by a complex step, exact to rounding; psi'' is
 * that of the table's v. The incompressible mode knows no bed: psi' = kappa e^(-kappa H) there.
 * `leading`: with nu_n = (2 n + 1) pi/2, as T's definitions before the table have it, and omega_n
 * from it. Units: g = H = 1. */
#include <complex.h>
#include <math.h>

#include "theory/modes.h"
#include "theory/theory.h"

static const char *const root_names[] = {"exact", "leading", NULL};
static const char *const root_helps[] = {"roots of (2.57)", "(2 n + 1) pi/2, (2.58)"};

struct potentials {
  double sound, kappa;
  int mode, root, points;
};

static const struct param params[] = {
    THEORY_INT(potentials, mode, -1, 10000, "-1, 0, 10",
               "-1: the incompressible mode; n: an acoustic one"),
    THEORY_REAL(potentials, sound, PARAM_ABOVE_0, 1e6, "3.1622776601683795", "c/sqrt(g H)"),
    THEORY_REAL(potentials, kappa, PARAM_ABOVE_0, 1e3, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_CHOICE(potentials, root, root_names, root_helps, "exact", "wavenumbers of the modes"),
    THEORY_POINTS(potentials),
};
static const struct theory_column columns[] = {
    {.key = "y", .unit = "H", .label = "y/H", .help = "height above the surface"},
    {.key = "potential", .unit = "1", .label = "ψ", .level = "0", .help = "psi"},
    {.key = "v", .unit = "1/H", .label = "v", .level = "0", .panel = 1, .help = "the table's v"},
    {.key = "laplacian",
     .unit = "1/H^2",
     .label = "∇²φ",
     .level = "0",
     .panel = 2,
     .help = "psi'' - kappa^2 psi: 0 where the water is incompressible"},
};
enum { VERTICAL_NUMBER, OMEGA, HORIZONTAL, VERTICAL, PRESSURE, EQUATION, SURFACE, BED };
static const struct theory_value values[] = {
    [VERTICAL_NUMBER] = {"vertical_number", "1/H", "nu, or kappa of the incompressible mode"},
    [OMEGA] = {"omega", "sqrt(g/H)", "frequency"},
    [HORIZONTAL] = {"horizontal", "1", "largest u - phi_x, relative"},
    [VERTICAL] = {"vertical", "1", "largest v - phi_y, relative"},
    [PRESSURE] = {"pressure", "1", "largest P_d/rho + phi_t, relative"},
    [EQUATION] = {"equation", "1", "largest residual of (2.25), relative"},
    [SURFACE] = {"surface", "1", "residual of the surface condition, relative"},
    [BED] = {"bed", "1", "residual of the condition on the bed, relative"},
};

struct entries { /* of the table's columns */
  double delta, kappa, nu, s, omega;
  bool acoustic;
};

static double complex psi_of(const struct entries *e, double complex y) {
  if (!e->acoustic) return cexp(e->kappa * y);
  return cexp(e->delta * y) * (csin(e->nu * y) + e->s * ccos(e->nu * y));
}

static double complex v_of(const struct entries *e, double complex y) {
  if (!e->acoustic) return e->kappa * cexp(e->kappa * y);
  return cexp(e->delta * y) * ((e->delta - e->nu * e->s) * csin(e->nu * y) +
                               (e->delta * e->s + e->nu) * ccos(e->nu * y));
}

static const double step = 1e-30; /* of a derivative: no difference, so no cancellation */

static double first(const struct entries *e, double y) {
  return cimag(psi_of(e, y + I * step)) / step;
}
static double second(const struct entries *e, double y) {
  return cimag(v_of(e, y + I * step)) / step;
}

static enum status entries_find(const struct potentials *p, struct entries *e) {
  struct theory_mode m;
  enum theory_profile profile = p->root || p->mode < 0 ? THEORY_LEADING : THEORY_EXACT;
  TRY(theory_mode_find(p->sound * p->sound, p->kappa, p->mode, profile, &m));
  *e = (struct entries){.delta = m.exact.delta,
                        .kappa = p->kappa,
                        .nu = m.exact.root,
                        .s = m.exact.s,
                        .omega = m.exact.omega,
                        .acoustic = p->mode >= 0};
  return OK;
}

static void note(double *most, double value) {
  if (!(fabs(value) <= *most)) *most = fabs(value); /* NaN at first */
}

/* At y, real parts at kappa x - omega t = 1: u = Re(i kappa psi e^i) and P_d/rho = Re(i omega psi
 * e^i) beside derivatives of psi cos(kappa x - omega t). */
static void measure(const struct potentials *p, const struct entries *e, double y,
                    const double size[2], double *v) {
  const double square = pow(e->omega / p->sound, 2) - e->kappa * e->kappa;
  double psi = creal(psi_of(e, y)), slope = creal(v_of(e, y));
  double by_x = cimag(psi * ccos(1 + I * e->kappa * step)) / step;
  double by_t = cimag(psi * ccos(1 - I * e->omega * step)) / step;
  note(&v[HORIZONTAL], (creal(I * e->kappa * psi * cexp(I)) - by_x) / size[1]);
  note(&v[VERTICAL], (slope - first(e, y)) / size[1]);
  note(&v[PRESSURE], (creal(I * e->omega * psi * cexp(I)) + by_t) / (e->omega * size[0]));
  note(&v[EQUATION],
       (second(e, y) - 2 * e->delta * slope + square * psi) / size[1] / fmax(e->nu, e->kappa));
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct potentials *p = with;
  struct entries e;
  TRY(entries_find(p, &e));
  double size[2] = {0}, *v = curve->value; /* |psi|, and kappa |psi| + |psi'| */
  for (int i = 0; i < p->points; i++) {
    double y = theory_between(-1, 0, i, p->points), psi = creal(psi_of(&e, y));
    size[0] = fmax(size[0], fabs(psi));
    size[1] = fmax(size[1], e.kappa * fabs(psi) + fabs(creal(v_of(&e, y))));
    TRY(THEORY_ROW(curve, y, psi, creal(v_of(&e, y)), second(&e, y) - e.kappa * e.kappa * psi));
  }
  for (int i = 0; i < p->points; i++) measure(p, &e, theory_between(-1, 0, i, p->points), size, v);
  v[VERTICAL_NUMBER] = e.acoustic ? e.nu : e.kappa;
  v[OMEGA] = e.omega;
  v[SURFACE] = fabs(second(&e, 0) - e.kappa * e.kappa * creal(psi_of(&e, 0))) / size[1] /
               fmax(e.nu, e.kappa);
  v[BED] = fabs(creal(v_of(&e, -1))) / size[1];
  return OK;
}

const struct theory_topic theory_potentials = {
    .name = "potentials",
    .help = "whether the potentials of table 2.1 satisfy their equation and conditions, and its "
            "velocities and pressures are theirs (T, eqs 2.25-2.29, 2.66, table 2.1)",
    .params_size = sizeof(struct potentials),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
