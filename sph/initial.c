#include "sph/initial.h"

#include <math.h>
#include <stdlib.h>

static const double close = 1e-9; /* of H: how far apart two lengths may be and still be the same */

double sph_released_head(double x, double y, double L, double H) {
  double head = H - y;
  /* k_n y = (2n+1) theta; cos by the recurrence cos(a + b) = 2 cos a cos b - cos(a - b), with
   * b = 2 theta. cosh(k x)/cosh(k L) written with decaying exponentials only. */
  double theta = M_PI * y / (2 * H), step = 2 * cos(2 * theta);
  double now = cos(theta), before = now; /* cos(-theta) */
  for (int n = 0; n < 1000000; n++) {
    double odd = 2 * n + 1, k = odd * M_PI / (2 * H);
    double ratio = exp(-k * (L - x)) * (1 + exp(-2 * k * x)) / (1 + exp(-2 * k * L));
    double size = 8 * H / (odd * odd * M_PI * M_PI) * ratio;
    head -= size * now;
    if (size < 1e-13 * H) break;
    double next = step * now - before;
    before = now;
    now = next;
  }
  return head;
}

bool sph_initial_column(const struct case_file *c, struct geo_box *column) {
  if (c->water.pieces != 1) return false;
  *column = geo_lines_box(&c->water);
  double w = column->max[0] - column->min[0], h = column->max[1] - column->min[1];
  bool rectangle = fabs(fabs(geo_piece_area(&c->water, 0)) - w * h) < close * w * h;
  bool on_bed = fabs(column->min[1] - c->tank.min[1]) < close * c->H;
  bool left = fabs(column->min[0] - c->tank.min[0]) < close * c->H;
  bool right = fabs(column->max[0] - c->tank.max[0]) < close * c->H;
  return rectangle && on_bed && (left || right);
}

static void place(struct sph *s, double x, double y, const double velocity[2], double pressure,
                  double cell) {
  struct sph_particles *f = &s->f;
  size_t i = f->n++;
  f->w.x[i] = x;
  f->w.y[i] = y;
  f->w.u[i] = velocity[0];
  f->w.v[i] = velocity[1];
  f->w.rho[i] = s->rho0 + pressure / (s->c0 * s->c0);
  f->m[i] = f->w.rho[i] * cell;
}

/* Pressure over rho g at a point of the regions. */
static double head_at(const struct sph *s, const struct case_file *c, double top, double x,
                      double y) {
  struct geo_box b;
  if (c->pressure != CASE_PRESSURE_RELEASED || !sph_initial_column(c, &b)) return top - y;
  bool left = fabs(b.min[0] - s->tank.min[0]) < close * c->H;
  bool right = fabs(b.max[0] - s->tank.max[0]) < close * c->H;
  if (left && right) return top - y;
  return sph_released_head(left ? x - b.min[0] : b.max[0] - x, y - b.min[1], b.max[0] - b.min[0],
                           b.max[1] - b.min[1]);
}

struct lattice {
  struct geo_box box;
  size_t nx, ny;
  double dx, dy;
};

static struct lattice lattice_over(const struct geo_lines *region, double dx) {
  struct lattice l = {.box = geo_lines_box(region)};
  double w = l.box.max[0] - l.box.min[0], h = l.box.max[1] - l.box.min[1];
  l.nx = sph_intervals(w, dx);
  l.ny = sph_intervals(h, dx);
  l.dx = w / (double)l.nx;
  l.dy = h / (double)l.ny;
  return l;
}

/* One closed piece of the water, alone. */
static enum status region_of(const struct case_file *c, size_t piece, struct geo_lines *region) {
  geo_lines_clear(region);
  TRY(geo_lines_begin(region, true));
  for (size_t k = c->water.first[piece]; k < c->water.first[piece + 1]; k++)
    TRY(geo_lines_add(region, c->water.p[k][0], c->water.p[k][1]));
  return OK;
}

static enum status fill_regions(struct sph *s, const struct case_file *c) {
  struct geo_lines region = {0};
  enum status status = OK;
  size_t room = 0;
  for (size_t r = 0; r < c->water.pieces; r++) {
    ATTEMPT(region_of(c, r, &region));
    struct lattice l = lattice_over(&region, s->dx);
    room += l.nx * l.ny;
  }
  ATTEMPT(sph_particles_create(&s->f, room));
  s->f.n = 0;
  for (size_t r = 0; r < c->water.pieces; r++) {
    ATTEMPT(region_of(c, r, &region));
    struct lattice l = lattice_over(&region, s->dx);
    for (size_t i = 0; i < l.nx; i++)
      for (size_t j = 0; j < l.ny; j++) {
        double x = l.box.min[0] + ((double)i + 0.5) * l.dx;
        double y = l.box.min[1] + ((double)j + 0.5) * l.dy;
        if (!geo_lines_contain(&region, x, y)) continue;
        double head = head_at(s, c, l.box.max[1], x, y);
        place(s, x, y, c->velocity, s->rho0 * s->g * head, l.dx * l.dy);
      }
  }
done:
  geo_lines_destroy(&region);
  return status;
}

/* At rest with elevation a cos(kx); the pressure of the linear wave, stretched with the column so
 * that it vanishes on the surface: p/(rho g) = depth - eta (1 - cosh(k Y)/cosh(k d)), Y the height
 * that the particle would have in still water. */
static enum status fill_standing_wave(struct sph *s, const struct case_file *c) {
  const double rest[2] = {0, 0};
  double width = s->tank.max[0] - s->tank.min[0], d = c->wave.depth, a = c->wave.amplitude;
  double k = 2 * M_PI / c->wave.wavelength;
  size_t nx = sph_intervals(width, s->dx), ny = sph_intervals(d, s->dx);
  TRY(sph_particles_create(&s->f, nx * ny));
  s->f.n = 0;
  double dx = width / (double)nx;
  for (size_t i = 0; i < nx; i++) {
    double x = ((double)i + 0.5) * dx, eta = a * cos(k * x), dy = (d + eta) / (double)ny;
    for (size_t j = 0; j < ny; j++) {
      double y = ((double)j + 0.5) * dy, Y = ((double)j + 0.5) * d / (double)ny;
      double decay = exp(k * (Y - d)) * (1 + exp(-2 * k * Y)) / (1 + exp(-2 * k * d));
      double head = d + eta - y - eta * (1 - decay);
      place(s, s->tank.min[0] + x, s->tank.min[1] + y, rest, s->rho0 * s->g * head, dx * dy);
    }
  }
  return OK;
}

enum status sph_initial_fill(struct sph *s, const struct case_file *c) {
  if (c->wave.kind == CASE_WAVE_STANDING)
    TRY(fill_standing_wave(s, c));
  else
    TRY(fill_regions(s, c));
  CHECK(s->f.n > 0, ERR_INPUT,
        "no particle of spacing %g m fits into the water: raise the resolution", s->dx);
  sph_particles_pad(&s->f);
  return OK;
}
