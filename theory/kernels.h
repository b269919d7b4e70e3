/* The particle solver's kernels and diffusions as parameters of topics; `plunge list` explains
 * them.
 */
#pragma once

extern const char *const theory_kernel_names[];
extern const char *const theory_diffusion_names[];
