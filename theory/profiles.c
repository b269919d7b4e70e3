/* Profiles of the decaying mode and of acoustic ones over depth (T, tables 2.1 to 2.3, figures 2-7
 * to 2-9): amplitudes of u, v and P_d/rho over phases i, 1, i (unit potential), 1, -i, 1 (unit
 * elevation or pressure), for a potential C psi:
 *     u = kappa C psi,  v = C psi',  P_d/rho = omega C psi,  eta = omega C psi(0)/g
 * `table` takes psi_-1 = e^(kappa y) with omega = sqrt(g kappa), and for n >> 1
 * psi_n = sin nu y + (2 delta/nu) cos nu y, nu = (2 n + 1) pi/2, omega = c nu, which needs
 * delta H << 1; `exact` the modes of the stratified tank. T's table 2.3 prints eta = 1/(c^1 nu) for
 * 1/(c^2 nu). Units: g = H = 1. */
#include <math.h>

#include "theory/modes.h"
#include "theory/theory.h"

static const char *const unit_names[] = {"potential", "elevation", "pressure", NULL};
static const char *const unit_helps[] = {"table 2.1", "table 2.2 (2.65)", "table 2.3"};
enum { POTENTIAL, ELEVATION, PRESSURE };
static const char *const layer_names[] = {"table", "exact", NULL};
static const char *const layer_helps[] = {"as T's tables have it", "modes of the stratified tank"};

struct profiles {
  double sound, kappa;
  int mode, unit, layer, points;
};

static const struct param params[] = {
    THEORY_INT(profiles, mode, -1, 10000, "-1, 10", "-1: the decaying mode; n: an acoustic one"),
    THEORY_REAL(profiles, sound, PARAM_ABOVE_0, 1e6, "1, 2, 5", "c/sqrt(g H)"),
    THEORY_REAL(profiles, kappa, PARAM_ABOVE_0, 1e4, "6.283185307179586",
                "horizontal wavenumber times H"),
    THEORY_CHOICE(profiles, unit, unit_names, unit_helps, "elevation", "what has amplitude 1"),
    THEORY_CHOICE(profiles, layer, layer_names, layer_helps, "table", "which modes"),
    THEORY_POINTS(profiles),
};
static const struct theory_column columns[] = {
    {.key = "y", .unit = "H", .label = "y/H", .help = "height above the surface"},
    {.key = "u",
     .unit = "1",
     .label = "u",
     .level = "0",
     .help = "amplitude of the horizontal velocity"},
    {.key = "v",
     .unit = "1",
     .label = "v",
     .level = "0",
     .help = "of the vertical velocity",
     .panel = 1},
    {.key = "pressure",
     .unit = "1",
     .label = "P_d/ρ",
     .level = "0",
     .panel = 2,
     .help = "of the dynamic pressure over density"},
    {.key = "potential",
     .unit = "1",
     .label = "φ",
     .undrawn = true,
     .help = "of the velocity potential"},
};
enum { WAVENUMBER, OMEGA, ETA, U0, V0, P0, PSI0, SCALE, U_MOST, P_MOST };
static const struct theory_value values[] = {
    [WAVENUMBER] = {"vertical", "1/H", "vertical wavenumber, nu or mu"},
    [OMEGA] = {"omega", "sqrt(g/H)", "frequency"},
    [ETA] = {"eta", "1", "amplitude of the elevation"},
    [U0] = {"u_surface", "1", "u at the surface"},
    [V0] = {"v_surface", "1", "v at the surface"},
    [P0] = {"pressure_surface", "1", "P_d/rho at the surface"},
    [PSI0] = {"psi_surface", "1", "psi at the surface"},
    [SCALE] = {"scale", "1", "C of the potential C psi"},
    [U_MOST] = {"u_most", "1", "largest |u| over depth"},
    [P_MOST] = {"pressure_most", "1", "largest |P_d/rho| over depth"},
};

/* A mode with its profile. */
struct shape {
  const struct profiles *p;
  struct theory_mode mode;
  bool table; /* acoustic, without e^(delta y) */
  double nu, share, omega;
};

static double psi(const struct shape *s, double y) {
  if (s->table) return sin(s->nu * y) + s->share * cos(s->nu * y);
  return theory_mode_psi(&s->mode, y);
}

static double slope(double y, const void *with) {
  const struct shape *s = with;
  double delta = s->mode.exact.delta;
  if (s->table) /* of e^(delta y) psi with e^(delta y) = 1 */
    return (delta - s->nu * s->share) * sin(s->nu * y) +
           (delta * s->share + s->nu) * cos(s->nu * y);
  return theory_mode_slope(&s->mode, y);
}

static enum status shape_find(const struct profiles *p, struct shape *s) {
  enum theory_profile profile = p->layer ? THEORY_EXACT : THEORY_LEADING;
  double c = p->sound;
  *s = (struct shape){.p = p, .table = !p->layer && p->mode >= 0};
  TRY(theory_mode_find(c * c, p->kappa, p->mode, profile, &s->mode));
  s->nu = s->mode.exact.root;
  s->omega = s->table ? c * s->nu : s->mode.exact.omega;
  s->share = s->table ? 2 * s->mode.exact.delta / s->nu : 0;
  return OK;
}

/* C of the potential. */
static double scale_of(const struct shape *s) {
  switch (s->p->unit) {
  case ELEVATION:
    return 1 / (s->omega * psi(s, 0));
  case PRESSURE:
    return 1 / s->omega;
  default:
    return 1;
  }
}

/* The first antinode of an acoustic mode below the surface, within half a wavelength: psi' is
 * (nu + d s) cos nu y - (nu s - d) sin nu y times e^(d y), in the table with d = 0. */
static double antinode(const struct shape *s) {
  const double d = s->table ? 0 : s->mode.exact.delta, part = s->table ? s->share : s->mode.exact.s;
  return atan2(-(s->nu + d * part), d - s->nu * part) / s->nu;
}

/* The largest |psi|: at the surface, at the bed, or at the first antinode, unless that lies below
 * the bed; deeper ones are no larger. */
static double largest(const struct shape *s) {
  double most = fmax(fabs(psi(s, 0)), fabs(psi(s, -1)));
  if (s->p->mode < 0 || antinode(s) < -1) return most;
  return fmax(most, fabs(psi(s, antinode(s))));
}

/* Table 2.2 leaves delta s nu out of v beside nu: (delta sin - nu cos). */
static double v_of(const struct shape *s, double y) {
  if (!s->table || s->p->unit == POTENTIAL) return slope(y, s);
  return s->nu * cos(s->nu * y) - s->mode.exact.delta * sin(s->nu * y);
}

static enum status evaluate(const void *with, struct theory_curve *curve) {
  const struct profiles *p = with;
  struct shape s;
  TRY(shape_find(p, &s));
  double scale = scale_of(&s), *v = curve->value, most = largest(&s);
  for (int i = 0; i < p->points; i++) {
    double y = theory_between(-1, 0, i, p->points), at = psi(&s, y);
    TRY(THEORY_ROW(curve, y, p->kappa * scale * at, scale * v_of(&s, y), s.omega * scale * at,
                   scale * at));
  }
  v[WAVENUMBER] = p->mode < 0 && !p->layer ? p->kappa : s.nu;
  v[OMEGA] = s.omega;
  v[ETA] = s.omega * scale * psi(&s, 0);
  v[U0] = p->kappa * scale * psi(&s, 0);
  v[V0] = scale * v_of(&s, 0);
  v[P0] = s.omega * scale * psi(&s, 0);
  v[PSI0] = psi(&s, 0);
  v[SCALE] = scale;
  v[U_MOST] = p->kappa * scale * most;
  v[P_MOST] = s.omega * scale * most;
  return OK;
}

const struct theory_topic theory_profiles = {
    .name = "profiles",
    .help = "velocities and pressure of the decaying and of acoustic modes over depth (T, tables "
            "2.1-2.3, figures 2-7 to 2-9)",
    .params_size = sizeof(struct profiles),
    THEORY_TABLES,
    THEORY_VALUES,
    .evaluate = evaluate,
};
