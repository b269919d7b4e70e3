/* The sections of a case file, each one table of keys and a few lines that put the values in place.
 */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case_draft.h"
#include "common/flow/flow.h"
#include "common/tank/tank.h"

/* ---- the sections ---- */

struct fluid_section {
  double density;
  int gravity;
};
static const struct param fluid_rows[] = {
    REAL(struct fluid_section, density, QTY_DENSITY, PARAM_ABOVE_0, 1e6, "1000",
         "density of the fluid"),
    NODE(
        struct fluid_section, gravity, "",
        "acceleration of gravity, downwards (9.81); 0: none, in SPH alone; [gx, gy]: along another "
        "direction, in SPH alone"),
};

static const struct param scales_rows[] = {
    REAL(struct case_file, H, QTY_LENGTH, PARAM_ABOVE_0, 1e6, "",
         "scale of length; default: the height of the water above the bed"),
    REAL(struct case_file, g, QTY_ACCELERATION, PARAM_ABOVE_0, 1e6, "",
         "acceleration of the units sqrt(H/g) and sqrt(gH) where there is no gravity"),
};

struct tank_section {
  int walls, sides, bed, motions;
};
enum { SIDES_WALLS, SIDES_PERIODIC };
static const char *const sides_names[] = {"walls", "periodic", NULL};
static const char *const sides_helps[] = {
    "water ends there",
    "what leaves through one comes in through the other: only the bed is a wall"};
static const char *const bed_names[] = {"wall", "periodic", NULL};
static const char *const bed_helps[] = {
    "water ends there", "what leaves through it comes in at the height of the sides: there are no "
                        "walls, and no gravity"};
static const struct param tank_rows[] = {
    NODE(struct tank_section, walls, NULL, "a list of walls, each a list of points [x, y]"),
    {.key = "sides",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct tank_section, sides),
     .choices = sides_names,
     .value = "walls",
     .help = "what the upright sides of a rectangular tank are",
     .helps = sides_helps},
    {.key = "bed",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct tank_section, bed),
     .choices = bed_names,
     .value = "wall",
     .help = "what its bed is",
     .helps = bed_helps},
    NODE(struct tank_section, motions, "", "a list of motions of the tank or its sides"),
};

struct water_section {
  int regions, wave, body, velocity, pressure;
};
static const struct param water_rows[] = {
    NODE(struct water_section, regions, "",
         "a list of regions, each a list of points [x, y] or a mapping with points, velocity"),
    NODE(struct water_section, wave, "", "a mapping with kind and the keys of that kind"),
    NODE(struct water_section, body, "", "a mapping with kind and the keys of that kind"),
    NODE(struct water_section, velocity, "", "a list of 2 velocities [u, v], of all regions"),
    {.key = "pressure",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct water_section, pressure),
     .choices = flow_region_names,
     .value = "hydrostatic",
     .help = "pressure at t = 0",
     .helps = flow_region_helps},
};

struct form_section {
  int kind;
};
static const struct param wave_rows[] = {
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct form_section, kind),
     .choices = flow_wave_names,
     .value = "standing",
     .help = "kind of wave",
     .helps = flow_wave_helps},
};
static const struct param body_rows[] = {
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct form_section, kind),
     .choices = flow_body_names,
     .help = "kind of body, which floats without gravity in the middle of the tank",
     .helps = flow_body_helps},
};

/* Water that a form of its own describes. */
static const struct form_list {
  const char *path;
  const struct param *rows; /* one: the kind */
  const struct flow_list *flows;
  const char *const *names;
} form_of_waves = {"water.wave", wave_rows, &flow_waves, flow_wave_names},
  form_of_bodies = {"water.body", body_rows, &flow_bodies, flow_body_names};

static const struct param time_rows[] = {
    REAL(struct case_file, end, QTY_TIME, PARAM_ABOVE_0, 1e9, NULL, "last output time"),
    REAL(struct case_file, every, QTY_TIME, PARAM_ABOVE_0, 1e9, "",
         "surfaces and particles are written at the multiples of it; default end/100"),
    REAL(struct case_file, sample, QTY_TIME, PARAM_ABOVE_0, 1e9, "",
         "energy, probes and gauges are written at the first step after each multiple of it; "
         "default every/10"),
};

struct probe_section {
  char *name;
  double size;
  int at;
};
static const struct param probe_rows[] = {
    TEXT(struct probe_section, name, 64, NULL, "name of the series"),
    NODE(struct probe_section, at, NULL, "a point [x, y] on a wall"),
    REAL(struct probe_section, size, QTY_LENGTH, 0, 1e6, "0",
         "length along the wall over which it averages; 0 is a point"),
};

static const struct param gauge_rows[] = {
    TEXT(struct case_gauge, name, 64, NULL, "name of the series"),
    REAL(struct case_gauge, x, QTY_LENGTH, -1e6, 1e6, NULL, "position of the vertical wire"),
};

struct point_section {
  char *name;
  int at, every;
  bool follow;
};
static const struct param point_rows[] = {
    TEXT(struct point_section, name, 64, NULL, "name of the series"),
    NODE(struct point_section, at, NULL, "a point [x, y] in the tank"),
    {.key = "every",
     .type = PARAM_INT,
     .offset = offsetof(struct point_section, every),
     .min = 1,
     .max = 1e6,
     .value = "1",
     .help = "steps of SPH from one row to the next: sum V f W / sum V W over the particles around "
             "it, of p, rho, u, v, the accelerations a_x, a_y, and sum V W, cover; BEM has a row a "
             "sample, without accelerations"},
    {.key = "follow",
     .type = PARAM_BOOL,
     .offset = offsetof(struct point_section, follow),
     .value = "false",
     .help = "of SPH: instead, what the particle has that is nearest at t = 0, wherever it goes"},
};

bool case_read_section(struct case_draft *d, int node, const char *path, const struct param *rows,
                       size_t n, void *into) {
  struct case_block block = {rows, n, into, NULL};
  int line = case_doc_line(&d->doc, case_doc_root(&d->doc));
  return case_doc_read(&d->doc, node, path, line, 1, &block);
}

enum status case_periodic_ends(const char *text, bool periodic[2]) {
  static const char *const keys[2] = {"sides", "bed"};
  struct problems problems = {0};
  struct case_doc doc = {0};
  periodic[0] = periodic[1] = false;
  if (case_doc_load(&doc, text, strlen(text), &problems)) {
    const int tank = case_doc_member(&doc, case_doc_root(&doc), "tank");
    for (int axis = 0; axis < 2; axis++) {
      const char *word = case_doc_text(&doc, case_doc_member(&doc, tank, keys[axis]));
      periodic[axis] = word && !strcmp(word, sides_names[SIDES_PERIODIC]);
    }
  }
  const bool memory = !problems.out_of_memory;
  case_doc_destroy(&doc);
  problems_destroy(&problems);
  CHECK(memory, ERR_MEMORY, "no memory to read a case");
  return OK;
}

/* tank, water and time are required: when they are absent the top level has said so, and nothing is
 * asked of what is in them. */
static enum status read_tank(struct case_draft *d) {
  struct tank_section s = {0};
  size_t faults = d->doc.faults;
  if (d->at.tank && case_read_section(d, d->at.tank, "tank", tank_rows, ROWS(tank_rows), &s))
    TRY(case_read_walls(d, s.walls));
  TRY(case_read_motions(d, s.motions));
  d->c->periodic[0] = s.sides == SIDES_PERIODIC;
  d->c->periodic[1] = s.bed == SIDES_PERIODIC;
  d->good.tank = d->at.tank && d->doc.faults == faults;
  d->c->tank = geo_lines_box(&d->c->walls);
  d->c->rectangular = d->good.tank && tank_is_rectangular(&d->c->walls, case_near(d->c));
  return OK;
}

/* The kind that a form says it is, or nearly says: it decides which keys there are. */
static const struct flow *kind_of_form(struct case_draft *d, int node, const struct form_list *l) {
  const char *text = case_doc_text(&d->doc, case_doc_member(&d->doc, node, "kind"));
  const char *name = text ? param_nearest(text, l->flows->n, l->names) : NULL;
  for (size_t i = 0; name && i < l->flows->n; i++)
    if (!strcmp(l->names[i], name)) return l->flows->flow[i];
  return l->flows->flow[0];
}

static enum status read_form(struct case_draft *d, int node, const struct form_list *l) {
  const struct flow *flow = kind_of_form(d, node, l);
  struct case_file *c = d->c;
  struct form_section s = {0};
  case_release_form(c);
  c->flow = flow;
  c->form = array_memory(NULL, 1, flow->params_size, "parameters of a flow");
  if (!c->form) return ERR_MEMORY;
  struct case_block blocks[] = {{l->rows, 1, &s, NULL},
                                {flow->params, flow->n_params, c->form, NULL}};
  if (!case_doc_read(&d->doc, node, l->path, case_doc_line(&d->doc, node), ROWS(blocks), blocks))
    return OK;
  return flow->read && d->read_data ? flow->read(d, node) : OK;
}

static enum status read_water(struct case_draft *d) {
  struct water_section s = {0};
  struct case_file *c = d->c;
  size_t faults = d->doc.faults;
  if (d->at.water && case_read_section(d, d->at.water, "water", water_rows, ROWS(water_rows), &s)) {
    d->pressure = s.pressure;
    case_release_form(c); /* by the flow that it is of */
    c->flow = flow_regions.flow[s.pressure];
    if (s.velocity) case_read_velocity(&d->doc, s.velocity, "water.velocity", c->velocity);
    const int given = !!s.regions + !!s.wave + !!s.body;
    if (given != 1)
      case_doc_problem(&d->doc, case_doc_line(&d->doc, d->at.water), "water",
                       given ? "more than one of regions, wave and body" : "no water",
                       "one of regions, wave and body", given ? "remove the others" : "add it");
    else if (s.regions)
      TRY(case_read_regions(d, s.regions));
    else if (s.wave)
      TRY(read_form(d, s.wave, &form_of_waves));
    else
      TRY(read_form(d, s.body, &form_of_bodies));
  }
  d->good.water = d->at.water && d->doc.faults == faults;
  return OK;
}

/* Without scales.H, H is the height of the water: known when no length there is in units of H. */
static enum status find_H(struct case_draft *d) {
  struct problems unheard = {0}, *told = d->doc.problems;
  struct case_doc *doc = &d->doc;
  size_t faults = doc->faults;
  d->doc.problems = &unheard;
  enum status status = read_tank(d);
  if (status == OK) status = read_water(d);
  if (doc->faults == faults)
    d->c->H = d->c->flow->scale ? d->c->flow->scale(d->c).depth
                                : geo_lines_box(&d->c->water).max[1] - d->c->tank.min[1];
  bool missed = doc->H_missed;
  problems_destroy(&unheard);
  doc->problems = told;
  doc->faults = faults;
  doc->H_missed = false;
  if (!(d->c->H > 0)) { /* the sections themselves say why when they are read again */
    d->c->H = missed ? NAN : 1;
    d->good.scales = false;
  }
  return status;
}

void case_read_time(struct case_draft *d) {
  struct case_file *c = d->c;
  d->good.time =
      d->at.time && case_read_section(d, d->at.time, "time", time_rows, ROWS(time_rows), c);
  if (!d->good.time) return;
  if (c->every == 0) c->every = c->end / 100;
  if (c->sample == 0) c->sample = c->every / 10;
}

/* How many items the list `node`, which may be absent, has. */
static size_t count_items(struct case_doc *doc, int node, const char *name) {
  if (!node || !case_doc_expect_list(doc, node, name, 0, CASE_MOST_ITEMS, name)) return 0;
  return case_doc_size(doc, node);
}

static enum status read_probes(struct case_draft *d) {
  struct case_doc *doc = &d->doc;
  size_t faults = doc->faults, n = count_items(doc, d->at.probes, "probes");
  TRY(array_create(&d->c->probes, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    struct case_probe *probe = &d->c->probes[d->c->n_probes++];
    struct probe_section s = {0};
    double at[2] = {0};
    char path[CASE_PATH], at_path[CASE_PATH + 8];
    int node = case_doc_item(doc, d->at.probes, i);
    case_doc_item_path(doc, "probes", node, i, path);
    if (case_read_section(d, node, path, probe_rows, ROWS(probe_rows), &s)) {
      snprintf(at_path, sizeof at_path, "%s.at", path);
      case_read_point(doc, s.at, at_path, at);
    }
    *probe = (struct case_probe){s.name, at[0], at[1], s.size};
  }
  d->good.probes = doc->faults == faults;
  return OK;
}

static enum status read_gauges(struct case_draft *d) {
  struct case_doc *doc = &d->doc;
  size_t faults = doc->faults, n = count_items(doc, d->at.gauges, "gauges");
  TRY(array_create(&d->c->gauges, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    char path[CASE_PATH];
    int node = case_doc_item(doc, d->at.gauges, i);
    case_doc_item_path(doc, "gauges", node, i, path);
    case_read_section(d, node, path, gauge_rows, ROWS(gauge_rows), &d->c->gauges[d->c->n_gauges++]);
  }
  d->good.gauges = doc->faults == faults;
  return OK;
}

static enum status read_points(struct case_draft *d) {
  struct case_doc *doc = &d->doc;
  size_t faults = doc->faults, n = count_items(doc, d->at.points, "points");
  TRY(array_create(&d->c->points, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    struct case_point *point = &d->c->points[d->c->n_points++];
    struct point_section s = {0};
    double at[2] = {0};
    char path[CASE_PATH], at_path[CASE_PATH + 8];
    int node = case_doc_item(doc, d->at.points, i);
    case_doc_item_path(doc, "points", node, i, path);
    if (case_read_section(d, node, path, point_rows, ROWS(point_rows), &s)) {
      snprintf(at_path, sizeof at_path, "%s.at", path);
      case_read_point(doc, s.at, at_path, at);
    }
    *point = (struct case_point){s.name, at[0], at[1], s.every, s.follow};
  }
  d->good.points = doc->faults == faults;
  return OK;
}

static const struct param top_rows[] = {
    TEXT(struct case_file, title, 200, "", "title of the report"),
};

const struct case_table case_section_tables[] = {
    {"(top level)", top_rows, ROWS(top_rows)},
    {"fluid", fluid_rows, ROWS(fluid_rows)},
    {"scales", scales_rows, ROWS(scales_rows)},
    {"tank", tank_rows, ROWS(tank_rows)},
    {"water", water_rows, ROWS(water_rows)},
    {"water.wave", wave_rows, ROWS(wave_rows)},
    {"water.body", body_rows, ROWS(body_rows)},
    {"time", time_rows, ROWS(time_rows)},
    {"probes (a list)", probe_rows, ROWS(probe_rows)},
    {"gauges (a list)", gauge_rows, ROWS(gauge_rows)},
    {"points (a list)", point_rows, ROWS(point_rows)},
    {0},
};

/* One number is gravity downwards, two are gravity along both axes. */
static bool read_gravity(struct case_draft *d, int node) {
  static const struct param downwards = {
      .type = PARAM_REAL, .quantity = QTY_ACCELERATION, .min = 0, .max = 1e6};
  static const struct param along = {
      .type = PARAM_REAL, .quantity = QTY_ACCELERATION, .min = -1e6, .max = 1e6};
  struct case_file *c = d->c;
  double g[2];
  c->gravity = 9.81;
  if (!node) return true;
  if (!case_doc_is_list(&d->doc, node))
    return case_doc_value(&d->doc, node, "fluid.gravity", &downwards, &c->gravity);
  if (!case_read_pair(&d->doc, node, "fluid.gravity", &along, "accelerations [gx, gy]", g))
    return false;
  c->gravity = hypot(g[0], g[1]);
  for (int k = 0; k < 2 && c->gravity > 0; k++) c->down[k] = g[k] / c->gravity;
  return true;
}

static void read_fluid(struct case_draft *d) {
  struct fluid_section s = {0};
  struct case_file *c = d->c;
  c->down[0] = 0;
  c->down[1] = -1;
  bool good = case_read_section(d, d->at.fluid, "fluid", fluid_rows, ROWS(fluid_rows), &s);
  good &= read_gravity(d, s.gravity);
  c->density = s.density;
  if (!good && !(c->gravity > 0))
    c->gravity = 9.81; /* the fault is noted; this one keeps units meaningful for what follows */
}

/* That of the scales is gravity, where there is any. */
static void choose_g(struct case_draft *d) {
  const struct case_file *c = d->c;
  if (!(c->gravity > 0) == (c->g > 0)) return;
  int line = d->at.scales ? case_doc_member_line(&d->doc, d->at.scales, "g")
                          : case_doc_line(&d->doc, d->at.fluid);
  case_doc_problem(&d->doc, line, "scales.g",
                   c->g > 0 ? "another acceleration than gravity" : "nothing, and no gravity",
                   "an acceleration where fluid.gravity is 0, and only there",
                   c->g > 0 ? "remove it" : "add it: units of time and velocity need one");
  d->good.scales = false;
}

enum status case_read_sections(struct case_draft *d) {
#define SECTION(name, def, text)                                                                   \
  {                                                                                                \
    .key = #name, .type = PARAM_NODE, .offset = offsetof(struct case_draft, at.name),              \
    .value = def, .help = text                                                                     \
  }
  static const struct param section_rows[] = {
      SECTION(fluid, "", "a mapping with density, gravity"),
      SECTION(scales, "", "a mapping with H, g"),
      SECTION(tank, NULL, "a mapping with walls, sides, bed, motions"),
      SECTION(water, NULL, "a mapping with regions, wave or body"),
      SECTION(time, NULL, "a mapping with end, every, sample"),
      SECTION(probes, "", "a list of probes"),
      SECTION(gauges, "", "a list of gauges"),
      SECTION(points, "", "a list of points"),
      SECTION(runs, NULL, "a list of runs"),
      SECTION(compare, "",
              "a mapping with reference, times, window, tolerances, averages, filters, spectra, "
              "experiments, profiles, events"),
  };
  struct case_file *c = d->c;
  struct case_doc *doc = &d->doc;
  int root = case_doc_root(doc);
  c->flow = flow_regions.flow[0];
  struct case_block top[] = {{top_rows, ROWS(top_rows), c, NULL},
                             {section_rows, ROWS(section_rows), d, NULL}};
  case_doc_read(doc, root, "", case_doc_line(doc, root), 2, top);
  if (!case_doc_is_mapping(doc, root)) return OK; /* said just now; the rest would only repeat it */

  read_fluid(d);
  doc->scales.g = c->gravity > 0 ? c->gravity : NAN;
  d->good.scales = case_read_section(d, d->at.scales, "scales", scales_rows, ROWS(scales_rows), c);
  if (d->good.scales) choose_g(d);
  if (!(c->g > 0)) c->g = c->gravity > 0 ? c->gravity : 1;
  doc->scales.g = c->g;
  if (!d->good.scales && !(c->H > 0)) c->H = 1; /* likewise */
  if (!(c->H > 0)) TRY(find_H(d));
  doc->scales.H = c->H;

  TRY(read_tank(d));
  TRY(read_water(d));
  if (d->good.tank && d->good.water && c->flow->scale) TRY(flow_outline(c, &c->water));
  case_read_time(d);
  TRY(read_probes(d));
  TRY(read_gauges(d));
  TRY(read_points(d));
  return OK;
}
