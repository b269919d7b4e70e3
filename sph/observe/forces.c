#include "sph/observe/forces.h"

#include <stdlib.h>

#include "sph/domain/wall.h"
#include "sph/fluid/clusters.h"
#include "sph/pair/rates.h"

/* On a part of the wall particles. */
struct load {
  double x, y, moment; /* N/m, N about `about` */
};

struct push {
  const struct sph_pack *pressing, *holding;
  double about[2]; /* m */
  struct load *of; /* [clusters] */
};

/* A pair's pressures act along the way between the two, so that their moment is the same at either.
 */
static void cluster_load(struct sph *s, size_t cluster, const void *wanted) {
  const struct push *how = wanted;
  const struct sph_near walls = sph_near_walls(s, cluster);
  struct load sum = {0};
  if (walls.n) {
    const struct sph_targets i = sph_targets_of(s, cluster);
    struct sph_push p;
    sph_rates_push(s, &i, &walls, how->pressing, how->holding, &p);
    for (size_t l = 0; l < SPH_LANES && cluster * SPH_LANES + l < s->f.n; l++) {
      const double m = s->f.m[cluster * SPH_LANES + l];
      const double x = -m * (p.x[l] + p.drag_x[l]), y = -m * (p.y[l] + p.drag_y[l]);
      sum.x += x;
      sum.y += y;
      sum.moment += (i.x[l] - how->about[0]) * y - (i.y[l] - how->about[1]) * x;
    }
  }
  how->of[cluster] = sum;
}

/* Of these packs; added up in the order of the clusters. */
static struct load load_of(struct sph *s, const struct sph_pack *pressing,
                           const struct sph_pack *holding) {
  const struct geo_box *box = &s->tank.box;
  const struct push how = {pressing,
                           holding,
                           {0.5 * (box->min[0] + box->max[0]), box->min[1]},
                           (struct load *)s->f.scratch};
  _Static_assert(sizeof *how.of <= SPH_LANES * sizeof(double), "scratch holds one for a cluster");
  struct load sum = {0};
  sph_each_cluster(s, cluster_load, &how);
  for (size_t c = 0; c < s->water_wall.n_clusters; c++) {
    sum.x += how.of[c].x;
    sum.y += how.of[c].y;
    sum.moment += how.of[c].moment;
  }
  return sum;
}

/* ---- a piece of wall ---- */

/* Where the walls begin on the left, or end on the right: at their outermost top, or the highest
 * point of a tank with a lid. */
static uint32_t outermost(const struct faces *f, int end) {
  uint32_t best = FACE_NONE;
  const double out = end ? 1 : -1;
  for (uint32_t k = 0; k < f->n; k++) {
    const double *p = end ? f->face[k].b : f->face[k].a;
    if (f->n_tops && f->face[k].end[end] != FACE_END_TOP) continue;
    if (best == FACE_NONE) best = k;
    const double *q = end ? f->face[best].b : f->face[best].a;
    const bool higher = !f->n_tops && p[1] > q[1], level = f->n_tops || p[1] == q[1];
    if (higher || (level && out * p[0] > out * q[0])) best = k;
  }
  return best;
}

static bool is_wet(const struct sph *s, const struct face *f) {
  for (size_t i = 0; i < s->f.n; i++) {
    const double way = face_way(f, s->f.w.x[i], s->f.w.y[i]);
    if (way < s->dx && face_distance(f, s->f.w.x[i], s->f.w.y[i]) > -s->dx) return true;
  }
  return false;
}

/* The first wet piece on the way from there. */
static uint32_t edge_face(const struct sph *s, int end) {
  uint32_t k = outermost(&s->faces, end);
  for (size_t n = 0; n < s->faces.n && k != FACE_NONE; n++) {
    const struct face *f = &s->faces.face[k];
    if (is_wet(s, f)) return k;
    k = end ? f->before : f->next;
  }
  return FACE_NONE;
}

/* What wall particles that this motion makes give. `part` is scratch, [w.n]. */
static struct load load_by(struct sph *s, uint32_t motion, struct sph_pack *part) {
  for (size_t k = 0; k < s->w.n; k++) {
    part[k] = s->w.pack[k];
    if (s->wall->motion(s, k) != motion) part[k].V = 0;
  }
  return load_of(s, part, part);
}

/* Of what those about the corner at an end give, the part along the normal of the face, the rest
 * being along that of the other; N/m, into the water. */
static double load_about(struct sph *s, uint32_t face, int end, struct sph_pack *part) {
  const struct face *f = &s->faces.face[face];
  const uint32_t beside = end ? f->next : f->before;
  if (f->end[end] != FACE_END_CORNER || beside == FACE_NONE) return 0;
  const double *t = s->faces.face[beside].t, across = f->t[0] * t[1] - f->t[1] * t[0];
  const struct load on = load_by(s, 2 * (end ? beside : face) + 1, part);
  const double along = on.x * t[0] + on.y * t[1];
  return along == 0 ? 0 : along / across;
}

/* Along x on a piece of wall. */
static double load_on(struct sph *s, uint32_t face, struct sph_pack *part) {
  if (face == FACE_NONE) return 0;
  const struct face *f = &s->faces.face[face];
  const double n[2] = {-f->t[1], f->t[0]};
  const struct load on = load_by(s, 2 * face, part);
  double sum = on.x * n[0] + on.y * n[1];
  for (int end = 0; end < 2; end++) sum += load_about(s, face, end, part);
  return sum * n[0];
}

enum status sph_forces_find(struct sph *s, struct sph_forces *out) {
  struct sph_pack *part = NULL;
  *out = (struct sph_forces){0};
  if (!s->w.n) return OK;
  const struct load all = load_of(s, s->w.pack, s->w.drag ? s->w.drag : s->w.pack);
  out->x = all.x;
  out->y = all.y;
  out->moment = all.moment;
  if (s->tank.periodic[0]) return OK;
  TRY(sph_allocate(s->w.n, sizeof *part, &part));
  out->left = load_on(s, edge_face(s, 0), part);
  out->right = load_on(s, edge_face(s, 1), part);
  free(part);
  return OK;
}
