/* The water's particles: structure of arrays, each aligned to 64 bytes and padded to whole clusters
 * of SPH_LANES. The pad lanes repeat the last particle with no mass. */
#pragma once
#include <stddef.h>
#include <stdint.h>

#include "common/base/status.h"

enum { SPH_LANES = 8 }; /* particles in a cluster */
enum { SPH_MAX_STAGES = 4 };

#define SPH_STATE(X) X(x) X(y) X(u) X(v) X(rho)

struct sph_state { /* position m, velocity m/s, density kg m^-3; or the rates of these */
#define X(a) double *a;
  SPH_STATE(X)
#undef X
};

struct sph_particles {
  size_t n, room;                     /* room: of every array, a multiple of SPH_LANES */
  uint32_t *id;                       /* [n], the particle's number at t = 0 */
  double *m;                          /* kg/m, [n] */
  struct sph_state w;                 /* now */
  struct sph_state w0;                /* at the start of the step */
  struct sph_state k[SPH_MAX_STAGES]; /* rates of the stages */
  double *p;                          /* pressure of an evaluation, Pa (sph_pack_water) */
  double *over; /* 1 for water that has passed over the top of a wall, else 0; [n] */
  double *D;    /* delta h c0 D_i, kg m^-3 s^-1: kept where an integrator freezes it */
  double *x_listed, *y_listed; /* where the particles were when they were sorted, m */
  double *x_walls, *y_walls;   /* ... when the walls were listed, m */
  double *scratch;
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
