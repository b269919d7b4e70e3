/* A family of variants (kernels, equations of state, ...) is one list, LIST(X) of X(name, help,
 * ...): it makes the enumeration here, and in scheme.c what a case may name, `plunge list` and the
 * help. Each property of the variants is one small function with a switch over the enumeration and
 * without a default, so that the compiler names the places that a new variant must fill. */
#pragma once

#include "sph/hot.h"

#define SPH_FAMILY_ENUM(name, help, PREFIX) PREFIX##_##name,
#define SPH_FAMILY_ONE(name, help, PREFIX)  +1
#define SPH_FAMILY(tag, PREFIX, LIST)                                                              \
  enum tag { LIST(SPH_FAMILY_ENUM, PREFIX) };                                                      \
  enum { PREFIX##_COUNT = 0 LIST(SPH_FAMILY_ONE, PREFIX) }
