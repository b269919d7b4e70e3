#include "sph/domain/wall.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/tank/images.h"

#define X(variant, name, help) &sph_wall_##variant,
const struct sph_wall *const sph_walls[] = {SPH_WALLS(X)};
#undef X
#define X(variant, name, help) name,
const char *const sph_wall_names[] = {SPH_WALLS(X) NULL};
#undef X
#define X(variant, name, help) help,
const char *const sph_wall_helps[] = {SPH_WALLS(X)};
#undef X

/* So far beyond the ends of a periodic tank, in particle spacings and supports, water or its images
 * may be (period.h). */
static double beyond(const struct sph *s) {
  return 3 * s->support + 60 * s->dx;
}

/* So far behind a wall water may be by rounding, m. */
static double rounding(const struct sph *s) {
  return 1e-9 * s->dx;
}

enum status sph_wall_create(struct sph *s, const struct geo_lines *all) {
  struct geo_lines walls = {0};
  enum status status = OK;
  s->wall = sph_walls[s->scheme.walls];
  ATTEMPT(tank_walls(&s->tank, all, beyond(s), &walls));
  ATTEMPT(faces_set(&s->faces, &walls, 2 * s->support, s->sides.bends));
  ATTEMPT(sph_sight_create(&s->sight, &s->faces, s->support));
  ATTEMPT(s->wall->create(s, &walls));
  ATTEMPT(sph_sides_attach(s));
done:
  geo_lines_destroy(&walls);
  return status;
}

static void free_packs(struct sph_wall_particles *w) {
  free(w->pack);
  free(w->drag);
  free(w->G);
  free(w->V);
  w->pack = w->drag = NULL;
  w->G = w->V = NULL;
  for (int k = 0; k < 4; k++) {
    free(w->part[k / 2][k % 2]);
    w->part[k / 2][k % 2] = NULL;
  }
}

static enum status make_parts(struct sph *s, size_t n) {
  const int kinds = s->scheme.slip == SPH_SLIP_no ? 2 : 1;
  TRY(sph_allocate(n, sizeof *s->w.V, &s->w.V));
  for (int axis = 0; axis < 2; axis++)
    for (int k = 0; k < kinds; k++)
      TRY(sph_allocate(n, sizeof *s->w.part[k][axis], &s->w.part[k][axis]));
  return OK;
}

enum status sph_wall_make_packs(struct sph *s, size_t n) {
  free_packs(&s->w);
  TRY(sph_allocate(n, sizeof *s->w.G, &s->w.G));
  if (s->sides.move) TRY(make_parts(s, n));
  if (s->scheme.slip == SPH_SLIP_no) TRY(sph_allocate(n, sizeof *s->w.drag, &s->w.drag));
  return sph_allocate(n, sizeof *s->w.pack, &s->w.pack);
}

/* The power of forces that are linear in the volumes is that of volumes times V. */
static void fill_parts(struct sph *s) {
  const struct sph_pack *const from[2] = {s->w.pack, s->w.drag};
  for (int k = 0; k < 4; k++) {
    struct sph_pack *part = s->w.part[k / 2][k % 2];
    for (size_t i = 0; part && i < s->w.n; i++) {
      const double V = k % 2 ? s->w.V[i].y : s->w.V[i].x;
      if (V != 0) part[i] = from[k / 2][i];
      part[i].V *= V;
    }
  }
}

void sph_wall_fill(struct sph *s) {
  s->wall->fill(s);
  if (s->w.V) fill_parts(s);
}

void sph_wall_begin(struct sph *s) {
  if (s->wall) sph_sides_begin(s);
  if (s->wall && s->wall->begin) s->wall->begin(s);
}

void sph_wall_rates(struct sph *s, int stage) {
  if (s->wall->rates) s->wall->rates(s, stage);
}

void sph_wall_advance(struct sph *s, const double *weights, int stages, double dt) {
  if (s->wall && s->wall->advance) s->wall->advance(s, weights, stages, dt);
}

/* ---- what is hidden ---- */

enum status sph_wall_see(struct sph *s) {
  sph_sight_destroy(&s->sight);
  return sph_sight_create(&s->sight, &s->faces, s->support + s->wall_skin);
}

enum status sph_wall_look(struct sph *s) {
  const struct sph_sources water = sph_sources_of_water(s);
  const struct sph_sources walls = {1, {{&s->w.grid, s->w.x, s->w.y, 0, 0}}};
  TRY(sph_sight_mark(&s->sight, &s->water_water, s->f.n, s->f.w.x, s->f.w.y, &water, NULL,
                     s->support));
  TRY(sph_sight_mark(&s->sight, &s->water_wall, s->f.n, s->f.w.x, s->f.w.y, &walls, s->w.chain,
                     s->support));
  return s->wall->look ? s->wall->look(s) : OK;
}

/* ---- the tops ---- */

/* The wall goes on straight beyond its end, or upwards if it ends downwards; on the one side of
 * that is the tank. */
struct top {
  double at[2], r[2]; /* m, 1 */
  double inwards;     /* 1: the tank is on the left of r; -1 */
};

static struct top top_of(const struct face *faces, size_t number) {
  const struct face *f = &faces[number / 2];
  const int end = number % 2;
  struct top t = {.inwards = end ? 1 : -1};
  const double away = end ? 1 : -1;
  for (int axis = 0; axis < 2; axis++) {
    t.at[axis] = end ? f->b[axis] : f->a[axis];
    t.r[axis] = away * f->t[axis];
  }
  if (t.r[1] <= 0) {
    t.r[0] = 0;
    t.r[1] = 1;
  }
  return t;
}

static double inside_of(const struct top *t, const double p[2]) {
  return t->inwards * (t->r[0] * (p[1] - t->at[1]) - t->r[1] * (p[0] - t->at[0]));
}

/* From p, where the top `was`, to q. */
static bool passes_over(const struct top *was, const struct top *t, const double p[2],
                        const double q[2]) {
  const double from = inside_of(was, p), to = inside_of(t, q);
  if (!(from >= 0 && to < 0)) return false;
  const double part = from / (from - to);
  double along = 0;
  for (int axis = 0; axis < 2; axis++)
    along += t->r[axis] * (p[axis] + part * (q[axis] - p[axis]) - t->at[axis]);
  return along >= 0;
}

/* f.over is the number of a top (faces.h) + 1. */
static struct top top_over(const struct sph *s, size_t i) {
  return top_of(s->faces.face, (size_t)s->f.over[i] - 1);
}

/* The top that the way from p, where the faces `were`, to q passes over, as f.over has it; or 0. */
static size_t passed_over(const struct sph *s, const struct face *were, const double p[2],
                          const double q[2]) {
  for (size_t k = 0; k < s->faces.n_tops; k++) {
    const struct top was = top_of(were, s->faces.top[k]);
    const struct top t = top_of(s->faces.face, s->faces.top[k]);
    if (passes_over(&was, &t, p, q)) return s->faces.top[k] + 1;
  }
  return 0;
}

bool sph_wall_has_lost(const struct sph *s, size_t i) {
  return s->f.over[i] != 0 && s->f.w.y[i] < top_over(s, i).at[1];
}

/* ---- through walls ---- */

bool sph_wall_stops(const struct sph *s, size_t i, double x, double y) {
  const double p[2] = {s->f.w.x[i], s->f.w.y[i]}, q[2] = {x, y};
  double part;
  return sph_sight_first(&s->sight, p, q, rounding(s), &part) != FACE_NONE ||
         (s->f.over[i] == 0 && passed_over(s, s->faces.face, p, q));
}

/* The first face that the way since the step began goes through, as a way against the face, where
 * that moves; p becomes where that way begins. */
static uint32_t first_met(const struct sph *s, double p[2], const double q[2], double *part) {
  if (!s->sides.move) return sph_sight_first(&s->sight, p, q, rounding(s), part);
  size_t n;
  const uint32_t *near = sph_sight_faces(&s->sight, p[0], p[1], &n);
  uint32_t first = FACE_NONE;
  double start[2] = {p[0], p[1]};
  *part = INFINITY;
  for (size_t k = 0; k < n; k++) {
    double from[2], here;
    sph_sides_follow(s, near[k], start, from);
    if (!face_stops(&s->faces.face[near[k]], from, q, rounding(s), &here) || here >= *part)
      continue;
    *part = here;
    first = near[k];
    memcpy(p, from, sizeof from);
  }
  return first;
}

/* How many times a step may meet walls: in the corner of two it is two. */
enum { MOST_WALLS = 4 };

/* Back into the tank, by reflection in the faces that the step went through, one after the other.
 * What is left of the way goes nowhere where that does not end. A side that moves gives what the
 * reflection does to the velocity. */
static size_t bring_back(struct sph *s, size_t i) {
  const struct sph_state *w0 = &s->f.w0, *w = &s->f.w;
  double p[2] = {w0->x[i], w0->y[i]}, part;
  for (size_t met = 0; met < MOST_WALLS; met++) {
    const double q[2] = {w->x[i], w->y[i]};
    const uint32_t k =
        met ? sph_sight_first(&s->sight, p, q, rounding(s), &part) : first_met(s, p, q, &part);
    if (k == FACE_NONE) return met;
    const struct face *f = &s->faces.face[k];
    const struct rigid m = rigid_mirror(f->a, f->b);
    rigid_turn(&m, q[0], q[1], &w->x[i], &w->y[i]);
    w->x[i] += m.at[0];
    w->y[i] += m.at[1];
    const struct sph_drive d = sph_wall_drive(s, 2 * k, w->x[i], w->y[i], w->u[i], w->v[i]);
    rigid_turn(&m, w->u[i], w->v[i], &w->u[i], &w->v[i]);
    w->u[i] += 2 * d.V[0];
    w->v[i] += 2 * d.V[1];
    for (int axis = 0; axis < 2; axis++) p[axis] += part * (q[axis] - p[axis]);
  }
  w->x[i] = p[0];
  w->y[i] = p[1];
  return MOST_WALLS;
}

/* Whether a step has met a wall; and what passed over a top, or came back. */
static bool has_met(struct sph *s, size_t i) {
  double p[2] = {s->f.w0.x[i], s->f.w0.y[i]};
  const double q[2] = {s->f.w.x[i], s->f.w.y[i]};
  if (s->f.over[i] != 0) {
    const struct top t = top_over(s, i);
    if (inside_of(&t, q) >= 0) s->f.over[i] = 0;
    return false;
  }
  s->f.over[i] = (double)passed_over(s, s->sides.move ? s->sides.before : s->faces.face, p, q);
  double part;
  return s->f.over[i] == 0 && first_met(s, p, q, &part) != FACE_NONE;
}

static double kinetic(const struct sph *s, size_t i) {
  return s->f.m[i] / 2 * (s->f.w.u[i] * s->f.w.u[i] + s->f.w.v[i] * s->f.w.v[i]);
}

void sph_wall_confine(struct sph *s) {
  double *const met = s->f.scratch;
  size_t n = 0;
#pragma omp parallel for schedule(static) reduction(+ : n)
  for (size_t i = 0; i < s->f.n; i++) {
    met[i] = has_met(s, i);
    n += met[i] != 0;
  }
  /* few, and one after the other: they share the budget */
  for (size_t i = 0; n; i++) {
    if (met[i] == 0) continue;
    const double from = sph_height(&s->force, s->f.w.x[i], s->f.w.y[i]);
    const double was = kinetic(s, i);
    s->reflections += bring_back(s, i);
    if (s->sides.move) s->budget.sides -= kinetic(s, i) - was;
    s->budget.walls -= s->f.m[i] * s->g * (sph_height(&s->force, s->f.w.x[i], s->f.w.y[i]) - from);
    n--;
  }
  sph_particles_pad(&s->f);
}

void sph_wall_destroy(struct sph *s) {
  if (s->wall) s->wall->destroy(s);
  free(s->w.x);
  free(s->w.y);
  free(s->w.chain);
  free_packs(&s->w);
  sph_grid_destroy(&s->w.grid);
  sph_sight_destroy(&s->sight);
  faces_destroy(&s->faces);
  sph_sides_destroy(s);
  s->w = (struct sph_wall_particles){0};
}
