#include "library/plunge_result.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/result/result.h"

enum { SURFACES, PARTICLES, ENERGIES, STEPS, CLOCKS };
enum { FIELDS = 5 };

struct plunge_result {
  char *path, *program, *run, *title; /* owned, as all below */
  struct result_about about;
  struct geo_lines walls;
  struct case_probe *probes;
  struct case_gauge *gauges;
  struct solver_term *terms;
  size_t probe_room, gauge_room, term_room;

  struct result *file;                      /* from the first output on */
  double clock[CLOCKS];                     /* last times, s; -INFINITY: none yet */
  double *pressure_clock, *elevation_clock; /* of each probe and gauge */
  int fields;                               /* that the particles have, a bit each; -1: none yet */
  struct geo_lines surface;
  double *column[4]; /* x, y, u, v, [room] */
  size_t room;
  enum status failed;
};

const char *plunge_result_message(void) {
  return status_message();
}

/* Remembers the first failure, and what it says is not done. */
static int answer(plunge_result *r, enum status status) {
  if (r && r->failed == OK) r->failed = status;
  return (int)status;
}

static enum status check_ready(const plunge_result *r) {
  CHECK(r, ERR_INPUT, "%s", *status_message() ? status_message() : "there is no open result");
  return r->failed;
}

static enum status check_undecided(const plunge_result *r, const char *what) {
  TRY(check_ready(r));
  CHECK(!r->file, ERR_INPUT, "%s: %s must be told before the first output", r->path, what);
  return OK;
}

/* ---- before the first output ---- */

static enum status copy_text(const char *text, char **out) {
  char *copy = strdup(text ? text : "");
  CHECK(copy, ERR_MEMORY, "no memory for a name");
  free(*out);
  *out = copy;
  return OK;
}

/* The name of the file without its folder and ending. */
static enum status name_run(plunge_result *r) {
  const char *slash = strrchr(r->path, '/');
  TRY(copy_text(slash ? slash + 1 : r->path, &r->run));
  char *dot = strrchr(r->run, '.');
  if (dot && dot > r->run) *dot = 0;
  return OK;
}

static enum status check_scale(const char *path, const char *name, double value) {
  CHECK(isfinite(value) && value > 0, ERR_INPUT, "%s: its %s is %g; it must be positive", path,
        name, value);
  return OK;
}

static enum status open_result(const char *path, const double scale[4], plunge_result *r) {
  static const char *const names[4] = {"H", "g", "density", "spacing"};
  for (int k = 0; k < 4; k++) TRY(check_scale(path, names[k], scale[k]));
  TRY(copy_text(path, &r->path));
  TRY(copy_text("", &r->program));
  TRY(copy_text("", &r->title));
  TRY(name_run(r));
  r->about = (struct result_about){.version = "",
                                   .revision = "",
                                   .case_text = "",
                                   .fingerprint = "",
                                   .water_fingerprint = "",
                                   .H = scale[0],
                                   .g = scale[1],
                                   .density = scale[2],
                                   .resolution = scale[0] / scale[3],
                                   .rest_potential = NAN,
                                   .walls = &r->walls};
  for (int k = 0; k < CLOCKS; k++) r->clock[k] = -INFINITY;
  r->fields = -1;
  return OK;
}

static void release(plunge_result *r) {
  result_destroy(r->file);
  for (size_t k = 0; k < r->about.n_probes; k++) free(r->probes[k].name);
  for (size_t k = 0; k < r->about.n_gauges; k++) free(r->gauges[k].name);
  for (size_t k = 0; k < r->about.n_terms; k++) {
    free((char *)r->terms[k].name);
    free((char *)r->terms[k].help);
  }
  for (int k = 0; k < 4; k++) free(r->column[k]);
  geo_lines_destroy(&r->walls);
  geo_lines_destroy(&r->surface);
  free(r->probes);
  free(r->gauges);
  free(r->terms);
  free(r->pressure_clock);
  free(r->elevation_clock);
  free(r->path);
  free(r->program);
  free(r->run);
  free(r->title);
  free(r);
}

plunge_result *plunge_result_open(const char *path, double H, double g, double density,
                                  double spacing) {
  plunge_result *r = calloc(1, sizeof *r);
  if (!r) {
    (void)status_raise(ERR_MEMORY, "no memory to write %s", path);
    return NULL;
  }
  if (open_result(path, (double[]){H, g, density, spacing}, r) == OK) return r;
  release(r);
  return NULL;
}

static enum status set_names(plunge_result *r, const char *program, const char *run,
                             const char *title) {
  TRY(check_undecided(r, "names"));
  if (program) TRY(copy_text(program, &r->program));
  if (run && *run) TRY(copy_text(run, &r->run));
  return title ? copy_text(title, &r->title) : OK;
}

int plunge_result_names(plunge_result *r, const char *program, const char *run, const char *title) {
  return answer(r, set_names(r, program, run, title));
}

static enum status add_line(const char *path, const char *what, int n, const double *points,
                            bool closed, struct geo_lines *to) {
  CHECK(n >= 2 && points, ERR_INPUT, "%s: %s of %d points; it needs 2", path, what, n);
  TRY(geo_lines_begin(to, closed));
  for (int i = 0; i < n; i++) {
    const double *p = points + 2 * (size_t)i;
    CHECK(isfinite(p[0]) && isfinite(p[1]), ERR_INPUT, "%s: point %d of %s is not finite", path, i,
          what);
    TRY(geo_lines_add(to, p[0], p[1]));
  }
  return OK;
}

static enum status add_wall(plunge_result *r, int n, const double *points, int closed) {
  TRY(check_undecided(r, "walls"));
  return add_line(r->path, "a wall", n, points, closed != 0, &r->walls);
}

int plunge_result_wall(plunge_result *r, int n, const double *points, int closed) {
  return answer(r, add_wall(r, n, points, closed));
}

static enum status set_rest(plunge_result *r, double potential) {
  TRY(check_undecided(r, "the energy at rest"));
  CHECK(isfinite(potential), ERR_INPUT, "%s: its energy at rest is not finite", r->path);
  r->about.rest_potential = potential;
  return OK;
}

int plunge_result_rest(plunge_result *r, double potential) {
  return answer(r, set_rest(r, potential));
}

/* Names of one kind differ; `element` of `size` bytes begins with its own. */
static enum status take_name(const plunge_result *r, const char *what, const char *name, size_t n,
                             const void *elements, size_t size, char **out) {
  TRY(check_undecided(r, what));
  const size_t length = name ? strlen(name) : 0;
  CHECK(length && length <= CASE_LONGEST_NAME, ERR_INPUT,
        "%s: a name among %s has %zu bytes; it must have 1 to %d", r->path, what, length,
        CASE_LONGEST_NAME);
  for (size_t k = 0; k < n; k++) {
    const char *its;
    memcpy(&its, (const char *)elements + k * size, sizeof its);
    CHECK(strcmp(its, name) != 0, ERR_INPUT, "%s: there are two %s '%s'", r->path, what, name);
  }
  return copy_text(name, out);
}

static enum status add_probe(plunge_result *r, const char *name, double x, double y, double size) {
  char *copy = NULL;
  TRY(check_ready(r));
  const size_t n = r->about.n_probes;
  CHECK(isfinite(x) && isfinite(y) && size >= 0, ERR_INPUT, "%s: a probe is nowhere", r->path);
  TRY(take_name(r, "probes", name, n, r->probes, sizeof *r->probes, &copy));
  enum status status = array_grow(&r->probes, &r->probe_room, n + 1, "probes");
  if (status != OK)
    free(copy);
  else
    r->probes[r->about.n_probes++] = (struct case_probe){copy, x, y, size};
  return status;
}

int plunge_result_probe(plunge_result *r, const char *name, double x, double y, double size) {
  return answer(r, add_probe(r, name, x, y, size));
}

static enum status add_gauge(plunge_result *r, const char *name, double x) {
  char *copy = NULL;
  TRY(check_ready(r));
  const size_t n = r->about.n_gauges;
  CHECK(isfinite(x), ERR_INPUT, "%s: a gauge is nowhere", r->path);
  TRY(take_name(r, "gauges", name, n, r->gauges, sizeof *r->gauges, &copy));
  enum status status = array_grow(&r->gauges, &r->gauge_room, n + 1, "gauges");
  if (status != OK)
    free(copy);
  else
    r->gauges[r->about.n_gauges++] = (struct case_gauge){copy, x};
  return status;
}

int plunge_result_gauge(plunge_result *r, const char *name, double x) {
  return answer(r, add_gauge(r, name, x));
}

static enum status add_term(plunge_result *r, const char *name, const char *help) {
  char *copy = NULL, *words = NULL;
  TRY(check_ready(r));
  const size_t n = r->about.n_terms;
  CHECK(n < RESULT_TERMS, ERR_INPUT, "%s: there are more than %d terms of energy", r->path,
        RESULT_TERMS);
  CHECK(!name || !strchr(name, '/'), ERR_INPUT, "%s: the term '%s' has a slash in its name",
        r->path, name);
  TRY(take_name(r, "terms", name, n, r->terms, sizeof *r->terms, &copy));
  enum status status = copy_text(help, &words);
  if (status == OK) status = array_grow(&r->terms, &r->term_room, n + 1, "terms");
  if (status == OK) {
    r->terms[r->about.n_terms++] = (struct solver_term){copy, words, false};
    return OK;
  }
  free(copy);
  free(words);
  return status;
}

int plunge_result_term(plunge_result *r, const char *name, const char *help) {
  return answer(r, add_term(r, name, help));
}

/* ---- outputs ---- */

static enum status make_clocks(size_t n, double **clock) {
  TRY(array_create(clock, n, "series"));
  for (size_t k = 0; k < n; k++) (*clock)[k] = -INFINITY;
  return OK;
}

/* The file comes to be with the first output. */
static enum status begin(plunge_result *r) {
  TRY(check_ready(r));
  if (r->file) return OK;
  r->about.solver = r->program;
  r->about.run = r->run;
  r->about.title = r->title;
  r->about.probes = r->probes;
  r->about.gauges = r->gauges;
  r->about.terms = r->terms;
  TRY(make_clocks(r->about.n_probes, &r->pressure_clock));
  TRY(make_clocks(r->about.n_gauges, &r->elevation_clock));
  return result_begin(r->path, &r->about, &r->file);
}

static enum status tick(const plunge_result *r, const char *what, double time, double *last) {
  CHECK(isfinite(time) && time >= *last, ERR_INPUT,
        "%s: the time of %s is %g s after %g s; times must not fall", r->path, what, time, *last);
  *last = time;
  return OK;
}

static enum status add_surface(plunge_result *r, double time, int pieces, const int *first,
                               const int *closed, const double *points) {
  TRY(begin(r));
  TRY(tick(r, "a surface", time, &r->clock[SURFACES]));
  geo_lines_clear(&r->surface);
  CHECK(pieces >= 0 && (first || !pieces), ERR_INPUT, "%s: a surface of %d pieces", r->path,
        pieces);
  for (int k = 0; k < pieces; k++) {
    CHECK(first[k] >= 0 && first[k + 1] >= first[k], ERR_INPUT,
          "%s: piece %d of a surface begins at point %d and ends at %d", r->path, k, first[k],
          first[k + 1]);
    TRY(add_line(r->path, "a surface", first[k + 1] - first[k], points + 2 * (size_t)first[k],
                 closed && closed[k] != 0, &r->surface));
  }
  TRY(result_surface(r->file, time, &r->surface));
  return result_flush(r->file);
}

int plunge_result_surface(plunge_result *r, double time, int n, const double *points) {
  return answer(r, add_surface(r, time, 1, (const int[]){0, n}, NULL, points));
}

int plunge_result_pieces(plunge_result *r, double time, int pieces, const int *first,
                         const int *closed, const double *points) {
  return answer(r, add_surface(r, time, pieces, first, closed, points));
}

/* Two columns of n numbers that come in turn. */
static void split(size_t n, const double *pairs, double *a, double *b) {
  for (size_t i = 0; i < n; i++) {
    a[i] = pairs[2 * i];
    b[i] = pairs[2 * i + 1];
  }
}

static enum status make_columns(plunge_result *r, size_t n) {
  if (n <= r->room) return OK;
  for (int k = 0; k < 4; k++) TRY(array_resize(&r->column[k], n, "particles"));
  r->room = n;
  return OK;
}

static enum status add_particles(plunge_result *r, double time, int n, const double *points,
                                 const double *const scalar[FIELDS - 1], const double *velocity) {
  struct result_field all[FIELDS] = {{"pressure", "Pa", "pressure", scalar[0], NULL},
                                     {"density", "kg/m^3", "density", scalar[1], NULL},
                                     {"mass", "kg/m", "mass", scalar[2], NULL},
                                     {"volume", "m^2", "volume", scalar[3], NULL},
                                     {"velocity", "m/s", "velocity", NULL, NULL}},
                      field[FIELDS];
  size_t n_fields = 0;
  int has = 0;
  TRY(begin(r));
  CHECK(n >= 0 && (points || !n), ERR_INPUT, "%s: an output of %d particles", r->path, n);
  TRY(tick(r, "an output of particles", time, &r->clock[PARTICLES]));
  TRY(make_columns(r, (size_t)n));
  split((size_t)n, points, r->column[0], r->column[1]);
  if (velocity) split((size_t)n, velocity, r->column[2], r->column[3]);
  all[FIELDS - 1].a = velocity ? r->column[2] : NULL;
  all[FIELDS - 1].b = r->column[3];
  for (int k = 0; k < FIELDS; k++)
    if (all[k].a) {
      field[n_fields++] = all[k];
      has |= 1 << k;
    }
  CHECK(r->fields < 0 || r->fields == has, ERR_INPUT,
        "%s: particles have other fields than at the output before", r->path);
  r->fields = has;
  TRY(result_points(r->file, time, (size_t)n, r->column[0], r->column[1], RESULT_VERTICES, n_fields,
                    field));
  return result_flush(r->file);
}

int plunge_result_particles(plunge_result *r, double time, int n, const double *points,
                            const double *pressure, const double *density, const double *mass,
                            const double *volume, const double *velocity) {
  return answer(r, add_particles(r, time, n, points,
                                 (const double *[]){pressure, density, mass, volume}, velocity));
}

/* ---- series ---- */

static enum status add_energy(plunge_result *r, const struct result_energy *given,
                              const double *terms) {
  struct result_energy row = *given;
  TRY(begin(r));
  CHECK(!isnan(r->about.rest_potential), ERR_INPUT,
        "%s: energies are counted from that at rest: call plunge_result_rest first", r->path);
  TRY(tick(r, "energies", row.time, &r->clock[ENERGIES]));
  row.total = row.kinetic + row.potential + row.internal;
  if (terms) memcpy(row.term, terms, r->about.n_terms * sizeof *terms);
  return result_energy(r->file, &row);
}

int plunge_result_energy(plunge_result *r, double time, double kinetic, double potential,
                         double internal, double removed, const double *terms) {
  const struct result_energy row = {.time = time,
                                    .kinetic = kinetic,
                                    .potential = potential,
                                    .internal = internal,
                                    .removed = removed};
  return answer(r, add_energy(r, &row, terms));
}

static enum status add_step(plunge_result *r, const struct result_step *row) {
  TRY(begin(r));
  TRY(tick(r, "a step", row->time, &r->clock[STEPS]));
  return result_step(r->file, row);
}

int plunge_result_step(plunge_result *r, double time, double dt, double volume, double removed,
                       double evaluations, double wall_time) {
  return answer(
      r, add_step(r, &(struct result_step){time, dt, evaluations, wall_time, volume, removed}));
}

/* Whether sensor k of n is one, and its time comes after the one before. */
static enum status tick_sensor(plunge_result *r, const char *what, size_t n, int k, double time,
                               double *const *clock) {
  TRY(begin(r));
  CHECK(k >= 0 && (size_t)k < n, ERR_INPUT, "%s: there is no %s %d among %zu", r->path, what, k, n);
  return tick(r, what, time, &(*clock)[k]);
}

static enum status add_pressure(plunge_result *r, int probe, double time, double pressure) {
  TRY(check_ready(r));
  TRY(tick_sensor(r, "probe", r->about.n_probes, probe, time, &r->pressure_clock));
  return result_probe(r->file, (size_t)probe, time, pressure);
}

int plunge_result_pressure(plunge_result *r, int probe, double time, double pressure) {
  return answer(r, add_pressure(r, probe, time, pressure));
}

static enum status add_elevation(plunge_result *r, int gauge, double time, double elevation) {
  TRY(check_ready(r));
  TRY(tick_sensor(r, "gauge", r->about.n_gauges, gauge, time, &r->elevation_clock));
  return result_gauge(r->file, (size_t)gauge, time, elevation);
}

int plunge_result_elevation(plunge_result *r, int gauge, double time, double elevation) {
  return answer(r, add_elevation(r, gauge, time, elevation));
}

static enum status add_event(plunge_result *r, const char *name, double time, double x, double y) {
  TRY(begin(r));
  CHECK(name && *name && isfinite(time), ERR_INPUT, "%s: an event without a name or a time",
        r->path);
  return result_event(r->file, name, time, x, y);
}

int plunge_result_event(plunge_result *r, const char *name, double time, double x, double y) {
  return answer(r, add_event(r, name, time, x, y));
}

/* ---- the end ---- */

static enum status finish(plunge_result *r, const char *ended) {
  TRY(begin(r));
  if (ended && *ended) TRY(result_ended(r->file, ended));
  return result_finish(r->file);
}

int plunge_result_close(plunge_result *r, const char *ended) {
  const int code = answer(r, finish(r, ended));
  if (r) release(r);
  return code;
}
