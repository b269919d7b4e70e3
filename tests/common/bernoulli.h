/* What Bernoulli's equation says of the pressure below a surface, for the tests of flows that find
 * it. */
#pragma once
#include <math.h>

#include "common/flow/flow.h"
#include "tests/test.h"

/* p/(rho g) + y + |u|^2/2g is harmonic: its mean over a circle in the water is what it is in the
 * middle, to `near` (m). */
static inline void expect_harmonic(const struct flow_water *w, double x, double y, double radius,
                                   double near) {
  double mean = 0, middle = 0;
  for (int i = 0; i <= 32; i++) { /* the last is the middle */
    const double far = i < 32 ? radius : 0, angle = 2 * M_PI * i / 32;
    const double px = x + far * cos(angle), py = y + far * sin(angle);
    double head, u[2];
    EXPECT_OK(flow_head(w, &(struct flow_point){px, py, py}, &head));
    flow_velocity(w, px, py, 0, u);
    const double sum = head + py + (u[0] * u[0] + u[1] * u[1]) / (2 * w->c->g);
    if (i < 32)
      mean += sum / 32;
    else
      middle = sum;
  }
  EXPECT_NEAR(mean, middle, near);
}
