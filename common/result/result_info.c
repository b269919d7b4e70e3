#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "common/result/health.h"
#include "common/result/result.h"
#include "common/result/result_diff.h"
#include "common/result/result_store.h"

enum { COLUMNS = 100 };

/* One line under a label; what is beyond the last column is cut. */
static void say(FILE *out, const char *label, const char *format, ...)
    __attribute__((format(printf, 3, 4)));
static void say(FILE *out, const char *label, const char *format, ...) {
  char text[1024], line[1100];
  va_list args;
  va_start(args, format);
  vsnprintf(text, sizeof text, format, args);
  va_end(args);
  snprintf(line, sizeof line, "%-12s%s", label, text);
  char *p = line, *cut = NULL;
  for (int columns = 0; *p; p++) {
    if (*p == '\n') *p = ' ';
    if ((*p & 0xc0) == 0x80) continue; /* inside a UTF-8 character */
    if (++columns == COLUMNS - 2) cut = p;
    if (columns > COLUMNS) break;
  }
  if (*p) strcpy(cut, "...");
  fprintf(out, "%s\n", line);
}

/* A text of its length: broken at blanks, whole, the label before its first line. */
static void say_text(FILE *out, const char *label, const char *text) {
  const size_t width = COLUMNS - 12;
  while (strlen(text) > width) {
    size_t n = width;
    while (n && text[n] != ' ') n--;
    if (!n) break; /* a word longer than the line */
    say(out, label, "%.*s", (int)n, text);
    label = "";
    text += n + 1;
  }
  say(out, label, "%s", text);
}

static void say_span(FILE *out, const char *label, size_t n, const double *t, size_t stride,
                     double scale, const char *more) {
  if (!n)
    say(out, label, "none");
  else
    say(out, label, "%zu from t = %.6g to %.6g s (t sqrt(g/H) = %.4g to %.4g)%s%s", n, t[0],
        t[(n - 1) * stride], t[0] / scale, t[(n - 1) * stride] / scale, *more ? ", " : "", more);
}

/* "a, b, c": what does not fit ends in "...". */
static void add_name(char *text, size_t size, const char *name) {
  size_t n = strlen(text);
  snprintf(text + n, size - n, "%s%s", n ? ", " : "", name);
}

static void say_points(FILE *out, const struct result_file *f, double scale) {
  char text[512] = "", fields[256] = "";
  int64_t least = f->n_outputs ? f->output_points[0] : 0, most = least;
  for (size_t k = 0; k < f->n_outputs; k++) {
    if (f->output_points[k] < least) least = f->output_points[k];
    if (f->output_points[k] > most) most = f->output_points[k];
  }
  say_span(out, "outputs", f->n_outputs, f->output_time, 1, scale, "");
  if (!f->n_outputs) return;
  for (size_t i = 0; i < f->n_fields; i++) add_name(fields, sizeof fields, f->fields[i]);
  if (least == most)
    snprintf(text, sizeof text, "%lld", (long long)most);
  else
    snprintf(text, sizeof text, "%lld to %lld", (long long)least, (long long)most);
  say(out, "points", "%s in each output, with %s", text, fields);
}

static void say_surfaces(FILE *out, const struct result_file *f, double scale) {
  char text[128] = "";
  if (f->n_surfaces) {
    const struct geo_lines *last = &f->surface[f->n_surfaces - 1];
    snprintf(text, sizeof text, "the last of %zu piece%s, %zu points", last->pieces,
             last->pieces == 1 ? "" : "s", last->points);
  }
  say_span(out, "surfaces", f->n_surfaces, f->surface_time, 1, scale, text);
}

/* What has left by each term that took anything, and by what the sum is off. */
static void say_budget(FILE *out, const struct result_file *f) {
  char text[1024] = "", one[128];
  const struct result_energy *first = &f->energy[0], *last = &f->energy[f->n_energy - 1];
  for (size_t k = 0; k < f->n_terms; k++) {
    if (last->term[k] == 0) continue;
    snprintf(one, sizeof one, "%s %.6g", f->terms[k].name, last->term[k]);
    add_name(text, sizeof text, one);
  }
  say_text(out, "lost", *text ? text : "nothing by any term");
  say(out, "", "unaccounted %.2g (J/m all)",
      result_energy_budget(first) - result_energy_budget(last));
}

/* How large the known ones of n error bars, `stride` numbers apart, become, and their mean. */
static double largest_error(size_t n, const double *error, size_t stride, double *mean) {
  double most = NAN, sum = 0;
  size_t known = 0;
  for (size_t i = 0; i < n; i++) {
    const double e = error[i * stride];
    if (!isfinite(e)) continue;
    most = fmax(most, e);
    sum += e;
    known++;
  }
  *mean = known ? sum / (double)known : NAN;
  return most;
}

/* Standard errors, if the run was held against a coarser one. */
static void say_errors(FILE *out, const struct result_file *f) {
  double mean, most;
  if (!(f->coarser.ratio > 0)) return;
  say(out, "error bars", "from a run with spacings %.3g times as wide, for errors of order %.3g",
      f->coarser.ratio, f->coarser.order);
  if (f->n_surfaces) {
    const size_t last = f->surface[f->n_surfaces - 1].points;
    most = largest_error(last, f->surface_error + f->n_surface_errors - last, 1, &mean);
    say(out, "", "last surface +-%.2g m (mean), +-%.2g m (at worst)", mean, most);
  }
  most = largest_error(f->n_energy_errors, &f->energy_error->total,
                       sizeof *f->energy_error / sizeof(double), &mean);
  say(out, "", "total energy +-%.2g J/m (mean), +-%.2g J/m (at worst)", mean, most);
  for (size_t i = 0; i < f->n_probes; i++) {
    most = largest_error(f->probes[i].n_errors, f->probes[i].error, 1, &mean);
    say(out, "", "%s +-%.2g Pa (mean), +-%.2g Pa (at worst)", f->probes[i].name, mean, most);
  }
  for (size_t i = 0; i < f->n_gauges; i++) {
    most = largest_error(f->gauges[i].n_errors, f->gauges[i].error, 1, &mean);
    say(out, "", "%s +-%.2g m (mean), +-%.2g m (at worst)", f->gauges[i].name, mean, most);
  }
}

static void say_series(FILE *out, const char *label, size_t n, const struct result_series *series) {
  char text[512] = "";
  size_t rows = 0;
  for (size_t i = 0; i < n; i++) {
    add_name(text, sizeof text, series[i].name);
    rows += series[i].n;
  }
  if (n) say(out, label, "%s (%zu rows)", text, rows);
}

static void say_places(FILE *out, const struct result_file *f) {
  char text[512] = "";
  size_t rows = 0;
  for (size_t i = 0; i < f->n_points; i++) {
    add_name(text, sizeof text, f->points[i].name);
    rows += f->points[i].n;
  }
  if (f->n_points) say(out, "points", "%s (%zu rows)", text, rows);
}

static void say_events(FILE *out, const struct result_file *f, double scale) {
  enum { SHOWN = 6 };
  for (size_t i = 0; i < f->n_events && i < SHOWN; i++) {
    const struct result_event_read *e = &f->events[i];
    say(out, i ? "" : "events", "%-12s t = %.6g s (t sqrt(g/H) = %.5g) at x = %.5g, y = %.5g m",
        e->name, e->time, e->time / scale, e->x, e->y);
    if (isfinite(e->error[0]))
      say(out, "", "%-12s +-%.2g s (%.2g sqrt(H/g)); x +-%.2g, y +-%.2g m", "", e->error[0],
          e->error[0] / scale, e->error[1], e->error[2]);
  }
  if (f->n_events > SHOWN) say(out, "", "and %zu more", f->n_events - SHOWN);
}

static void say_statistics(FILE *out, const struct result_file *f) {
  char text[COLUMNS] = "", one[COLUMNS];
  const char *label = "statistics";
  for (size_t i = 0; i < f->n_statistics; i++) {
    snprintf(one, sizeof one, "%s = %.6g", f->statistics[i].name, f->statistics[i].value);
    if (*text && strlen(text) + strlen(one) + 2 > COLUMNS - 12) {
      say(out, label, "%s", text);
      *text = 0;
      label = "";
    }
    add_name(text, sizeof text, one);
  }
  if (*text) say(out, label, "%s", text);
}

/* The verdict with its facts, a line for each of its reasons, and what it could not look at. */
static void say_health(FILE *out, const struct result_file *f) {
  struct health h;
  health_of_file(f, &h);
  char verdict[32 + sizeof h.facts];
  snprintf(verdict, sizeof verdict, "%s%s%s", health_word(&h), *h.facts ? ": " : "", h.facts);
  say_text(out, "health", verdict);
  for (char *rest = h.reasons, *reason; *h.reasons && (reason = strsep(&rest, ";"));)
    say_text(out, "", reason + strspn(reason, " "));
  if (*h.missing) say(out, "", "the file does not tell: %s", h.missing);
}

enum status result_info(const char *path, FILE *out) {
  struct result_file *f;
  TRY(result_read(path, &f));
  double scale = sqrt(f->H / f->g);
  say(out, "file", "%s", path);
  if (*f->title) say(out, "title", "%s", f->title);
  say(out, "run", "%s (%s), %s", f->run, *f->solver ? f->solver : "another program",
      f->complete                     ? "complete"
      : result_store_is_written(path) ? "under way"
                                      : "stopped before its end");
  if (*f->ended) say_text(out, "ended", f->ended);
  if (*f->imported) say_text(out, "imported", f->imported);
  say_health(out, f);
  if (*f->version)
    say(out, "program", "plunge %s, revision %s, run at %s", f->version, f->revision, f->created);
  say(out, "scales", "H = %.6g m, g = %.6g m/s^2, density %.6g kg/m^3, spacing %.5g m (H/%.5g)",
      f->H, f->g, f->density, f->spacing, f->H / f->spacing);
  say_points(out, f, scale);
  say_surfaces(out, f, scale);
  say_span(out, "energy", f->n_energy, &f->energy->time, sizeof *f->energy / sizeof(double), scale,
           "");
  if (f->n_energy)
    say(out, "", "total %.6g J/m at first, %.6g J/m at last; at rest %.6g J/m", f->energy[0].total,
        f->energy[f->n_energy - 1].total, f->rest_potential);
  if (f->n_energy) say_budget(out, f);
  if (f->n_steps) {
    const struct result_step *last = &f->steps[f->n_steps - 1];
    say(out, "work", "%.0f evaluations in %.4g s, dt = %.4g s at last", last->evaluations,
        last->wall_time, last->dt);
  }
  say_series(out, "probes", f->n_probes, f->probes);
  say_series(out, "gauges", f->n_gauges, f->gauges);
  say_places(out, f);
  say_series(out, "diagnostics", f->n_diagnostics, f->diagnostics);
  if (f->n_experiments) say(out, "experiments", "%zu series to compare with", f->n_experiments);
  say_events(out, f, scale);
  say_errors(out, f);
  say_statistics(out, f);
  result_file_destroy(f);
  return OK;
}
