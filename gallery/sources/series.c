/* Series that runs have in their files, without dimensions. */
#include <math.h>
#include <string.h>

#include "gallery/desk.h"
#include "gallery/source.h"

struct series_source {
  char *run, *series;
  int what;
};

/* ---- scales of a file ---- */

struct scales {
  double T, p, E; /* sqrt(H/g) s, rho g H Pa, rho g H^3 J/m */
};
static struct scales scales_of(const struct result_file *f) {
  return (struct scales){sqrt(f->H / f->g), f->density * f->g * f->H,
                         f->density * f->g * pow(f->H, 3)};
}

static enum status add_all(struct gallery_curve *curve, size_t n, const double *t,
                           const double *value, double T, double unit) {
  for (size_t i = 0; i < n; i++) TRY(gallery_curve_add(curve, t[i] / T, value[i] / unit));
  return OK;
}

static const struct result_series *find(const struct result_series *s, size_t n,
                                        const char *name) {
  for (size_t i = 0; i < n; i++)
    if (!strcmp(s[i].name, name)) return &s[i];
  return NULL;
}

static enum status missing(const char *what, const char *name, const char *run) {
  return status_raise(ERR_INPUT, "run %s has no %s '%s'", run, what, name);
}

/* ---- energy ---- */

#define ENERGIES(X)                                                                                \
  X(mechanical) X(kinetic) X(potential) X(internal) X(total) X(removed) X(budget)
#define X(name) #name,
static const char *const energy_names[] = {ENERGIES(X) NULL};
#undef X
enum energy {
#define X(name) ENERGY_##name,
  ENERGIES(X)
#undef X
};

static double energy_of(const struct result_energy *e, enum energy what) {
  switch (what) {
  case ENERGY_mechanical: return e->kinetic + e->potential;
  case ENERGY_kinetic: return e->kinetic;
  case ENERGY_potential: return e->potential;
  case ENERGY_internal: return e->internal;
  case ENERGY_total: return e->total;
  case ENERGY_removed: return e->removed;
  case ENERGY_budget: return result_energy_budget(e);
  }
  return NAN;
}

static enum status energy(struct gallery_desk *desk, const void *with,
                          struct gallery_curve *curve) {
  const struct series_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  const struct scales u = scales_of(f);
  for (size_t i = 0; i < f->n_energy; i++) {
    const enum energy what = (enum energy)s->what;
    const bool rests = what == ENERGY_mechanical || what == ENERGY_potential;
    const double rest = rests && isfinite(f->rest_potential) ? f->rest_potential : 0;
    TRY(gallery_curve_add(curve, f->energy[i].time / u.T,
                          (energy_of(&f->energy[i], what) - rest) / u.E));
  }
  return OK;
}

static const struct param energy_params[] = {
    SOURCE_RUN(series_source),
    SOURCE_CHOICE(series_source, what, energy_names, "mechanical",
                  "which; mechanical and potential are above those of the water at rest"),
};

/* ---- probes, gauges, diagnostics, points ---- */

static enum status probe(struct gallery_desk *desk, const void *with,
                         struct gallery_curve *curve) {
  const struct series_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  const struct result_series *p = find(f->probes, f->n_probes, s->series);
  if (!p) return missing("probe", s->series, s->run);
  return add_all(curve, p->n, p->t, p->value, scales_of(f).T, scales_of(f).p);
}

static enum status gauge(struct gallery_desk *desk, const void *with,
                         struct gallery_curve *curve) {
  const struct series_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  const struct result_series *g = find(f->gauges, f->n_gauges, s->series);
  if (!g) return missing("gauge", s->series, s->run);
  return add_all(curve, g->n, g->t, g->value, scales_of(f).T, f->H);
}

static enum status diagnostic(struct gallery_desk *desk, const void *with,
                              struct gallery_curve *curve) {
  const struct series_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  const struct result_series *d = find(f->diagnostics, f->n_diagnostics, s->series);
  if (!d) return missing("diagnostic", s->series, s->run);
  return add_all(curve, d->n, d->t, d->value, scales_of(f).T, 1);
}

/* What a field of a point is divided by. */
static double point_unit(const struct result_file *f, const char *field) {
  if (!strcmp(field, "p")) return scales_of(f).p;
  if (!strcmp(field, "rho")) return f->density;
  if (!strcmp(field, "u") || !strcmp(field, "v")) return sqrt(f->g * f->H);
  return !strncmp(field, "a_", 2) ? f->g : 1;
}

static const char *const point_fields[] = {
#define X(field, ...) #field,
    CASE_POINT(X)
#undef X
};

static enum status point(struct gallery_desk *desk, const void *with,
                         struct gallery_curve *curve) {
  const struct series_source *s = with;
  const struct result_file *f;
  TRY(gallery_desk_result(desk, s->run, &f));
  const char *dot = strrchr(s->series, '.');
  const size_t length = dot ? (size_t)(dot - s->series) : 0;
  for (size_t i = 0; i < f->n_points && dot; i++) {
    const struct result_point_read *p = &f->points[i];
    if (strlen(p->name) != length || strncmp(p->name, s->series, length)) continue;
    for (size_t k = 0; k < CASE_POINT_FIELDS; k++)
      if (!strcmp(point_fields[k], dot + 1))
        return add_all(curve, p->n, p->t, p->value[k], scales_of(f).T,
                       point_unit(f, point_fields[k]));
  }
  return missing("point and field", s->series, s->run);
}

/* ---- the sources ---- */

#define NAMED(what, text)                                                                          \
  static const struct param what##_params[] = {                                                    \
      SOURCE_RUN(series_source),                                                                   \
      SOURCE_TEXT(series_source, series, NULL, text),                                              \
  };
NAMED(probe, "its name")
NAMED(gauge, "its name")
NAMED(diagnostic, "its name")
NAMED(point, "its name and a field, as in NAME.a_y")

#define SERIES(what, text)                                                                         \
  const struct gallery_source gallery_source_##what = {                                            \
      .name = #what,                                                                               \
      .help = text,                                                                                \
      .params = what##_params,                                                                     \
      .n_params = sizeof what##_params / sizeof *what##_params,                                    \
      .params_size = sizeof(struct series_source),                                                 \
      .evaluate = what,                                                                            \
  };
SERIES(energy, "an energy of a run, rho g H^3, over t")
SERIES(probe, "pressure of a probe of a run, rho g H, over t")
SERIES(gauge, "elevation at a gauge of a run, H, over t")
SERIES(diagnostic, "a diagnostic of a run, as its file has it, over t")
SERIES(point, "a field at a point of a run, over t: p, rho, u, v, a_x, a_y, cover")
