/* The particle solver's variants as parameters of topics; `plunge list` explains them. */
#pragma once

extern const char *const theory_kernel_names[];
extern const char *const theory_diffusion_names[];
extern const char *const theory_derivative_names[];
extern const char *const theory_continuity_names[];
extern const char *const theory_momentum_names[];
extern const char *const theory_free_surface_names[];
