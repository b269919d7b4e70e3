/* tank.motions: read beside the walls, and checked when walls, water and times are known. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/case/case_draft.h"
#include "common/tank/motion.h"
#include "common/tank/tank.h"

struct motion_section {
  int kind, side, about;
  char *file;
  double amplitude, period, phase, ramp, hinge;
};

static const char *const kind_names[] = {
#define X(name, help) #name,
    TANK_MOTIONS(X)
#undef X
        NULL};
static const char *const kind_helps[] = {
#define X(name, help) help,
    TANK_MOTIONS(X)
#undef X
        NULL};
enum { N_KINDS = ROWS(kind_names) - 1 };

static const struct param motion_rows[] = {
    {.key = "kind",
     .type = PARAM_CHOICE,
     .offset = offsetof(struct motion_section, kind),
     .choices = kind_names,
     .help = "what moves, and which way is positive",
     .helps = kind_helps},
    TEXT(struct motion_section, file, 1000, "",
         "lines 't, q' in s and m or rad, of positions, from t = 0 or before to time.end; relative "
         "to the case; a cubic spline goes through them"),
    REAL(struct motion_section, period, QTY_TIME, PARAM_ABOVE_0, 1e9, "",
         "of amplitude R(t/ramp) sin(2 pi t/period + phase)"),
    REAL(struct motion_section, phase, QTY_NUMBER, -1e6, 1e6, "0", "rad"),
    REAL(struct motion_section, ramp, QTY_TIME, 0, 1e9, "",
         "time over which R(s) = s^3 (10 - 15 s + 6 s^2) lets the sine grow; default: one period"),
};
#define LENGTH                                                                                     \
  REAL(struct motion_section, amplitude, QTY_LENGTH, -1e6, 1e6, "", "largest displacement")
#define ANGLE(most)                                                                                \
  REAL(struct motion_section, amplitude, QTY_NUMBER, -most, most, "", "largest angle, rad")
static const char *const side_names[] = {"left", "right", NULL};
#define SIDE                                                                                       \
  {                                                                                                \
    .key = "side", .type = PARAM_CHOICE, .offset = offsetof(struct motion_section, side),          \
    .choices = side_names, .help = "which side of the tank"                                        \
  }
static const struct param shift_rows[] = {LENGTH};
static const struct param roll_rows[] = {
    ANGLE(3.15),
    NODE(struct motion_section, about, "",
         "a point [x, y] that it rolls about; default: the middle of the bed"),
};
static const struct param piston_rows[] = {LENGTH, SIDE};
static const struct param flap_rows[] = {
    ANGLE(1.5),
    SIDE,
    REAL(struct motion_section, hinge, QTY_LENGTH, -1e6, 1e6, "",
         "height y of the hinge; default: that of the bed"),
};

/* The rows of each kind's own keys, in the order of TANK_MOTIONS. */
static const struct {
  const struct param *rows;
  size_t n;
} own_rows[] = {
    [TANK_MOTION_sway] = {shift_rows, ROWS(shift_rows)},
    [TANK_MOTION_heave] = {shift_rows, ROWS(shift_rows)},
    [TANK_MOTION_roll] = {roll_rows, ROWS(roll_rows)},
    [TANK_MOTION_piston] = {piston_rows, ROWS(piston_rows)},
    [TANK_MOTION_flap] = {flap_rows, ROWS(flap_rows)},
};

const struct case_table case_motion_tables[] = {
    {"tank.motions (a list; and the keys of the kind)", motion_rows, ROWS(motion_rows)},
    {"tank.motions of kind sway or heave", shift_rows, ROWS(shift_rows)},
    {"tank.motions of kind roll", roll_rows, ROWS(roll_rows)},
    {"tank.motions of kind piston", piston_rows, ROWS(piston_rows)},
    {"tank.motions of kind flap", flap_rows, ROWS(flap_rows)},
    {0},
};

static void motion_path(size_t i, const char *key, char path[CASE_PATH]) {
  snprintf(path, CASE_PATH, "tank.motions[%zu]%s%s", i, key ? "." : "", key ? key : "");
}

static int motion_node(struct case_draft *d, size_t i) {
  return case_doc_item(&d->doc, case_doc_member(&d->doc, d->at.tank, "motions"), i);
}

void case_motion_problem(struct case_draft *d, size_t i, const char *key, const char *found,
                         const char *allowed, const char *todo) {
  char path[CASE_PATH];
  int node = motion_node(d, i);
  motion_path(i, key, path);
  case_doc_problem(&d->doc,
                   key ? case_doc_member_line(&d->doc, node, key) : case_doc_line(&d->doc, node),
                   path, found, allowed, todo);
}

/* ---- reading ---- */

/* The kind that it says it is, or nearly says: it decides which keys there are. */
static enum tank_motion_kind kind_of(struct case_draft *d, int node) {
  const char *text = case_doc_text(&d->doc, case_doc_member(&d->doc, node, "kind"));
  const char *name = text ? param_nearest(text, N_KINDS, kind_names) : NULL;
  size_t kind = 0;
  while (name && strcmp(kind_names[kind], name) != 0) kind++;
  return (enum tank_motion_kind)kind;
}

/* A sine has an amplitude and a period, a file has nothing of a sine. */
static void check_sine(struct case_draft *d, size_t i, int node, const struct motion_section *s) {
  static const char *const keys[] = {"amplitude", "period", "phase", "ramp"};
  for (size_t k = 0; k < ROWS(keys); k++) {
    const bool given = case_doc_member(&d->doc, node, keys[k]);
    if (s->file && given)
      case_motion_problem(d, i, keys[k], "a sine beside a file", "one of them", "remove the other");
    else if (!s->file && !given && k < 2)
      case_motion_problem(d, i, keys[k], "nothing",
                          "amplitude and period of a sine, or a file of positions", "add this key");
  }
}

static enum status read_record(struct case_draft *d, size_t i, const char *file,
                               struct tank_record *record) {
  static const struct case_columns columns = {
      "t, q", 2, {1, 1}, CASE_ROWS_RISE, "times that increase", "s"};
  char path[CASE_PATH];
  struct case_rows rows;
  size_t faults = d->doc.faults;
  motion_path(i, "file", path);
  const int line = case_doc_member_line(&d->doc, motion_node(d, i), "file");
  enum status status = case_read_rows(d, file, line, path, &columns, &rows);
  *record = (struct tank_record){.n = rows.n, .t = rows.x, .q = rows.y};
  if (status == OK && d->doc.faults == faults)
    status = case_check_rows(d, file, line, path, &columns, &rows);
  if (status == OK && d->doc.faults == faults) return tank_record_finish(record);
  tank_record_destroy(record);
  return status;
}

static enum status read_motion(struct case_draft *d, size_t i, int node, struct tank_motion *m) {
  struct case_doc *doc = &d->doc;
  struct motion_section s = {.hinge = NAN, .ramp = NAN};
  char path[CASE_PATH];
  const struct geo_box box = geo_lines_box(&d->c->walls);
  enum status status = OK;
  m->kind = kind_of(d, node);
  struct case_block blocks[] = {{motion_rows, ROWS(motion_rows), &s, NULL},
                                {own_rows[m->kind].rows, own_rows[m->kind].n, &s, NULL}};
  motion_path(i, NULL, path);
  m->about[0] = (box.min[0] + box.max[0]) / 2;
  m->about[1] = box.min[1];
  if (case_doc_read(doc, node, path, case_doc_line(doc, node), ROWS(blocks), blocks)) {
    check_sine(d, i, node, &s);
    motion_path(i, "about", path);
    if (s.about) case_read_point(doc, s.about, path, m->about);
    if (s.file && d->read_data) status = read_record(d, i, s.file, &m->file);
    m->side = s.side;
    m->hinge = s.hinge;
    m->sine.amplitude = s.amplitude;
    m->sine.period = s.period;
    m->sine.phase = s.phase;
    m->sine.ramp = isnan(s.ramp) ? s.period : s.ramp;
  }
  free(s.file);
  return status;
}

enum status case_read_motions(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  case_release_motions(d->c);
  if (!node || !case_doc_expect_list(doc, node, "tank.motions", 1, CASE_MOST_ITEMS, "motions"))
    return OK;
  const size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->motions, n, "entries of the case"));
  for (size_t i = 0; i < n; i++)
    TRY(read_motion(d, i, case_doc_item(doc, node, i), &d->c->motions[d->c->n_motions++]));
  return OK;
}

void case_release_motions(struct case_file *c) {
  for (size_t i = 0; i < c->n_motions; i++) tank_record_destroy(&c->motions[i].file);
  free(c->motions);
  c->motions = NULL;
  c->n_motions = 0;
}

/* ---- checking ---- */

/* Of one kind with each other: rolls about one point, flaps of one side about one hinge. */
static void check_together(struct case_draft *d, size_t i) {
  const struct tank_motion *m = &d->c->motions[i];
  for (size_t k = 0; k < i; k++) {
    const struct tank_motion *o = &d->c->motions[k];
    if (o->kind != m->kind) continue;
    if (m->kind == TANK_MOTION_roll && (o->about[0] != m->about[0] || o->about[1] != m->about[1])) {
      case_motion_problem(d, i, "about", "a second point to roll about", "rolls about one point",
                          "give both the same");
      return;
    }
    if (m->kind == TANK_MOTION_flap && o->side == m->side && o->hinge != m->hinge) {
      case_motion_problem(d, i, "hinge", "a second hinge of a side",
                          "flaps of a side about one hinge", "give both the same");
      return;
    }
  }
}

/* The bed beside a piston slides under it. */
static void check_bed_of_piston(struct case_draft *d, size_t i, const struct tank_side *s) {
  const struct geo_lines *w = &d->c->walls;
  const double *foot = w->p[s->foot], *next = w->p[s->next];
  const double way = d->c->motions[i].side == TANK_RIGHT ? -1 : 1;
  char found[128];
  if (fabs(next[1] - foot[1]) <= case_near(d->c) && (next[0] - foot[0]) * way > 0) return;
  snprintf(found, sizeof found, "a piston on a bed from (%.6g, %.6g) to (%.6g, %.6g) m", foot[0],
           foot[1], next[0], next[1]);
  case_motion_problem(d, i, "side", found, "a piston whose piece of the bed is level",
                      "put a level piece before it");
}

/* The wall bends at the hinge: a vertex more there, unless there is one. */
static void put_vertex(struct case_draft *d, const struct tank_side *s, double hinge) {
  struct geo_lines *w = &d->c->walls;
  size_t i = s->top < s->foot ? s->top : s->foot;
  const size_t last = s->top < s->foot ? s->foot : s->top;
  const double near = case_near(d->c);
  for (; i < last; i++) {
    const double *p = w->p[i], *q = w->p[i + 1];
    if (fmin(p[1], q[1]) > hinge - near || fmax(p[1], q[1]) < hinge + near) continue;
    const double part = (hinge - p[1]) / (q[1] - p[1]);
    if (geo_lines_insert(w, geo_lines_vessel(w), i + 1, p[0] + part * (q[0] - p[0]), hinge) != OK)
      d->doc.problems->out_of_memory = true;
    return;
  }
}

/* Where the hinge is, and that it is on the side. */
static void check_hinge(struct case_draft *d, size_t i, const struct tank_side *s) {
  struct tank_motion *m = &d->c->motions[i];
  const struct geo_lines *w = &d->c->walls;
  const double foot = w->p[s->foot][1], top = w->p[s->top][1];
  char found[96], allowed[128];
  if (isnan(m->hinge)) m->hinge = foot;
  if (m->hinge >= foot && m->hinge < top - case_near(d->c)) {
    put_vertex(d, s, m->hinge);
    return;
  }
  snprintf(found, sizeof found, "a hinge at y = %.6g m", m->hinge);
  snprintf(allowed, sizeof allowed, "on its side, from %.6g m to below %.6g m", foot, top);
  case_motion_problem(d, i, "hinge", found, allowed, "move it");
}

static void check_side(struct case_draft *d, size_t i) {
  const struct tank_motion *m = &d->c->motions[i];
  struct tank_side s;
  char found[96];
  if (!tank_find_side(&d->c->walls, m->side, &s)) {
    case_motion_problem(d, i, "side", "a side of walls that make no tank",
                        "one open wall: down the left side, along the bed, up the right side",
                        "change tank.walls");
    return;
  }
  if (m->kind == TANK_MOTION_piston)
    check_bed_of_piston(d, i, &s);
  else
    check_hinge(d, i, &s);
  double q[3];
  tank_motion_at(m, 0, q);
  if (fabs(q[0]) <= 1e-6 * (m->kind == TANK_MOTION_piston ? case_tank_size(d->c) : 1)) return;
  snprintf(found, sizeof found, "the %s at %.6g %s at t = 0", tank_motion_name(m), q[0],
           m->kind == TANK_MOTION_piston ? "m" : "rad");
  case_motion_problem(d, i, m->file.n ? "file" : "ramp", found, "0 there, where tank.walls draw it",
                      m->file.n ? "subtract it from the file's positions" : "give it a ramp");
}

static void check_periodic(struct case_draft *d, size_t i) {
  const struct tank_motion *m = &d->c->motions[i];
  char found[96];
  if (!d->c->periodic[0] || m->kind == TANK_MOTION_sway || m->kind == TANK_MOTION_heave) return;
  snprintf(found, sizeof found, "'%s' with periodic sides", tank_motion_name(m));
  case_motion_problem(d, i, "kind", found, "sway and heave of a tank without sides",
                      "write tank.sides: walls");
}

/* A file has the whole time of the case. */
static void check_span(struct case_draft *d, size_t i) {
  const struct tank_record *r = &d->c->motions[i].file;
  char found[96], allowed[96];
  if (!r->n || !d->good.time) return;
  if (r->t[0] <= 0 && r->t[r->n - 1] >= d->c->end * (1 - CASE_SAME)) return;
  snprintf(found, sizeof found, "rows from %.6g to %.6g s", r->t[0], r->t[r->n - 1]);
  snprintf(allowed, sizeof allowed, "rows from 0 to time.end, %.6g s", d->c->end);
  case_motion_problem(d, i, "file", found, allowed,
                      r->t[0] > 0 ? "add the first rows" : "add the last rows or end earlier");
}

void case_refuse_motions(const struct case_file *c, const struct case_run *r,
                         struct problems *problems) {
  if (!c->n_motions) return;
  problems_add(problems, case_run_line(r, "solver"),
               "runs.%s.solver: found '%s' in a tank that moves (%s); allowed: a tank at rest; "
               "remove tank.motions or take another solver",
               r->name, r->solver->name, tank_motion_name(&c->motions[0]));
}

void case_check_motions(struct case_draft *d) {
  const struct case_file *c = d->c;
  size_t faults = d->doc.faults;
  for (size_t i = 0; d->good.tank && i < c->n_motions; i++) {
    check_periodic(d, i);
    if (tank_motion_is_of_side(&c->motions[i])) check_side(d, i);
    check_together(d, i);
    check_span(d, i);
  }
  if (d->doc.faults == faults && d->good.shapes && d->good.time && case_check_strokes(d) != OK)
    d->doc.problems->out_of_memory = true;
  d->good.shapes &= d->doc.faults == faults;
}
