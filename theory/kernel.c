/* A kernel's sums over an undisturbed square lattice (T, section 2.5; sph/theory/lattice.h), and
 * what they make of a plane wave: the interpolation, the gradient and the diffusive term, beside
 * the kernel's Fourier transform. B of Antuono's term is the coefficient of h^2 k^4 at long waves:
 * <q_x^2>/4 (P, eq. 13) with an exact gradient, three times that with the renormalised one, which
 * is smoothed itself. */
#include <math.h>

#include "sph/theory/lattice.h"
#include "theory/kernels.h"
#include "theory/theory.h"

struct kernel {
  int kernel, diffusion, points;
  double ratio, direction;
};

static const struct param params[] = {
    THEORY_CHOICE(kernel, kernel, theory_kernel_names, NULL, "gaussian, cubic, wendland_c2",
                  "the kernel"),
    THEORY_REAL(kernel, ratio, 0.5, 4, "1.3333333333333333", "h/dx"),
    THEORY_CHOICE(kernel, diffusion, theory_diffusion_names, NULL, "antuono", "the diffusive term"),
    THEORY_REAL(kernel, direction, 0, 45, "0", "of the wave, degrees from a row"),
    THEORY_INT(kernel, points, 2, 10000, "60", "points of each curve"),
};
static const struct theory_column columns[] = {
    {.key = "kdx", .unit = "pi", .label = "k Δx/π", .help = "wavenumber along a row or column"},
    {.key = "interpolation",
     .unit = "1",
     .label = "Σ W V",
     .help = "what interpolation makes of a wave"},
    {.key = "gradient",
     .unit = "1",
     .label = "gradient/k",
     .help = "gradient over that of the wave",
     .panel = 1},
    {.key = "diffusion",
     .unit = "1",
     .label = "h^2 D",
     .help = "decay by the diffusive term, without delta, times h^2",
     .panel = 2},
    {.key = "transform",
     .unit = "1",
     .label = "transform",
     .help = "Fourier transform of the kernel",
     .undrawn = true},
};
enum { NEIGHBOURS, ZEROTH, SECOND, FIRST, B_PAPER, B_LATTICE, SOUND, DECAY };
static const struct theory_value values[] = {
    [NEIGHBOURS] = {"neighbours", "1", "particles within the support, itself included"},
    [ZEROTH] = {"sum_W", "1", "sum V W, 1 in the continuum"},
    [SECOND] = {"sum_x2_W", "h^2", "sum V x^2 W"},
    [FIRST] = {"sum_x_dW", "1", "sum V x dW/dx, 1 in the continuum"},
    [B_PAPER] = {"B", "1", "<q_x^2>/4 in the continuum (P, eq. 13)"},
    [B_LATTICE] = {"B_lattice", "1", "of Antuono's term as it is computed: sum V x^4 slope/4"},
    [SOUND] = {"gradient_most", "1/h", "largest gradient of any wave"},
    [DECAY] = {"diffusion_most", "1/h^2", "largest decay of any wave"},
};

/* Along the direction until the shorter of its steps has turned by pi between particles. */
static void row_of(const struct kernel *p, const struct sph_lattice *l, double share,
                   double row[5]) {
  double angle = p->direction * M_PI / 180, kx = share * M_PI * p->ratio, ky = kx * tan(angle);
  struct sph_symbols s;
  sph_lattice_symbols(l, (enum sph_diffusion)p->diffusion, kx, ky, &s);
  double k = hypot(kx, ky);
  row[0] = share;
  row[1] = s.W;
  row[2] = (s.Gx * kx + s.Gy * ky) / (k * k);
  row[3] = s.D;
  row[4] = sph_kernel_transform((enum sph_kernel)p->kernel, kx, ky);
}

static void values_set(const struct kernel *p, const struct sph_lattice *l, double *v) {
  enum sph_kernel k = (enum sph_kernel)p->kernel;
  v[NEIGHBOURS] = (double)l->n;
  v[ZEROTH] = sph_lattice_moment(l, 0, 0, SPH_LATTICE_REACH);
  v[SECOND] = sph_lattice_moment(l, 2, 0, SPH_LATTICE_REACH);
  v[FIRST] = sph_lattice_gradient_moment(l, 1, 0, SPH_LATTICE_REACH);
  v[B_PAPER] = sph_kernel_slope_moment(k, 4, 0) / 12;
  v[B_LATTICE] = sph_lattice_slope_moment(l, 4, 0, SPH_LATTICE_REACH) / 4;
  sph_lattice_extremes(l, (enum sph_diffusion)p->diffusion, &v[SOUND], &v[DECAY]);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct kernel *p = with;
  struct sph_lattice l;
  double row[5];
  sph_lattice_of((enum sph_kernel)p->kernel, p->ratio, &l);
  for (int i = 1; i <= p->points; i++) {
    row_of(p, &l, (double)i / p->points, row);
    TRY(theory_row_add(curve, 5, row));
  }
  values_set(p, &l, curve->value);
  return OK;
}

const struct theory_topic theory_kernel = {
    .name = "kernel",
    .help = "sums of a kernel over a square lattice, and what they make of waves (T, section 2.5, "
            "eqs 2.104-2.125; P, eq. 13)",
    .params_size = sizeof(struct kernel),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
