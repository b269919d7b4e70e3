#include "compare/frame.h"

#include <stdlib.h>

#include "common/base/array.h"

/* Everything is dimensionless: less than a fiftieth never counts as straying. */
#define LEAST_SIZE 0.02

struct extent { /* of a series: of all rows, and of all but one in two hundred at each end */
  struct cmp_frame whole, usual;
};

static bool extent_take(const struct cmp_series *s, double end, struct extent *e) {
  double *v = s ? malloc((s->n + 1) * sizeof *v) : NULL;
  size_t n = 0;
  for (size_t i = 0; v && i < s->n; i++)
    if (isfinite(s->value[i]) && s->t[i] <= end) v[n++] = s->value[i];
  if (n) {
    qsort(v, n, sizeof *v, array_ascending);
    *e = (struct extent){{v[0], v[n - 1]}, {v[n / 200], v[n - 1 - n / 200]}};
  }
  free(v);
  return n > 0;
}

static double median(double *v, size_t n) { /* the lower one; leaves v sorted */
  qsort(v, n, sizeof *v, array_ascending);
  return v[(n - 1) / 2];
}

static double middle_of(const struct cmp_frame *f) {
  return 0.5 * (f->low + f->high);
}

static double size_of(const struct cmp_frame *f) {
  return fmax(fmax(fabs(f->low), fabs(f->high)), LEAST_SIZE);
}

static void frame_include(struct cmp_frame *all, const struct cmp_frame *f) {
  all->low = fmin(all->low, f->low);
  all->high = fmax(all->high, f->high);
}

static struct cmp_frame frame_of(const struct extent *e, size_t n, double *scratch, double most) {
  struct cmp_frame whole = {INFINITY, -INFINITY}, usual = whole;
  for (size_t k = 0; k < n; k++) scratch[k] = middle_of(&e[k].usual);
  double middle = median(scratch, n);
  for (size_t k = 0; k < n; k++) scratch[k] = size_of(&e[k].usual);
  double reach = most * median(scratch, n);
  for (size_t k = 0; k < n; k++) {
    if (!(fabs(e[k].usual.low - middle) <= reach && fabs(e[k].usual.high - middle) <= reach))
      continue;
    frame_include(&whole, &e[k].whole);
    frame_include(&usual, &e[k].usual);
  }
  if (!(usual.low <= usual.high)) return e[0].usual; /* none is near the others: the first */
  return whole.high - whole.low <= 2 * (usual.high - usual.low) + LEAST_SIZE ? whole : usual;
}

struct cmp_frame cmp_frame_choose(size_t n, const struct cmp_series *const *series, double end,
                                  double most) {
  struct cmp_frame frame = {0, 1};
  struct extent *e = calloc(n + 1, sizeof *e);
  double *scratch = calloc(n + 1, sizeof *scratch);
  size_t found = 0;
  for (size_t k = 0; e && scratch && k < n; k++) found += extent_take(series[k], end, &e[found]);
  if (found) {
    frame = frame_of(e, found, scratch, most);
    double size = fmax(fabs(frame.low), fabs(frame.high));
    double margin = fmax(0.06 * (frame.high - frame.low), size > 0 ? 1e-6 * size : 1e-6);
    frame = (struct cmp_frame){frame.low - margin, frame.high + margin};
  }
  free(e);
  free(scratch);
  return frame;
}

static void extreme_note(struct cmp_extreme *x, double t, double value, double sign) {
  if (!x->found || sign * value > sign * x->value) *x = (struct cmp_extreme){true, t, value};
}

struct cmp_beyond cmp_frame_beyond(const struct cmp_frame *frame, const struct cmp_series *s,
                                   double end) {
  struct cmp_beyond b = {0};
  for (size_t i = 0; i < s->n; i++) {
    if (!isfinite(s->value[i]) || s->t[i] > end) continue;
    b.n++;
    bool above = s->value[i] > frame->high, below = s->value[i] < frame->low;
    if (above) extreme_note(&b.above, s->t[i], s->value[i], 1);
    if (below) extreme_note(&b.below, s->t[i], s->value[i], -1);
    b.outside += above || below;
  }
  return b;
}
