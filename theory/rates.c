/* T's table 2.4: growth of modes e^(mu y) and e^(i nu y), kappa = 0, of a column of water
 * (continuum), of a line of particles (lattice: dx = h, cubic B-spline) and of RK4 on it
 * (discrete), on a density that is uniform or that of rest. `eigenvalue` is that of the system of
 * position, velocity and density over rho_f itself,
 *
 *     y' = v,  v' = -(b g + c^2 F) r,  r' = -F v,     F = mu, sinh(mu h)/h, i nu, i sin(nu h)/h
 *
 * with b = 0 on uniform density and 1 on that of rest. Of waves on the lattice at rest it is that
 * of the sums of (2.15) and (2.201) over the neighbours of a particle at the depth |y|, with the
 * masses that rest needs, linear in disturbances y e^(i nu y), v e^(i nu y) and r e^(i nu y) of
 * position, velocity and density over that of rest:
 *
 *     v' = - sum m_b [(q_a r_a + q_b r_b) W' + (P_a/rho_a^2 + P_b/rho_b^2) W'' (y_a - y_b)],
 *     rho_a r' = sum m_b (v_a - v_b) W',                 q = rho d(P/rho^2)/drho, P = c^2 (rho - 1)
 *
 * `closed` is
 *
 *     e^(mu y)     c mu, c mu sqrt(1 + 2 delta/mu);  c F, sqrt(c^2 F^2 + g F);  ln R(z)/dt
 *     e^(i nu y)   0, sqrt{[-a + sqrt(a^2 + g^2 nu^2)]/2} with a = c^2 nu^2, which is c delta up to
 *                  (delta/nu)^2; of the lattice Re sqrt(q); ln |R(z)|/dt
 *
 *     q = (c/h)^2 {-s1^2 - 8 theta s2^2 - 2 i delta h s1 (2 - cos nu h)}, s1 = sin(nu h),
 *     s2 = sin^2(nu h/2), theta = 2 delta |y|, up to theta^2 and (delta h)^2
 *
 * R = 1 + z + z^2/2 + z^3/6 + z^4/24 and z = dt times the lattice's rate. `printed` is the table's
 * entry, where it has a number: c mu sqrt(1 - 2 delta/mu) for uniform density holds gravity, of
 * another variable (2.176); delta/nu is no rate; O(c theta') is taken as c |theta'| = 2 c delta.
 * Units: g = H = 1. */
#include <complex.h>
#include <math.h>

#include "theory/column.h"
#include "theory/theory.h"

static const char *const mode_names[] = {"decaying", "oscillating", NULL};
static const char *const mode_helps[] = {"e^(mu y)", "e^(i nu y)"};
enum { DECAYING, OSCILLATING };
static const char *const base_names[] = {"uniform", "rest", NULL};
static const char *const base_helps[] = {"theta = 0", "theta = -2 delta y"};
enum { UNIFORM, REST };
static const char *const system_names[] = {"continuum", "lattice", "discrete", NULL};
static const char *const system_helps[] = {"CMA-SPH", "semi-discrete", "fully discrete, RK4"};
enum { CONTINUUM, LATTICE, DISCRETE };

struct rates {
  double beta, spacing, courant, depth, to;
  int mode, base, system, points;
};

static const struct param params[] = {
    THEORY_CHOICE(rates, mode, mode_names, mode_helps, "decaying", "form of the mode"),
    THEORY_CHOICE(rates, base, base_names, base_helps, "uniform, rest", "density at rest"),
    THEORY_CHOICE(rates, system, system_names, system_helps, "continuum, lattice, discrete",
                  "column of table 2.4"),
    THEORY_REAL(rates, beta, PARAM_ABOVE_0, 1e6, "20", "c^2/(g H)"),
    THEORY_REAL(rates, spacing, PARAM_ABOVE_0, 1, "0.02", "dx = h over H"),
    THEORY_REAL(rates, courant, PARAM_ABOVE_0, 2.8, "0.5", "c dt/h, of discrete"),
    THEORY_REAL(rates, depth, 0, 1, "0",
                "|y|/H of the particle whose neighbours see waves at rest"),
    THEORY_REAL(rates, to, PARAM_ABOVE_0, 3.1, "2", "largest mu h or nu h"),
    THEORY_POINTS(rates),
};
static const struct theory_column columns[] = {
    {.key = "kh", .unit = "1", .label = "μ h or ν h", .help = "wavenumber times h"},
    {.key = "closed",
     .unit = "sqrt(g/H)",
     .label = "closed form",
     .axis = "growth w √(H/g)",
     .help = "growth by its closed form"},
    {.key = "eigenvalue",
     .unit = "sqrt(g/H)",
     .label = "eigenvalue",
     .undrawn = true,
     .help = "by the eigenvalues of the system"},
    {.key = "printed",
     .unit = "sqrt(g/H)",
     .label = "as printed",
     .undrawn = true,
     .help = "the entry of table 2.4; none where it is blank"},
};
enum { OFF, PRINTED_OFF };
static const struct theory_value values[] = {
    [OFF] = {"off", "1", "largest |eigenvalue - closed| over the largest |eigenvalue| at that kh"},
    [PRINTED_OFF] = {"printed_off", "1",
                     "largest |printed/eigenvalue - 1|; none where either is 0"},
};

/* What a column's system makes of a derivative, in 1/H. */
static double complex symbol(const struct rates *p, double k) {
  double h = p->spacing;
  if (p->system == CONTINUUM) return p->mode == DECAYING ? k : I * k;
  return p->mode == DECAYING ? sinh(k * h) / h : I * sin(k * h) / h;
}

/* The sums over a particle and its two neighbours; of W at dx = h, h^2 W' is 1/2 above and h^3 W''
 * is 1. */
static struct theory_matrix sums_of(const struct rates *p, double k) {
  double c2 = p->beta, h = p->spacing, at_rest = exp(p->depth / c2);
  double complex v_y = 0, v_r = 0, r_v = 0;
  for (int j = -1; j <= 1; j += 2) {
    double rho = at_rest * exp(-j * h / c2), mass = rho * h, slope = j / (2 * h * h);
    double complex along = cexp(I * k * h * j);
    double both = c2 * ((at_rest - 1) / (at_rest * at_rest) + (rho - 1) / (rho * rho));
    double q_a = c2 * (2 / at_rest - 1) / at_rest, q_b = c2 * (2 / rho - 1) / rho;
    v_y -= mass * both / (h * h * h) * (1 - along);
    v_r -= mass * slope * (q_a + q_b * along);
    r_v += mass * slope * (1 - along) / at_rest;
  }
  return (struct theory_matrix){3, {{0, 1, 0}, {v_y, 0, v_r}, {0, r_v, 0}}};
}

static bool is_sums(const struct rates *p) {
  return p->mode == OSCILLATING && p->base == REST && p->system != CONTINUUM;
}

/* Of y, v and r; with times in sqrt(H/g). */
static struct theory_matrix system_of(const struct rates *p, double k) {
  if (is_sums(p)) return sums_of(p, k);
  double complex f = symbol(p, k);
  double g = p->base == REST;
  return (struct theory_matrix){3, {{0, 1, 0}, {0, 0, -(g + p->beta * f)}, {0, -f, 0}}};
}

/* The square of a rate of the system: the growing one is its root. */
static double complex square_of(const struct rates *p, double k) {
  double complex f = symbol(p, k);
  double c2 = p->beta, h = p->spacing;
  if (p->base == UNIFORM) return c2 * f * f;
  if (p->mode == DECAYING || p->system == CONTINUUM) return c2 * f * f + f;
  double s1 = sin(k * h), s2 = pow(sin(k * h / 2), 2), theta = p->depth / c2;
  return -c2 / (h * h) * (s1 * s1 + 8 * theta * s2 * s2) - I * s1 * (2 - cos(k * h)) / h;
}

static double closed(const struct rates *p, double k, double dt) {
  double complex square = square_of(p, k), rate = csqrt(square), z = rate * dt;
  if (p->system == DISCRETE) return log(cabs(1 + z * (1 + z / 2 * (1 + z / 3 * (1 + z / 4))))) / dt;
  if (p->mode == DECAYING) return creal(rate);
  double a = -creal(square); /* without the cancellation of sqrt */
  return p->base == UNIFORM ? 0 : fabs(cimag(square)) / sqrt(2 * (a + cabs(square)));
}

/* What a step of RK4 makes larger: of its three eigenvalues that nearest one belongs to position
 * alone, or to a density that a displacement balances. */
static enum status step_growth(struct theory_matrix z, double dt, double *growth) {
  double complex lambda[THEORY_LARGEST];
  for (int i = 0; i < z.n; i++) /* in steps of dt: y, dt v, r */
    for (int j = 0; j < z.n; j++) z.a[i][j] *= i == 1 ? dt * dt : j == 1 ? 1 : dt;
  struct theory_matrix m = theory_step(&sph_rk4, &z, 0);
  TRY(theory_eigenvalues(&m, lambda));
  int still = 0;
  double radius = 0;
  for (int i = 1; i < m.n; i++)
    if (cabs(lambda[i] - 1) < cabs(lambda[still] - 1)) still = i;
  for (int i = 0; i < m.n; i++)
    if (i != still) radius = fmax(radius, cabs(lambda[i]));
  *growth = log(radius) / dt;
  return OK;
}

/* Growth and the largest magnitude of a rate. */
static enum status eigenvalue(const struct rates *p, double k, double dt, double *growth,
                              double *size) {
  struct theory_matrix z = system_of(p, k);
  double complex lambda[THEORY_LARGEST];
  TRY(theory_eigenvalues(&z, lambda));
  *growth = -INFINITY;
  *size = 0;
  for (int i = 0; i < z.n; i++) {
    *growth = fmax(*growth, creal(lambda[i]));
    *size = fmax(*size, cabs(lambda[i]));
  }
  return p->system == DISCRETE ? step_growth(z, dt, growth) : OK;
}

static double printed(const struct rates *p, double k) {
  double c = sqrt(p->beta), delta = 1 / (2 * p->beta), h = p->spacing;
  if (p->system == DISCRETE) return NAN;
  if (p->mode == OSCILLATING)
    return p->base == UNIFORM ? 0 : p->system == CONTINUUM ? delta / k : 2 * c * delta;
  if (p->system == LATTICE) return p->base == UNIFORM ? c * sinh(k * h) / h : NAN;
  return c * k * sqrt(fmax(1 + (p->base == UNIFORM ? -2 : 2) * delta / k, 0));
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct rates *p = with;
  double *v = curve->value, dt = p->courant * p->spacing / sqrt(p->beta);
  for (int i = 1; i <= p->points; i++) {
    double kh = p->to * i / p->points, k = kh / p->spacing, growth, size;
    TRY(eigenvalue(p, k, dt, &growth, &size));
    double law = closed(p, k, dt), print = printed(p, k);
    TRY(THEORY_ROW(curve, kh, law, growth, print));
    v[OFF] = fmax(v[OFF], fabs(growth - law) / size);
    if (growth > 1e-12 * size && print > 0)
      v[PRINTED_OFF] = fmax(v[PRINTED_OFF], fabs(print / growth - 1));
  }
  return OK;
}

const struct theory_topic theory_rates = {
    .name = "rates",
    .help =
        "growth of modes of a column by closed forms and by eigenvalues, beside what is printed "
        "(T, table 2.4)",
    .params_size = sizeof(struct rates),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
