/* The water's particles: structure of arrays, each aligned to 64 bytes and padded to whole clusters
 * of SPH_LANES. The pad lanes repeat the last particle with no mass. */
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "common/base/status.h"
#include "sph/fluid/fields.h"

enum { SPH_LANES = 8 }; /* particles in a cluster */
enum { SPH_MAX_STAGES = 4 };

struct sph_state { /* what evolves; or the rates of it, per second */
#define X(name, unit, help) double *name;
  SPH_EVOLVING(X)
#undef X
};

struct sph_particles {
  size_t n, room;                     /* room: of every array, a multiple of SPH_LANES */
  uint32_t *id;                       /* [n], the particle's number at t = 0 */
  struct sph_state w;                 /* now */
  struct sph_state w0;                /* at the start of the step */
  struct sph_state k[SPH_MAX_STAGES]; /* rates of the stages */
#define X(name, unit, help) double *name;
  SPH_KEPT(X)
  SPH_MADE(X)
#undef X
  uint32_t *order, *key; /* scratch of the sort */
};

enum status sph_particles_create(struct sph_particles *p, size_t n);
void sph_particles_destroy(struct sph_particles *p);
void sph_particles_pad(struct sph_particles *p);

/* Puts particle order[i] at place i of the arrays that particles carry from step to step (w, m,
 * over, id), for i < n; n may be smaller than before. The others are to be computed anew. */
void sph_particles_permute(struct sph_particles *p, size_t n);

/* Zeroed memory aligned to 64 bytes for n elements of `size` bytes, freed with free(); `array` is
 * the address of a pointer to them. ERR_MEMORY. */
#define sph_allocate(n, size, array)                                                               \
  ({                                                                                               \
    void *allocated_ = sph_memory(n, size);                                                        \
    if (allocated_) *(array) = allocated_;                                                         \
    allocated_ ? OK : ERR_MEMORY;                                                                  \
  })
void *sph_memory(size_t n, size_t size); /* NULL and a message when there is none */
