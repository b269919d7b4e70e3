#include "compare/spectra.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "compare/chart.h"
#include "compare/graph.h"
#include "compare/pick.h"
#include "compare/text.h"

/* Of bins closer than this, relative, the figure has the highest alone: nobody sees more of them on
 * its axis. */
#define CLOSE 1.002

enum { FREQUENCY, AMPLITUDE, PEAK, POWER, COLUMNS };

/* ---- rows ---- */

/* Of bins [from, to) one row: the place and height of the highest. */
static void row_of(const struct cmp_spectrum *s, size_t from, size_t to, double *row) {
  size_t top = from;
  for (size_t k = from; k < to; k++)
    if (s->amplitude[k] > s->amplitude[top]) top = k;
  row[FREQUENCY] = (double)top * s->step;
  row[AMPLITUDE] = s->amplitude[top];
  row[PEAK] = NAN;
  row[POWER] = s->power[top];
}

static enum status rows_of(const struct cmp_spectrum *s, size_t *n, double **out) {
  double *row = *out = malloc((s->n + s->n_peaks) * COLUMNS * sizeof *row);
  CHECK(row, ERR_MEMORY, "no memory for the figure of a spectrum of %zu bins", s->n);
  *n = 0;
  for (size_t k = 1, next; k < s->n; k = next) {
    next = (size_t)((double)k * CLOSE);
    next = next > k ? next : k + 1;
    row_of(s, k, next < s->n ? next : s->n, row + COLUMNS * (*n)++);
  }
  for (size_t k = 0; k < s->n_peaks; k++) {
    const double peak[COLUMNS] = {s->peak[k].frequency, NAN, s->peak[k].amplitude, NAN};
    memcpy(row + COLUMNS * (*n)++, peak, sizeof peak);
  }
  return OK;
}

/* ---- the figure ---- */

struct look { /* of a spectrum: what its graph borrows */
  char name[64], title[160], caption[512], amplitude[64], power[64], head[2][96];
  struct cmp_style style[CMP_NAMED + 1];
};

static const struct cmp_series *series_of(const struct comparison *c, const char *name) {
  for (size_t i = 0; i <= c->n_runs; i++) {
    const struct cmp_series *s =
        cmp_data_series(&cmp_run_or_ref(c, i ? i - 1 : SIZE_MAX)->data, name);
    if (s) return s;
  }
  return NULL;
}

static void look_make(const struct comparison *c, size_t k, struct look *l) {
  const char *name = c->settings->compare.spectra[k].series;
  const struct cmp_series *s = series_of(c, name);
  char slug[40];
  cmp_slug(name, slug, sizeof slug);
  snprintf(l->name, sizeof l->name, "spectrum-%zu-%s", k + 1, slug);
  if (isfinite(s->y))
    snprintf(l->title, sizeof l->title, "%.60s at (%.4g, %.4g) H", name, s->x, s->y);
  else
    snprintf(l->title, sizeof l->title, "%.60s at x = %.4g H", name, s->x);
  snprintf(l->caption, sizeof l->caption,
           "Spectrum of %.60s%s by a Hann window: amplitude of a sine at each frequency, its peaks "
           "as symbols, and power density, whose integral is the mean square.",
           name, s->average > 0 ? ", as it is without its average," : "");
  const bool one = !strchr(s->label, ' ');
  snprintf(l->amplitude, sizeof l->amplitude, one ? "amplitude / %s" : "amplitude / (%s)",
           s->label);
  snprintf(l->power, sizeof l->power, one ? "power / (%s² √(H/g))" : "power / ((%s)² √(H/g))",
           s->label);
  snprintf(l->head[0], sizeof l->head[0], "amplitude [%s]", s->units);
  snprintf(l->head[1], sizeof l->head[1], "power [(%s)^2 sqrt(H/g)]", s->units);
}

static enum status curves_make(const struct comparison *c, size_t k, struct look *l,
                               struct cmp_graph_curve *curve, size_t *n) {
  for (size_t i = 0; i <= c->n_runs; i++) {
    const size_t r = i ? i - 1 : SIZE_MAX;
    const struct cmp_run *run = cmp_run_or_ref(c, r);
    const struct cmp_spectrum *s = &run->spectrum[k];
    if (!s->n || (i && !cmp_run_is_picked(c, r, CMP_NAMED))) continue;
    struct cmp_graph_curve *own = &curve[*n];
    l->style[*n] = cmp_run_style(c, r);
    *own = (struct cmp_graph_curve){.name = run->data.label, .style = &l->style[*n]};
    ++*n;
    TRY(rows_of(s, &own->n, (double **)&own->row));
  }
  return OK;
}

static enum status graph_write(const struct look *l, size_t n, const struct cmp_graph_curve *curve,
                               struct cmp_figures *f) {
  const struct cmp_graph_column column[COLUMNS] = {
      [FREQUENCY] = {.head = "f [sqrt(g/H)]", .label = "f √(H/g)", .log = true},
      [AMPLITUDE] = {.head = l->head[0],
                     .label = "amplitude",
                     .axis = l->amplitude,
                     .log = true,
                     .span = 1e4},
      [PEAK] = {.head = "peak", .label = "peaks", .points = true, .log = true},
      [POWER] = {.head = l->head[1], .label = l->power, .panel = 1, .log = true, .span = 1e8}};
  const struct cmp_graph graph = {.name = l->name,
                                  .title = l->title,
                                  .caption = l->caption,
                                  .section = CMP_SECTION_SPECTRA,
                                  .raster = n > 8, /* as vectors, megabytes */
                                  .n_columns = COLUMNS,
                                  .column = column,
                                  .n_curves = n,
                                  .curve = curve};
  return cmp_graph_write(&graph, f);
}

static enum status spectrum_write(const struct comparison *c, size_t k, struct cmp_figures *f) {
  struct cmp_graph_curve curve[CMP_NAMED + 1] = {0};
  struct look look = {0};
  size_t n = 0;
  enum status status = OK;
  if (!series_of(c, c->settings->compare.spectra[k].series)) return OK;
  look_make(c, k, &look);
  ATTEMPT(curves_make(c, k, &look, curve, &n));
  if (n) ATTEMPT(graph_write(&look, n, curve, f));
done:
  for (size_t i = 0; i < n; i++) free((double *)curve[i].row);
  return status;
}

enum status cmp_spectra_write(const struct comparison *c, struct cmp_figures *f) {
  for (size_t k = 0; k < c->settings->compare.n_spectra; k++) TRY(spectrum_write(c, k, f));
  return OK;
}
