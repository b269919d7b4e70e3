#include "common/flow/release.h"

#include <math.h>
#include <stdbool.h>
#include <stdlib.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/flow/release_field.h"

double release_head(double x, double y, double L, double H) {
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

enum { PLAIN, MIRRORED, VIEWS };

/* More nodes than this do not make the start better: the pressure is smooth at that scale. */
static const double MOST_NODES = 4e5;

/* The mean of two solutions, on the triangles of the water and on those of its mirror image, level
 * as its weight has it: what is mirrored or turned as a whole gets the same pressure, to rounding.
 */
struct release {
  double middle[2], down[2];          /* m; a direction */
  bool suction;                       /* is what drives it */
  struct release_field *field[VIEWS]; /* owned */
};

/* A point as the solution sees it: from the middle of the water's box, m. */
static void view(const struct release *r, int which, const double p[2], double out[2]) {
  const double x = p[0] - r->middle[0], y = p[1] - r->middle[1];
  out[0] = r->down[0] * y - r->down[1] * x;
  out[1] = -r->down[0] * x - r->down[1] * y;
  if (which == MIRRORED) out[0] = -out[0];
}

/* Keeps the water on the left: a mirror image runs the other way. */
static enum status view_lines(const struct release *r, int which, const struct geo_lines *from,
                              struct geo_lines *to) {
  TRY(geo_lines_copy(to, from));
  for (size_t i = 0; i < to->points; i++) view(r, which, from->p[i], to->p[i]);
  for (size_t k = 0; which == MIRRORED && k < to->pieces; k++) geo_piece_reverse(to, k);
  return OK;
}

static enum status solve(struct release *r, int which, const struct geo_lines *water,
                         const struct geo_lines *walls, double size, double near,
                         const struct release_drive *drive) {
  const struct release_drive level = {{0, -hypot(drive->weight[0], drive->weight[1])},
                                      drive->source};
  struct geo_lines seen[2] = {0};
  enum status status = OK;
  ATTEMPT(view_lines(r, which, water, &seen[0]));
  ATTEMPT(view_lines(r, which, walls, &seen[1]));
  ATTEMPT(release_field_create(&seen[0], &seen[1], size, near, &level, &r->field[which]));
done:
  for (int k = 0; k < 2; k++) geo_lines_destroy(&seen[k]);
  return status;
}

static double area_of(const struct geo_lines *water) {
  double area = 0;
  for (size_t k = 0; k < water->pieces; k++) area += fabs(geo_piece_area(water, k));
  return area;
}

static double node_spacing(const struct geo_lines *water, double spacing) {
  return fmax(spacing, sqrt(area_of(water) / MOST_NODES));
}

double release_seconds(const struct geo_lines *water, double spacing) {
  const double size = node_spacing(water, spacing);
  return 2.7 * pow(area_of(water) / (size * size) / 102400, 1.4);
}

enum status release_create(const struct geo_lines *water, const struct geo_lines *walls,
                           double spacing, double near, const struct release_drive *drive,
                           struct release **out) {
  const struct geo_box box = geo_lines_box(water);
  const double weight = hypot(drive->weight[0], drive->weight[1]);
  enum status status = OK;
  struct release *r = NULL;
  *out = NULL;
  const double size = 2 * node_spacing(water, spacing); /* with nodes half way, too */
  ATTEMPT(array_create(&r, 1, "the released pressure"));
  r->suction = drive->source < 0;
  for (int k = 0; k < 2; k++) {
    r->middle[k] = (box.min[k] + box.max[k]) / 2;
    r->down[k] = weight > 0 ? drive->weight[k] / weight : -k;
  }
  for (int which = 0; which < VIEWS; which++)
    ATTEMPT(solve(r, which, water, walls, size, near, drive));
done:
  if (status == OK)
    *out = r;
  else
    release_destroy(r);
  return status;
}

void release_destroy(struct release *r) {
  if (!r) return;
  for (int which = 0; which < VIEWS; which++) release_field_destroy(r->field[which]);
  free(r);
}

double release_at(const struct release *r, double x, double y) {
  double mean = 0;
  for (int which = 0; which < VIEWS; which++) {
    double at[2];
    view(r, which, (double[2]){x, y}, at);
    mean += release_field_at(r->field[which], at) / VIEWS;
  }
  return r->suction ? mean : fmax(mean, 0); /* water that is let go is not drawn together */
}
