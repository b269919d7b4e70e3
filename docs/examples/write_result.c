/* Hands the results of another program to plunge: a standing wave by linear theory.
 *
 *   cc write_result.c $(pkg-config --cflags --libs plunge-result) -lm */
#include <math.h>
#include <plunge_result.h>
#include <stdio.h>

enum { POINTS = 161, OUTPUTS = 21 };

int main(void) {
  const double H = 2, g = 9.81, rho = 1000, length = 4, amplitude = 0.04;
  const double k = acos(-1) / length, omega = sqrt(g * k * tanh(k * H));
  const double rest = rho * g * length * H * H / 2,
               E = rho * g * length * amplitude * amplitude / 4;
  const double walls[] = {0, 3, 0, 0, length, 0, length, 3};
  double points[2 * POINTS];

  plunge_result *r = plunge_result_open("airy-c.h5", H, g, rho, length / (POINTS - 1));
  plunge_result_names(r, "airy", "theirs", "A small standing wave");
  plunge_result_wall(r, 4, walls, 0);
  plunge_result_rest(r, rest);
  plunge_result_gauge(r, "middle", length / 4);
  for (int i = 0; i < OUTPUTS; i++) {
    const double t = 0.1 * i, c = cos(omega * t), s = sin(omega * t);
    for (int j = 0; j < POINTS; j++) {
      points[2 * j] = length * j / (POINTS - 1);
      points[2 * j + 1] = H + amplitude * cos(k * points[2 * j]) * c;
    }
    plunge_result_surface(r, t, POINTS, points);
    plunge_result_energy(r, t, E * s * s, E * c * c + rest, 0, 0, NULL);
    plunge_result_elevation(r, 0, t, points[2 * 40 + 1]);
  }
  if (plunge_result_close(r, NULL) == 0) return 0;
  fprintf(stderr, "%s\n", plunge_result_message());
  return 1;
}
