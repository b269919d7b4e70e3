#include "bem/run/pace.h"

#include <math.h>
#include <stdlib.h>

#include "common/base/array.h"

static const double SHORTEST = 1e-9; /* sqrt(H/g), steps that lead nowhere */
static const double CRAWL = 0.002;   /* sqrt(H/g) in a stretch: a hundredth of the usual pace */
static const double RUNAWAY = 3e-4;  /* of the energy, in as long as a stretch that crawls */
static const double CUT = 0.1; /* of the pace of the WINDOW before: a step that was cut short */
enum {
  WINDOW = 15,   /* steps */
  PATIENCE = 50, /* steps */
  STRETCH = 200,
  MOST_STEPS = 1000000, /* a hundred times as many as any run has needed */
  SETTLE = 60           /* steps that CVODE's order and step need to grow after a start */
};

void bem_pace_destroy(struct bem_pace *p) {
  free(p->dt);
  *p = (struct bem_pace){0};
}

enum status bem_pace_add(struct bem_pace *p, double time, double dt) {
  p->tiny = dt < SHORTEST ? p->tiny + 1 : 0;
  if (p->steps % STRETCH == 0) p->mark = time - dt;
  p->steps++;
  if (++p->since <= SETTLE) return OK;
  TRY(array_grow(&p->dt, &p->room, p->settled + 1, "lengths of time steps"));
  p->dt[p->settled++] = dt;
  return OK;
}

void bem_pace_restarted(struct bem_pace *p) {
  p->since = 0;
  p->watch.set = false;
}

bool bem_pace_is_spent(const struct bem_pace *p) {
  return p->steps >= MOST_STEPS;
}

bool bem_pace_leads_nowhere(const struct bem_pace *p) {
  return p->tiny >= PATIENCE;
}

bool bem_pace_is_lost(const struct bem_pace *p, double time) {
  return bem_pace_leads_nowhere(p) ||
         (p->steps > 0 && p->steps % STRETCH == 0 && time - p->mark < CRAWL);
}

bool bem_pace_runs_away(struct bem_pace *p, double time, double energy, double whole) {
  const bool away = p->watch.set && fabs(energy - p->watch.energy) > RUNAWAY * fabs(whole);
  if (p->watch.set && time - p->watch.time < CRAWL) return away;
  const bool crawled = p->watch.set && time - p->watch.time < 2 * CRAWL;
  p->watch.set = true;
  p->watch.time = time;
  p->watch.energy = energy;
  return crawled && away;
}

/* Puts a value into a sorted list of n in the place of another, or of none (NAN). */
static void take_over(double *sorted, size_t n, double old, double fresh) {
  size_t k = n;
  if (!isnan(old))
    for (k = 0; sorted[k] != old;) k++;
  for (; k + 1 < n && sorted[k + 1] < fresh; k++) sorted[k] = sorted[k + 1];
  for (; k > 0 && sorted[k - 1] > fresh; k--) sorted[k] = sorted[k - 1];
  sorted[k] = fresh;
}

double bem_pace_cut(const struct bem_pace *p) {
  double sorted[WINDOW];
  size_t cut = 0, n = 0;
  for (size_t i = 0; i < p->settled; i++) {
    cut += n == WINDOW && p->dt[i] < CUT * sorted[WINDOW / 2];
    take_over(sorted, n, n == WINDOW ? p->dt[i - WINDOW] : NAN, p->dt[i]);
    n += n < WINDOW;
  }
  return (double)cut;
}
