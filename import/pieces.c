#include "import/pieces.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

/* ---- profiles ---- */

/* Of the spacing: what texts of few digits and sines leave between the ends of a closed piece. */
static const double CLOSED = 1e-3;

static void reverse(struct geo_lines *l, size_t piece) {
  if (l->first[piece + 1] == l->first[piece]) return;
  for (size_t a = l->first[piece], b = l->first[piece + 1] - 1; a < b; a++, b--)
    for (int k = 0; k < 2; k++) {
      const double keep = l->p[a][k];
      l->p[a][k] = l->p[b][k];
      l->p[b][k] = keep;
    }
}

/* Whether a piece is in the water: straight upwards from it the others are crossed an odd number of
 * times. */
static bool is_under(const struct geo_lines *l, size_t piece) {
  const double *p = l->p[l->first[piece]];
  bool under = false;
  for (size_t k = 0; k < l->pieces; k++) {
    if (k == piece) continue;
    for (size_t i = 0; i < geo_piece_segments(l, k); i++) {
      const double *a = l->p[l->first[k] + i], *b = geo_segment_end(l, k, i);
      if ((a[0] <= p[0]) == (b[0] <= p[0])) continue;
      const double y = a[1] + (p[0] - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
      under ^= y > p[1];
    }
  }
  return under;
}

static void orient(struct geo_lines *l) {
  for (size_t k = 0; k < l->pieces; k++)
    if (!l->closed[k] && l->p[l->first[k]][0] > l->p[l->first[k + 1] - 1][0]) reverse(l, k);
  for (size_t k = 0; k < l->pieces; k++) {
    if (!l->closed[k]) continue;
    const bool cavity = is_under(l, k);
    if ((geo_piece_area(l, k) > 0) != cavity) reverse(l, k);
  }
}

/* The largest distance of points from the first one of their piece. */
static double reach(const struct geo_lines *l, size_t k) {
  const double *a = l->p[l->first[k]];
  double most = 0;
  for (size_t i = l->first[k]; i < l->first[k + 1]; i++)
    most = fmax(most, hypot(l->p[i][0] - a[0], l->p[i][1] - a[1]));
  return most;
}

enum status import_profile(const char *name, double time, double spacing, size_t n, const double *x,
                           const double *y, const double *piece, struct geo_lines *out) {
  geo_lines_clear(out);
  for (size_t i = 0; i < n; i++) {
    CHECK(isfinite(x[i]) && isfinite(y[i]), ERR_INPUT,
          "%s: point %zu of the profile at %g s is missing; every point needs x and y", name, i + 1,
          time);
    if (!i || (piece && piece[i] != piece[i - 1])) TRY(geo_lines_begin(out, false));
    TRY(geo_lines_add(out, x[i], y[i]));
  }
  for (size_t k = 0; k < out->pieces; k++) {
    const size_t a = out->first[k], b = out->first[k + 1];
    CHECK(b - a >= 2, ERR_INPUT,
          "%s: a piece of the profile at %g s has one point; it needs at least two", name, time);
    CHECK(reach(out, k) > 0, ERR_INPUT,
          "%s: a piece of the profile at %g s has all its points in one place, (%g, %g) m", name,
          time, out->p[a][0], out->p[a][1]);
    const double apart = hypot(out->p[b - 1][0] - out->p[a][0], out->p[b - 1][1] - out->p[a][1]);
    if (b - a < 4 || apart > CLOSED * spacing) continue;
    /* the point that is there twice goes */
    memmove(out->p + b - 1, out->p + b, (out->points - b) * sizeof *out->p);
    out->points--;
    for (size_t j = k + 1; j <= out->pieces; j++) out->first[j]--;
    out->closed[k] = 1;
  }
  orient(out);
  return OK;
}

/* ---- contours ---- */

/* A point of the contour lies on an edge of the mesh, by which it is known. */
struct crossing {
  size_t from, to; /* corners, from < to */
  size_t next;     /* crossing that follows, the water on the right; SIZE_MAX: none */
  bool reached;    /* one leads here */
  double p[2];
};

struct contour {
  size_t n, slots;
  struct crossing *cross; /* [n], owned */
  size_t room;
  size_t *slot; /* hash of edges: place among them + 1, [slots], owned */
};

static size_t *find_slot(const struct contour *c, size_t from, size_t to) {
  uint64_t h = (uint64_t)from * 0x9e3779b97f4a7c15u ^ ((uint64_t)to * 0xc2b2ae3d27d4eb4fu);
  h ^= h >> 29;
  for (size_t k = h & (c->slots - 1);; k = (k + 1) & (c->slots - 1)) {
    const size_t at = c->slot[k];
    if (!at || (c->cross[at - 1].from == from && c->cross[at - 1].to == to)) return &c->slot[k];
  }
}

struct field {
  const double *x, *y, *value;
  double level, sign; /* water where sign (value - level) > 0, or at it */
};

static double depth(const struct field *f, size_t i) {
  return f->sign * (f->value[i] - f->level);
}

static enum status cross_edge(struct contour *c, const struct field *f, size_t a, size_t b,
                              size_t *at) {
  const size_t from = a < b ? a : b, to = a < b ? b : a;
  size_t *slot = find_slot(c, from, to);
  if (!*slot) {
    const double da = depth(f, from), db = depth(f, to);
    const double t = fmin(fmax(da / (da - db), 0), 1);
    TRY(array_grow(&c->cross, &c->room, c->n + 1, "points of a contour"));
    c->cross[c->n] = (struct crossing){
        from,
        to,
        SIZE_MAX,
        false,
        {f->x[from] + t * (f->x[to] - f->x[from]), f->y[from] + t * (f->y[to] - f->y[from])}};
    *slot = ++c->n;
  }
  *at = *slot - 1;
  return OK;
}

/* Round a triangle, counter-clockwise: a curve with the water on its right comes in where dry turns
 * into wet, and goes out where wet turns into dry. */
static enum status cut_triangle(struct contour *c, const struct field *f, const size_t corner[3]) {
  size_t q[3] = {corner[0], corner[1], corner[2]}, in = SIZE_MAX, out = SIZE_MAX;
  const double turn = (f->x[q[1]] - f->x[q[0]]) * (f->y[q[2]] - f->y[q[0]]) -
                      (f->x[q[2]] - f->x[q[0]]) * (f->y[q[1]] - f->y[q[0]]);
  if (turn == 0) return OK;
  if (turn < 0) {
    q[1] = corner[2];
    q[2] = corner[1];
  }
  for (int k = 0; k < 3; k++) {
    const size_t a = q[k], b = q[(k + 1) % 3];
    const bool wet_a = depth(f, a) >= 0, wet_b = depth(f, b) >= 0;
    if (wet_a == wet_b) continue;
    TRY(cross_edge(c, f, a, b, wet_b ? &in : &out));
  }
  if (in == SIZE_MAX || out == SIZE_MAX) return OK;
  c->cross[in].next = out;
  c->cross[out].reached = true;
  return OK;
}

/* From a crossing on, each once. Points in the same place (where the level is met at a corner of
 * the mesh) are one. */
static enum status follow(struct contour *c, size_t start, bool closed, struct geo_lines *out) {
  TRY(geo_lines_begin(out, closed));
  const size_t first = out->points;
  for (size_t i = start; i != SIZE_MAX;) {
    const double *p = c->cross[i].p, *last = out->points > first ? out->p[out->points - 1] : NULL;
    if (!last || last[0] != p[0] || last[1] != p[1]) TRY(geo_lines_add(out, p[0], p[1]));
    const size_t next = c->cross[i].next;
    c->cross[i].next = SIZE_MAX;
    c->cross[i].reached = true;
    i = next == start ? SIZE_MAX : next;
  }
  if (closed && out->points > first + 1 && out->p[out->points - 1][0] == out->p[first][0] &&
      out->p[out->points - 1][1] == out->p[first][1])
    out->first[out->pieces] = --out->points;
  if (out->points < first + (closed ? 3 : 2)) { /* only touched */
    out->points = first;
    out->first[--out->pieces] = first;
  }
  return OK;
}

static enum status trace(struct contour *c, struct geo_lines *out) {
  struct geo_lines all = {0};
  enum status status = OK;
  for (size_t i = 0; i < c->n && status == OK; i++)
    if (!c->cross[i].reached && c->cross[i].next != SIZE_MAX) status = follow(c, i, false, &all);
  const size_t open = all.pieces;
  for (size_t i = 0; i < c->n && status == OK; i++)
    if (c->cross[i].next != SIZE_MAX) status = follow(c, i, true, &all);
  size_t longest = 0;
  for (size_t k = 1; k < open; k++)
    if (geo_piece_length(&all, k) > geo_piece_length(&all, longest)) longest = k;
  geo_lines_clear(out);
  if (all.pieces && status == OK) status = geo_lines_add_piece(out, &all, longest);
  for (size_t k = 0; k < all.pieces && status == OK; k++)
    if (k != longest) status = geo_lines_add_piece(out, &all, k);
  geo_lines_destroy(&all);
  return status;
}

enum status import_contour(const char *name, size_t n, const double *x, const double *y,
                           const double *field, const struct import_mesh *mesh, double level,
                           bool below, struct geo_lines *out) {
  const struct field f = {x, y, field, level, below ? -1 : 1};
  struct contour c = {.slots = 64};
  for (size_t i = 0; i < n; i++)
    CHECK(isfinite(x[i]) && isfinite(y[i]) && isfinite(field[i]), ERR_INPUT,
          "%s: the field is not a number at (%g, %g)", name, x[i], y[i]);
  double low = INFINITY, high = -INFINITY;
  for (size_t i = 0; i < n; i++) {
    low = fmin(low, field[i]);
    high = fmax(high, field[i]);
  }
  CHECK(
      low < level && high >= level, ERR_INPUT,
      "%s: the field goes from %g to %g there, so it has no contour at %g; correct the field, the "
      "level or the axes",
      name, low, high, level);
  while (c.slots < 4 * mesh->n) c.slots *= 2; /* at most 3 edges for 2 triangles, half full */
  enum status status = array_create(&c.slot, c.slots, "edges of a mesh");
  for (size_t k = 0; k < mesh->n && status == OK; k++)
    status = cut_triangle(&c, &f, mesh->corner + 3 * k);
  if (status == OK) status = trace(&c, out);
  free(c.slot);
  free(c.cross);
  return status;
}
