#include "bem/breaking/cuts.h"

#include <math.h>
#include <string.h>

#include "bem/breaking/replace.h"
#include "bem/shape/curve.h"

static const double PIECE = 0.02; /* of the water: more than that is no drop */
static const double OPEN = 2;     /* a sheet is cut where it is so many times as thick */
enum {
  CAP = 5,    /* points of a rounded end */
  BACK = 12,  /* nodes that a cut goes back at most */
  AROUND = 8, /* nodes on either side of a wrinkle that are smoothed */
  PASSES = 4
};

static double complex node(const struct bem_surface *s, size_t k) {
  return CMPLX(s->state[k], s->state[s->n + k]);
}

static double piece_area(const struct bem_surface *s, size_t first, size_t last) {
  double twice = 0;
  for (size_t k = first; k < last; k++)
    twice += cimag(conj(node(s, k) - node(s, first)) * (node(s, k + 1) - node(s, first)));
  return -0.5 * twice;
}

static bool is_little(const struct bem_surface *s, double area) {
  return area < PIECE * s->volume;
}

/* ---- what is to be cut ---- */

static struct bem_piece piece(const struct bem_surface *s, size_t first, size_t last) {
  const double complex middle = 0.5 * (node(s, first) + node(s, last));
  return (struct bem_piece){first, last, creal(middle), cimag(middle)};
}

/* Back to where the sheet is thick enough for a while. */
static struct bem_piece open_piece(const struct bem_sides *w, const struct bem_surface *s,
                                   struct bem_near near, double thick) {
  size_t first = near.node, last = near.panel + 1;
  for (int i = 0; i < BACK && first > 2 && last + 3 < s->n; i++) {
    if (!bem_sides_across(w, s, s->state, first - 1, BEM_WATER, thick, &near)) break;
    if (near.panel <= first) break;
    first--;
    last = near.panel + 1 > last ? near.panel + 1 : last;
  }
  return piece(s, first, last);
}

/* Near the surface on the other side of air: what meets that soon is left to do so. */
static bool lands(const struct bem_sides *w, const struct bem_surface *s, const struct bem_piece *p,
                  double reach) {
  struct bem_near near;
  for (size_t k = p->first; k <= p->last; k++)
    if (bem_sides_across(w, s, s->state, k, BEM_AIR, reach, &near)) return true;
  return false;
}

bool bem_cuts_find_sheet(const struct bem_sides *w, const struct bem_surface *s, double coarse,
                         struct bem_piece *p) {
  for (size_t k = 2; k + 3 < s->n; k++) {
    struct bem_near near;
    const double panel = 0.5 * (w->arc[k + 1] - w->arc[k - 1]);
    const double thin = coarse * fmax(panel, s->film);
    if (!bem_sides_across(w, s, s->state, k, BEM_WATER, thin, &near) || near.panel <= k + 1)
      continue;
    *p = open_piece(w, s, near, OPEN * thin);
    const double area = piece_area(s, p->first, p->last);
    if (p->last + 2 >= s->n || !is_little(s, area)) continue;
    if (coarse > 1 || !lands(w, s, p, OPEN * thin)) return true;
  }
  return false;
}

bool bem_cuts_find_loop(const struct bem_sides *w, const struct bem_surface *s,
                        struct bem_piece *p) {
  struct bem_crossing c;
  for (size_t from = 0; bem_sides_cross(w, s, s->state, from, &c); from = c.first + 1) {
    if (c.last + 1 >= s->n || c.last < c.first + 2) continue;
    if (c.area > 0 ? !is_little(s, c.area) : c.last - c.first > BEM_BUBBLE) continue;
    *p = (struct bem_piece){c.first, c.last + 1, c.x, c.y};
    return true;
  }
  return false;
}

struct bem_piece bem_cuts_find_wrinkle(const struct bem_flow *f) {
  const struct bem_surface *s = &f->surface;
  double most = -1;
  size_t at = 1;
  for (size_t k = 1; k + 1 < s->n; k++) {
    const double strain =
        hypot(f->u[k + 1] - f->u[k], f->v[k + 1] - f->v[k]) / cabs(node(s, k + 1) - node(s, k));
    if (strain > most) most = strain, at = k;
  }
  const size_t first = at > AROUND ? at - AROUND : 0;
  const size_t last = at + AROUND < s->n - 1 ? at + AROUND : s->n - 1;
  struct bem_piece p = piece(s, at, at);
  p.first = first;
  p.last = last;
  return p;
}

/* ---- cutting ---- */

/* The nodes of a sheet whose polynomial gives the potential on its end. */
static void choose_carriers(const struct bem_surface *s, const struct bem_piece *p, double wide,
                            size_t carrier[BEM_CARRIERS]) {
  size_t a = p->first + 1, b = p->last - 1;
  while (a + 2 < b && cabs(node(s, a) - node(s, p->first)) < wide) a++;
  while (a + 1 < b - 1 && cabs(node(s, b) - node(s, p->last)) < wide) b--;
  carrier[0] = p->first;
  carrier[1] = a;
  carrier[2] = b;
  carrier[3] = p->last;
}

static double within(const struct bem_flow *f, const struct bem_piece *p, double phi) {
  const double *at = f->surface.state + 2 * f->surface.n;
  double least = at[p->first], most = least;
  for (size_t k = p->first; k <= p->last; k++) {
    least = fmin(least, at[k]);
    most = fmax(most, at[k]);
  }
  return fmin(fmax(phi, least), most);
}

enum status bem_cuts_sheet(struct bem_flow *f, const struct bem_piece *p) {
  const struct bem_surface *s = &f->surface;
  if (p->last < p->first + 4) return bem_cuts_loop(f, p);
  const double complex a = node(s, p->first), b = node(s, p->last), middle = 0.5 * (a + b);
  const double wide = cabs(b - a);
  double complex way =
      node(s, p->first + 1) - node(s, p->first - 1) - (node(s, p->last + 1) - node(s, p->last - 1));
  double point[CAP][BEM_FIELDS];
  size_t carrier[BEM_CARRIERS];
  way *= wide / cabs(way);
  choose_carriers(s, p, wide, carrier);
  for (int i = 0; i < CAP; i++) { /* half an ellipse, twice as long as wide */
    const double angle = M_PI * (i + 1) / (CAP + 1);
    const double complex z = middle + (a - middle) * cos(angle) + way * sin(angle);
    point[i][0] = creal(z);
    point[i][1] = cimag(z);
    point[i][2] = within(f, p, bem_replace_potential(f, carrier, z));
  }
  return bem_replace(f, p->first + 1, p->last, CAP, point);
}

enum status bem_cuts_loop(struct bem_flow *f, const struct bem_piece *p) {
  return bem_replace(f, p->first + 1, p->last, 0, NULL);
}

enum status bem_cuts_wrinkle(struct bem_flow *f, const struct bem_piece *p) {
  struct bem_surface *s = &f->surface;
  for (int pass = 0; pass < PASSES; pass++)
    for (size_t field = 0; field < BEM_FIELDS; field++) {
      double *g = s->state + field * s->n;
      double before[2] = {g[p->first], g[p->first + 1]};
      for (size_t k = p->first + 2; k + 2 <= p->last; k++) {
        const double is = g[k];
        g[k] = (-before[0] + 4 * before[1] + 10 * is + 4 * g[k + 1] - g[k + 2]) / 16;
        before[0] = before[1];
        before[1] = is;
      }
    }
  return bem_mesh_regrid(&f->mesh, s);
}
