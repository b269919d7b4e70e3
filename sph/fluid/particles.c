#include "sph/fluid/particles.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "sph/family.h"

void *sph_memory(size_t n, size_t size) {
  /* Large arrays are read in many streams at once: more pages than the processor remembers, unless
   * they are large, too. */
  const size_t page = (size_t)1 << 21, unit = n * size >= 2 * page ? page : 64;
  size_t bytes = n && size ? (n * size + unit - 1) / unit * unit : 64;
  void *memory = aligned_alloc(unit, bytes);
  if (memory && unit == page) madvise(memory, bytes, MADV_HUGEPAGE);
  if (memory)
    memset(memory, 0, bytes);
  else
    status_raise(ERR_MEMORY, "no memory for %zu particles", n);
  return memory;
}

#define ONE(name, unit, help) +1
enum { EVOLVING = SPH_EVOLVING(ONE), CARRIED = EVOLVING SPH_KEPT(ONE) };
enum { MAX_ARRAYS = CARRIED + EVOLVING * (1 + SPH_MAX_STAGES) SPH_MADE(ONE) };

/* Every array, first those that a particle carries with it from step to step. */
static size_t arrays(struct sph_particles *p, double **list[MAX_ARRAYS]) {
  size_t n = 0;
  struct sph_state *state = &p->w;
#define OF_STATE(name, unit, help)     list[n++] = &state->name;
#define OF_PARTICLES(name, unit, help) list[n++] = &p->name;
  SPH_EVOLVING(OF_STATE)
  SPH_KEPT(OF_PARTICLES)
  state = &p->w0;
  SPH_EVOLVING(OF_STATE)
  for (state = p->k; state < p->k + SPH_MAX_STAGES; state++) {
    SPH_EVOLVING(OF_STATE)
  }
  SPH_MADE(OF_PARTICLES)
#undef OF_STATE
#undef OF_PARTICLES
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
#define X(name, unit, help) p->w.name[i] = p->w.name[p->n - 1];
    SPH_EVOLVING(X)
#undef X
#define X(name, unit, help) p->name[i] = p->name[p->n - 1];
    SPH_KEPT(X)
#undef X
    p->m[i] = p->D[i] = 0; /* it is not there */
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
