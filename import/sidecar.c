#include "import/sidecar.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "import/reader.h"

enum { MOST_BYTES = 1 << 20 };

/* ---- the tables ---- */

static const struct param name_rows[] = {
    TEXT(struct import_sidecar, run, 64, NULL, "name of the run in reports and of its file"),
    TEXT(struct import_sidecar, solver, 64, NULL, "the program that the files are of"),
    TEXT(struct import_sidecar, source, 1000, NULL,
         "who computed them, how, and where they come from"),
    TEXT(struct import_sidecar, title, 200, "", "what was computed"),
    REAL(struct import_sidecar, spacing, QTY_LENGTH, PARAM_ABOVE_0, 1e6, NULL,
         "of cells or particles; the surface of particles is found with it"),
    {.key = "time_offset",
     .type = PARAM_REAL,
     .quantity = QTY_TIME,
     .offset = offsetof(struct import_sidecar, offset),
     .min = -1e9,
     .max = 1e9,
     .value = "0",
     .help = "added to the times of the files, and reported"},
};
static const struct param section_rows[] = {
    {.key = "case",
     .type = PARAM_TEXT,
     .offset = offsetof(struct import_top, case_path),
     .max = 1000,
     .value = "",
     .help = "a case file that has the tank, the scales, the density and the water at t = 0, in "
             "place of scales and tank"},
    NODE(struct import_top, scales, "", "a mapping with H, g, density"),
    NODE(struct import_top, tank, "", "a mapping with walls"),
    NODE(struct import_top, units, NULL,
         "a mapping with length, time, velocity, density, pressure, mass, energy"),
    NODE(struct import_top, origin, "",
         "a list of 2 lengths [x, y]: where in the files our (0, 0) is"),
    NODE(struct import_top, profiles, "", "a mapping: the surface as points in a row"),
    NODE(struct import_top, grid, "", "a mapping: the surface as a contour on a grid"),
    NODE(struct import_top, particles, "", "a mapping: particles, whose surface is found"),
    NODE(struct import_top, series, "", "a list of mappings: energy, probes, gauges, volumes"),
};

struct scales_section {
  double H, g, density;
};
static const struct param scales_rows[] = {
    REAL(struct scales_section, H, QTY_LENGTH, PARAM_ABOVE_0, 1e6, NULL, "scale of length"),
    REAL(struct scales_section, g, QTY_ACCELERATION, PARAM_ABOVE_0, 1e6, NULL, "gravity"),
    REAL(struct scales_section, density, QTY_DENSITY, PARAM_ABOVE_0, 1e6, NULL,
         "density of the fluid"),
};

struct tank_section {
  int walls;
};
static const struct param tank_rows[] = {
    NODE(struct tank_section, walls, NULL,
         "a list of walls, each a list of points [x, y], the water on their left"),
};

struct units_section {
  double length, time, velocity, density;
  int pressure, mass, energy;
};
static const char *const pressures[] = {"Pa", "kPa", "rho g H", NULL};
static const char *const masses[] = {"kg/m", "rho H^2", NULL};
static const char *const energies[] = {"J/m", "kJ/m", "rho g H^3", NULL};
#define UNIT(key_, names)                                                                          \
  {                                                                                                \
    .key = #key_, .type = PARAM_CHOICE, .offset = offsetof(struct units_section, key_),            \
    .choices = names, .value = "", .help = "of the numbers in the files"                           \
  }
#define UNIT_REAL(key_, quantity_, default_)                                                       \
  REAL(struct units_section, key_, quantity_, PARAM_ABOVE_0, 1e9, default_,                        \
       "of the numbers in the files: a unit such as mm, or a number of one")
static const struct param units_rows[] = {
    UNIT_REAL(length, QTY_LENGTH, NULL),
    UNIT_REAL(time, QTY_TIME, ""),
    UNIT_REAL(velocity, QTY_VELOCITY, ""),
    UNIT_REAL(density, QTY_DENSITY, ""),
    UNIT(pressure, pressures),
    UNIT(mass, masses),
    UNIT(energy, energies),
};

#define TABLE(name, rows)                                                                          \
  { name, rows, ROWS(rows) }
const struct case_table import_tables[] = {
    TABLE("(top level)", name_rows), TABLE("(top level, sections)", section_rows),
    TABLE("scales", scales_rows),    TABLE("tank", tank_rows),
    TABLE("units", units_rows),      {0},
};

/* ---- scales, tank, units ---- */

static void take_scales(struct import_reader *r) {
  struct scales_section s = {0};
  struct case_file *c = r->d.c;
  if (!r->top.scales) {
    if (!r->top.case_path)
      import_complain(r, case_doc_root(&r->d.doc), "scales", "nothing, and no case",
                      "a mapping with H, g, density, or the key case", "add it");
    return;
  }
  if (case_read_section(&r->d, r->top.scales, "scales", scales_rows, ROWS(scales_rows), &s)) {
    c->H = s.H;
    c->g = c->gravity = s.g;
    c->density = s.density;
  }
}

/* The case that has them; what is wrong with it is told of the key. */
static enum status take_case(struct import_reader *r, const struct registry *registry) {
  struct problems theirs = {0};
  struct case_file *c = NULL;
  char *full, shown[64], found[400];
  const int node = case_doc_member(&r->d.doc, case_doc_root(&r->d.doc), "case");
  if (!r->top.case_path) return OK;
  if (r->top.scales || r->top.tank)
    import_complain(r, node, "case", "both case and scales or tank", "one of them", "remove one");
  TRY(import_join_path(r->s, r->top.case_path, &full));
  enum status status = case_load(full, 0, NULL, registry, &theirs, &c);
  free(full);
  case_quote(r->top.case_path, strlen(r->top.case_path), shown, sizeof shown);
  if (status == ERR_INPUT) {
    snprintf(found, sizeof found, "'%s', which is refused: %s", shown,
             theirs.n ? theirs.text[0] : status_message());
    import_complain(r, node, "case", found, "a sound case file, its path relative to the sidecar",
                    "correct it (plunge check)");
    status = OK;
  } else if (status == OK) {
    case_destroy(r->d.c);
    r->d.c = c;
    r->s->has_case = r->d.good.tank = true;
  }
  problems_destroy(&theirs);
  return status;
}

static enum status take_tank(struct import_reader *r) {
  struct tank_section s = {0};
  if (!r->top.tank) return OK;
  const size_t faults = r->d.doc.faults;
  if (case_read_section(&r->d, r->top.tank, "tank", tank_rows, ROWS(tank_rows), &s))
    TRY(case_read_walls(&r->d, s.walls));
  if (r->d.doc.faults > faults) return OK;
  r->d.at.tank = r->top.tank;
  r->d.c->tank = geo_lines_box(&r->d.c->walls);
  case_check_walls(&r->d);
  return OK;
}

static void take_units(struct import_reader *r) {
  struct units_section u = {NAN, NAN, NAN, NAN, -1, -1, -1};
  const struct case_file *c = r->d.c;
  if (!r->top.units ||
      !case_read_section(&r->d, r->top.units, "units", units_rows, ROWS(units_rows), &u)) {
    r->units_bad = true;
    return;
  }
  const double pressure[] = {1, 1000, c->density * c->g * c->H},
               mass[] = {1, c->density * c->H * c->H},
               energy[] = {1, 1000, c->density * c->g * c->H * c->H * c->H};
  r->s->unit.length = u.length;
  r->s->unit.time = u.time;
  r->s->unit.velocity = u.velocity;
  r->s->unit.density = u.density;
  if (u.pressure >= 0) r->s->unit.pressure = pressure[u.pressure];
  if (u.mass >= 0) r->s->unit.mass = mass[u.mass];
  if (u.energy >= 0) r->s->unit.energy = energy[u.energy];
}

double import_unit(const struct import_sidecar *s, enum import_role role) {
  const double number = 1, clock = 1, length = s->unit.length, time = s->unit.time;
  const double velocity = s->unit.velocity, pressure = s->unit.pressure, mass = s->unit.mass;
  const double density = s->unit.density, energy = s->unit.energy, area = length * length;
  const double units[] = {
#define X(name, unit, help) unit,
      IMPORT_ROLES(X)
#undef X
  };
  return units[role];
}

/* ---- all of it ---- */

static void check_run(struct import_reader *r) {
  const struct import_sidecar *s = r->s;
  const int root = case_doc_root(&r->d.doc);
  if (s->run && !case_name_fits(s->run)) {
    char shown[64], found[72];
    case_quote(s->run, strlen(s->run), shown, sizeof shown);
    snprintf(found, sizeof found, "'%s'", shown);
    import_complain(r, case_doc_member(&r->d.doc, root, "run"), "run", found,
                    "letters, digits, '.', '_' and '-', with no '.' first, at most 64", "");
  }
}

static enum status read_all(struct import_reader *r, const struct registry *registry) {
  struct case_doc *doc = &r->d.doc;
  struct import_sidecar *s = r->s;
  const int root = case_doc_root(doc);
  /* H and g come first: all else may be in units of them */
  struct case_block top[] = {{section_rows, ROWS(section_rows), &r->top, NULL}};
  for (size_t k = 0; k < ROWS(section_rows); k++) {
    const int node = case_doc_member(doc, root, section_rows[k].key);
    if (section_rows[k].type == PARAM_NODE)
      *(int *)((char *)&r->top + section_rows[k].offset) = node;
  }
  const char *text = case_doc_text(doc, case_doc_member(doc, root, "case"));
  if (text && *text) r->top.case_path = strdup(text);
  TRY(take_case(r, registry));
  if (!s->has_case) take_scales(r);
  const bool known = r->d.c->H > 0 && r->d.c->g > 0;
  doc->scales = (struct param_scales){known ? r->d.c->H : NAN, known ? r->d.c->g : NAN};
  struct case_block both[] = {{name_rows, ROWS(name_rows), s, NULL}, top[0]};
  case_doc_read(doc, root, "", case_doc_line(doc, root), 2, both);
  if (!case_doc_is_mapping(doc, root)) return OK;
  if (!s->has_case) TRY(take_tank(r));
  take_units(r);
  if (r->top.origin) case_read_point(doc, r->top.origin, "origin", s->origin);
  TRY(import_read_sections(r));
  check_run(r);
  return OK;
}

static char *read_text(const char *path, struct problems *problems, size_t *n) {
  char *text;
  enum status status = text_read(path, MOST_BYTES, &text, n);
  if (status == ERR_INPUT)
    problems_add(problems, 0,
                 "found %s; allowed: a sidecar in YAML of at most 1 MB; correct the path",
                 status_message());
  else if (status != OK)
    problems->out_of_memory = true;
  if (text && text_bad_utf8(text, *n)) {
    problems_add(problems, 0,
                 "found a byte that is not UTF-8; allowed: a sidecar in YAML, UTF-8 "
                 "text; save it as UTF-8");
    free(text);
    return NULL;
  }
  return text;
}

static enum status create(const char *path, struct import_reader *r) {
  r->s = calloc(1, sizeof *r->s);
  r->d.c = calloc(1, sizeof *r->d.c);
  CHECK(r->s && r->d.c, ERR_MEMORY, "no memory for a sidecar");
  r->s->path = strdup(path);
  r->d.c->path = strdup(path);
  CHECK(r->s->path && r->d.c->path, ERR_MEMORY, "no memory for a sidecar");
  r->s->unit.length = r->s->unit.time = r->s->unit.velocity = r->s->unit.density = NAN;
  r->s->unit.pressure = r->s->unit.mass = r->s->unit.energy = NAN;
  r->s->spacing = NAN;
  return OK;
}

enum status import_sidecar_load(const char *path, const struct registry *registry,
                                struct problems *problems, struct import_sidecar **out) {
  static const char wanted[] =
      "a mapping with run, source, scales or case, and profiles, grid or particles at least";
  struct import_reader r = {.d = {.registry = registry}};
  size_t n = 0;
  *problems = (struct problems){0};
  *out = NULL;
  enum status status = create(path, &r);
  char *text = status == OK ? read_text(path, problems, &n) : NULL;
  if (text && case_doc_load_other(&r.d.doc, text, n, wanted, problems))
    status = read_all(&r, registry);
  case_doc_destroy(&r.d.doc);
  free(text);
  free(r.top.case_path);
  if (r.s) r.s->scales = r.d.c;
  const size_t faults = problems->n + problems->unlisted;
  problems_finish(problems, path, 0, NULL);
  if (status == OK && problems->out_of_memory)
    status = status_raise(ERR_MEMORY, "no memory to read %s", path);
  if (status == OK && faults)
    status = status_raise(ERR_INPUT, "%s has %zu problem%s", path, faults, faults == 1 ? "" : "s");
  if (status == OK)
    *out = r.s;
  else
    import_sidecar_destroy(r.s);
  return status;
}

static void destroy_section(struct import_section *s) {
  for (size_t i = 0; i < s->n_items; i++) {
    free(s->items[i].file);
    free(s->items[i].where);
  }
  free(s->items);
  for (size_t k = 0; k < IMPORT_N_ROLES; k++) free(s->column[k]);
  free(s->time_after);
  free(s->name);
}

void import_sidecar_destroy(struct import_sidecar *s) {
  if (!s) return;
  case_destroy(s->scales);
  destroy_section(&s->profiles);
  destroy_section(&s->grid);
  destroy_section(&s->particles);
  for (size_t i = 0; i < s->n_series; i++) destroy_section(&s->series[i]);
  free(s->series);
  free(s->path);
  free(s->run);
  free(s->solver);
  free(s->source);
  free(s->title);
  free(s);
}
