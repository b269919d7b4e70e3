/* The same in single precision. */
#define SPH_SINGLE
#include "tests/sph/test_kernel.c"
