#include "sph/domain/sides.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/tank/motion.h"
#include "sph/domain/wall.h"

/* ---- which points ---- */

static bool has_motion(const struct sph_force *f, enum tank_motion_kind kind, int side) {
  for (size_t k = 0; k < f->n; k++)
    if (f->motion[k].kind == kind && f->motion[k].side == side) return true;
  return false;
}

/* Points of a side that moves: all of them with a piston, those above the hinge with a flap. */
static void mark_side(struct sph *s, int side) {
  struct sph_sides *t = &s->sides;
  const double near = t->near;
  const bool piston = has_motion(&s->force, TANK_MOTION_piston, side);
  const double hinge = tank_hinge(s->force.motion, s->force.n, side);
  struct tank_side at;
  if (!tank_find_side(&t->rest, side, &at)) return;
  const size_t first = at.top < at.foot ? at.top : at.foot;
  const size_t last = at.top < at.foot ? at.foot : at.top;
  for (size_t i = first; i <= last; i++) {
    t->bends[i] = fabs(t->rest.p[i][1] - hinge) <= near;
    t->rides[i] = piston || t->rest.p[i][1] >= hinge - near;
  }
}

enum status sph_sides_create(struct sph *s, const struct case_file *c) {
  struct sph_sides *t = &s->sides;
  const size_t n = c->walls.points;
  for (size_t k = 0; k < c->n_motions; k++) t->move |= tank_motion_is_of_side(&c->motions[k]);
  if (!t->move) return OK;
  t->near = case_near(c);
  TRY(geo_lines_copy(&t->rest, &c->walls));
  TRY(geo_lines_copy(&t->now, &c->walls));
  TRY(array_create(&t->v, n, "sides that move"));
  TRY(array_create(&t->a, n, "sides that move"));
  TRY(array_create(&t->listed, n, "sides that move"));
  TRY(array_create(&t->then, 2 * n, "sides that move"));
  TRY(array_create(&t->rides, n, "sides that move"));
  TRY(array_create(&t->bends, n, "sides that move"));
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) mark_side(s, side);
  return OK;
}

enum status sph_sides_attach(struct sph *s) {
  struct sph_sides *t = &s->sides;
  if (!t->move) return OK;
  TRY(array_create(&t->before, s->faces.n, "sides that move"));
  sph_sides_set(s, 0);
  sph_sides_list(s);
  sph_sides_begin(s);
  return OK;
}

void sph_sides_destroy(struct sph *s) {
  struct sph_sides *t = &s->sides;
  geo_lines_destroy(&t->rest);
  geo_lines_destroy(&t->now);
  free(t->v);
  free(t->a);
  free(t->listed);
  free(t->then);
  free(t->rides);
  free(t->bends);
  free(t->before);
  *t = (struct sph_sides){0};
}

/* ---- how flaps fold ---- */

/* With one side at one end of its stroke. */
static void look_at_end(struct sph *s, const struct case_strokes *most, int side, int end,
                        double *angle) {
  struct sph_sides *t = &s->sides;
  const struct tank_shift shift = {.piston = {most->piston[end]},
                                   .flap = {most->flap[end]},
                                   .hinge = tank_hinge(s->force.motion, s->force.n, side)};
  struct tank_side at;
  if (!tank_find_side(&t->rest, side, &at)) return;
  memcpy(t->now.p, t->rest.p, t->rest.points * sizeof *t->now.p);
  tank_side_move(&t->rest, &at, &shift, t->now.p, NULL, NULL);
  faces_move(&s->faces, (const double(*)[2])t->now.p);
  for (size_t k = 0; k < s->faces.n; k++) {
    const struct face *f = &s->faces.face[k];
    if (f->next != FACE_NONE && f->point[1] != FACE_NO_POINT && t->bends[f->point[1]])
      *angle = fmin(*angle, M_PI - fabs(f->turn));
  }
}

enum status sph_sides_sharpest(const struct case_file *c, double *angle) {
  struct sph s = {.force = {.n = c->n_motions, .motion = c->motions}};
  enum status status = OK;
  *angle = M_PI;
  ATTEMPT(sph_sides_create(&s, c));
  if (!s.sides.move) goto done;
  ATTEMPT(faces_set(&s.faces, &c->walls, 0, s.sides.bends));
  for (int side = TANK_LEFT; side <= TANK_RIGHT; side++) {
    const struct case_strokes most = case_find_strokes(c, side);
    for (int end = 0; end < 2; end++) look_at_end(&s, &most, side, end, angle);
  }
done:
  faces_destroy(&s.faces);
  sph_sides_destroy(&s);
  return status;
}

/* ---- where they are ---- */

void sph_sides_set(struct sph *s, double t) {
  struct sph_sides *e = &s->sides;
  tank_vertices_at(&e->rest, s->force.motion, s->force.n, t, e->now.p, e->v, e->a);
  e->at = t;
  e->speed = 0;
  for (size_t i = 0; i < e->now.points; i++)
    e->speed = fmax(e->speed, hypot(e->v[i][0], e->v[i][1]));
  s->tank = tank_of(&e->now, s->tank.periodic);
  faces_move(&s->faces, (const double(*)[2])e->now.p);
  if (s->wall->move) s->wall->move(s);
}

void sph_sides_list(struct sph *s) {
  struct sph_sides *t = &s->sides;
  if (t->move) memcpy(t->listed, t->now.p, t->now.points * sizeof *t->listed);
}

void sph_sides_begin(struct sph *s) {
  if (s->sides.move) memcpy(s->sides.before, s->faces.face, s->faces.n * sizeof *s->sides.before);
}

/* The farthest that a point behind a face, within the support of it, has gone with it. */
static double way_of_face(const struct sph *s, const struct face *f, const double (*now)[2]) {
  const double(*was)[2] = (const double(*)[2])s->sides.listed;
  double d[2][2] = {{0}}, way = 0;
  for (int end = 0; end < 2; end++) {
    const uint32_t i = f->point[end];
    for (int axis = 0; axis < 2 && i != FACE_NO_POINT; axis++)
      d[end][axis] = now[i][axis] - was[i][axis];
    way = fmax(way, hypot(d[end][0], d[end][1]));
  }
  return way + hypot(d[1][0] - d[0][0], d[1][1] - d[0][1]) * s->support / f->length;
}

double sph_sides_way(const struct sph *s, double t) {
  const struct sph_sides *e = &s->sides;
  double way = 0;
  if (!e->move) return 0;
  tank_vertices_at(&e->rest, s->force.motion, s->force.n, t, e->then, e->then + e->rest.points,
                   NULL);
  for (size_t k = 0; k < s->faces.n; k++) {
    const struct face *f = &s->faces.face[k];
    way = fmax(way, way_of_face(s, f, (const double(*)[2])e->then));
    way = fmax(way, way_of_face(s, f, (const double(*)[2])e->now.p));
  }
  return way;
}

const struct geo_lines *sph_sides_walls(const struct sph *s, const struct geo_lines *rest) {
  return s->sides.move ? &s->sides.now : rest;
}

void sph_sides_carry(const struct sph *s, double p[2]) {
  const struct sph_sides *t = &s->sides;
  if (t->move) tank_point_at(&t->rest, s->force.motion, s->force.n, t->at, t->near, p);
}

bool sph_sides_hide(const struct sph *s, const double p[2]) {
  const struct sph_sides *t = &s->sides;
  return t->move && tank_hides_at(&t->rest, s->force.motion, s->force.n, t->at, t->near, p);
}

/* ---- what they do ---- */

static const double *of_point(const double (*q)[2], uint32_t i) {
  static const double still[2] = {0, 0};
  return i == FACE_NO_POINT ? still : q[i];
}

/* Along a vector. */
static double along(const double q[2], const double t[2]) {
  return q[0] * t[0] + q[1] * t[1];
}

static bool rides(const struct sph_sides *e, const struct face *f) {
  return f->point[0] != FACE_NO_POINT && f->point[1] != FACE_NO_POINT && e->rides[f->point[0]] &&
         e->rides[f->point[1]];
}

static struct sph_drive drive_of_vertex(const double v[2], const double a[2]) {
  return (struct sph_drive){.V = {v[0], v[1]}, .A = {a[0], a[1]}, .held = {v[0], v[1]}};
}

struct sph_drive sph_sides_drive(const struct sph *s, uint32_t motion, const double p[2],
                                 const double u[2]) {
  const struct sph_sides *e = &s->sides;
  const struct face *f = &s->faces.face[motion / 2];
  const double(*v)[2] = (const double(*)[2])e->v, (*a)[2] = (const double(*)[2])e->a;
  const double *va = of_point(v, f->point[0]), *vb = of_point(v, f->point[1]);
  const double *aa = of_point(a, f->point[0]), *ab = of_point(a, f->point[1]);
  if (motion % 2) return drive_of_vertex(va, aa);
  const double n[2] = {-f->t[1], f->t[0]}, L = f->length;
  const double dv[2] = {vb[0] - va[0], vb[1] - va[1]}, da[2] = {ab[0] - aa[0], ab[1] - aa[1]};
  const double w = along(dv, n) / L, turning = (along(da, n) - 2 * along(dv, f->t) * w) / L;
  const double at = face_along(f, p[0], p[1]), slip = along(u, f->t) - along(va, f->t);
  const double speed = along(va, n) + w * at;
  const double rate = along(aa, n) + turning * at + 2 * w * slip;
  struct sph_drive d;
  for (int axis = 0; axis < 2; axis++) {
    d.V[axis] = speed * n[axis];
    d.A[axis] = rate * n[axis];
    d.held[axis] = rides(e, f) ? va[axis] + at / L * dv[axis] : d.V[axis];
  }
  return d;
}

void sph_sides_follow(const struct sph *s, uint32_t face, const double p[2], double now[2]) {
  const struct face *was = &s->sides.before[face], *is = &s->faces.face[face];
  memcpy(now, p, 2 * sizeof *now);
  if (!rides(&s->sides, is)) return;
  const double n[2] = {-is->t[1], is->t[0]};
  const double along = face_along(was, p[0], p[1]), off = face_distance(was, p[0], p[1]);
  for (int axis = 0; axis < 2; axis++)
    now[axis] = is->a[axis] + along * is->t[axis] + off * n[axis];
}
