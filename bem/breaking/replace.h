/* A part of the surface gives way to another, on which the potential of the water is known. */
#pragma once
#include "bem/shape/curve.h"
#include "bem/water/flow.h"

enum { BEM_CARRIERS = 4 }; /* nodes whose polynomial gives the potential */

/* Replaces the nodes from `from` to before `to` by m points (x, y, phi) and regrids. */
enum status bem_replace(struct bem_flow *f, size_t from, size_t to, size_t m,
                        double point[][BEM_FIELDS]);

/* phi at z by the complex polynomial of these nodes. */
double bem_replace_potential(const struct bem_flow *f, const size_t carrier[BEM_CARRIERS],
                             double complex z);
