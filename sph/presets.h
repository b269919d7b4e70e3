/* Named schemes: what the key `scheme` sets as long as a run does not say otherwise. */
#pragma once
#include "common/base/params.h"

enum { SPH_N_PRESETS = 8 };
extern const struct param_preset sph_presets[SPH_N_PRESETS];
extern const char *const sph_preset_names[]; /* NULL at the end */
