#include "compare/cuts.h"

#include <stdint.h>
#include <string.h>

#include "compare/chart.h"

static const double LEAST = 5e-4; /* E0: less does not show in a curve */

bool cmp_cut_shows(const struct cmp_data *d, size_t i) {
  return i > 0 && i < d->removed.n && fabs(d->removed.value[i] - d->removed.value[i - 1]) > LEAST;
}

static bool any(const struct cmp_data *d) {
  for (size_t i = 1; i < d->removed.n; i++)
    if (cmp_cut_shows(d, i)) return true;
  return false;
}

bool cmp_cuts_any(const struct comparison *c) {
  for (size_t r = 0; r <= c->n_runs; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (d->removed.n && fabs(d->removed.value[d->removed.n - 1]) > LEAST) return true;
  }
  return false;
}

/* Events of a kind, which are numbered behind its name when there are several. */
static size_t count_events(const struct result_file *f, const char *kind) {
  const size_t length = strlen(kind);
  size_t n = 0;
  for (size_t i = 0; i < f->n_events; i++) {
    const char *name = f->events[i].name;
    n += !strncmp(name, kind, length) && (!name[length] || name[length] == '_');
  }
  return n;
}

static double volume_share(const struct result_file *f) {
  const struct result_step *last = f->n_steps ? &f->steps[f->n_steps - 1] : NULL;
  const double all = last ? f->steps[0].volume + f->steps[0].removed_volume : 0;
  return all > 0 ? last->removed_volume / all : NAN;
}

static void say_count(size_t n, const char *before, const char *noun, char *out, size_t room) {
  const size_t used = strlen(out);
  if (n) snprintf(out + used, room - used, "%s%zu %s%s", before, n, noun, n == 1 ? "" : "s");
}

static void say_run(const struct cmp_data *d, bool first, char *out, size_t room) {
  const size_t cuts = count_events(d->file, "cut"), smoothed = count_events(d->file, "smoothed");
  char times[96] = "";
  say_count(cuts, " in ", "cut", times, sizeof times);
  say_count(smoothed, cuts ? " and " : " in ", "smoothing", times, sizeof times);
  snprintf(out, room, "%s %.40s %.2g %% of E0 and %.2g %% of its water%s", first ? "" : ";",
           d->label, 100 * d->removed.value[d->removed.n - 1], 100 * volume_share(d->file), times);
}

void cmp_cuts_say(const struct comparison *c, char *out, size_t room) {
  size_t used = strlen(out);
  bool first = true;
  for (size_t r = 0; r <= c->n_runs && used < room; r++) {
    const struct cmp_data *d = &cmp_run_or_ref(c, r < c->n_runs ? r : SIZE_MAX)->data;
    if (!any(d) || (r < c->n_runs && !cmp_run_is_picked(c, r, CMP_NAMED))) continue;
    if (first)
      snprintf(out + used, room - used,
               " Crosses: water was taken out there, cut away or spilled. In all:");
    used += strlen(out + used);
    say_run(d, first, out + used, room - used);
    used += strlen(out + used);
    first = false;
  }
  if (!first && used < room) snprintf(out + used, room - used, ".");
}
