/* Where the time of a run goes: it is always in one phase, whose clock runs. */
#pragma once

/* X(phase, what is done in it). */
#define SPH_PHASES(X)                                                                              \
  X(other, "whatever is not named below")                                                          \
  X(sort, "sorting particles and listing neighbours")                                              \
  X(treat, "treatments between steps")                                                             \
  X(rates, "evaluations of the right-hand side")                                                   \
  X(step, "the integrator around them")                                                            \
  X(check, "time step and health")                                                                 \
  X(output, "measuring and writing")

enum sph_phase {
#define X(phase, help) SPH_PHASE_##phase,
  SPH_PHASES(X)
#undef X
      SPH_PHASE_COUNT
};

struct sph_clock {
  enum sph_phase in;
  double since; /* s */
  double seconds[SPH_PHASE_COUNT];
};

struct sph;

/* The run goes on in another phase; returns the one that it was in. */
enum sph_phase sph_enter(struct sph *s, enum sph_phase phase);
