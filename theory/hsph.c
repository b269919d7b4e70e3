/* hSPH (T, section 4.2) on rows of particles at rest, its linear equations (sph/theory/rows.h), a
 * deep Airy wave of length L on rows h = L/`rows` apart in steps of h/c, projected on the wave
 * every so many of them: how far rows are off theory in u, v, dynamic pressure and acceleration, at
 * their worst within so many periods, over the amplitude there, any particle of the row or the
 * first; and how fast waves of any whole number to L grow that are not projected. Lengths in L,
 * times in sqrt(L/g). */
#include <math.h>
#include <stdlib.h>

#include "sph/theory/rows.h"
#include "theory/theory.h"

static const char *const surface_names[] = {"kept", "natural", NULL};
static const char *const surface_helps[] = {"p = 0 on the first row", "nothing is kept there"};

static const char *const particle_names[] = {"any", "first", NULL};
static const char *const particle_helps[] = {"the worst of a row at each instant",
                                             "that at x = h/2"};

struct hsph {
  double radius, beta, periods;
  int rows, surface, particle, every, waves;
};

static const struct param params[] = {
    THEORY_INT(hsph, rows, 8, SPH_ROWS_MOST, "16", "L/h"),
    THEORY_REAL(hsph, radius, 1.5, SPH_ROWS_REACH, "1.5, 3", "of the support, h"),
    THEORY_CHOICE(hsph, surface, surface_names, surface_helps, "kept", "what is done there"),
    THEORY_CHOICE(hsph, particle, particle_names, particle_helps, "any", "whose errors are taken"),
    THEORY_REAL(hsph, beta, 1, 1000, "10", "c^2/(g L)"),
    THEORY_INT(hsph, every, 0, 100000, "15", "steps between two projections; 0: none"),
    THEORY_INT(hsph, waves, 0, SPH_ROWS_MOST / 2, "32",
               "the most to L whose growth is looked for, up to L/(2h)"),
    THEORY_REAL(hsph, periods, 0.5, 20, "1", "how long"),
};
static const struct theory_column columns[] = {
    {.key = "depth", .unit = "L", .label = "|y|/L", .help = "of the row"},
    {.key = "u",
     .unit = "1",
     .label = "u",
     .axis = "largest error over the amplitude",
     .log = true,
     .help = "largest error of the velocity along x, over its amplitude there"},
    {.key = "v", .unit = "1", .label = "v", .help = "the same along y"},
    {.key = "p",
     .unit = "1",
     .label = "p_d",
     .axis = "largest error over the amplitude",
     .log = true,
     .panel = 1,
     .help = "the same of the dynamic pressure"},
    {.key = "a_x",
     .unit = "1",
     .label = "a_x",
     .panel = 1,
     .help = "the same of the acceleration along x"},
    {.key = "a_y", .unit = "1", .label = "a_y", .panel = 1, .help = "the same along y"},
    {.key = "rate",
     .unit = "1",
     .label = "dp_d/dt",
     .panel = 1,
     .help = "the same of the rate of p_d"},
};
enum { FREQUENCY, FITTED, AMPLITUDE, GROWTH, WAVES };
static const struct theory_value values[] = {
    [FREQUENCY] = {"frequency", "sqrt(g k)", "of the wave in all rows: its mean"},
    [FITTED] = {"fitted", "sqrt(g k)",
                "of the sine nearest to u of the first row; none unless it is between 0.5 and 1.5"},
    [AMPLITUDE] = {"amplitude", "1", "of the wave at the end over that of the start"},
    [GROWTH] = {"growth", "sqrt(g/L)", "the fastest of any wave, without projection"},
    [WAVES] = {"waves", "1", "how many to L these are"},
};

enum { G = 1 };

static struct sph_rows rows_of(const struct hsph *p, int waves) {
  return sph_rows_at_rest(p->rows, 2 * M_PI * waves, G, p->beta * G, p->radius, !p->surface);
}

static void note(const struct hsph *p, const struct sph_rows *l, double t,
                 double (*most)[SPH_ROWS_QUANTITIES]) {
  const double complex first = cexp(I * l->k * l->h / 2);
  struct sph_rows_state rates;
  double complex off[SPH_ROWS_QUANTITIES];
  sph_rows_rates(l, &l->w, &rates);
  for (int row = 0; row < l->n; row++) {
    sph_rows_off(l, &rates, t, row, off);
    for (int q = 0; q < SPH_ROWS_QUANTITIES; q++)
      most[row][q] = fmax(most[row][q], p->particle ? fabs(creal(off[q] * first)) : cabs(off[q]));
  }
}

/* sum u e^(i w t), largest for the sine nearest to u. */
static double nearness(const double complex *u, int n, double w_dt) {
  double complex sum = 0;
  for (int i = 0; i < n; i++) sum += u[i] * cexp(I * w_dt * i);
  return cabs(sum);
}

/* Of samples w0_dt apart, over w0, looked for from 0 to 2, to 1e-6. NaN unless it is between 0.5
 * and 1.5, the wave's: what is nearest there otherwise is a side lobe of something else. */
static double fitted(const double complex *u, int n, double w0_dt) {
  double at = 0, step = 0.02, most = 0;
  for (int k = 0; k <= 100; k++) {
    const double near = nearness(u, n, w0_dt * 0.02 * k);
    if (near <= most) continue;
    most = near;
    at = 0.02 * k;
  }
  for (; step > 5e-7; step /= 2)
    for (int side = -1; side <= 1; side += 2) {
      const double near = nearness(u, n, w0_dt * (at + side * step));
      if (near <= most) continue;
      most = near;
      at += side * step;
    }
  return at > 0.5 && at < 1.5 ? at : NAN;
}

static enum status follow(const struct hsph *p, struct theory_curve *curve) {
  struct sph_rows l = rows_of(p, 1);
  double most[SPH_ROWS_MOST][SPH_ROWS_QUANTITIES] = {{0}};
  sph_rows_airy(&l);
  const double complex start = sph_rows_wave(&l);
  const double omega = sqrt(G * l.k), dt = l.h / sqrt(l.c2), end = p->periods * 2 * M_PI / omega;
  double complex last = start;
  double turned = 0;
  const int steps = (int)(end / dt);
  double complex *u = malloc((size_t)steps * sizeof *u);
  CHECK(u, ERR_MEMORY, "not enough memory for %d steps", steps);
  for (int step = 0; step < steps; step++) {
    if (step > 0 && p->every > 0 && step % p->every == 0) sph_rows_project(&l, true, true);
    note(p, &l, step * dt, most);
    u[step] = l.w.u[0];
    sph_rows_step(&l, dt);
    const double complex now = sph_rows_wave(&l);
    turned -= carg(now / last);
    last = now;
  }
  curve->value[FREQUENCY] = turned / (omega * steps * dt);
  curve->value[FITTED] = fitted(u, steps, omega * dt);
  curve->value[AMPLITUDE] = cabs(last) / cabs(start);
  free(u);
  for (int row = 0; row < l.n; row++)
    TRY(THEORY_ROW(curve, row * l.h, most[row][SPH_ROWS_U], most[row][SPH_ROWS_V],
                   most[row][SPH_ROWS_P], most[row][SPH_ROWS_AX], most[row][SPH_ROWS_AY],
                   most[row][SPH_ROWS_RATE]));
  return OK;
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct hsph *p = with;
  double growth;
  TRY(follow(p, curve));
  for (int waves = 1; waves <= p->rows / 2 && waves <= p->waves; waves++) {
    const struct sph_rows l = rows_of(p, waves);
    TRY(sph_rows_growth(&l, &growth));
    if (growth <= curve->value[GROWTH]) continue;
    curve->value[GROWTH] = growth;
    curve->value[WAVES] = waves;
  }
  return OK;
}

const struct theory_topic theory_hsph = {
    .name = "hsph",
    .help = "an Airy wave by hSPH on rows at rest: errors, frequency, growth (T, section 4.2)",
    .params_size = sizeof(struct hsph),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
