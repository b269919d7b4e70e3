#include "sph/domain/sight.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "sph/fluid/particles.h"

/* ---- the grid ---- */

static double distance_from(const struct face *f, const double p[2]) {
  double foot[2];
  geo_segment_foot(f->a, f->b, p, foot);
  return hypot(p[0] - foot[0], p[1] - foot[1]);
}

static bool ends_near(const struct face *f, const double p[2], double near) {
  for (int end = 0; end < 2; end++) {
    const double *at = end ? f->b : f->a;
    if (f->end[end] == FACE_END_TOP && hypot(p[0] - at[0], p[1] - at[1]) < near) return true;
  }
  return false;
}

/* All is seen where one chain is near that does not end. */
static bool is_plain(const struct faces *faces, const uint32_t *near, size_t n, const double p[2],
                     double end_reach) {
  for (size_t k = 0; k < n; k++) {
    const struct face *f = &faces->face[near[k]];
    if (f->chain != faces->face[near[0]].chain || ends_near(f, p, end_reach)) return false;
  }
  return true;
}

/* A wall particle that is seen from up to `reach` is no farther than that behind its face. */
static enum status fill_cell(struct sph_sight *t, size_t cell, double round, double reach) {
  const double p[2] = {t->x0 + ((double)(cell % t->nx) + 0.5) / t->per,
                       t->y0 + ((double)(cell / t->nx) + 0.5) / t->per};
  const size_t from = t->first[cell];
  size_t n = 0, kept = 0;
  for (size_t k = 0; k < t->faces->n; k++) {
    if (distance_from(&t->faces->face[k], p) > round + 2 * reach) continue;
    TRY(array_grow(&t->face, &t->room, from + n + 1, "faces of walls"));
    t->face[from + n++] = (uint32_t)k;
  }
  t->plain[cell] = is_plain(t->faces, t->face + from, n, p, round + reach);
  for (size_t k = 0; k < n; k++) {
    t->face[from + kept] = t->face[from + k];
    kept += distance_from(&t->faces->face[t->face[from + k]], p) <= round + reach;
  }
  t->first[cell + 1] = (uint32_t)(from + kept);
  return OK;
}

enum status sph_sight_create(struct sph_sight *t, const struct faces *faces, double reach) {
  double low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  *t = (struct sph_sight){.faces = faces, .per = 1 / reach};
  if (!faces->n) return OK;
  for (size_t k = 0; k < faces->n; k++)
    for (int axis = 0; axis < 2; axis++) {
      const struct face *f = &faces->face[k];
      low[axis] = fmin(low[axis], fmin(f->a[axis], f->b[axis]));
      high[axis] = fmax(high[axis], fmax(f->a[axis], f->b[axis]));
    }
  t->x0 = low[0] - 3 * reach;
  t->y0 = low[1] - 3 * reach;
  t->nx = (size_t)ceil((high[0] - low[0]) * t->per) + 6;
  t->ny = (size_t)ceil((high[1] - low[1]) * t->per) + 6;
  TRY(array_create(&t->first, t->nx * t->ny + 1, "where walls are"));
  TRY(array_create(&t->plain, t->nx * t->ny, "where walls are"));
  for (size_t cell = 0; cell < t->nx * t->ny; cell++)
    TRY(fill_cell(t, cell, M_SQRT1_2 * reach, reach));
  return OK;
}

void sph_sight_destroy(struct sph_sight *t) {
  free(t->first);
  free(t->face);
  free(t->plain);
  *t = (struct sph_sight){0};
}

/* false: it is far from all walls */
static bool find_cell(const struct sph_sight *t, double x, double y, size_t *cell) {
  const double i = (x - t->x0) * t->per, j = (y - t->y0) * t->per;
  if (!(i >= 0 && j >= 0 && i < (double)t->nx && j < (double)t->ny)) return false;
  *cell = (size_t)j * t->nx + (size_t)i;
  return true;
}

bool sph_sight_is_plain(const struct sph_sight *t, double x, double y) {
  size_t cell;
  return !find_cell(t, x, y, &cell) || t->plain[cell];
}

const uint32_t *sph_sight_faces(const struct sph_sight *t, double x, double y, size_t *n) {
  size_t cell;
  *n = 0;
  if (!find_cell(t, x, y, &cell)) return NULL;
  *n = t->first[cell + 1] - t->first[cell];
  return t->face + t->first[cell];
}

uint32_t sph_sight_first(const struct sph_sight *t, const double p[2], const double q[2],
                         double slack, double *part) {
  size_t n;
  const uint32_t *near = sph_sight_faces(t, p[0], p[1], &n);
  uint32_t first = FACE_NONE;
  *part = INFINITY;
  for (size_t k = 0; k < n; k++) {
    double here;
    if (!face_stops(&t->faces->face[near[k]], p, q, slack, &here) || here >= *part) continue;
    *part = here;
    first = near[k];
  }
  return first;
}

/* ---- marks ---- */

/* What a mark is asked of: a target, and sources by number. */
struct look {
  const struct sph_sight *sight;
  const struct sph_sources *sources;
  const uint32_t *chain;
  double reach, slack; /* m */
};

static void place_of(const struct sph_sources *s, uint32_t j, double at[2]) {
  const struct sph_points *p = &s->of[s->n > 1 && j >= s->of[1].first];
  at[0] = p->x[j - p->first];
  at[1] = p->y[j - p->first];
}

static uint32_t chain_of(const struct look *l, uint32_t face) {
  return face == FACE_NONE ? FACE_NONE : l->sight->faces->face[face].chain;
}

/* Whether p is before a half end of that chain. */
static bool is_before_end(const struct look *l, const double p[2], uint32_t chain) {
  size_t n;
  const uint32_t *near = sph_sight_faces(l->sight, p[0], p[1], &n);
  for (size_t k = 0; k < n; k++) {
    const struct face *f = &l->sight->faces->face[near[k]];
    if (f->chain == chain && (f->end[0] == FACE_END_HALF || f->end[1] == FACE_END_HALF) &&
        face_distance(f, p[0], p[1]) > 0)
      return true;
  }
  return false;
}

/* Around a blunt corner of the solid water sees water. From before the end of a thin wall it sees
 * all water, and of wall particles those in the solid. */
static bool is_hidden(const struct look *l, const double p[2], const double q[2], uint32_t j) {
  double part;
  const uint32_t in = chain_of(l, sph_sight_first(l->sight, p, q, l->slack, &part));
  if (l->chain && in != l->chain[j]) return true;
  if (l->chain && !is_before_end(l, p, in)) return false;
  const uint32_t out = chain_of(l, sph_sight_first(l->sight, q, p, l->slack, &part));
  if (l->chain) return out != FACE_NONE;
  return in != out && !is_before_end(l, p, in) && !is_before_end(l, q, out);
}

static unsigned char lanes_blind_to(const struct look *l, const double p[][2], size_t n,
                                    uint32_t j) {
  double q[2];
  unsigned blind = 0;
  place_of(l->sources, j, q);
  for (size_t lane = 0; lane < n; lane++) {
    const double x = q[0] - p[lane][0], y = q[1] - p[lane][1];
    if (x * x + y * y < l->reach * l->reach && is_hidden(l, p[lane], q, j)) blind |= 1u << lane;
  }
  return (unsigned char)blind;
}

static enum status mark_cluster(const struct look *l, struct sph_chunk *k, size_t c,
                                const double p[][2], size_t n) {
  bool plain = true;
  k->hides[c] = false;
  for (size_t lane = 0; lane < n; lane++)
    plain &= sph_sight_is_plain(l->sight, p[lane][0], p[lane][1]);
  if (plain) return OK;
  TRY(array_grow(&k->hidden, &k->hidden_room, k->first[SPH_CHUNK], "what walls hide"));
  for (size_t at = k->first[c]; at < k->first[c + 1]; at++) {
    k->hidden[at] = lanes_blind_to(l, p, n, k->j[at]);
    k->hides[c] |= k->hidden[at] != 0;
  }
  return OK;
}

static enum status mark_chunk(const struct look *l, struct sph_chunk *k, size_t from, size_t n,
                              const double *x, const double *y) {
  for (size_t c = 0; c < SPH_CHUNK; c++) {
    double p[SPH_LANES][2];
    size_t lanes = 0;
    for (size_t at = from + c * SPH_LANES; lanes < SPH_LANES && at < n; lanes++, at++) {
      p[lanes][0] = x[at];
      p[lanes][1] = y[at];
    }
    if (lanes) TRY(mark_cluster(l, k, c, p, lanes));
  }
  return OK;
}

enum status sph_sight_mark(const struct sph_sight *t, struct sph_lists *lists, size_t n,
                           const double *x, const double *y, const struct sph_sources *sources,
                           const uint32_t *chain, double reach) {
  const struct look l = {t, sources, chain, reach, 1e-6 * reach};
  int failed = 0;
#pragma omp parallel for schedule(dynamic) reduction(| : failed)
  for (size_t k = 0; k < lists->n_chunks; k++)
    failed |= mark_chunk(&l, &lists->chunks[k], k * SPH_CHUNK * SPH_LANES, n, x, y) != OK;
  CHECK(!failed, ERR_MEMORY, "no memory for what walls hide");
  return OK;
}
