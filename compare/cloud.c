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

double cmp_cloud_spacing(const struct cmp_data *d, size_t n) {
  const struct cmp_series *volume = &d->volume;
  const double area = (double)n * d->dx * d->dx;
  if (!n) return 0;
  if (!(volume->n && fabs(area / volume->value[0] - 1) > 0.5)) return d->dx;
  return cmp_cloud_has_field(d->file, "volume") ? sqrt(volume->value[0] / (double)n) : 0;
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
static void values_scale(struct result_cloud *points, bool vector, double unit) {
  for (size_t i = 0; i < points->n; i++)
    points->value[i] =
        (vector ? hypot(points->value[2 * i], points->value[2 * i + 1]) : points->value[i]) / unit;
}

/* Sorts the values of `points`, which are done with then. */
static struct cmp_cloud cloud_of(struct result_cloud *points, double spacing) {
  const size_t n = points->n;
  if (!(spacing > 0)) return (struct cmp_cloud){0};
  qsort(points->value, n, sizeof *points->value, array_ascending);
  return (struct cmp_cloud){n, points->value[n / 100], points->value[n - 1 - n / 100], spacing};
}

static enum status table_write(const struct comparison *c, size_t r, enum cmp_field field,
                               struct cmp_figures *f, const struct cmp_figure *fig,
                               const struct result_cloud *points) {
  FILE *data;
  char suffix[48];
  snprintf(suffix, sizeof suffix, "-particles-%zu.csv", r + 1);
  TRY(cmp_figure_data(f, fig, suffix, &data));
  fprintf(data, "x [H],y [H],%s\n", cmp_fields[field].head);
  for (size_t i = 0; i < points->n; i++)
    fprintf(data, "%.6g,%.6g,%.5g\n", points->p[i][0] / c->scales.H, points->p[i][1] / c->scales.H,
            points->value[i]);
  return cmp_figure_data_end(fig, data);
}

static enum status points_read(const struct result_file *file, enum cmp_field field, size_t n,
                               const size_t *output, struct result_cloud *points) {
  const struct cmp_field_about *about = &cmp_fields[field];
  return (about->vector ? result_read_vectors : result_read_points)(file->path, about->stored, n,
                                                                    output, points);
}

/* At n comparison times; `figure` NULL: nothing is written, else as above, by time. */
static enum status clouds_take(const struct comparison *c, size_t r, enum cmp_field field, size_t n,
                               const size_t *time, struct cmp_figures *f, const size_t *figure,
                               struct cmp_cloud *cloud) {
  const struct cmp_run *run = &c->run[r];
  size_t found = 0, *output = NULL, *index = NULL;
  struct result_cloud *points = NULL;
  enum status status = OK;
  ATTEMPT(array_create(&output, n, "pictures"));
  ATTEMPT(array_create(&index, n, "pictures"));
  ATTEMPT(array_create(&points, n, "pictures"));
  for (size_t i = 0; i < n; i++) {
    const size_t at = cmp_cloud_output(c, run->data.file, run->at[time[i]].t);
    cloud[i] = (struct cmp_cloud){0};
    if (at == SIZE_MAX) continue;
    output[found] = at;
    index[found++] = i;
  }
  if (points_read(run->data.file, field, found, output, points) != OK)
    found = 0; /* a solver without such points */
  for (size_t k = 0; k < found && status == OK; k++) {
    const size_t i = index[k];
    const double spacing = cmp_cloud_spacing(&run->data, points[k].n);
    values_scale(&points[k], cmp_fields[field].vector, unit_of(c, run, field));
    if (figure && spacing > 0)
      status = table_write(c, r, field, f, &f->figure[figure[time[i]]], &points[k]);
    cloud[i] = cloud_of(&points[k], spacing);
  }
done:
  for (size_t k = 0; points && k < n; k++) result_cloud_free(&points[k]);
  free(points);
  free(index);
  free(output);
  return status;
}

enum status cmp_clouds_look(const struct comparison *c, size_t r, enum cmp_field field, size_t n,
                            const size_t *time, struct cmp_cloud *cloud) {
  return clouds_take(c, r, field, n, time, NULL, NULL, cloud);
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
  ATTEMPT(clouds_take(c, r, field, n, time, f, figure, own));
  for (size_t i = 0; i < n; i++) cloud[time[i]] = own[i];
done:
  free(time);
  free(own);
  return status;
}
