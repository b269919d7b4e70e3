/* Methods whose stages treat positions, velocities and densities differently.
 *
 * modified-pc: the predictor-corrector with positions to second order, T eqs. (2.256) to (2.258).
 * Where the density follows from positions it is the velocity Verlet method, stable to omega dt =
 * 2; with a density of its own it amplifies sound as predictor-corrector does (2.267).
 *
 * damped-pc: T eqs. (3.36) to (3.45), with zeta = 1 + Gamma dt/2; (3.45) has rho^{n+1} on its left.
 * With the velocity in the middle, u_m = (u0 + u1)/2, (3.39) is u1 = u0 + dt (A_1 - Gamma u_m):
 * what damping takes is dt Gamma sum m u_m^2, to rounding. About rest
 *
 *   |lambda|^2 = (2 zeta - zeta^2 + s^4/4)/zeta^2,  s = omega dt > zeta - 1
 *
 * so that sound is stable to s^2 = 2 sqrt(2 zeta (zeta - 1)), and amplified at any step without
 * damping.
 *
 * stoermer-verlet: kick, drift, kick. A drift takes the velocity in the middle of the step for
 * positions and densities alike, so that a wave of sound is neutral to omega dt = 2. Velocities
 * that drag is taken from are predicted from the middle, for second order. */
#include "sph/time/integrator.h"
#include "sph/time/stages.h"

#include "sph/domain/wall.h"
#include "sph/pair/rates.h"

/* Sums of rates, to be added to what a field was at the start. */
struct terms {
  int n;
  double weight[SPH_MAX_STAGES + 1]; /* s */
  const double *rate[SPH_MAX_STAGES + 1];
};

static void add_term(struct terms *t, double weight, const double *rate) {
  if (weight == 0) return;
  t->weight[t->n] = weight;
  t->rate[t->n++] = rate;
}

static void sum_up(size_t n, double *w, double keep, const double *w0, const struct terms *t) {
#pragma omp parallel for schedule(static)
  for (size_t i = 0; i < n; i++) {
    double sum = 0;
    for (int k = 0; k < t->n; k++) sum += t->weight[k] * t->rate[k][i];
    w[i] = keep * w0[i] + sum;
  }
}

/* One field; `own`, of positions, is the velocity that the row has itself. */
#define SET(field, weights, kept, own_weight, own)                                                 \
  do {                                                                                             \
    struct terms t_ = {0};                                                                         \
    for (int l = 0; l < r; l++) add_term(&t_, dt *(weights)[l], f->k[l].field);                    \
    add_term(&t_, dt *(own_weight), own);                                                          \
    sum_up(f->n, f->w.field, kept, f->w0.field, &t_);                                              \
  } while (0)

/* The state of row r. */
static void set_state(struct sph *s, const struct sph_row *row, int r, double dt) {
  struct sph_particles *f = &s->f;
  SET(u, row->u, row->keep, 0, NULL);
  SET(v, row->u, row->keep, 0, NULL);
  SET(x, row->x, 1, row->own, f->w.u);
  SET(y, row->x, 1, row->own, f->w.v);
  SET(rho, row->rho, 1, 0, NULL);
  sph_particles_pad(f);
  sph_wall_advance(s, row->rho, r, dt);
}

/* Powers that velocities lose with their weights at the end of the step, and diffusion, which
 * densities lose, with theirs. */
static void spend(struct sph_totals *spent, const struct sph_row *end, int r, double dt,
                  const struct sph_totals *t) {
#define X(name, ...) spent->name += dt * end->u[r] * t->name;
  SPH_POWERS(X)
#undef X
  spent->diffusion += dt * (end->rho[r] - end->u[r]) * t->diffusion;
}

/* Energy that damping takes in the step that has just been made, J/m; in the order of particles. */
static double energy_damped(const struct sph *s, double damping) {
  const struct sph_particles *f = &s->f;
  double sum = 0;
  if (damping == 0) return 0;
  for (size_t i = 0; i < f->n; i++) {
    const double u = (f->w0.u[i] + f->w.u[i]) / 2, v = (f->w0.v[i] + f->w.v[i]) / 2;
    sum += f->m[i] * (u * u + v * v);
  }
  return damping * sum;
}

static double elapsed(const struct sph_row *row, int r) {
  double sum = row->own;
  for (int l = 0; l < r; l++) sum += row->x[l];
  return sum;
}

static enum status step(struct sph *s, const struct sph_integrator *method, double dt,
                        struct sph_totals *spent, bool *held) {
  const double damping = method->damps ? dt * sph_damping(s) : 0;
  const struct sph_stages stages = sph_stages_of(method, damping);
  const struct sph_row *end = &stages.row[stages.n];
  spend(spent, end, 0, dt, &s->totals);
  for (int r = 1; r < stages.n; r++) {
    set_state(s, &stages.row[r], r, dt);
    const double later = elapsed(&stages.row[r], r) * dt;
    *held = sph_lists_hold(s, later);
    if (!*held) return OK;
    sph_tank_set(s, s->t + later);
    TRY(sph_rates(s, r, true, false));
    spend(spent, end, r, dt, &s->totals);
  }
  set_state(s, end, stages.n, dt);
  spent->damping += energy_damped(s, damping);
  return OK;
}

static struct sph_stages modified_stages(double damping) {
  (void)damping;
  return (struct sph_stages){
      2,
      {{.keep = 1},
       {.keep = 1, .own = 1. / 2, .x = {1. / 2}, .u = {1}, .rho = {1}},
       {.keep = 1, .x = {1. / 2, 1. / 2}, .u = {1. / 2, 1. / 2}, .rho = {1. / 2, 1. / 2}}}};
}
const struct sph_integrator sph_modified_pc = {
    .order = 2, .evaluations = 2, .diffusive = 2 / 2.785, .stages = modified_stages, .step = step};

static struct sph_stages damped_stages(double damping) {
  const double zeta = 1 + damping / 2;
  return (struct sph_stages){
      2,
      {{.keep = 1},
       {.keep = 1 / zeta, .x = {1. / 2}, .u = {1 / (2 * zeta)}, .rho = {1. / 2}},
       {.keep = 2 / zeta - 1, .x = {0, 1}, .u = {0, 1 / zeta}, .rho = {0, 1}}}};
}
const struct sph_integrator sph_damped_pc = {.order = 2,
                                             .evaluations = 2,
                                             .diffusive = 2 / 2.785,
                                             .damps = true,
                                             .stages = damped_stages,
                                             .step = step};

static struct sph_stages verlet_stages(double damping) {
  (void)damping;
  return (struct sph_stages){3,
                             {{.keep = 1},
                              {.keep = 1, .own = 1. / 2, .u = {1. / 2}, .rho = {1. / 2}},
                              {.keep = 1, .x = {0, 1}, .u = {1. / 2, 1. / 2}, .rho = {0, 1}},
                              {.keep = 1, .x = {0, 1}, .u = {1. / 2, 0, 1. / 2}, .rho = {0, 1}}}};
}
const struct sph_integrator sph_stoermer_verlet = {.order = 2,
                                                   .evaluations = 3,
                                                   .acoustic = 2 / 2.828,
                                                   .diffusive = 2 / 2.785,
                                                   .stages = verlet_stages,
                                                   .step = step};
