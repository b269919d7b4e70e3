#include "sph/time/integrator.h"

#include <math.h>

#include "sph/domain/wall.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/forms.h"
#include "sph/pair/rates.h"

const struct sph_integrator *const sph_integrators[] = {
#define X(variant, name, help) &sph_##variant,
    SPH_INTEGRATORS(X)
#undef X
};
const char *const sph_integrator_names[] = {
#define X(variant, name, help) name,
    SPH_INTEGRATORS(X)
#undef X
        "auto",
    NULL};
const char *const sph_integrator_helps[] = {
#define X(variant, name, help) help,
    SPH_INTEGRATORS(X)
#undef X
        "rk4-split with a diffusion that frozen needs shorter steps, else rk4-frozen"};

int sph_integrator_chosen(const struct sph_scheme *o) {
  if (o->integrator != SPH_INTEGRATOR_AUTO) return o->integrator;
  return diffusion_frozen((enum sph_diffusion)o->diffusion) < 1 ? SPH_INTEGRATOR_rk4_split
                                                                : SPH_INTEGRATOR_rk4_frozen;
}

double sph_damping(const struct sph *s) {
  const double end = s->scheme.damping_end;
  return end == 0 || s->t < end * (1 - 1e-9) ? s->scheme.damping : 0;
}

static void copy_state(size_t n, const struct sph_state *to, const struct sph_state *from) {
#pragma omp parallel for simd schedule(static)
  for (size_t i = 0; i < n; i++) {
#define X(q, unit, help) to->q[i] = from->q[i];
    SPH_EVOLVING(X)
#undef X
  }
}

/* Names the particle that goes farthest. */
static enum status refuse(const struct sph *s) {
  const struct sph_particles *f = &s->f;
  size_t far = 0;
  double most = 0;
  for (size_t i = 0; i < f->n; i++) {
    double way = hypot(f->w.x[i] - f->w0.x[i], f->w.y[i] - f->w0.y[i]);
    if (way <= most) continue;
    most = way;
    far = i;
  }
  char advice[SPH_ADVICE];
  sph_forms_advise(s, advice);
  return status_raise(ERR_DIVERGED,
                      "particle %u at (%g, %g) m moves %.3g particle spacings within a step at t = "
                      "%g s: %s",
                      f->id[far], f->w0.x[far], f->w0.y[far], most / s->dx, s->t, advice);
}

/* From the usual skin to the widest one (sph.c) it takes six. */
enum { MOST_ATTEMPTS = 7 };

/* Back to the start of the step, with lists that hold for longer ways. */
static enum status start_again(struct sph *s, int attempt) {
  enum status status = attempt > MOST_ATTEMPTS ? refuse(s) : OK;
  copy_state(s->f.n, &s->f.w, &s->f.w0);
  sph_particles_pad(&s->f);
  sph_wall_advance(s, NULL, 0, 0);
  TRY(status);
  sph_tank_set(s, s->t);
  TRY(sph_neighbours_widen(s));
  TRY(sph_rates(s, 0, true, false));
  copy_state(s->f.n, &s->f.w0, &s->f.w); /* in their new places */
  return OK;
}

enum status sph_step(struct sph *s, double dt) {
  const struct sph_integrator *method = sph_integrators[s->scheme.integrator];
  struct sph_totals spent;
  bool held = false;
  copy_state(s->f.n, &s->f.w0, &s->f.w);
  sph_wall_begin(s);
  for (int attempt = 1; !held; attempt++) {
    if (attempt > 1) TRY(start_again(s, attempt));
    spent = (struct sph_totals){0};
    held = true;
    TRY(method->step(s, method, dt, &spent, &held));
  }
  s->again = false;
#define X(name, ...) s->budget.name += spent.name;
  SPH_SPENT(X)
#undef X
  sph_tank_set(s, s->t + dt);
  sph_wall_confine(s);
  s->t += dt;
  s->dt = dt;
  s->steps++;
  return OK;
}
