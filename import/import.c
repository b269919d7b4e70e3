#include "import/import.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/cloud/surface.h"
#include "common/result/result.h"
#include "common/tank/tank.h"
#include "import/gap.h"
#include "import/pieces.h"
#include "import/reader.h"
#include "import/rows.h"
#include "import/target.h"
#include "revision.h"

struct work {
  const struct import_sidecar *s;
  const struct import_section *section;
  struct result *result; /* NULL: files are only checked */
  size_t sensor;         /* of a probe or gauge, its number */
  struct case_probe *probes;
  struct case_gauge *gauges;
  struct geo_lines surface;
  struct cloud_surface *finder;
  struct tank tank;
  struct geo_lines walls; /* behind which the water goes on */
  double *volume;         /* scratch, [volume_room] */
  size_t volume_room;
  double *place[2]; /* scratch, [place_room]: x, y where they are wrapped */
  size_t place_room[2];
  struct import_summary *summary;
};

/* ---- what is at a time ---- */

static void count(struct work *w, double time, size_t *n) {
  struct import_summary *m = w->summary;
  ++*n;
  if (!(time >= m->first)) m->first = time;
  if (!(time <= m->last)) m->last = time;
}

static enum status put_surface(struct work *w, double time) {
  if (!w->result) return OK;
  count(w, time, &w->summary->surfaces);
  TRY(result_surface(w->result, time, &w->surface));
  return result_flush(w->result);
}

static enum status take_profile(void *data, const struct import_rows *r) {
  struct work *w = data;
  TRY(import_profile(r->path, r->time, w->s->spacing, r->n, r->column[IMPORT_x],
                     r->column[IMPORT_y], r->column[IMPORT_piece], &w->surface));
  return put_surface(w, r->time);
}

static enum status take_grid(void *data, const struct import_rows *r) {
  struct work *w = data;
  TRY(import_contour(r->path, r->n, r->column[IMPORT_x], r->column[IMPORT_y],
                     r->column[IMPORT_field], r->mesh, w->section->level, w->section->water != 0,
                     &w->surface));
  return put_surface(w, r->time);
}

/* The area of each particle, where there is any word of it. */
static enum status find_volume(struct work *w, const struct import_rows *r, const double **volume) {
  const double *mass = r->column[IMPORT_mass], *density = r->column[IMPORT_density];
  *volume = r->column[IMPORT_volume];
  if (*volume || !mass) return OK;
  TRY(array_grow(&w->volume, &w->volume_room, r->n + 1, "particles"));
  for (size_t i = 0; i < r->n; i++)
    w->volume[i] = mass[i] / (density ? density[i] : w->s->scales->density);
  *volume = w->volume;
  return OK;
}

static enum status check_particles(const struct import_rows *r) {
  for (size_t k = 0; k < IMPORT_N_ROLES; k++)
    for (size_t i = 0; r->column[k] && i < r->n; i++) {
      CHECK(isfinite(r->column[k][i]), ERR_INPUT, "%s: particle %zu at %g s has no %s", r->path,
            i + 1, r->time, import_roles[k]);
      const bool amount = k == IMPORT_mass || k == IMPORT_density || k == IMPORT_volume;
      CHECK(!amount || r->column[k][i] > 0, ERR_INPUT,
            "%s: particle %zu at %g s has the %s %g; it must be positive", r->path, i + 1, r->time,
            import_roles[k], r->column[k][i]);
    }
  return OK;
}

/* The places of particles. Those beyond an end of a periodic tank are the same water as what is one
 * period further in. */
static enum status find_places(struct work *w, const struct import_rows *r, const double *at[2]) {
  for (int k = 0; k < 2; k++) {
    at[k] = r->column[k ? IMPORT_y : IMPORT_x];
    if (!w->s->scales->walls.pieces || !w->tank.periodic[k]) continue;
    TRY(array_grow(&w->place[k], &w->place_room[k], r->n + 1, "particles"));
    for (size_t i = 0; i < r->n; i++) w->place[k][i] = tank_wrap(&w->tank, k, at[k][i]);
    at[k] = w->place[k];
  }
  return OK;
}

static enum status put_particles(struct work *w, const struct import_rows *r,
                                 const double *const at[2]) {
  const double *const *c = r->column;
  const struct result_field all[] = {{"pressure", "Pa", "pressure", c[IMPORT_pressure], NULL},
                                     {"density", "kg/m^3", "density", c[IMPORT_density], NULL},
                                     {"mass", "kg/m", "mass", c[IMPORT_mass], NULL},
                                     {"volume", "m^2", "volume", c[IMPORT_volume], NULL},
                                     {"velocity", "m/s", "velocity", c[IMPORT_u], c[IMPORT_v]}};
  struct result_field field[sizeof all / sizeof *all];
  size_t n = 0;
  for (size_t k = 0; k < sizeof all / sizeof *all; k++)
    if (all[k].a) field[n++] = all[k];
  count(w, r->time, &w->summary->clouds);
  return result_points(w->result, r->time, r->n, at[0], at[1], RESULT_VERTICES, n, field);
}

static enum status take_particles(void *data, const struct import_rows *r) {
  struct work *w = data;
  const bool found = !w->s->profiles.given && !w->s->grid.given;
  const double *place[2];
  TRY(check_particles(r));
  if (!w->result) return OK;
  TRY(find_places(w, r, place));
  TRY(put_particles(w, r, place));
  if (found) {
    const double *volume;
    TRY(find_volume(w, r, &volume));
    const struct cloud cloud = {r->n,          place[0],
                                place[1],      volume,
                                w->s->spacing, w->s->scales->walls.pieces ? &w->tank : NULL};
    enum status status = cloud_surface_extract(w->finder, &cloud, &w->walls, &w->surface);
    if (status != OK) return status_context(status, "%s: ", r->path);
    count(w, r->time, &w->summary->surfaces);
    TRY(result_surface(w->result, r->time, &w->surface));
  }
  return result_flush(w->result);
}

/* ---- series ---- */

static enum status check_energies(const struct import_rows *r) {
  for (size_t k = IMPORT_kinetic; k <= IMPORT_removed; k++)
    for (size_t i = 0; r->column[k] && i < r->n; i++)
      CHECK(isfinite(r->column[k][i]), ERR_INPUT, "%s: row %zu has no %s energy", r->path, i + 1,
            import_roles[k]);
  return OK;
}

static double at(const struct import_rows *r, enum import_role role, size_t i, double absent) {
  return r->column[role] ? r->column[role][i] : absent;
}

static enum status take_series(void *data, const struct import_rows *r) {
  struct work *w = data;
  const double *t = r->column[IMPORT_time];
  TRY(check_energies(r));
  if (!w->result) return OK;
  w->summary->rows += r->n;
  for (size_t i = 0; i < r->n; i++) {
    struct result_energy energy = {.time = t[i],
                                   .kinetic = at(r, IMPORT_kinetic, i, 0),
                                   .potential = at(r, IMPORT_potential, i, 0),
                                   .internal = at(r, IMPORT_internal, i, 0),
                                   .removed = at(r, IMPORT_removed, i, 0)};
    const struct result_step step = {.time = t[i],
                                     .dt = NAN,
                                     .evaluations = at(r, IMPORT_evaluations, i, NAN),
                                     .wall_time = at(r, IMPORT_wall_time, i, NAN),
                                     .volume = at(r, IMPORT_volume, i, 0)};
    energy.total = energy.kinetic + energy.potential + energy.internal;
    switch ((enum import_kind)w->section->kind) {
    case IMPORT_ENERGY:
      TRY(result_energy(w->result, &energy));
      break;
    case IMPORT_PROBE:
      TRY(result_probe(w->result, w->sensor, t[i], r->column[IMPORT_pressure][i]));
      break;
    case IMPORT_GAUGE:
      TRY(result_gauge(w->result, w->sensor, t[i], r->column[IMPORT_elevation][i]));
      break;
    case IMPORT_RUN:
      TRY(result_step(w->result, &step));
      break;
    }
  }
  return OK;
}

/* ---- all of it ---- */

static enum status go_through(struct work *w) {
  const struct import_sidecar *s = w->s;
  const struct {
    const struct import_section *section;
    enum status (*take)(void *, const struct import_rows *);
  } parts[] = {
      {&s->profiles, take_profile}, {&s->grid, take_grid}, {&s->particles, take_particles}};
  for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
    w->section = parts[k].section;
    if (w->section->given) TRY(import_each(s, w->section, false, parts[k].take, w));
  }
  size_t sensors[4] = {0};
  for (size_t i = 0; i < s->n_series; i++) {
    w->section = &s->series[i];
    w->sensor = sensors[w->section->kind]++;
    TRY(import_each(s, w->section, true, take_series, w));
  }
  return w->result ? result_flush(w->result) : OK;
}

static enum status prepare(struct work *w, struct result_about *about) {
  const struct import_sidecar *s = w->s;
  const struct case_file *c = s->scales;
  TRY(cloud_surface_create(&w->finder));
  TRY(array_create(&w->probes, s->n_series, "probes"));
  TRY(array_create(&w->gauges, s->n_series, "gauges"));
  for (size_t i = 0; i < s->n_series; i++) {
    const struct import_section *one = &s->series[i];
    if (one->kind == IMPORT_PROBE)
      w->probes[about->n_probes++] = (struct case_probe){one->name, one->x, one->y, one->size};
    if (one->kind == IMPORT_GAUGE)
      w->gauges[about->n_gauges++] = (struct case_gauge){one->name, one->x};
    if (one->kind == IMPORT_ENERGY)
      about->rest_potential =
          isnan(one->rest) ? case_rest_potential(c) : one->rest * s->unit.energy;
  }
  about->probes = w->probes;
  about->gauges = w->gauges;
  enum status status = import_gap(&c->walls, s->particles.gap, &w->walls);
  if (status != OK)
    return status_context(status, "%s:%d: particles.gap: ", s->path, s->particles.line);
  if (c->walls.pieces) w->tank = tank_of(&c->walls, c->periodic);
  return OK;
}

/* ---- how it was made ---- */

static const char *name_in(const char *path) {
  const char *slash = strrchr(path, '/');
  return slash ? slash + 1 : path;
}

static void say_files(FILE *out, const char *what, const struct import_section *section) {
  if (!section->given) return;
  fprintf(out, "; %s from %s", what, name_in(section->items[0].file));
  if (section->n_items > 1)
    fprintf(out, " to %s, %zu files", name_in(section->items[section->n_items - 1].file),
            section->n_items);
  fprintf(out, " (%s)", import_format_names[section->format]);
}

/* One line for the attribute `imported`. */
static enum status say_how(const struct import_sidecar *s, char **out) {
  size_t n = 0;
  FILE *text = open_memstream(out, &n);
  CHECK(text, ERR_MEMORY, "no memory to describe an import");
  fprintf(text, "by plunge %s by %s", PLUNGE_VERSION, name_in(s->path));
  say_files(text, "surface as points", &s->profiles);
  say_files(text, "surface as a contour", &s->grid);
  if (s->grid.given) {
    fprintf(text, " of %s = %g", s->grid.column[IMPORT_field], s->grid.level);
    if (!isnan(s->grid.slice)) fprintf(text, " in a plane at %g m", s->grid.slice);
  }
  say_files(text, "particles", &s->particles);
  if (s->particles.given && !s->profiles.given && !s->grid.given)
    fprintf(text,
            ", whose surface is F = 1/2 of their smoothed volume fraction at a spacing of %g m",
            s->spacing);
  if (s->particles.gap > 0) fprintf(text, ", %g m from the walls", s->particles.gap);
  for (size_t i = 0; i < s->n_series; i++) {
    const char *const kinds[] = {"energies", "pressure", "water height", "volume"};
    say_files(text, kinds[s->series[i].kind], &s->series[i]);
  }
  fprintf(text, "; unit of length %g m", s->unit.length);
  if (!isnan(s->unit.time)) fprintf(text, ", of time %g s", s->unit.time);
  fprintf(text, ", times moved by %g s, places by (%g, %g) m; source: %s", s->offset,
          0 - s->origin[0], 0 - s->origin[1], s->source);
  if (fclose(text) == 0) return OK;
  return status_raise(ERR_MEMORY, "no memory to describe an import");
}

/* ---- writing ---- */

static enum status write_result(struct work *w, const struct result_about *about,
                                const char *path) {
  enum status status = result_begin(path, about, &w->result);
  if (status != OK) return status;
  status = go_through(w);
  if (status == OK) status = result_finish(w->result);
  if (status == OK)
    result_destroy(w->result);
  else
    result_discard(w->result); /* nothing half-written */
  w->result = NULL;
  return status;
}

static enum status import_all(struct work *w, const char *path) {
  const struct import_sidecar *s = w->s;
  const struct case_file *c = s->scales;
  struct result_about about = {.solver = s->solver,
                               .run = s->run,
                               .title = s->title ? s->title : "",
                               .version = "",
                               .revision = "",
                               .case_text = "",
                               .fingerprint = "",
                               .water_fingerprint = "",
                               .H = c->H,
                               .g = c->g,
                               .density = c->density,
                               .resolution = c->H / s->spacing,
                               .rest_potential = NAN,
                               .walls = &c->walls};
  char *how = NULL;
  enum status status = OK;
  ATTEMPT(say_how(s, &how));
  about.imported = how;
  ATTEMPT(prepare(w, &about));
  ATTEMPT(go_through(w));
  status = write_result(w, &about, path);
done:
  free(how);
  return status;
}

static void release(struct work *w) {
  cloud_surface_destroy(w->finder);
  geo_lines_destroy(&w->surface);
  geo_lines_destroy(&w->walls);
  free(w->probes);
  free(w->gauges);
  free(w->volume);
  for (int k = 0; k < 2; k++) free(w->place[k]);
}

enum status import_run(const char *sidecar, const char *out, const struct registry *registry,
                       struct problems *problems, char **written, struct import_summary *summary) {
  struct import_sidecar *s = NULL;
  *written = NULL;
  *summary = (struct import_summary){.first = NAN, .last = NAN};
  TRY(import_sidecar_load(sidecar, registry, problems, &s));
  struct work w = {.s = s, .summary = summary};
  enum status status = OK;
  if (asprintf(written, "%s%s", out ? out : s->run, out ? "" : ".h5") < 0) {
    *written = NULL;
    status = status_raise(ERR_MEMORY, "no memory for a file name");
  }
  if (status == OK) status = import_check_target(*written, s);
  if (status == OK) status = import_all(&w, *written);
  summary->walls = s->scales->walls.pieces > 0;
  summary->particles = s->particles.given && !s->profiles.given && !s->grid.given;
  release(&w);
  import_sidecar_destroy(s);
  return status;
}

void import_print_keys(FILE *out) {
  fputs("formats\n", out);
  for (size_t k = 0; k < IMPORT_N_FORMATS; k++)
    fprintf(out, "    %-6s %s\n", import_format_names[k], import_format_helps[k]);
  fputc('\n', out);
  const struct case_table *const lists[] = {import_tables, import_section_tables};
  for (size_t i = 0; i < sizeof lists / sizeof *lists; i++)
    for (const struct case_table *t = lists[i]; t->name; t++) {
      fprintf(out, "%s\n", t->name);
      params_print(out, t->params, t->n);
      fputc('\n', out);
    }
}
