/* Figures of the spectra that the settings ask for. */
#pragma once
#include "compare/comparison.h"
#include "compare/figure.h"

enum status cmp_spectra_write(const struct comparison *c, struct cmp_figures *f);
