#include "compare/cloud.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"

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

/* Sorts the pressures of `points`, which are done with then. */
static enum status cloud_write(const struct comparison *c, size_t r, struct cmp_figures *f,
                               const struct cmp_figure *fig, struct result_cloud *points,
                               struct cmp_cloud *cloud) {
  FILE *data;
  char suffix[48];
  const double spacing = cmp_cloud_spacing(&c->run[r].data, points->n);
  if (!(spacing > 0)) return OK;
  snprintf(suffix, sizeof suffix, "-particles-%zu.csv", r + 1);
  TRY(cmp_figure_data(f, fig, suffix, &data));
  fputs("x [H],y [H],pressure [rho g H]\n", data);
  for (size_t i = 0; i < points->n; i++)
    fprintf(data, "%.6g,%.6g,%.5g\n", points->p[i][0] / c->scales.H, points->p[i][1] / c->scales.H,
            points->value[i] / c->scales.p);
  qsort(points->value, points->n, sizeof *points->value, array_ascending);
  *cloud = (struct cmp_cloud){
      points->n, points->value[points->n - 1 - points->n / 100] / c->scales.p, spacing};
  return cmp_figure_data_end(fig, data);
}

enum status cmp_clouds_write(const struct comparison *c, size_t r, struct cmp_figures *f,
                             const size_t *figure, struct cmp_cloud *cloud) {
  const struct cmp_run *run = &c->run[r];
  size_t n = 0, *output = calloc(2 * c->n_times + 1, sizeof *output), *time = output + c->n_times;
  struct result_cloud *points = calloc(c->n_times + 1, sizeof *points);
  enum status status = OK;
  for (size_t k = 0; output && k < c->n_times; k++) {
    cloud[k] = (struct cmp_cloud){0};
    size_t at =
        figure[k] == SIZE_MAX ? SIZE_MAX : cmp_cloud_output(c, run->data.file, run->at[k].t);
    if (at == SIZE_MAX) continue;
    output[n] = at;
    time[n++] = k;
  }
  if (!output || !points)
    status = status_raise(ERR_MEMORY, "no memory for the pictures");
  else if (result_read_points(run->data.file->path, "pressure", n, output, points) != OK)
    n = 0; /* a solver without particles */
  for (size_t i = 0; i < n && status == OK; i++)
    status = cloud_write(c, r, f, &f->figure[figure[time[i]]], &points[i], &cloud[time[i]]);
  for (size_t i = 0; points && i < n; i++) result_cloud_free(&points[i]);
  free(points);
  free(output);
  return status;
}
