#include "theory/kernels.h"

#include <stddef.h>

#include "sph/pair/diffusion.h"
#include "sph/pair/kernel.h"

#define NAME(name, help) #name,
const char *const theory_kernel_names[] = {SPH_KERNELS(NAME) NULL};
const char *const theory_diffusion_names[] = {SPH_DIFFUSIONS(NAME) NULL};
