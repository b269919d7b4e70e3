/* How far the sides of a tank move: a wavemaker stays in its tank, meets no other wall, and leaves
 * room for the water. */
#include <math.h>
#include <string.h>

#include "common/base/geometry_check.h"
#include "common/case/case_draft.h"
#include "common/tank/motion.h"
#include "common/tank/tank.h"

enum {
  SAMPLES_PER_PERIOD = 64, /* the extreme is found within 1 - cos(pi/64), a thousandth */
  MOST_SAMPLES = 200000,
  STEPS = 16, /* between rest and the extreme, to find which comes first of what is in the way */
};

static double shortest_time(const struct case_file *c, int side) {
  double shortest = c->end;
  for (size_t i = 0; i < c->n_motions; i++) {
    const struct tank_motion *m = &c->motions[i];
    if (!tank_motion_is_of_side(m) || m->side != side) continue;
    for (size_t k = 0; k + 1 < m->file.n; k++)
      shortest = fmin(shortest, 8 * (m->file.t[k + 1] - m->file.t[k]));
    if (!m->file.n && m->sine.period > 0) shortest = fmin(shortest, m->sine.period);
  }
  return shortest;
}

static int count_samples(const struct case_file *c, int side) {
  const double samples = c->end / shortest_time(c, side) * SAMPLES_PER_PERIOD;
  return (int)fmin(fmax(samples, SAMPLES_PER_PERIOD), MOST_SAMPLES);
}

struct case_strokes case_find_strokes(const struct case_file *c, int side) {
  struct case_strokes s = {{0, 0}, {0, 0}};
  const int n = count_samples(c, side);
  for (int i = 0; i <= n; i++) {
    double q[3], t = c->end * i / n;
    tank_side_at(c->motions, c->n_motions, TANK_MOTION_piston, side, t, q);
    s.piston[0] = fmin(s.piston[0], q[0]);
    s.piston[1] = fmax(s.piston[1], q[0]);
    tank_side_at(c->motions, c->n_motions, TANK_MOTION_flap, side, t, q);
    s.flap[0] = fmin(s.flap[0], q[0]);
    s.flap[1] = fmax(s.flap[1], q[0]);
  }
  return s;
}

/* The room that a vessel closes, as a closed piece. */
static enum status copy_vessel(const struct geo_lines *w, size_t vessel, struct geo_lines *room) {
  geo_lines_clear(room);
  TRY(geo_lines_begin(room, true));
  for (size_t i = w->first[vessel]; i < w->first[vessel + 1]; i++)
    TRY(geo_lines_add(room, w->p[i][0], w->p[i][1]));
  return OK;
}

/* Whether a side has gone past wall k: a part of it that was in the room at rest is behind. Sides
 * pass each place once on their way to one end, so that what has neither been met nor passed there
 * is not met before, however thin it is. */
static bool has_passed(const struct geo_lines *rest, const struct geo_lines *now,
                       const struct geo_lines *w, size_t k) {
  for (size_t i = 0; i < geo_piece_segments(w, k); i++) {
    const double *a = w->p[w->first[k] + i], *b = geo_segment_end(w, k, i);
    const double x = (a[0] + b[0]) / 2, y = (a[1] + b[1]) / 2;
    if (geo_lines_contain(rest, x, y) && !geo_lines_contain(now, x, y)) return true;
  }
  return false;
}

/* Whether a wall other than the vessel is met or passed. */
static bool meets_other(const struct case_file *c, const struct geo_lines *w, size_t vessel,
                        enum status *status) {
  struct geo_lines rest = {0}, now = {0};
  bool meets = false;
  *status = copy_vessel(&c->walls, vessel, &rest);
  if (*status == OK) *status = copy_vessel(w, vessel, &now);
  for (size_t k = 0; k < w->pieces && *status == OK && !meets; k++) {
    if (k == vessel) continue;
    *status = geo_pieces_cross(w, vessel, k, &meets);
    meets = *status == OK && (meets || has_passed(&rest, &now, w, k));
  }
  geo_lines_destroy(&rest);
  geo_lines_destroy(&now);
  return meets;
}

/* What is wrong with walls in a place, or NULL; *status for want of memory. */
static const char *judge_walls(const struct case_file *c, const struct geo_lines *w,
                               const struct tank_side *s, enum status *status) {
  const size_t vessel = geo_lines_vessel(&c->walls);
  const double *foot = w->p[s->foot], *next = w->p[s->next], *was = c->walls.p[s->foot];
  bool simple;
  double at[2], area = INFINITY;
  if (s->next != s->foot && (next[0] - foot[0]) * (c->walls.p[s->next][0] - was[0]) < 0)
    return "beyond the end of its level bed";
  if ((*status = geo_piece_simple(w, vessel, true, &simple, at)) != OK) return NULL;
  if (!simple) return "into another part of the wall";
  if (meets_other(c, w, vessel, status)) return "through another wall";
  if (*status != OK) return NULL;
  const size_t a = w->first[vessel], b = w->first[vessel + 1] - 1;
  if ((*status = geo_area_below(w, fmin(w->p[a][1], w->p[b][1]), &area, at)) != OK) return NULL;
  return area < case_water_area(c) * (1 - CASE_SAME) ? "until the water has no room" : NULL;
}

/* The same with a side that has gone `part` of its stroke to one end. */
static const char *judge_part(const struct case_file *c, int side, const struct case_strokes *s,
                              int end, double part, struct geo_lines *w, enum status *status) {
  struct tank_side where;
  struct tank_shift shift = {.piston = {part * s->piston[end]},
                             .flap = {part * s->flap[end]},
                             .hinge = tank_hinge(c->motions, c->n_motions, side)};
  if (!tank_find_side(&c->walls, side, &where)) return NULL;
  if ((*status = geo_lines_copy(w, &c->walls)) != OK) return NULL;
  tank_side_move(&c->walls, &where, &shift, w->p, NULL, NULL);
  return judge_walls(c, w, &where, status);
}

static size_t first_of_side(const struct case_file *c, int side, enum tank_motion_kind kind) {
  size_t i = 0;
  while (i < c->n_motions && (c->motions[i].kind != kind || c->motions[i].side != side)) i++;
  return i;
}

static void say_stroke(struct case_draft *d, int side, const struct case_strokes *s, int end,
                       double least, const char *why) {
  const struct case_file *c = d->c;
  const bool turns = fabs(s->flap[end]) > 0;
  const size_t i = first_of_side(c, side, turns ? TANK_MOTION_flap : TANK_MOTION_piston);
  const double stroke = turns ? s->flap[end] : s->piston[end];
  const char *unit = turns ? "rad" : "m";
  char found[160], allowed[96];
  snprintf(found, sizeof found, "%.4g %s to the %s, %s", fabs(stroke), unit, end ? "right" : "left",
           why);
  snprintf(allowed, sizeof allowed, "up to %.3g %s", floor(least * fabs(stroke) * 1e4) / 1e4, unit);
  case_motion_problem(d, i, c->motions[i].file.n ? "file" : "amplitude", found, allowed,
                      "make the stroke smaller");
}

/* The first part of the stroke that does not go, and then between it and the last that does. */
static enum status check_end(struct case_draft *d, int side, const struct case_strokes *s, int end,
                             struct geo_lines *w) {
  enum status status = OK;
  const char *why = NULL, *then;
  double good = 0, bad = 0;
  if (s->piston[end] == 0 && s->flap[end] == 0) return OK;
  for (int k = 1; k <= STEPS && !why && status == OK; k++) {
    good = bad;
    bad = (double)k / STEPS;
    why = judge_part(d->c, side, s, end, bad, w, &status);
  }
  if (!why) return status;
  for (int k = 0; k < 20 && status == OK; k++) {
    const double middle = (good + bad) / 2;
    if ((then = judge_part(d->c, side, s, end, middle, w, &status)) != NULL) {
      bad = middle;
      why = then;
    } else {
      good = middle;
    }
  }
  if (status == OK) say_stroke(d, side, s, end, good, why);
  return status;
}

/* Displacements of a side at t. */
static struct tank_shift shift_at(const struct case_file *c, int side, double t) {
  struct tank_shift s = {.hinge = tank_hinge(c->motions, c->n_motions, side)};
  tank_side_at(c->motions, c->n_motions, TANK_MOTION_piston, side, t, s.piston);
  tank_side_at(c->motions, c->n_motions, TANK_MOTION_flap, side, t, s.flap);
  return s;
}

/* How far the bed gets shorter between two sides, and the level of their tops, m. */
static void close_in(const struct case_file *c, double t, double by[2]) {
  const struct tank_shift l = shift_at(c, TANK_LEFT, t), r = shift_at(c, TANK_RIGHT, t);
  by[0] = l.piston[0] - r.piston[0];
  by[1] = by[0];
  if (l.flap[0] != 0) by[1] += (c->tank.max[1] - l.hinge) * l.flap[0];
  if (r.flap[0] != 0) by[1] -= (c->tank.max[1] - r.hinge) * r.flap[0];
}

static const char *judge_instant(const struct case_file *c, double t, struct geo_lines *w,
                                 enum status *status) {
  const char *why = NULL;
  struct tank_side where[2];
  if ((*status = geo_lines_copy(w, &c->walls)) != OK) return NULL;
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    const struct tank_shift shift = shift_at(c, side, t);
    if (!tank_find_side(&c->walls, side, &where[side])) return NULL;
    tank_side_move(&c->walls, &where[side], &shift, w->p, NULL, NULL);
  }
  for (int side = TANK_LEFT; side <= TANK_RIGHT && !why && *status == OK; side++)
    why = judge_walls(c, w, &where[side], status);
  return why;
}

/* Both sides, where their feet and where their tops are nearest to each other: each may have room
 * by itself, and not beside the other. */
static enum status check_together(struct case_draft *d, struct geo_lines *w) {
  const struct case_file *c = d->c;
  const int left = count_samples(c, TANK_LEFT), right = count_samples(c, TANK_RIGHT);
  const int n = left > right ? left : right;
  double most[2] = {0}, when[2] = {0}, by[2];
  enum status status = OK;
  for (int i = 0; i <= n; i++) {
    close_in(c, c->end * i / n, by);
    for (int k = 0; k < 2; k++) {
      if (!(by[k] > most[k])) continue;
      most[k] = by[k];
      when[k] = c->end * i / n;
    }
  }
  for (int k = 0; k < 2 && status == OK; k++) {
    const char *why = judge_instant(c, when[k], w, &status);
    if (!why) continue;
    char found[160];
    snprintf(found, sizeof found, "both sides at t = %.4g s, of which one goes %s", when[k], why);
    case_motion_problem(d, 0, NULL, found, "strokes of both sides that leave room for the water",
                        "make them smaller");
    break;
  }
  return status;
}

static bool moves(const struct case_file *c, int side) {
  return first_of_side(c, side, TANK_MOTION_piston) < c->n_motions ||
         first_of_side(c, side, TANK_MOTION_flap) < c->n_motions;
}

enum status case_check_strokes(struct case_draft *d) {
  struct geo_lines w = {0};
  enum status status = OK;
  const size_t before = d->doc.problems->n;
  for (int side = TANK_LEFT; side <= TANK_RIGHT && status == OK; side++) {
    if (!moves(d->c, side)) continue;
    const struct case_strokes s = case_find_strokes(d->c, side);
    for (int end = 0; end < 2 && status == OK; end++) status = check_end(d, side, &s, end, &w);
  }
  if (moves(d->c, TANK_LEFT) && moves(d->c, TANK_RIGHT) && d->doc.problems->n == before &&
      status == OK)
    status = check_together(d, &w);
  geo_lines_destroy(&w);
  return status;
}
