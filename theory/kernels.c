#include "theory/kernels.h"

#include <stddef.h>

#include "sph/domain/fitted.h"
#include "sph/pair/continuity.h"
#include "sph/pair/derivative.h"
#include "sph/pair/diffusion.h"
#include "sph/pair/kernel.h"
#include "sph/pair/momentum.h"

#define NAME(name, help) #name,
const char *const theory_kernel_names[] = {SPH_KERNELS(NAME) NULL};
const char *const theory_diffusion_names[] = {SPH_DIFFUSIONS(NAME) NULL};
const char *const theory_derivative_names[] = {SPH_DERIVATIVES(NAME) NULL};
const char *const theory_continuity_names[] = {SPH_CONTINUITIES(NAME) NULL};
const char *const theory_momentum_names[] = {SPH_MOMENTUMS(NAME) NULL};
const char *const theory_free_surface_names[] = {SPH_FREE_SURFACES(NAME) NULL};
