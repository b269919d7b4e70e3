/* Floating-point traps of the debug build: a division by zero, an overflow or an invalid operation
 * inside a solver stops the program where it happens. They are off outside the solvers, where
 * libraries compare NaNs on purpose. */
#pragma once
#include <fenv.h>

static inline void traps_enable(void) {
#ifdef PLUNGE_TRAP_FLOATS
  feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
#endif
}

static inline void traps_disable(void) {
#ifdef PLUNGE_TRAP_FLOATS
  fedisableexcept(FE_DIVBYZERO | FE_INVALID | FE_OVERFLOW);
#endif
}
