#include "common/flow/release_mesh.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/geometry_check.h"
#include "common/base/triangles.h"
#include "common/flow/release_rim.h"

enum { FRAME = 8 };

/* Nodes leave their even places by up to this, of their distance, so that no four are on a circle,
 * where rounding would choose the triangles. */
static const double UNEVEN = 0.2;

/* Of the distance wanted: the widest leaf, how near to the outline a node may stand, and what is
 * too short to be halved. */
static const double WIDEST = 1.4, CLEAR = 0.45, TINY = 1e-6;

/* Of the water's area: what sums over triangles and over the outline may differ by, to rounding. */
static const double FILLED = 1e-9;

/* A piece of the outline between two nodes, or of a wall within the water. */
struct segment {
  size_t end[2]; /* the water is on the left */
  enum release_kind kind;
};

/* One side of a triangle: the nodes at its ends in order, and the corner that it is across from. */
struct half {
  size_t low, high, triangle;
  int corner;
};

struct drawing {
  const struct geo_lines *water;
  struct release_rims rims;
  size_t nodes, node_room, segments, segment_room, triangles, halves;
  double (*p)[2];
  struct segment *segment, *sorted; /* as they are along the rims; by their ends */
  size_t (*corner)[3];
  struct half *half;        /* [halves], sorted */
  unsigned char *wet;       /* [triangles] */
  size_t *stack, *kept;     /* [triangles]; the number of a wet one in `out` */
  size_t *same;             /* [3 * triangles], a corner that is the same node */
  struct release_mesh *out; /* owned by the caller */
};

/* Between -1/2 and 1/2, another one for each number. */
static double scatter(double number) {
  return number - floor(number) - 0.5;
}

static enum status add_node(struct drawing *d, const double at[2]) {
  TRY(array_grow(&d->p, &d->node_room, d->nodes + 1, "the nodes of the released pressure"));
  memcpy(d->p[d->nodes++], at, sizeof *d->p);
  return OK;
}

/* ---- nodes along the rims ---- */

static enum status add_segment(struct drawing *d, size_t a, size_t b, enum release_kind kind) {
  TRY(array_grow(&d->segment, &d->segment_room, d->segments + 1,
                 "the outline of the released pressure"));
  d->segment[d->segments++] = (struct segment){{a, b}, kind};
  return OK;
}

/* The node at the end of a rim, of which the ends of all come first. */
static enum status find_end(struct drawing *d, const double at[2], size_t *node) {
  for (*node = 0; *node < d->nodes; ++*node)
    if (d->p[*node][0] == at[0] && d->p[*node][1] == at[1]) return OK;
  return add_node(d, at);
}

/* How many distances of nodes it is from a to b, by steps of an eighth of them; where `wanted` of
 * them are gone, as a part of the way. */
static double count_along(const struct release_rims *r, const double a[2], const double b[2],
                          double wanted, double *part) {
  const double length = hypot(b[0] - a[0], b[1] - a[1]);
  double gone = 0, count = 0;
  for (*part = 1; gone < length;) {
    double at[2], step;
    for (int pass = 0; pass < 2; pass++) { /* the size in the middle of the step */
      const double ahead = gone + (pass ? step / 2 : 0);
      for (int k = 0; k < 2; k++) at[k] = a[k] + ahead / length * (b[k] - a[k]);
      step = fmin(release_rims_size(r, at) / 8, length - gone);
    }
    const double more = step / release_rims_size(r, at);
    if (count + more >= wanted) {
      *part = fmin((gone + (wanted - count) / more * step) / length, 1);
      return wanted;
    }
    count += more;
    gone += step;
  }
  return count;
}

static enum status divide_rim(struct drawing *d, const struct release_rim *e, size_t a, size_t b) {
  double part;
  const double count = count_along(&d->rims, e->end[0], e->end[1], INFINITY, &part);
  const size_t n = (size_t)fmax(ceil(count - 1e-6), 1);
  size_t last = a;
  for (size_t i = 1; i < n; i++) {
    double at[2];
    const double uneven = (double)i + UNEVEN * scatter(M_SQRT2 * (double)i);
    count_along(&d->rims, e->end[0], e->end[1], count * uneven / (double)n, &part);
    for (int k = 0; k < 2; k++) at[k] = e->end[0][k] + part * (e->end[1][k] - e->end[0][k]);
    TRY(add_node(d, at));
    TRY(add_segment(d, last, d->nodes - 1, e->kind));
    last = d->nodes - 1;
  }
  return add_segment(d, last, b, e->kind);
}

static enum status divide_rims(struct drawing *d) {
  size_t *end = NULL;
  enum status status = OK;
  ATTEMPT(array_create(&end, 2 * d->rims.n, "the outline of the released pressure"));
  for (size_t i = 0; i < 2 * d->rims.n; i++)
    ATTEMPT(find_end(d, d->rims.edge[i / 2].end[i % 2], &end[i]));
  for (size_t i = 0; i < d->rims.n; i++)
    ATTEMPT(divide_rim(d, &d->rims.edge[i], end[2 * i], end[2 * i + 1]));
done:
  free(end);
  return status;
}

/* ---- nodes inside ---- */

/* A square of the tree, and the rims that come near it. */
struct square {
  double at[2], width; /* m */
  size_t n;
  size_t *rim;  /* [n], owned */
  bool inside;  /* where no rim comes near it */
  uint64_t key; /* of its place in the tree */
};

static double rim_distance(const struct drawing *d, size_t rim, const double at[2]) {
  const struct release_rim *e = &d->rims.edge[rim];
  double foot[2];
  geo_segment_foot(e->end[0], e->end[1], at, foot);
  return hypot(at[0] - foot[0], at[1] - foot[1]);
}

static enum status plant_leaf(struct drawing *d, const struct square *s) {
  if (s->n ? !geo_lines_contain(d->water, s->at[0], s->at[1]) : !s->inside) return OK;
  for (size_t i = 0; i < s->n; i++)
    if (rim_distance(d, s->rim[i], s->at) < CLEAR * s->width) return OK;
  const double at[2] = {s->at[0] + UNEVEN * s->width * scatter(M_SQRT2 * (double)s->key),
                        s->at[1] + UNEVEN * s->width * scatter(M_E * (double)s->key)};
  return add_node(d, at);
}

static enum status plant(struct drawing *d, const struct square *from, double x, double y,
                         double width, uint64_t key) {
  struct square s = {.at = {x, y}, .width = width, .inside = from->inside, .key = key};
  enum status status = OK;
  if (from->n) {
    ATTEMPT(array_create(&s.rim, from->n, "the nodes of the released pressure"));
    for (size_t i = 0; i < from->n; i++)
      if (rim_distance(d, from->rim[i], s.at) < (CLEAR + M_SQRT1_2) * width)
        s.rim[s.n++] = from->rim[i];
    if (!s.n) s.inside = geo_lines_contain(d->water, x, y);
  }
  if (!s.n && !s.inside) goto done;
  if (width <= WIDEST * release_rims_size(&d->rims, s.at))
    ATTEMPT(plant_leaf(d, &s));
  else
    for (int k = 0; k < 4; k++)
      ATTEMPT(plant(d, &s, x + (k & 1 ? 0.25 : -0.25) * width, y + (k & 2 ? 0.25 : -0.25) * width,
                    width / 2, 4 * key + (uint64_t)k));
done:
  free(s.rim);
  return status;
}

/* The root is so wide that leaves away from bends are as wide as asked. */
static enum status plant_all(struct drawing *d) {
  struct square all = {.n = d->rims.n};
  const struct geo_box *b = &d->rims.box;
  double width = d->rims.size;
  enum status status = OK;
  ATTEMPT(array_create(&all.rim, all.n, "the nodes of the released pressure"));
  for (size_t i = 0; i < all.n; i++) all.rim[i] = i;
  while (width < fmax(b->max[0] - b->min[0], b->max[1] - b->min[1])) width *= 2;
  ATTEMPT(plant(d, &all, b->min[0] + width / 2, b->min[1] + width / 2, width, 1));
done:
  free(all.rim);
  return status;
}

/* Far around the water, so that the hull of all nodes is nowhere near it. */
static enum status plant_frame(struct drawing *d) {
  const struct geo_box *b = &d->rims.box;
  const double far = 2 * hypot(b->max[0] - b->min[0], b->max[1] - b->min[1]);
  for (int k = 0; k < FRAME; k++) {
    const double turn = 2 * M_PI * (k + 0.3) / FRAME;
    const double at[2] = {(b->min[0] + b->max[0]) / 2 + far * cos(turn),
                          (b->min[1] + b->max[1]) / 2 + far * sin(turn)};
    TRY(add_node(d, at));
  }
  return OK;
}

/* ---- triangles ---- */

static int by_ends(const void *a, const void *b) {
  const struct half *p = a, *q = b;
  return p->low != q->low ? (p->low > q->low) - (p->low < q->low)
                          : (p->high > q->high) - (p->high < q->high);
}

/* From the low node to the high one in the order of the corners, that is with the triangle on the
 * left. */
static bool runs_up(const struct drawing *d, const struct half *h) {
  return d->corner[h->triangle][(h->corner + 1) % 3] == h->low;
}

static enum status sort_halves(struct drawing *d) {
  free(d->half);
  d->half = NULL;
  d->halves = 3 * d->triangles;
  TRY(array_create(&d->half, d->halves, "the triangles of the released pressure"));
  for (size_t i = 0; i < d->halves; i++) {
    const size_t *corner = d->corner[i / 3], a = corner[(i + 1) % 3], b = corner[(i + 2) % 3];
    d->half[i] = (struct half){a < b ? a : b, a < b ? b : a, i / 3, (int)(i % 3)};
  }
  qsort(d->half, d->halves, sizeof *d->half, by_ends);
  return OK;
}

static const struct half *find_half(const struct drawing *d, const struct segment *s) {
  const size_t a = s->end[0], b = s->end[1];
  const struct half wanted = {.low = a < b ? a : b, .high = a < b ? b : a};
  return bsearch(&wanted, d->half, d->halves, sizeof *d->half, by_ends);
}

/* Halves the segments that are no side of a triangle; how many there were. */
static enum status halve_missing(struct drawing *d, size_t *missing) {
  const size_t n = d->segments;
  *missing = 0;
  for (size_t i = 0; i < n; i++) {
    const struct segment s = d->segment[i];
    if (find_half(d, &s)) continue;
    double middle[2];
    const double *a = d->p[s.end[0]], *b = d->p[s.end[1]];
    for (int k = 0; k < 2; k++) middle[k] = (a[k] + b[k]) / 2;
    CHECK(
        hypot(b[0] - a[0], b[1] - a[1]) > TINY * d->rims.size, ERR_SOLVER,
        "no triangles between the walls and surfaces of the water at (%g, %g) m, for the released "
        "pressure: draw its outline without tiny parts there",
        middle[0], middle[1]);
    TRY(add_node(d, middle));
    d->segment[i].end[1] = d->nodes - 1;
    TRY(add_segment(d, d->nodes - 1, s.end[1], s.kind));
    ++*missing;
  }
  return OK;
}

static enum status join_nodes(struct drawing *d) {
  for (size_t missing = 1; missing;) {
    free(d->corner);
    d->corner = NULL;
    TRY(geo_triangulate(d->nodes, (const double(*)[2])d->p, &d->triangles, &d->corner));
    TRY(sort_halves(d));
    TRY(halve_missing(d, &missing));
  }
  return OK;
}

/* ---- which of them are water ---- */

static int by_segment(const void *a, const void *b) {
  const struct segment *p = a, *q = b;
  for (int k = 0; k < 2; k++)
    if (p->end[k] != q->end[k]) return p->end[k] < q->end[k] ? -1 : 1;
  return 0;
}

static enum status sort_segments(struct drawing *d) {
  TRY(array_create(&d->sorted, d->segments, "the outline of the released pressure"));
  for (size_t i = 0; i < d->segments; i++) {
    const size_t a = d->segment[i].end[0], b = d->segment[i].end[1];
    d->sorted[i] = (struct segment){{a < b ? a : b, a < b ? b : a}, d->segment[i].kind};
  }
  qsort(d->sorted, d->segments, sizeof *d->sorted, by_segment);
  return OK;
}

static const struct segment *segment_of(const struct drawing *d, const struct half *h) {
  const struct segment wanted = {.end = {h->low, h->high}};
  return bsearch(&wanted, d->sorted, d->segments, sizeof *d->sorted, by_segment);
}

/* The half-side of the triangle across, or NULL. */
static const struct half *other_half(const struct drawing *d, const struct half *h) {
  if (h > d->half && by_ends(h - 1, h) == 0) return h - 1;
  return h + 1 < d->half + d->halves && by_ends(h, h + 1) == 0 ? h + 1 : NULL;
}

/* Wet are the triangles on the left of the outline, and what can be come to from them. */
static enum status flood(struct drawing *d) {
  size_t waiting = 0, *place = NULL;
  enum status status = OK;
  ATTEMPT(array_create(&d->wet, d->triangles, "the triangles of the released pressure"));
  ATTEMPT(array_create(&d->stack, d->triangles, "the triangles of the released pressure"));
  ATTEMPT(array_create(&place, d->halves, "the triangles of the released pressure"));
  for (size_t i = 0; i < d->halves; i++)
    place[3 * d->half[i].triangle + (size_t)d->half[i].corner] = i;
  for (size_t i = 0; i < d->segments; i++) {
    const struct segment *s = &d->segment[i];
    const struct half *h = find_half(d, s), *pair[2] = {h, other_half(d, h)};
    for (int k = 0; k < 2 && s->kind != RELEASE_SLIT; k++)
      if (pair[k] && runs_up(d, pair[k]) == (s->end[0] < s->end[1]) && !d->wet[pair[k]->triangle])
        d->wet[d->stack[waiting++] = pair[k]->triangle] = 1;
  }
  while (waiting) {
    const size_t t = d->stack[--waiting];
    for (size_t k = 0; k < 3; k++) {
      const struct half *h = &d->half[place[3 * t + k]], *next = other_half(d, h);
      const struct segment *s = segment_of(d, h);
      if (next && (!s || s->kind == RELEASE_SLIT) && !d->wet[next->triangle])
        d->wet[d->stack[waiting++] = next->triangle] = 1;
    }
  }
done:
  free(place);
  return status;
}

/* ---- the mesh ---- */

static size_t first_of(struct drawing *d, size_t corner) {
  while (d->same[corner] != corner) corner = d->same[corner] = d->same[d->same[corner]];
  return corner;
}

static bool is_shared(const struct drawing *d, const struct half *h) {
  return h + 1 < d->half + d->halves && by_ends(h, h + 1) == 0 && d->wet[h->triangle] &&
         d->wet[h[1].triangle] && !segment_of(d, h);
}

/* Corners of triangles are one node where the triangles have a side in common: so the two sides of
 * a plate have their own. */
static enum status join_corners(struct drawing *d) {
  TRY(array_create(&d->same, 3 * d->triangles, "the triangles of the released pressure"));
  for (size_t i = 0; i < 3 * d->triangles; i++) d->same[i] = i;
  for (size_t i = 0; i < d->halves; i++) {
    const struct half *h = &d->half[i], *o = h + 1;
    if (!is_shared(d, h)) continue;
    for (int k = 1; k < 3; k++) { /* they run in opposite directions */
      const size_t a = first_of(d, 3 * h->triangle + (size_t)((h->corner + k) % 3));
      const size_t b = first_of(d, 3 * o->triangle + (size_t)((o->corner + 3 - k) % 3));
      d->same[a > b ? a : b] = a > b ? b : a;
    }
  }
  return OK;
}

/* Numbers the wet triangles, and the nodes in the order of their first corners. */
static enum status collect_triangles(struct drawing *d, size_t *number) {
  struct release_mesh *m = d->out;
  TRY(array_create(&m->corner, d->triangles, "the triangles of the released pressure"));
  TRY(array_create(&m->across, d->triangles, "the triangles of the released pressure"));
  TRY(array_create(&m->p, 3 * d->triangles, "the nodes of the released pressure"));
  TRY(array_create(&d->kept, d->triangles, "the triangles of the released pressure"));
  for (size_t t = 0; t < d->triangles; t++) {
    if (!d->wet[t]) continue;
    for (size_t k = 0; k < 3; k++) {
      const size_t first = first_of(d, 3 * t + k);
      if (first == 3 * t + k) {
        memcpy(m->p[m->nodes], d->p[d->corner[t][k]], sizeof *m->p);
        number[first] = m->nodes++;
      }
      m->corner[m->triangles][k] = number[first];
    }
    d->kept[t] = m->triangles++;
  }
  return array_resize(&m->p, m->nodes, "the nodes of the released pressure");
}

static void put_edge(struct drawing *d, const struct half *h, enum release_kind kind) {
  struct release_mesh *m = d->out;
  const size_t t = d->kept[h->triangle], *corner = m->corner[t];
  m->across[t][h->corner] = m->edges;
  m->edge[m->edges++] =
      (struct release_edge){{corner[(h->corner + 1) % 3], corner[(h->corner + 2) % 3]}, kind};
}

#define GAP                                                                                        \
  "the triangles of the released pressure leave a gap in the water at (%g, %g) m: draw its "       \
  "outline without tiny parts there"

static enum status collect_edges(struct drawing *d) {
  struct release_mesh *m = d->out;
  TRY(array_create(&m->edge, 3 * m->triangles, "the triangles of the released pressure"));
  for (size_t i = 0; i < d->halves; i++) {
    const struct half *h = &d->half[i];
    if (!d->wet[h->triangle]) continue;
    const struct segment *s = segment_of(d, h);
    const double *a = d->p[h->low], *b = d->p[h->high];
    CHECK(s || is_shared(d, h), ERR_SOLVER, GAP, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
    put_edge(d, h, s ? s->kind : RELEASE_INSIDE);
    if (!is_shared(d, h)) continue;
    const struct half *o = &d->half[++i];
    m->across[d->kept[o->triangle]][o->corner] = m->edges - 1;
  }
  return OK;
}

/* That wet triangles fill the outline. */
static enum status check_area(const struct drawing *d) {
  const struct release_mesh *m = d->out;
  const double *at = d->p[0];
  double filled = 0, outlined = 0;
  for (size_t t = 0; t < m->triangles; t++)
    filled +=
        geo_triangle_cross(m->p[m->corner[t][0]], m->p[m->corner[t][1]], m->p[m->corner[t][2]]);
  for (size_t i = 0; i < d->segments; i++) {
    const struct segment *s = &d->segment[i];
    if (s->kind != RELEASE_SLIT)
      outlined += geo_triangle_cross(at, d->p[s->end[0]], d->p[s->end[1]]);
  }
  CHECK(
      fabs(filled - outlined) <= FILLED * outlined, ERR_SOLVER,
      "the triangles of the released pressure fill %.9g m^2 of water of %.9g m^2: draw its outline "
      "without tiny parts",
      filled / 2, outlined / 2);
  return OK;
}

static enum status collect(struct drawing *d) {
  size_t *number = NULL;
  enum status status = OK;
  ATTEMPT(join_corners(d));
  ATTEMPT(array_create(&number, 3 * d->triangles, "the nodes of the released pressure"));
  ATTEMPT(collect_triangles(d, number));
  ATTEMPT(collect_edges(d));
  ATTEMPT(check_area(d));
done:
  free(number);
  return status;
}

static void drop(struct drawing *d) {
  release_rims_destroy(&d->rims);
  free(d->p);
  free(d->segment);
  free(d->sorted);
  free(d->corner);
  free(d->half);
  free(d->wet);
  free(d->stack);
  free(d->kept);
  free(d->same);
}

enum status release_mesh_create(const struct geo_lines *water, const struct geo_lines *walls,
                                double size, double near, struct release_mesh **out) {
  struct drawing d = {.water = water};
  enum status status = OK;
  *out = NULL;
  ATTEMPT(array_create(&d.out, 1, "the released pressure"));
  ATTEMPT(release_rims_create(water, walls, size, near, &d.rims));
  ATTEMPT(divide_rims(&d));
  ATTEMPT(plant_all(&d));
  ATTEMPT(plant_frame(&d));
  ATTEMPT(join_nodes(&d));
  ATTEMPT(sort_segments(&d));
  ATTEMPT(flood(&d));
  ATTEMPT(collect(&d));
done:
  drop(&d);
  if (status == OK)
    *out = d.out;
  else
    release_mesh_destroy(d.out);
  return status;
}

void release_mesh_destroy(struct release_mesh *m) {
  if (!m) return;
  free(m->p);
  free(m->corner);
  free(m->across);
  free(m->edge);
  free(m);
}
