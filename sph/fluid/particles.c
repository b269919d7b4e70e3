#include "sph/fluid/particles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "sph/family.h"

void *sph_memory(size_t n, size_t size) {
  size_t bytes = n && size ? (n * size + 63) / 64 * 64 : 64;
  void *memory = aligned_alloc(64, bytes);
  if (memory)
    memset(memory, 0, bytes);
  else
    status_raise(ERR_MEMORY, "no memory for %zu particles", n);
  return memory;
}

/* Every array of doubles, in one list; first those that a particle carries with it from step to
 * step. */
enum { CARRIED = 5 + 2, MAX_ARRAYS = CARRIED + 5 * (1 + SPH_MAX_STAGES) + 7 };

static size_t arrays(struct sph_particles *p, double **list[MAX_ARRAYS]) {
  size_t n = 0;
#define X(a) list[n++] = &p->w.a;
  SPH_STATE(X)
#undef X
  list[n++] = &p->m;
  list[n++] = &p->over;
#define X(a) list[n++] = &p->w0.a;
  SPH_STATE(X)
#undef X
  for (size_t s = 0; s < SPH_MAX_STAGES; s++) {
#define X(a) list[n++] = &p->k[s].a;
    SPH_STATE(X)
#undef X
  }
  list[n++] = &p->p;
  list[n++] = &p->D;
  list[n++] = &p->x_listed;
  list[n++] = &p->y_listed;
  list[n++] = &p->x_walls;
  list[n++] = &p->y_walls;
  list[n++] = &p->scratch;
  return n;
}

enum status sph_particles_create(struct sph_particles *p, size_t n) {
  double **list[MAX_ARRAYS];
  size_t n_arrays = arrays(p, list);
  CHECK(n < UINT32_MAX - SPH_LANES, ERR_INPUT,
        "%zu particles are more than this program can number", n);
  p->n = n;
  p->room = (n + SPH_LANES - 1) / SPH_LANES * SPH_LANES;
  for (size_t a = 0; a < n_arrays; a++) TRY(sph_allocate(p->room, sizeof(double), list[a]));
  TRY(sph_allocate(p->room, sizeof *p->id, &p->id));
  TRY(sph_allocate(p->room, sizeof *p->order, &p->order));
  TRY(sph_allocate(p->room, sizeof *p->key, &p->key));
  for (size_t i = 0; i < n; i++) p->id[i] = (uint32_t)i;
  return OK;
}

void sph_particles_destroy(struct sph_particles *p) {
  double **list[MAX_ARRAYS];
  size_t n_arrays = arrays(p, list);
  for (size_t a = 0; a < n_arrays; a++) free(*list[a]);
  free(p->id);
  free(p->order);
  free(p->key);
  *p = (struct sph_particles){0};
}

void sph_particles_pad(struct sph_particles *p) {
  if (!p->n) return;
  for (size_t i = p->n; i % SPH_LANES; i++) {
#define X(a) p->w.a[i] = p->w.a[p->n - 1];
    SPH_STATE(X)
#undef X
    p->m[i] = 0;
    p->over[i] = p->over[p->n - 1];
    p->D[i] = 0;
  }
}

void sph_particles_permute(struct sph_particles *p, size_t n) {
  double **list[MAX_ARRAYS];
  arrays(p, list);
  const uint32_t *order = p->order;
  for (size_t a = 0; a < CARRIED; a++) {
    double *from = *list[a], *to = p->scratch;
#pragma omp parallel for schedule(static)
    for (size_t i = 0; i < n; i++) to[i] = from[order[i]];
    *list[a] = to;
    p->scratch = from;
  }
  for (size_t i = 0; i < n; i++) p->key[i] = p->id[order[i]];
  uint32_t *id = p->id;
  p->id = p->key;
  p->key = id;
  p->n = n;
  sph_particles_pad(p);
}
