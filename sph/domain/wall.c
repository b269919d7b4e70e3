#include "sph/domain/wall.h"

#include <math.h>
#include <stdlib.h>

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

enum status sph_wall_create(struct sph *s, const struct geo_lines *all) {
  struct geo_lines walls = {0};
  enum status status = OK;
  s->wall = sph_walls[s->scheme.walls];
  ATTEMPT(tank_walls(&s->tank, all, beyond(s), &walls));
  ATTEMPT(s->wall->create(s, &walls));
done:
  geo_lines_destroy(&walls);
  return status;
}

enum status sph_wall_make_packs(struct sph *s, size_t n) {
  free(s->w.pack);
  free(s->w.drag);
  free(s->w.G);
  s->w.pack = s->w.drag = NULL;
  s->w.G = NULL;
  TRY(sph_allocate(n, sizeof *s->w.G, &s->w.G));
  if (s->scheme.slip == SPH_SLIP_no) TRY(sph_allocate(n, sizeof *s->w.drag, &s->w.drag));
  return sph_allocate(n, sizeof *s->w.pack, &s->w.pack);
}

void sph_wall_begin(struct sph *s) {
  if (s->wall && s->wall->begin) s->wall->begin(s);
}

void sph_wall_rates(struct sph *s, int stage) {
  if (s->wall->rates) s->wall->rates(s, stage);
}

void sph_wall_advance(struct sph *s, const double *weights, int stages, double dt) {
  if (s->wall && s->wall->advance) s->wall->advance(s, weights, stages, dt);
}

bool sph_lip_at(const struct sph *s, const double *x, const double *y, const double *over,
                struct sph_lip *lip) {
  const struct tank *t = &s->tank;
  bool any = false;
  for (size_t l = 0; l < SPH_LANES; l++) any |= over[l] != 0 || y[l] > t->lowest_top;
  if (!any) return false;
  for (size_t l = 0; l < SPH_LANES; l++) {
    int side = tank_nearer(t, x[l]);
    lip->wall[l] = tank_wall(t, side);
    lip->top[l] = t->top[side];
    lip->outwards[l] = side == TANK_RIGHT ? 1 : -1;
    lip->rise[l] = fmax(y[l] - lip->top[l], 0);
    double way = tank_inside(t, side, x[l]);
    lip->inside[l] = over[l] != 0 ? -1 : lip->rise[l] > 0 ? way : fabs(way);
  }
  return true;
}

/* Whether a particle that was inside the side wall at the start of the step, and is outside now,
 * went over the top, on the straight way. */
static bool went_over(const struct sph *s, size_t i, double wall, double top) {
  const struct sph_state *a = &s->f.w0, *b = &s->f.w;
  double t = (wall - a->x[i]) / (b->x[i] - a->x[i]);
  return a->y[i] + t * (b->y[i] - a->y[i]) >= top;
}

/* Whether the particle was brought back. */
static bool confine_sides(const struct sph *s, size_t i) {
  const struct sph_state *w = &s->f.w;
  const struct geo_box walled = tank_walled(&s->tank);
  bool beside = w->x[i] < walled.min[0] || w->x[i] > walled.max[0];
  if (!beside) s->f.over[i] = 0;
  if (!beside || s->f.over[i]) return false;
  int side = tank_nearer(&s->tank, w->x[i]);
  double wall = tank_wall(&s->tank, side);
  if (went_over(s, i, wall, s->tank.top[side])) {
    s->f.over[i] = 1;
    return false;
  }
  w->x[i] = 2 * wall - w->x[i];
  w->u[i] = -w->u[i];
  return true;
}

static bool is_under_bed(const struct sph *s, size_t i) {
  const struct geo_box t = tank_walled(&s->tank);
  return s->f.w.y[i] < t.min[1] && s->f.w.x[i] > t.min[0] && s->f.w.x[i] < t.max[0];
}

static void confine_bed(struct sph *s, size_t i) {
  const struct sph_state *w = &s->f.w;
  double lift = 2 * (s->tank.box.min[1] - w->y[i]);
  w->y[i] += lift;
  w->v[i] = -w->v[i];
  s->budget.walls -= s->f.m[i] * s->g * lift;
}

void sph_wall_confine(struct sph *s) {
  size_t beside = 0, under = 0;
#pragma omp parallel for schedule(static) reduction(+ : beside, under)
  for (size_t i = 0; i < s->f.n; i++) {
    beside += confine_sides(s, i);
    under += is_under_bed(s, i);
  }
  s->reflections += beside + under;
  /* few, and one after the other: they share the budget */
  for (size_t i = 0; under; i++) {
    if (!is_under_bed(s, i)) continue;
    confine_bed(s, i);
    under--;
  }
  sph_particles_pad(&s->f);
}

void sph_wall_destroy(struct sph *s) {
  if (s->wall) s->wall->destroy(s);
  free(s->w.x);
  free(s->w.y);
  free(s->w.pack);
  free(s->w.drag);
  free(s->w.G);
  sph_grid_destroy(&s->w.grid);
  s->w = (struct sph_wall_particles){0};
}
