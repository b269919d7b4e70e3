/* A surface from a file: its height over x, and water at rest or the potential on it, or the
 * velocities there, along which the potential is found. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case.h"
#include "common/case/case_draft.h"
#include "common/flow/flow.h"
#include "common/flow/harmonic.h"
#include "common/flow/line.h"
#include "common/tank/motion.h"

enum { MOST_TERMS = 240 };            /* of the harmonic functions */
static const double SAME_ENDS = 1e-6; /* of the depth: a period ends as it begins */

struct form {
  double depth; /* m */
  char *file;
  struct tank_record eta, phi; /* over x: m, and m^2/s; no rows: level, at rest */
  double from, to;             /* x of the file's first and last row, m */
  double mean, high, low;      /* of eta in the tank, m */
  double length;               /* of a cosine with as much slope for its height, m */
};

static const struct param rows[] = {
    FLOW_LENGTH(struct form, depth, PARAM_ABOVE_0, "of the water at rest, above which eta counts"),
    TEXT(struct form, file, 1000, NULL,
         "lines 'x, eta' in m of water at rest, 'x, eta, phi' with the potential on the surface "
         "(m^2/s), or 'x, eta, u, v' with the velocity there (m/s), from side to side; relative to "
         "the case; a cubic spline goes through them"),
};

/* ---- reading ---- */

/* A period as it goes on at either side of itself, so that the spline knows no ends. */
static enum status repeat(size_t n, double **value, double step) {
  const size_t m = n - 1;
  const double *old = *value;
  double *all;
  TRY(array_create(&all, 3 * m + 1, "a surface"));
  for (size_t i = 0; i <= 3 * m; i++)
    all[i] = old[i < 3 * m ? i % m : m] + step * (i < 3 * m ? (double)(i / m) - 1 : 1);
  free(*value);
  *value = all;
  return OK;
}

static enum status copy(const double *from, size_t n, double **to) {
  TRY(array_create(to, n, "a surface"));
  memcpy(*to, from, n * sizeof **to);
  return OK;
}

/* Puts the potential in the place of the velocities. */
static enum status find_potential(const struct case_file *c, struct case_rows *r) {
  struct flow_way way = {0};
  struct tank_record *of[] = {&way.x, &way.y, &way.u, &way.v};
  const double *column[] = {r->x, r->y, r->z, r->w};
  enum status status = OK;
  for (int i = 0; i < 4; i++) {
    of[i]->n = r->n;
    ATTEMPT(copy(r->x, r->n, &of[i]->t));
    ATTEMPT(copy(column[i], r->n, &of[i]->q));
    ATTEMPT(tank_record_finish(of[i]));
  }
  flow_way_integrate(&way, c->periodic[0], r->z);
done:
  for (int i = 0; i < 4; i++) tank_record_destroy(of[i]);
  return status;
}

static enum status go_round(struct case_rows *r) {
  const size_t n = r->n;
  const double length = r->x[n - 1] - r->x[0];
  TRY(repeat(n, &r->x, length));
  TRY(repeat(n, &r->y, 0));
  if (r->z) TRY(repeat(n, &r->z, 0));
  r->n = 3 * (n - 1) + 1;
  return OK;
}

/* Simpson's rule between the rows: exact for the mean of the spline. */
static void measure(struct form *f, double left, double right) {
  double area = 0, square = 0, slope = 0, q[3];
  f->high = -INFINITY;
  f->low = INFINITY;
  for (size_t i = 0; i + 1 < f->eta.n; i++) {
    const double a = fmax(f->eta.t[i], left), b = fmin(f->eta.t[i + 1], right);
    for (int k = 0; k <= 2 && b > a; k++) {
      const double weight = (k == 1 ? 4 : 1) * (b - a) / 6;
      tank_record_at(&f->eta, a + (b - a) * k / 2, q);
      area += weight * q[0];
      square += weight * q[0] * q[0];
      slope += weight * q[1] * q[1];
      f->high = fmax(f->high, q[0]);
      f->low = fmin(f->low, q[0]);
    }
  }
  const double width = right - left;
  f->mean = area / width;
  const double spread = fmax(square - area * area / width, 0);
  f->length = slope > 0 ? fmin(2 * M_PI * sqrt(spread / slope), width) : width;
  if (!(f->length > 0)) f->length = width;
}

/* Takes the rows. */
static enum status take(const struct case_file *c, struct form *f, struct case_rows *r) {
  f->from = r->x[0];
  f->to = r->x[r->n - 1];
  if (r->w) TRY(find_potential(c, r));
  if (c->periodic[0]) TRY(go_round(r));
  f->eta = (struct tank_record){.n = r->n, .t = r->x, .q = r->y};
  r->x = r->y = NULL;
  TRY(tank_record_finish(&f->eta));
  measure(f, c->tank.min[0], c->tank.max[0]);
  if (!r->z) return OK;
  f->phi = (struct tank_record){.n = r->n, .q = r->z};
  r->z = NULL;
  TRY(array_create(&f->phi.t, r->n, "a surface"));
  memcpy(f->phi.t, f->eta.t, r->n * sizeof *f->phi.t);
  return tank_record_finish(&f->phi);
}

static enum status read_surface(struct case_draft *d, int node) {
  static const char *const path = "water.wave.file";
  static const struct case_columns columns = {
      "x, eta", 4, {1, 1, 1, 1}, CASE_ROWS_RISE, "places x that increase", "m"};
  struct form *f = d->c->form;
  const size_t faults = d->doc.faults;
  const int line = case_doc_member_line(&d->doc, node, "file");
  struct case_rows r;
  enum status status = case_read_rows(d, f->file, line, path, &columns, &r);
  if (status == OK && d->doc.faults == faults)
    status = case_check_rows(d, f->file, line, path, &columns, &r);
  if (status == OK && d->doc.faults == faults) status = take(d->c, f, &r);
  case_rows_destroy(&r);
  return status;
}

static void release(void *form) {
  struct form *f = form;
  tank_record_destroy(&f->eta);
  tank_record_destroy(&f->phi);
}

static void write_rows(FILE *out, const void *form) {
  const struct form *f = form;
  fputs("surface", out);
  for (size_t i = 0; i < f->eta.n; i++) {
    fprintf(out, " %.12g %.12g", f->eta.t[i] + 0.0, f->eta.q[i] + 0.0);
    if (f->phi.n) fprintf(out, " %.12g", f->phi.q[i] + 0.0);
  }
  fputc('\n', out);
}

/* ---- checks ---- */

static struct flow_scale scale(const struct case_file *c) {
  const struct form *f = c->form;
  const double width = c->tank.max[0] - c->tank.min[0];
  if (!f->eta.n) return (struct flow_scale){f->depth, f->depth, 0, width};
  return (struct flow_scale){f->depth, f->depth + f->mean, fmax(f->high, 0), f->length};
}

static void check_cover(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  const double left = c->tank.min[0], right = c->tank.max[0], near = case_near(c);
  const bool round = c->periodic[0];
  const double over[] = {left - f->from, f->to - right}; /* what there is beyond the tank */
  char found[96], allowed[96];
  if (fmin(over[0], over[1]) >= -near && (!round || fmax(over[0], over[1]) <= near)) return;
  snprintf(found, sizeof found, "rows from x = %.6g to %.6g m", f->from, f->to);
  snprintf(allowed, sizeof allowed, "%s, from %.6g to %.6g m",
           round ? "one period" : "rows that cover the tank", left, right);
  case_flow_problem(d, "file", found, allowed,
                    round ? "write one period, its ends alike" : "add the rows that are missing");
}

static void check_ends(const struct case_file *c, struct case_draft *d, const struct tank_record *r,
                       const char *name, double near) {
  char found[128];
  const size_t m = (r->n - 1) / 3; /* rows of a period; the last has a value of its own */
  if (!c->periodic[0] || !r->n || fabs(r->q[3 * m] - r->q[m]) <= near) return;
  snprintf(found, sizeof found, "%s that is %.6g at the left side and %.6g at the right one", name,
           r->q[m], r->q[3 * m]);
  case_flow_problem(d, "file", found, "one period, its ends alike",
                    "correct the file, or write tank.sides: walls");
}

static void check(const struct case_file *c, struct case_draft *d) {
  const struct form *f = c->form;
  char found[96], allowed[96];
  if (!f->eta.n) return;
  check_cover(c, d);
  check_ends(c, d, &f->eta, "eta", SAME_ENDS * f->depth);
  check_ends(c, d, &f->phi, "phi", SAME_ENDS * f->depth * sqrt(c->g * f->depth));
  if (c->rectangular && f->low <= -f->depth) {
    snprintf(found, sizeof found, "a trough %.6g m below the water at rest", -f->low);
    snprintf(allowed, sizeof allowed, "a surface above the bed, %.6g m below it", f->depth);
    case_flow_problem(d, "file", found, allowed, "correct the file or the depth");
  }
}

/* ---- the water ---- */

struct inside { /* what there is below the surface */
  struct flow_harmonic *phi;
  struct flow_harmonic *lift; /* p/(rho g) + y + |u|^2/2g, m: minus the rate of phi, over g */
};

static void destroy(struct flow_water *w) {
  struct inside *in = w->own;
  if (!in) return;
  flow_harmonic_destroy(in->phi);
  flow_harmonic_destroy(in->lift);
  free(in);
}

static double elevation(const struct flow_water *w, double x, double t) {
  (void)t;
  const struct form *f = w->c->form;
  double q[3] = {0};
  if (f->eta.n) tank_record_at(&f->eta, x, q);
  return w->c->tank.min[1] + f->depth + q[0];
}

static void velocity(const struct flow_water *w, double x, double y, double t, double out[2]) {
  (void)t;
  const struct inside *in = w->own;
  out[0] = out[1] = 0;
  if (in && in->phi) flow_harmonic_at(in->phi, x, y, out);
}

static double potential(const struct flow_water *w, double x, double y, double t) {
  (void)t;
  const struct inside *in = w->own;
  const struct form *f = w->c->form;
  double q[3] = {0};
  if (in && in->phi) return flow_harmonic_at(in->phi, x, y, NULL);
  if (f->phi.n) tank_record_at(&f->phi, x, q);
  return q[0];
}

/* In other tanks than rectangular ones no cosines go along the walls. */
static bool on_surface_alone(const struct case_file *c) {
  const struct form *f = c->form;
  return !c->rectangular && f->phi.n > 0;
}

static double dynamic_head(const struct flow_water *w, double x, double y) {
  double u[2];
  velocity(w, x, y, 0, u);
  return (u[0] * u[0] + u[1] * u[1]) / (2 * w->c->g);
}

/* As many terms as the rows of a tank can tell apart. */
static size_t count_terms(const struct case_file *c) {
  const struct form *f = c->form;
  const size_t rows_of_tank = c->periodic[0] ? (f->eta.n - 1) / 6 : f->eta.n - 1;
  return rows_of_tank < MOST_TERMS ? rows_of_tank : MOST_TERMS;
}

/* Fits phi, and then lift, to what they are on the surface. */
static enum status fit(const struct flow_water *w, size_t terms, size_t n,
                       struct flow_harmonic_value *at, struct inside *in) {
  const struct form *f = w->c->form;
  const double left = w->c->tank.min[0], width = w->c->tank.max[0] - left;
  for (size_t i = 0; i < n; i++) {
    double q[3] = {0};
    const double x = left + width * ((double)i + 0.5) / (double)n;
    if (f->phi.n) tank_record_at(&f->phi, x, q);
    at[i] = (struct flow_harmonic_value){x, elevation(w, x, 0), q[0]};
  }
  if (f->phi.n) TRY(flow_harmonic_create(w->c, terms, n, at, &in->phi));
  if (!(w->use.spacing > 0)) return OK;
  for (size_t i = 0; i < n; i++) at[i].value = at[i].y + dynamic_head(w, at[i].x, at[i].y);
  return flow_harmonic_create(w->c, terms, n, at, &in->lift);
}

static enum status create(struct flow_water *w) {
  const struct form *f = w->c->form;
  if (!f->eta.n || !w->c->rectangular) return OK;
  const size_t terms = count_terms(w->c), n = 4 * (1 + (w->c->periodic[0] ? 2 : 1) * terms);
  struct inside *in;
  struct flow_harmonic_value *at;
  TRY(array_create(&in, 1, "a surface"));
  *in = (struct inside){0};
  w->own = in;
  TRY(array_create(&at, n, "points of the surface"));
  const enum status status = fit(w, terms, n, at, in);
  free(at);
  return status;
}

static enum status head(const struct flow_water *w, const struct flow_point *p, double *out) {
  const struct inside *in = w->own;
  const double top = elevation(w, p->x, 0);
  *out = top - p->y;
  if (in && in->lift && p->y < top)
    *out = flow_harmonic_at(in->lift, p->x, p->y, NULL) - p->y - dynamic_head(w, p->x, p->y);
  return OK;
}

const struct flow flow_file = {
    .params = rows,
    .n_params = sizeof rows / sizeof *rows,
    .params_size = sizeof(struct form),
    .example = "wave: {kind: file, depth: 0.7, file: surface.csv}",
    .check = check,
    .read = read_surface,
    .release = release,
    .write = write_rows,
    .create = create,
    .destroy = destroy,
    .scale = scale,
    .elevation = elevation,
    .on_surface_alone = on_surface_alone,
    .potential = potential,
    .velocity = velocity,
    .head = head,
};
