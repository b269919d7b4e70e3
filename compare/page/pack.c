/* The packed data of the page. Lengths in H, times in sqrt(H/g), as in report.json.
 *
 * runs: the reference and then the runs: {"label", "colour", "dashes", "named", "dx",
 * "surfaces": [{"t", "tip": [x, y] or null, "overhang", "pieces": [n], "closed": [0/1], "planes":
 * x, y}], "points": [{"t", "every", "fields": ["p", "u", "v", "rho"], "planes": x, y, fields}]}
 * charts: [{"section", "name", "title", "unit", "at": [x, y] of a sensor or null, "curves":
 * [{"run", "experiment": the other is null, "averaged_over" or "raw", "planes": t, value, error}]}]
 * walls, of the reference: {"pieces", "closed", "planes": x, y}
 * thinned: sentences about what of all this is not in the page.
 */
#include "compare/page/pack.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/cloud.h"
#include "compare/page/packing.h"

/* Characters of base64 that surfaces, particles and series may have together: with the figures the
 * page then stays below 10 MB. What a number of each costs, measured on dam breaks. */
static const double SURFACES_ROOM = 1.2e6, POINTS_ROOM = 3.3e6;
static const double CHARACTERS_SURFACE = 2.5, CHARACTERS_POINT = 5.6;
/* Positions of particles in steps of a fraction of their spacing, and fields as finely as a colour
 * can tell: what is below that does not get smaller by packing. */
static const uint16_t coarse[6] = {8191, 8191, 1023, 1023, 1023, 1023};

/* ---- which outputs there is room for ---- */

static bool is_compared(const struct comparison *c, double t) {
  for (size_t k = 0; k < c->n_times; k++)
    if (fabs(t - c->times[k]) < 1e-6) return true;
  return false;
}

/* Every so many outputs, those at comparison times, and the last. */
static bool is_packed(const struct comparison *c, size_t stride, size_t i, size_t n, double t) {
  return i % stride == 0 || i + 1 == n || is_compared(c, t);
}

static bool has_points(const struct cmp_run *run, size_t output) {
  const int64_t n = run->data.file->output_points[output];
  return n > 0 && cmp_cloud_spacing(run->data.file, (size_t)n) > 0;
}

static double surface_cost(const struct pack *p, size_t stride) {
  double cost = 0;
  for (size_t i = 0; i <= p->c->n_runs; i++) {
    const struct cmp_data *d = &cmp_packed_run(p, i)->data;
    for (size_t k = 0; k < d->n; k++)
      if (is_packed(p->c, stride, k, d->n, d->t[k]))
        cost += CHARACTERS_SURFACE * (double)d->surface[k].points;
  }
  return cost;
}

static double point_cost(const struct pack *p, size_t stride) {
  double cost = 0;
  for (size_t i = 0; i <= p->c->n_runs; i++) {
    const struct cmp_run *run = cmp_packed_run(p, i);
    const struct result_file *f = run->data.file;
    for (size_t k = 0; k < f->n_outputs; k++)
      if (has_points(run, k) &&
          is_packed(p->c, stride, k, f->n_outputs, f->output_time[k] / p->c->scales.T))
        cost += CHARACTERS_POINT * (double)f->output_points[k];
  }
  return cost;
}

static size_t stride_for(const struct pack *p, double (*cost)(const struct pack *p, size_t stride),
                         double room) {
  size_t stride = 1;
  while (stride < 16 && cost(p, stride) > room) stride++;
  return stride;
}

/* ---- surfaces ---- */

static enum status lines_pack(struct pack *p, const struct geo_lines *l, json_t *object) {
  enum status status = OK;
  double *x = NULL, *y = NULL;
  json_t *planes = NULL, *pieces = json_array(), *closed = json_array();
  cmp_json_set(&p->m, object, "pieces", pieces);
  cmp_json_set(&p->m, object, "closed", closed);
  for (size_t k = 0; k < l->pieces; k++) {
    cmp_json_add(&p->m, pieces, json_integer((json_int_t)(l->first[k + 1] - l->first[k])));
    cmp_json_add(&p->m, closed, json_integer(l->closed[k]));
  }
  ATTEMPT(array_create(&x, l->points, "a surface"));
  ATTEMPT(array_create(&y, l->points, "a surface"));
  for (size_t i = 0; i < l->points; i++) x[i] = l->p[i][0], y[i] = l->p[i][1];
  ATTEMPT(cmp_planes_pack(p->packer, l->points, 2, (const double *[]){x, y}, cmp_fine, &planes));
  cmp_json_set(&p->m, object, "planes", planes);
done:
  free(x);
  free(y);
  return status;
}

static enum status surfaces_pack(struct pack *p, const struct cmp_data *d, json_t *list) {
  for (size_t k = 0; k < d->n; k++) {
    if (!is_packed(p->c, p->surface_stride, k, d->n, d->t[k])) continue;
    json_t *object = json_object();
    cmp_json_add(&p->m, list, object);
    cmp_json_set(&p->m, object, "t", cmp_json_number(d->t[k]));
    cmp_json_set(&p->m, object, "tip",
                 d->jet[k].found ? cmp_json_point(&p->m, d->jet[k].tip) : json_null());
    cmp_json_set(&p->m, object, "overhang",
                 d->jet[k].found ? cmp_json_number(d->jet[k].overhang) : json_null());
    TRY(lines_pack(p, &d->surface[k], object));
  }
  return OK;
}

/* ---- particles ---- */

/* The cell of a lattice of 1024 times 1024 along a curve that keeps neighbours near each other
 * (Morton's): neighbours have like numbers, which take less room. */
struct sorted {
  uint32_t key, index;
};

static uint32_t spread(uint32_t v) {
  v = (v | v << 8) & 0x00ff00ff;
  v = (v | v << 4) & 0x0f0f0f0f;
  v = (v | v << 2) & 0x33333333;
  return (v | v << 1) & 0x55555555;
}

static int by_key(const void *a, const void *b) {
  const struct sorted *x = a, *y = b;
  return x->key != y->key ? (x->key > y->key) - (x->key < y->key)
                          : (x->index > y->index) - (x->index < y->index);
}

static void sort(size_t n, const double *x, const double *y, struct sorted *order) {
  double low[2] = {INFINITY, INFINITY}, high = 0;
  for (size_t i = 0; i < n; i++) low[0] = fmin(low[0], x[i]), low[1] = fmin(low[1], y[i]);
  for (size_t i = 0; i < n; i++) high = fmax(high, fmax(x[i] - low[0], y[i] - low[1]));
  for (size_t i = 0; i < n; i++) {
    const double scale = high > 0 ? 1023 / high : 0;
    order[i] = (struct sorted){spread((uint32_t)((x[i] - low[0]) * scale)) |
                                   spread((uint32_t)((y[i] - low[1]) * scale)) << 1,
                               (uint32_t)i};
  }
  qsort(order, n, sizeof *order, by_key);
}

enum { FIELDS = 4 };
static const char *const field_names[FIELDS] = {"p", "u", "v", "rho"};

enum { PRESSURE, VELOCITY, DENSITY, STORED };
static const struct result_wanted stored[STORED] = {[PRESSURE] = {"pressure", false, true},
                                                    [VELOCITY] = {"velocity", true, true},
                                                    [DENSITY] = {"density", false, true}};

/* Where a field of the page comes from. */
static size_t stored_of(size_t field) {
  return field == 0 ? PRESSURE : field == 3 ? DENSITY : VELOCITY;
}

/* The value of a field at a point, dimensionless; density over that of the case. */
static double value_of(const struct pack *p, const struct result_water *w, size_t field, size_t i,
                       double density) {
  const double speed = p->c->scales.H / p->c->scales.T;
  if (field == 0) return w->value[PRESSURE][i] / p->c->scales.p;
  if (field == 3) return w->value[DENSITY][i] / density;
  return w->value[VELOCITY][2 * i + field - 1] / speed;
}

static void box_join(struct geo_box *a, const struct geo_lines *l) {
  const struct geo_box b = geo_lines_box(l);
  for (int k = 0; k < 2 && l->points; k++) {
    a->min[k] = fmin(a->min[k], b.min[k]);
    a->max[k] = fmax(a->max[k], b.max[k]);
  }
}

/* The tank and the water as it begins, and as far again around them as they are large: what is
 * further away has escaped, and would take the steps of positions from all others. */
static struct geo_box reach_of(const struct comparison *c, const struct cmp_data *d) {
  struct geo_box box = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
  box_join(&box, &c->ref.data.walls);
  box_join(&box, &d->walls);
  if (d->n) box_join(&box, &d->surface[0]);
  if (!(box.min[0] <= box.max[0])) box = c->window;
  const double around = fmax(box.max[0] - box.min[0], box.max[1] - box.min[1]);
  for (int k = 0; k < 2; k++) box.min[k] -= around, box.max[k] += around;
  return box;
}

struct packing { /* the particles of a run */
  struct pack *p;
  const struct result_file *f;
  const size_t *output;
  json_t *list;
  struct geo_box reach;
  size_t escaped; /* at most, of an output */
};

/* Positions of those within reach that there is room for, and their indices; how many. */
static size_t positions_take(struct packing *q, const struct result_water *w, double *x, double *y,
                             size_t *kept) {
  const double H = q->p->c->scales.H;
  size_t n = 0, escaped = 0;
  for (size_t i = 0; i < w->n; i++) {
    const bool here = geo_box_contains(&q->reach, w->p[i][0] / H, w->p[i][1] / H);
    escaped += !here; /* also what has no position */
    if (!here || i % q->p->point_every) continue;
    x[n] = w->p[i][0] / H;
    y[n] = w->p[i][1] / H;
    kept[n++] = i;
  }
  if (escaped > q->escaped) q->escaped = escaped;
  return n;
}

static enum status cloud_pack(struct packing *q, const struct result_water *any, json_t *object) {
  enum status status = OK;
  struct pack *p = q->p;
  double *column[2 + FIELDS] = {NULL}, *moved = NULL;
  struct sorted *order = NULL;
  json_t *fields = json_array(), *planes = NULL;
  size_t *kept = NULL, columns = 2;
  cmp_json_set(&p->m, object, "fields", fields);
  if (!any->value[PRESSURE] && !any->value[VELOCITY] && !any->value[DENSITY]) return OK;
  for (size_t i = 0; i < 2 + FIELDS; i++) ATTEMPT(array_create(&column[i], any->n, "particles"));
  ATTEMPT(array_create(&order, any->n, "particles"));
  ATTEMPT(array_create(&moved, any->n, "particles"));
  ATTEMPT(array_create(&kept, any->n, "particles"));
  const size_t n = positions_take(q, any, column[0], column[1], kept);
  for (size_t field = 0; field < FIELDS; field++) {
    if (!any->value[stored_of(field)]) continue;
    for (size_t m = 0; m < n; m++)
      column[columns][m] = value_of(p, any, field, kept[m], q->f->density);
    cmp_json_add(&p->m, fields, json_string(field_names[field]));
    columns++;
  }
  sort(n, column[0], column[1], order);
  for (size_t i = 0; i < columns; i++) {
    for (size_t m = 0; m < n; m++) moved[m] = column[i][order[m].index];
    memcpy(column[i], moved, n * sizeof *moved);
  }
  ATTEMPT(cmp_planes_pack(p->packer, n, columns, (const double *const *)column, coarse, &planes));
  cmp_json_set(&p->m, object, "planes", planes);
done:
  for (size_t i = 0; i < 2 + FIELDS; i++) free(column[i]);
  free(order);
  free(moved);
  free(kept);
  return status;
}

static enum status water_take(void *data, size_t k, struct result_water *w) {
  struct packing *q = data;
  json_t *object = json_object();
  cmp_json_add(&q->p->m, q->list, object);
  cmp_json_set(&q->p->m, object, "t",
               cmp_json_number(q->f->output_time[q->output[k]] / q->p->c->scales.T));
  cmp_json_set(&q->p->m, object, "every", json_integer((json_int_t)q->p->point_every));
  return cloud_pack(q, w, object);
}

/* What is not in the page, and what cannot be read at all. */
static void particles_remark(struct packing *q, const char *label, enum status read) {
  if (read != OK) {
    fprintf(q->p->remarks, " Particles of %s are left out: %s.", label, status_message());
    json_array_clear(q->list);
  } else if (q->escaped) {
    fprintf(q->p->remarks,
            " Particles of %s without a position, or further from the tank than it is large, are "
            "left out: at most %zu of an output.",
            label, q->escaped);
  }
}

static enum status points_pack(struct pack *p, const struct cmp_run *run, json_t *list) {
  const struct result_file *f = run->data.file;
  size_t *output = NULL, n = 0;
  TRY(array_create(&output, f->n_outputs, "outputs"));
  for (size_t k = 0; k < f->n_outputs; k++)
    if (has_points(run, k) &&
        is_packed(p->c, p->point_stride, k, f->n_outputs, f->output_time[k] / p->c->scales.T))
      output[n++] = k;
  struct packing q = {p, f, output, list, reach_of(p->c, &run->data), 0};
  const enum status status =
      n ? result_stream(f->path, STORED, stored, n, output, water_take, &q) : OK;
  free(output);
  if (status != OK && status != ERR_INPUT) return status;
  particles_remark(&q, run->data.label, status);
  return OK;
}

/* ---- all of it ---- */

static enum status run_pack(struct pack *p, size_t i, json_t *runs) {
  const struct cmp_run *run = cmp_packed_run(p, i);
  const size_t r = i ? i - 1 : SIZE_MAX;
  const struct cmp_style style = cmp_run_style(p->c, r);
  json_t *object = json_object(), *surfaces = json_array(), *points = json_array();
  cmp_json_add(&p->m, runs, object);
  cmp_json_set(&p->m, object, "label", cmp_json_text(run->data.label));
  cmp_json_set(&p->m, object, "colour", json_string(style.colour));
  cmp_json_set(&p->m, object, "dashes", json_integer(style.dashes));
  cmp_json_set(&p->m, object, "named", json_boolean(!i || cmp_run_is_picked(p->c, r, CMP_NAMED)));
  cmp_json_set(&p->m, object, "dx", cmp_json_number(run->data.dx));
  cmp_json_set(&p->m, object, "surfaces", surfaces);
  cmp_json_set(&p->m, object, "points", points);
  if (json_is_true(json_object_get(object, "named"))) TRY(surfaces_pack(p, &run->data, surfaces));
  return points_pack(p, run, points);
}

static json_t *thinned_say(const struct pack *p, const char *remarks) {
  char *said, surfaces[96] = "of every output", points[160] = "of every output", every[64] = "";
  if (p->surface_stride > 1)
    snprintf(surfaces, sizeof surfaces, "of one in %zu outputs and of the comparison times",
             p->surface_stride);
  if (p->point_stride > 1)
    snprintf(points, sizeof points, "of one in %zu outputs and of the comparison times",
             p->point_stride);
  if (p->point_every > 1) snprintf(every, sizeof every, ", one in %zu of them", p->point_every);
  if (asprintf(
          &said,
          "In this page: surfaces %s; particles %s%s; of series longer than %d rows the lowest and "
          "highest value of each stretch (%zu series). Of the numbers of the drawing those of "
          "surfaces and series have 16 bits, places of particles 13 and their fields 10; tables "
          "have all that report.json has.%s",
          surfaces, points, every, CMP_SERIES_ROWS, p->rows_thinned, remarks) < 0)
    return NULL;
  json_t *value = cmp_json_text(said);
  free(said);
  return value;
}

enum status cmp_pack_create(const struct comparison *c, json_t **out) {
  enum status status = OK;
  char *remarks = NULL;
  size_t length;
  struct pack pack = {.c = c,
                      .packer = cmp_packer_create(),
                      .remarks = open_memstream(&remarks, &length),
                      .m = {true}},
              *p = &pack;
  json_t *root = json_object(), *runs = json_array(), *charts = json_array(),
         *walls = json_object();
  cmp_json_set(&p->m, root, "runs", runs);
  cmp_json_set(&p->m, root, "charts", charts);
  cmp_json_set(&p->m, root, "walls", walls);
  if (!p->packer || !p->remarks || !p->m.ok) {
    status = status_raise(ERR_MEMORY, "no memory for the data of the page");
    goto done;
  }
  p->surface_stride = stride_for(p, surface_cost, SURFACES_ROOM);
  p->point_stride = stride_for(p, point_cost, POINTS_ROOM);
  p->point_every = (size_t)fmax(1, ceil(point_cost(p, p->point_stride) / POINTS_ROOM));
  ATTEMPT(lines_pack(p, &c->ref.data.walls, walls));
  for (size_t i = 0; i <= c->n_runs; i++) ATTEMPT(run_pack(p, i, runs));
  ATTEMPT(cmp_charts_pack(p, charts));
  if (fflush(p->remarks) != 0) p->m.ok = false;
  cmp_json_set(&p->m, root, "thinned", thinned_say(p, remarks));
  if (!p->m.ok) status = status_raise(ERR_MEMORY, "no memory for the data of the page");
done:
  cmp_packer_destroy(p->packer);
  if (p->remarks) fclose(p->remarks);
  free(remarks);
  if (status != OK) {
    json_decref(root);
    root = NULL;
  }
  *out = root;
  return status;
}
