/* Rows of an undisturbed square lattice below a flat surface, pressure hydrostatic and zero at the
 * surface (T, section 2.5.6, figure 2-24, eqs 2.157-2.170, 3.17; P, eqs 3, 4, 8-10). Row j lies
 * `offset` + j spacings deep. What the sums over its incomplete supports give:
 *
 *     fill, slope                sum V W; -dx sum V dW/dy
 *     variable, plus, minus      dv/dt over g by (2.12), by the sum P_b + P_a (4.40, 3.16) and by
 *                                the difference (3.16); 0 is rest
 *     molteni, ferrari, antuono  the diffusive term on the hydrostatic density, rho0 g/(c^2 dx)
 *     gradient_x, gradient_y     sum V x dW/dx and sum V y dW/dy: of u_x and v_y in drho/dt
 *                                (2.163), and of P_x and P_y (2.159, 2.160)
 *
 * (2.157) and (2.163) silently use differences of velocity; a row of velocity v itself has besides
 * v sum V dW/dy. */
#include <math.h>

#include "sph/theory/lattice.h"
#include "theory/kernels.h"
#include "theory/theory.h"

struct surface {
  double ratio, offset;
  int kernel, rows;
};

static const struct param params[] = {
    THEORY_CHOICE(surface, kernel, theory_kernel_names, NULL, "gaussian", "the kernel"),
    THEORY_REAL(surface, ratio, 0.5, 4, "1.3333333333333333", "h/dx"),
    THEORY_REAL(surface, offset, 0, 1, "0.5", "depth of the top row, dx"),
    THEORY_INT(surface, rows, 1, 100, "6", "how many"),
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
};

/* Of the particle that has `above` rows above it; lengths in h. */
struct sums {
  double W, gy, xgx, ygy, ye, yqe, yye;
};

static struct sums sum(const struct sph_lattice *l, int above) {
  struct sums s = {0};
  for (const struct sph_neighbour *a = l->near; a < l->near + l->n; a++) {
    if (a->j > above) continue;
    s.W += a->W;
    s.gy += a->gy;
    s.xgx += a->x * a->gx;
    s.ygy += a->y * a->gy;
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

static enum status row_add(const struct surface *p, const struct sph_lattice *l, int row,
                           struct theory_curve *curve) {
  struct sums s = sum(l, row);
  double dx = 1 / p->ratio, depth = (p->offset + row) * dx; /* h */
  double per = -2 * dx; /* of 2 sum psi slope V, psi = -y, in rho0 g/(c^2 dx) */
  return THEORY_ROW(curve, row, s.W, -s.gy * dx, s.ygy - depth * s.gy - 1,
                    s.ygy - 2 * depth * s.gy - 1, s.ygy - 1, per * s.ye, per * s.yqe / 2,
                    per * antuono(l, row), s.xgx, s.ygy);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct surface *p = with;
  struct sph_lattice l;
  sph_lattice_of((enum sph_kernel)p->kernel, p->ratio, &l);
  for (int row = 0; row < p->rows; row++) TRY(row_add(p, &l, row, curve));
  return OK;
}

const struct theory_topic theory_surface = {
    .name = "surface",
    .help = "what incomplete supports do to rest in the rows below a surface (T, eqs 2.157-2.170, "
            "3.16, 3.17, figure 2-24; P, eqs 3-10)",
    .params_size = sizeof(struct surface),
    THEORY_TABLES,
    .evaluate = evaluate,
};
