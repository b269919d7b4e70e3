/* Rows of an undisturbed square lattice below a flat surface, pressure hydrostatic and zero at the
 * surface (T, section 2.5.6, figure 2-24, eqs 2.157-2.170, 3.17; P, eqs 3, 4, 8-10). Row j lies
 * `offset` + j spacings deep. What the sums over its incomplete supports give:
 *
 *     fill, slope, slope_x       sum V W; -sum V dW/dy, -sum V dW/dx, in 1/dx
 *     variable, plus, minus      dv/dt over g by (2.12), by the sum P_b + P_a (4.40, 3.16) and by
 *                                the difference (3.16); 0 is rest
 *     molteni, ferrari, antuono  the diffusive term on the hydrostatic density, rho0 g/(c^2 dx)
 *     gradient_x, gradient_y     sum V x dW/dx and sum V y dW/dy: of u_x and v_y in drho/dt
 *                                (2.163), and of P_x and P_y (2.159, 2.160)
 *     gradient_cross             the larger of sum V x dW/dy and sum V y dW/dx: of v_x and u_y
 *     slope_integral             -int dW/dy over the half-plane below a point of the surface, int
 *                                W(x, 0) dx, in 1/dx, which takes the place of slope in (2.165)
 *
 * Accelerations take the water's own density with depth, e^(-2 delta y), where `stratification`
 * says how much it changes, and masses rho dx^2; without it, P = -rho0 g y and one density.
 *
 * (2.157) and (2.163) silently use differences of velocity; a row of velocity v itself has besides
 * v sum V dW/dy. */
#include <math.h>

#include "sph/theory/lattice.h"
#include "theory/kernels.h"
#include "theory/theory.h"

struct surface {
  double ratio, offset, stratification;
  int kernel, rows;
};

static const struct param params[] = {
    THEORY_CHOICE(surface, kernel, theory_kernel_names, NULL, "gaussian", "the kernel"),
    THEORY_REAL(surface, ratio, 0.5, 4, "1.3333333333333333", "h/dx"),
    THEORY_REAL(surface, offset, 0, 1, "0.5", "depth of the top row, dx"),
    THEORY_INT(surface, rows, 1, 100, "6", "how many"),
    THEORY_REAL(surface, stratification, 0, 1, "0", "g dx/c^2, of the accelerations"),
};
static const struct theory_column columns[] = {
    {.key = "row", .unit = "1", .label = "row", .help = "row, from the top"},
    {.key = "fill", .unit = "1", .label = "Σ V W", .help = "sum V W", .points = true},
    {.key = "slope",
     .unit = "1/dx",
     .label = "Δx |Σ V ∇W|",
     .help = "-sum V dW/dy",
     .points = true},
    {.key = "variable",
     .unit = "g",
     .label = "P_b (2.12)",
     .axis = "dv/dt / g",
     .level = "0",
     .help = "acceleration by (2.12)",
     .panel = 1,
     .points = true},
    {.key = "plus",
     .unit = "g",
     .label = "P_b + P_a (4.40)",
     .help = "by (3.16) with plus, (4.40)",
     .panel = 1,
     .points = true},
    {.key = "minus",
     .unit = "g",
     .label = "P_b − P_a (3.16)",
     .help = "by (3.16) with minus",
     .panel = 1,
     .points = true},
    {.key = "molteni",
     .unit = "rho0 g/(c^2 dx)",
     .label = "Molteni",
     .axis = "D c^2 Δx/(ρ_0 g)",
     .level = "0",
     .help = "P (7)",
     .panel = 2,
     .points = true},
    {.key = "ferrari",
     .unit = "rho0 g/(c^2 dx)",
     .label = "Ferrari",
     .help = "P (10)",
     .panel = 2,
     .points = true},
    {.key = "antuono",
     .unit = "rho0 g/(c^2 dx)",
     .label = "Antuono",
     .help = "P (9)",
     .panel = 2,
     .points = true},
    {.key = "gradient_x",
     .unit = "1",
     .label = "Σ V x ∂W/∂x",
     .help = "sum V x dW/dx",
     .undrawn = true},
    {.key = "gradient_y",
     .unit = "1",
     .label = "Σ V y ∂W/∂y",
     .help = "sum V y dW/dy",
     .undrawn = true},
    {.key = "gradient_cross",
     .unit = "1",
     .label = "Σ V x ∂W/∂y",
     .help = "the larger of |sum V x dW/dy| and |sum V y dW/dx|",
     .undrawn = true},
    {.key = "slope_x",
     .unit = "1/dx",
     .label = "−Δx Σ V ∂W/∂x",
     .help = "-sum V dW/dx: 0 by symmetry",
     .undrawn = true},
    {.key = "symmetric",
     .unit = "g",
     .label = "(2.15)",
     .help = "acceleration by (2.15), P_a/rho_a^2 + P_b/rho_b^2",
     .undrawn = true},
};
enum { SLOPE_INTEGRAL };
static const struct theory_value values[] = {
    [SLOPE_INTEGRAL] = {"slope_integral", "1/dx", "slope of a half-plane without particles"},
};

/* Of the particle that has `above` rows above it; lengths in h. */
struct sums {
  double W, gx, gy, xgx, ygy, xgy, ygx, ye, yqe, yye;
};

static struct sums sum(const struct sph_lattice *l, int above) {
  struct sums s = {0};
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++) {
    if (a->j > above) continue;
    s.W += a->W;
    s.gx += a->gx;
    s.gy += a->gy;
    s.xgx += a->x * a->gx;
    s.ygy += a->y * a->gy;
    s.xgy += a->x * a->gy;
    s.ygx += a->y * a->gx;
    s.ye += a->y * a->e;
    s.yqe += a->y * sqrt(a->q2) * a->e;
    s.yye += a->y * a->y * a->e;
  }
  return s;
}

/* The renormalised gradient of y in a row: 1, of any neighbours. */
static double gradient(const struct sph_lattice *l, int above) {
  struct sums s = sum(l, above);
  double found = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++)
    if (a->j <= above) found += a->y * (a->y * a->e);
  return found / s.yye;
}

/* sum slope V psi of Antuono's term for a density y. */
static double antuono(const struct sph_lattice *l, int above) {
  double own = gradient(l, above), d = 0;
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++)
    if (a->j <= above) d += a->e * (a->y - 0.5 * (gradient(l, above - a->j) + own) * a->y);
  return d;
}

/* Density over rho0 and pressure over rho0 g h at a depth in dx. */
static double density(const struct surface *p, double depth) {
  return exp(p->stratification * depth);
}

static double pressure(const struct surface *p, double depth) {
  double s = p->stratification;
  return (s > 0 ? expm1(s * depth) / s : depth) / p->ratio;
}

/* dv/dt over g of a row. */
struct accelerations {
  double variable, plus, minus, symmetric;
};

static struct accelerations accelerate(const struct surface *p, const struct sph_lattice *l,
                                       int row) {
  struct accelerations v = {-1, -1, -1, -1};
  double depth = p->offset + row, rho = density(p, depth), P = pressure(p, depth);
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++) {
    if (a->j > row) continue;
    double rho_b = density(p, depth - a->j), P_b = pressure(p, depth - a->j);
    v.variable -= P_b * a->gy / rho;
    v.plus -= (P_b + P) * a->gy / rho;
    v.minus -= (P_b - P) * a->gy / rho;
    v.symmetric -= rho_b * (P / (rho * rho) + P_b / (rho_b * rho_b)) * a->gy;
  }
  return v;
}

/* By the trapezium rule on the finest lattice there is: to 1e-4. */
static double slope_integral(const struct surface *p) {
  struct sph_lattice fine;
  double ratio = 4, sum = 0;
  sph_lattice_of((enum sph_kernel)p->kernel, ratio, &fine);
  for (const struct sph_neighbour *a = fine.near; a < fine.near + fine.n; a++)
    if (a->j == 0) sum += a->W * ratio; /* W V = W dx^2 */
  return sum / p->ratio;
}

static enum status row_add(const struct surface *p, const struct sph_lattice *l, int row,
                           struct theory_curve *curve) {
  struct sums s = sum(l, row);
  struct accelerations v = accelerate(p, l, row);
  double dx = 1 / p->ratio; /* h */
  double per = -2 * dx;     /* of 2 sum psi slope V, psi = -y, in rho0 g/(c^2 dx) */
  return THEORY_ROW(curve, row, s.W, -s.gy * dx, v.variable, v.plus, v.minus, per * s.ye,
                    per * s.yqe / 2, per * antuono(l, row), s.xgx, s.ygy,
                    fmax(fabs(s.xgy), fabs(s.ygx)), -s.gx * dx, v.symmetric);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct surface *p = with;
  struct sph_lattice l;
  sph_lattice_of((enum sph_kernel)p->kernel, p->ratio, &l);
  for (int row = 0; row < p->rows; row++) TRY(row_add(p, &l, row, curve));
  curve->value[SLOPE_INTEGRAL] = slope_integral(p);
  return OK;
}

const struct theory_topic theory_surface = {
    .name = "surface",
    .help = "what incomplete supports do to rest in the rows below a surface (T, eqs 2.157-2.170, "
            "3.16, 3.17, figure 2-24; P, eqs 3-10)",
    .params_size = sizeof(struct surface),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
