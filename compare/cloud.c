#include "compare/cloud.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

const struct cmp_field_about cmp_fields[CMP_FIELDS] = {
#define X(name, stored, vector, head, label) {#name, stored, vector, head, label},
    CMP_FIELD_LIST(X)
#undef X
};

size_t cmp_cloud_output(const struct comparison *c, const struct result_file *f, double t) {
  for (size_t i = 0; i < f->n_outputs; i++)
    if (fabs(f->output_time[i] / c->scales.T - t) < 1e-6) return i;
  return SIZE_MAX;
}

bool cmp_cloud_has_field(const struct result_file *f, const char *name) {
  for (size_t i = 0; i < f->n_fields; i++)
    if (!strcmp(f->fields[i], name)) return true;
  return false;
}

double cmp_cloud_spacing(const struct result_file *f, size_t n) {
  const double area = (double)n * f->spacing * f->spacing;
  if (!n) return 0;
  if (!f->n_steps) return f->spacing;
  const double volume = f->steps[0].volume + f->steps[0].removed_volume;
  if (!(fabs(area / volume - 1) > 0.5)) return f->spacing;
  return cmp_cloud_has_field(f, "volume") ? sqrt(volume / (double)n) : 0;
}

static double unit_of(const struct comparison *c, const struct cmp_run *run, enum cmp_field field) {
  switch (field) {
  case CMP_FIELD_pressure:
    return c->scales.p;
  case CMP_FIELD_speed:
    return c->scales.H / c->scales.T;
  case CMP_FIELD_density:
    return run->data.file->density;
  case CMP_FIELDS:
    break;
  }
  return 1;
}

/* Vectors become their lengths; all become dimensionless. */
static void values_scale(const struct result_water *w, bool vector, double unit) {
  double *v = w->value[0];
  for (size_t i = 0; i < w->n; i++) v[i] = (vector ? hypot(v[2 * i], v[2 * i + 1]) : v[i]) / unit;
}

/* Sorts the values of the points, which are done with then. */
static struct cmp_cloud cloud_of(const struct result_water *w, double spacing) {
  const size_t n = w->n;
  double *v = w->value[0];
  if (!(spacing > 0)) return (struct cmp_cloud){0};
  qsort(v, n, sizeof *v, array_ascending);
  return (struct cmp_cloud){n, v[n / 100], v[n - 1 - n / 100], spacing};
}

struct taking { /* the points of a run, output by output */
  const struct comparison *c;
  size_t r;
  enum cmp_field field;
  const size_t *time, *index; /* of the clouds; which of them an output is */
  struct cmp_figures *f;
  const size_t *figure; /* NULL: nothing is written, else by time */
  struct cmp_cloud *cloud;
};

static enum status table_write(const struct taking *t, const struct cmp_figure *fig,
                               const struct result_water *w) {
  FILE *data;
  char suffix[48];
  const double H = t->c->scales.H;
  snprintf(suffix, sizeof suffix, "-particles-%zu.csv", t->r + 1);
  TRY(cmp_figure_data(t->f, fig, suffix, &data));
  fprintf(data, "x [H],y [H],%s\n", cmp_fields[t->field].head);
  for (size_t i = 0; i < w->n; i++)
    fprintf(data, "%.6g,%.6g,%.5g\n", w->p[i][0] / H, w->p[i][1] / H, w->value[0][i]);
  return cmp_figure_data_end(fig, data);
}

static enum status cloud_take(void *data, size_t k, struct result_water *w) {
  const struct taking *t = data;
  const struct cmp_run *run = &t->c->run[t->r];
  const size_t i = t->index[k];
  const double spacing = cmp_cloud_spacing(run->data.file, w->n) / t->c->scales.H;
  values_scale(w, cmp_fields[t->field].vector, unit_of(t->c, run, t->field));
  if (t->figure && spacing > 0) TRY(table_write(t, &t->f->figure[t->figure[t->time[i]]], w));
  t->cloud[i] = cloud_of(w, spacing);
  return OK;
}

static enum status clouds_take(const struct taking *t, size_t n) {
  const struct cmp_run *run = &t->c->run[t->r];
  const struct cmp_field_about *about = &cmp_fields[t->field];
  const struct result_wanted wanted = {about->stored, about->vector, false};
  size_t found = 0, *output = NULL, *index = NULL;
  enum status status = OK;
  for (size_t i = 0; i < n; i++) t->cloud[i] = (struct cmp_cloud){0};
  if (!cmp_cloud_has_field(run->data.file, about->stored)) return OK; /* no such points */
  ATTEMPT(array_create(&output, n, "pictures"));
  ATTEMPT(array_create(&index, n, "pictures"));
  for (size_t i = 0; i < n; i++) {
    output[found] = cmp_cloud_output(t->c, run->data.file, run->at[t->time[i]].t);
    if (output[found] != SIZE_MAX) index[found++] = i;
  }
  struct taking own = *t;
  own.index = index;
  if (found)
    status = result_stream(run->data.file->path, 1, &wanted, found, output, cloud_take, &own);
  if (status == ERR_INPUT) status = OK; /* what cannot be read has no picture */
done:
  free(index);
  free(output);
  return status;
}

enum status cmp_clouds_look(const struct comparison *c, size_t r, enum cmp_field field, size_t n,
                            const size_t *time, struct cmp_cloud *cloud) {
  return clouds_take(&(struct taking){.c = c, .r = r, .field = field, .time = time, .cloud = cloud},
                     n);
}

enum status cmp_clouds_write(const struct comparison *c, size_t r, enum cmp_field field,
                             struct cmp_figures *f, const size_t *figure, struct cmp_cloud *cloud) {
  size_t n = 0, *time = NULL;
  struct cmp_cloud *own = NULL;
  enum status status = OK;
  ATTEMPT(array_create(&time, c->n_times, "pictures"));
  ATTEMPT(array_create(&own, c->n_times, "pictures"));
  for (size_t k = 0; k < c->n_times; k++) {
    cloud[k] = (struct cmp_cloud){0};
    if (figure[k] != SIZE_MAX) time[n++] = k;
  }
  ATTEMPT(clouds_take(&(struct taking){c, r, field, time, NULL, f, figure, own}, n));
  for (size_t i = 0; i < n; i++) cloud[time[i]] = own[i];
done:
  free(time);
  free(own);
  return status;
}
