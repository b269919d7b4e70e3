/* A surface that may hang over, as a jet does: points of it from a file, at rest or with the
 * potential there or the velocity, along which the potential is found. */
#include <math.h>
#include <stdlib.h>

#include "common/base/geometry_check.h"
#include "common/case/case.h"
#include "common/case/case_draft.h"
#include "common/flow/cauchy.h"
#include "common/flow/edges.h"
#include "common/flow/flow.h"
#include "common/flow/line.h"

static const double SAME_ENDS = 1e-6; /* of the depth: a period ends as it begins */
static const double MOST_GAP = 10;    /* over both gaps beside it: beyond it a row is missing */
enum { PARTS = 4 };                   /* of the way between two rows, to measure */

struct form {
  double depth; /* m */
  char *file;
  struct flow_line line; /* no rows: level, at rest */
  double mean, high;     /* of the height over the water at rest in the tank, m */
  double length;         /* of a cosine with as much slope for its height, m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "of the water at rest"),
    TEXT(struct form, file, 1000, NULL,
         "lines 'x, y' in m of water at rest, 'x, y, phi' with the potential there (m^2/s), or 'x, "
         "y, u, v' with the velocity (m/s), along the surface from the left side to the right one; "
         "relative to the case; cubic splines go through them"),
};

/* ---- reading ---- */

static double gap_behind(const struct case_rows *r, size_t k) {
  return hypot(r->x[k + 1] - r->x[k], r->y[k + 1] - r->y[k]);
}

/* Panels are as unequal as a surface wants them, but not at once. */
static bool is_hole(const struct case_rows *r, size_t k) {
  double beside = 0;
  if (k > 0) beside = gap_behind(r, k - 1);
  if (k + 2 < r->n) beside = fmax(beside, gap_behind(r, k + 1));
  return gap_behind(r, k) > MOST_GAP * beside;
}

static bool check_rows(struct case_draft *d, const struct case_rows *r) {
  char found[160];
  if (r->n < TANK_LEAST_ROWS) {
    snprintf(found, sizeof found, "%zu row%s", r->n, r->n == 1 ? "" : "s");
    case_flow_problem(d, "file", found, "at least 4 rows 'x, y'", "add rows");
    return false;
  }
  for (size_t k = 0; k + 1 < r->n; k++)
    if (!(gap_behind(r, k) > 0)) {
      snprintf(found, sizeof found, "the point (%.6g, %.6g) m twice in a row", r->x[k], r->y[k]);
      case_flow_problem(d, "file", found, "points that differ", "remove one");
      return false;
    }
  for (size_t k = 0; k + 1 < r->n; k++)
    if (is_hole(r, k)) {
      snprintf(found, sizeof found, "a hole from (%.6g, %.6g) to (%.6g, %.6g) m", r->x[k], r->y[k],
               r->x[k + 1], r->y[k + 1]);
      case_flow_problem(d, "file", found, "rows at most 10 times as far apart as those beside them",
                        "add the rows that are missing");
      return false;
    }
  return true;
}

/* Simpson's rule between the rows. */
static void measure(const struct case_file *c, struct form *f) {
  const double rest = c->tank.min[1] + f->depth, width = c->tank.max[0] - c->tank.min[0];
  const struct flow_line *l = &f->line;
  double area = 0, square = 0, slope = 0;
  f->high = -INFINITY;
  const size_t n = (l->x.n - 1) / (c->periodic[0] ? 3 : 1), first = c->periodic[0] ? n : 0;
  for (size_t i = first; i < first + n; i++) { /* of the three periods that the line has, one */
    const double a = l->x.t[i], step = (l->x.t[i + 1] - a) / PARTS;
    for (int k = 0; k <= PARTS; k++) {
      const struct flow_line_point at = flow_line_at(l, a + k * step);
      const double weight = step / 3 * (k == 0 || k == PARTS ? 1 : k % 2 ? 4 : 2);
      const double eta = at.p[1] - rest;
      area += weight * eta * at.slope[0];
      square += weight * eta * eta;
      slope += weight * at.slope[1] * at.slope[1];
      f->high = fmax(f->high, eta);
    }
  }
  f->mean = area / width;
  f->length = slope > 0 ? fmin(2 * M_PI * sqrt(square / slope), width) : width;
  if (!(f->length > 0)) f->length = width;
}

/* One period, wherever it begins. */
static enum status take(struct case_draft *d, const struct case_rows *r) {
  const struct case_file *c = d->c;
  struct form *f = d->c->form;
  const struct flow_rows all = {r->n, r->x, r->y, r->z, r->w};
  const double width = c->tank.max[0] - c->tank.min[0], gain = r->x[r->n - 1] - r->x[0];
  char found[128], allowed[96];
  if (c->periodic[0] && fabs(gain - width) > case_near(c)) {
    snprintf(found, sizeof found, "rows from x = %.6g to %.6g m", r->x[0], r->x[r->n - 1]);
    snprintf(allowed, sizeof allowed, "one period, %.6g m", width);
    case_flow_problem(d, "file", found, allowed, "write one period, its ends alike");
    return OK;
  }
  TRY(flow_line_create(&all, c->periodic[0], &f->line));
  if (c->periodic[0] && !flow_line_turn(&f->line, c->tank.min[0], width))
    case_flow_problem(d, "file", "a surface that passes the periodic sides more than once",
                      "one that passes them once", "move the waves along the tank");
  measure(c, f);
  return OK;
}

static enum status read_surface(struct case_draft *d, int node) {
  static const char *const path = "water.wave.file";
  static const struct case_columns columns = {
      "x, y", 4, {1, 1, 1, 1}, CASE_ROWS_ANY, "points of a surface", "m"};
  struct form *f = d->c->form;
  const size_t faults = d->doc.faults;
  struct case_rows r;
  enum status status =
      case_read_rows(d, f->file, case_doc_member_line(&d->doc, node, "file"), path, &columns, &r);
  if (status == OK && d->doc.faults == faults && check_rows(d, &r)) status = take(d, &r);
  case_rows_destroy(&r);
  return status;
}

static void release(void *form) {
  struct form *f = form;
  flow_line_destroy(&f->line);
}

static void write_rows(FILE *out, const void *form) {
  const struct form *f = form;
  const struct flow_line *l = &f->line;
  fputs("surface", out);
  for (size_t i = 0; i < l->x.n; i++) {
    fprintf(out, " %.12g %.12g", l->x.q[i] + 0.0, l->y.q[i] + 0.0);
    if (l->phi.n) fprintf(out, " %.12g", l->phi.q[i] + 0.0);
  }
  fputc('\n', out);
}

/* ---- checks ---- */

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  const double width = c->tank.max[0] - c->tank.min[0];
  if (!f->line.x.n) return (struct flow_scale){f->depth, f->depth, 0, width};
  return (struct flow_scale){f->depth, f->depth + f->mean, fmax(f->high, 0), f->length};
}

static const struct flow_line *line(const struct case_file *c) {
  const struct form *f = c->form;
  return f->line.x.n ? &f->line : NULL;
}

static bool check_ends(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const struct flow_line *l = &f->line;
  struct flow_edges e;
  char found[160];
  const char *problem = flow_line_edges(&c->walls, l, case_near(c), &e);
  if (!problem) return true;
  const struct flow_line_point a = flow_line_at(l, l->from), b = flow_line_at(l, l->to);
  snprintf(found, sizeof found, "%s, from (%.6g, %.6g) to (%.6g, %.6g) m", problem, a.p[0], a.p[1],
           b.p[0], b.p[1]);
  case_flow_problem(d, "file", found, "a surface from the left side to the right one",
                    "correct the ends or the order of the rows");
  return false;
}

static bool check_period(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const struct flow_line *l = &f->line;
  const struct tank_record *all[] = {&l->y, &l->phi};
  const char *const name[] = {"y", "phi"};
  const double near[] = {SAME_ENDS * f->depth, SAME_ENDS * f->depth * sqrt(c->g * f->depth)};
  const size_t m = (l->x.n - 1) / 3; /* rows of a period; the last has a value of its own */
  char found[128];
  for (int i = 0; i < 2; i++) {
    if (!all[i]->n || fabs(all[i]->q[3 * m] - all[i]->q[m]) <= near[i]) continue;
    snprintf(found, sizeof found, "%s that is %.6g at the left side and %.6g at the right one",
             name[i], all[i]->q[m], all[i]->q[3 * m]);
    case_flow_problem(d, "file", found, "one period, its ends alike",
                      "correct the file, or write tank.sides: walls");
    return false;
  }
  return true;
}

/* The outline of the water, between the tank's walls and the surface. */
static void check_outline(const struct case_file *c, struct case_draft *d) {
  bool simple = false;
  double at[2] = {0}, area = 0;
  char found[160];
  enum status status = geo_piece_simple(&c->water, 0, true, &simple, at);
  if (status == OK && !simple) {
    snprintf(found, sizeof found, "a surface that meets itself or a wall at (%.6g, %.6g) m", at[0],
             at[1]);
    case_flow_problem(d, "file", found, "one line that meets the walls at its ends alone",
                      "correct its points or their order");
    return;
  }
  if (status == OK && geo_piece_area(&c->water, 0) <= 0) {
    case_flow_problem(d, "file", "a surface without water below it", "a surface above the bed",
                      "correct the file");
    return;
  }
  if (status == OK) status = geo_piece_outside(&c->water, 0, &c->walls, &area, at);
  if (status != OK)
    d->doc.problems->out_of_memory = true;
  else if (area > CASE_SAME * geo_piece_area(&c->water, 0)) {
    snprintf(found, sizeof found, "water outside the tank, at (%.6g, %.6g) m for one", at[0],
             at[1]);
    case_flow_problem(d, "file", found, "a surface inside tank.walls",
                      "correct the file, or make the walls higher");
  }
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  if (!f->line.x.n || !d->good.tank || c->walls.pieces != 1 || c->walls.closed[0]) return;
  if (!(c->periodic[0] ? check_period(c, d) : check_ends(c, d))) return;
  if (c->water.pieces == 1) check_outline(c, d);
}

/* ---- the water ---- */

static enum status create(struct flow_water *w) {
  const struct flow_line *l = line(w->c);
  struct flow_cauchy *in;
  if (!l || !(w->use.spacing > 0)) return OK;
  TRY(flow_cauchy_create(w->c, l, w->use.spacing / 2, &in));
  w->own = in;
  return OK;
}

static void destroy(struct flow_water *w) {
  flow_cauchy_destroy(w->own);
}

static double elevation(const struct flow_water *w, double x, double t) {
  const struct form *f = w->c->form;
  (void)t;
  return f->line.x.n ? flow_line_top(&f->line, x) : w->c->tank.min[1] + f->depth;
}

static struct flow_inside inside(const struct flow_water *w, double x, double y) {
  return w->own ? flow_cauchy_at(w->own, x, y) : (struct flow_inside){0};
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  (void)t;
  const struct flow_inside at = inside(w, x, y);
  out[0] = at.velocity[0];
  out[1] = at.velocity[1];
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  (void)t;
  return inside(w, x, y).phi;
}

/* Of the instant after all that held the water, as in any flow that goes on by itself. */
static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  if (!w->own) {
    *out = elevation(w, p->x, 0) - p->y;
    return OK;
  }
  const struct flow_inside at = inside(w, p->x, p->y);
  const double square = at.velocity[0] * at.velocity[0] + at.velocity[1] * at.velocity[1];
  *out = at.is ? at.lift - p->y - square / (2 * w->c->g) : 0;
  return OK;
}

const struct flow flow_curve = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: curve, depth: 0.7, file: surface.csv}",
    .check = check,
    .read = read_surface,
    .release = release,
    .write = write_rows,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .elevation = elevation,
    .line = line,
    .potential = potential,
    .velocity = velocity,
    .head = head,
};
