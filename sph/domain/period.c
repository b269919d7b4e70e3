#include "sph/domain/period.h"

#include <math.h>
#include <stdlib.h>

#include "sph/sph.h"

/* In particle spacings: as often as particles go this far, all are sorted. */
static const double usual_reserve = 2, widest_reserve = 20;

enum status sph_period_create(struct sph *s) {
  if (!tank_is_periodic(&s->tank)) return OK;
  s->period.reserve = usual_reserve * s->dx;
  const struct geo_box box = tank_around(&s->tank, 2 * (s->support + s->period.reserve));
  return sph_grid_create(&s->period.grid, &box, s->dx);
}

void sph_period_destroy(struct sph *s) {
  images_destroy(&s->period.images);
  sph_copies_destroy(&s->period.copies);
  sph_grid_destroy(&s->period.grid);
}

double sph_period_widest(const struct sph *s) {
  return widest_reserve * s->dx;
}

void sph_period_wrap(struct sph *s) {
  double *const at[2] = {s->f.w.x, s->f.w.y};
  for (int axis = 0; axis < 2; axis++) {
    if (!s->tank.periodic[axis]) continue;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < s->f.n; i++) at[axis][i] = tank_wrap(&s->tank, axis, at[axis][i]);
  }
}

static enum status make_room_for_packs(struct sph *s) {
  const size_t n = s->f.room + s->period.copies.n;
  CHECK(n < UINT32_MAX, ERR_INPUT, "%zu particles and images are too many to number", n);
  if (n <= s->pack_room) return OK;
  s->pack_room = n + s->period.copies.n / 2;
  free(s->pack);
  free(s->G);
  s->pack = NULL;
  s->G = NULL;
  TRY(sph_allocate(s->pack_room, sizeof *s->pack, &s->pack));
  return sph_allocate(s->pack_room, sizeof *s->G, &s->G);
}

/* A particle beyond an end meets others within the support of it, and wall particles whose values
 * come from water within one more (ghost.c); since they were listed all have gone no farther than
 * the reserve. */
enum status sph_period_list(struct sph *s, double least) {
  struct sph_period *p = &s->period;
  if (!tank_is_periodic(&s->tank)) return OK;
  const double ahead = s->drift.most / 2;
  const double wanted = fmax(fmax(usual_reserve * s->dx, least), fmax(s->skin, 1.1 * ahead));
  p->reserve = fmin(wanted, sph_period_widest(s));
  TRY(images_set_periods(&p->images, &s->tank, 2 * (s->support + p->reserve)));
  for (size_t i = 0; i < s->f.n; i++) {
    const size_t n = images_beyond(&p->images, s->f.w.x[i], s->f.w.y[i]);
    TRY(sph_copies_add(&p->copies, (uint32_t)i, n, p->images.found));
  }
  TRY(sph_copies_sort(&p->copies, &p->grid));
  return make_room_for_packs(s);
}

/* The three that follow are called in every stage; a parallel loop over nothing takes as long as
 * one over a few thousand particles. */
void sph_period_move(struct sph *s) {
  struct sph_period *p = &s->period;
  if (!p->copies.n) return;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < p->copies.n; k++) {
    const struct sph_copy *c = &p->copies.copy[k];
    const struct rigid *shift = images_motion(&p->images, c->motion);
    p->copies.x[k] = s->f.w.x[c->of] + shift->at[0];
    p->copies.y[k] = s->f.w.y[c->of] + shift->at[1];
  }
}

void sph_period_fill(struct sph *s) {
  const struct sph_period *p = &s->period;
  if (!p->copies.n) return;
  sph_period_move(s);
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < p->copies.n; k++) {
    struct sph_pack *image = &s->pack[s->f.room + k];
    *image = s->pack[p->copies.copy[k].of];
    image->x = p->copies.x[k];
    image->y = p->copies.y[k];
  }
}

void sph_period_fill_gradients(struct sph *s) {
  const struct sph_copies *c = &s->period.copies;
  if (!c->n) return;
#pragma omp parallel for schedule(static)
  for (size_t k = 0; k < c->n; k++) s->G[s->f.room + k] = s->G[c->copy[k].of];
}

double sph_period_left(const struct sph *s) {
  return tank_is_periodic(&s->tank) ? s->period.reserve - s->drift.most / 2 : INFINITY;
}

uint32_t sph_period_particle(const struct sph *s, uint32_t of) {
  return of < s->f.room ? of : s->period.copies.copy[of - s->f.room].of;
}
