#include "compare/surfaces.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/measure.h"
#include "compare/measures/look.h"
#include "compare/outline.h"

/* Outputs this close (in sqrt(H/g)) count as simultaneous. */
static const double simultaneous = 0.01;
/* An outline that encloses less or more than the run's own volume by this fraction is not trusted.
 */
static const double enclosed_tolerance = 0.2;

/* ---- one surface against the reference's ---- */

static void unavailable(struct cmp_at *at, struct cmp_value why) {
  at->hausdorff = at->frechet = at->mean = at->largest = at->area = why;
}

/* The volume enclosed by an outline must be the run's, or the outline is not what it seems. */
static bool encloses(const struct cmp_data *d, double t, const struct cmp_outline *o,
                     struct cmp_value *why) {
  struct cmp_signal volume = cmp_series_signal(&d->volume);
  double expected = cmp_signal_at(&volume, t), found = cmp_outline_enclosed(o);
  if (!isfinite(expected) || fabs(found - expected) <= enclosed_tolerance * expected) return true;
  *why = cmp_unknown("the outline of %.40s encloses %.0f %% of its water", d->label,
                     100 * found / expected);
  return false;
}

/* `step`: between sample points. */
static enum status outline_of(const struct comparison *c, struct cmp_geos *g,
                              const struct cmp_data *d, size_t output, double step,
                              struct cmp_outline **o) {
  return cmp_outline_create(g, &d->surface[output], &d->walls, &c->window, step, c->depth, o);
}

/* `q` is the reference's outline; `all`: also what is costly, the Hausdorff and Frechet distances.
 */
static enum status surfaces_compare(const struct comparison *c, struct cmp_geos *g,
                                    const struct cmp_run *run, double step, bool all,
                                    const struct cmp_outline *q, struct cmp_at *at) {
  enum status status = OK;
  const struct cmp_data *a = &run->data, *b = &c->ref.data;
  struct cmp_outline *p = NULL;
  struct cmp_distance distance;
  unavailable(at, cmp_unknown("not computed"));
  ATTEMPT(outline_of(c, g, a, at->output, step, &p));
  ATTEMPT(cmp_outline_distance(p, q, &distance, &at->mean, &at->largest));
  memcpy(at->where, distance.at, sizeof at->where);
  at->noise_area = run->noise * cmp_outline_length(q);
  if (encloses(a, at->t, p, &at->area) && encloses(b, at->ref_t, q, &at->area))
    ATTEMPT(cmp_outline_area(p, q, &at->area));
  if (all) {
    ATTEMPT(cmp_outline_hausdorff(p, q, &at->hausdorff));
    ATTEMPT(cmp_outline_frechet(p, q, &at->frechet));
  }
done:
  cmp_outline_destroy(p);
  return status;
}

/* ---- what is to be compared, by the reference's outputs: each is made ready once ---- */

struct task {
  struct cmp_run *run;
  struct cmp_at *at; /* NULL: for row `row` of the run's evolution */
  size_t row, output, ref_output;
  double step; /* between sample points: half the run's spacing */
};

struct tasks {
  size_t n, room;
  struct task *task;
};

static enum status task_add(struct tasks *tasks, const struct task *task) {
  TRY(array_grow(&tasks->task, &tasks->room, tasks->n + 1, "pairs of surfaces"));
  tasks->task[tasks->n++] = *task;
  return OK;
}

static int by_outline(const void *a, const void *b) {
  const struct task *x = a, *y = b;
  if (x->ref_output != y->ref_output) return x->ref_output < y->ref_output ? -1 : 1;
  return (x->step > y->step) - (x->step < y->step);
}

static void at_choose(const struct comparison *c, const struct cmp_run *run, double t,
                      struct cmp_at *at) {
  const struct cmp_data *a = &run->data, *b = &c->ref.data;
  *at = (struct cmp_at){.t = NAN, .ref_t = NAN, .where = {NAN, NAN}, .noise_area = NAN};
  at->output = cmp_data_output(a, t, 0.5 * cmp_data_interval(a) + 1e-9);
  at->ref_output = SIZE_MAX;
  if (at->output == SIZE_MAX) {
    unavailable(at, !a->n ? cmp_unknown("%.60s has no surfaces", a->label)
                          : cmp_unknown("%.40s has no surface near t* = %.4g (its last: %.4g)",
                                        a->label, t, a->t[a->n - 1]));
    return;
  }
  at->t = a->t[at->output];
  at->ref_output = cmp_data_output(b, at->t, 0.5 * cmp_data_interval(b) + 1e-9);
  if (at->ref_output == SIZE_MAX)
    unavailable(at, !b->n ? cmp_unknown("%.60s has no surfaces", b->label)
                          : cmp_unknown("%.40s has no surface near t* = %.4g (its last: %.4g)",
                                        b->label, at->t, b->t[b->n - 1]));
  else
    at->ref_t = b->t[at->ref_output];
  if (at->ref_output != SIZE_MAX) unavailable(at, cmp_unknown("not computed"));
}

enum status cmp_surfaces_choose(struct comparison *c) {
  for (size_t r = 0; r < c->n_runs; r++) {
    struct cmp_run *run = &c->run[r];
    TRY(array_create(&run->at, c->n_times, "comparison times"));
    for (size_t k = 0; k < c->n_times; k++) at_choose(c, run, c->times[k], &run->at[k]);
  }
  return OK;
}

static enum status run_tasks(const struct comparison *c, struct cmp_run *run, struct tasks *tasks) {
  struct cmp_evolution *e = &run->evolution;
  size_t n = run->data.n;
  struct task task = {.run = run, .step = fmax(run->data.dx / 2, 1e-3)};
  e->t = calloc(n + 1, sizeof *e->t);
  CHECK(e->t, ERR_MEMORY, "no memory for %zu outputs", n);
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    if (!cmp_measure_always(m)) continue;
    e->value[m] = calloc(n + 1, sizeof *e->value[m]);
    CHECK(e->value[m], ERR_MEMORY, "no memory for %s at %zu outputs", cmp_measures[m].name, n);
  }
  for (size_t k = 0; k < c->n_times; k++) {
    task.at = &run->at[k];
    task.output = task.at->output;
    task.ref_output = task.at->ref_output;
    if (task.ref_output != SIZE_MAX) TRY(task_add(tasks, &task));
  }
  task.at = NULL;
  for (task.output = 0; task.output < n; task.output++) {
    task.ref_output = cmp_data_output(&c->ref.data, run->data.t[task.output], simultaneous);
    if (task.ref_output == SIZE_MAX) continue;
    task.row = e->n;
    e->t[e->n++] = run->data.t[task.output];
    TRY(task_add(tasks, &task));
  }
  return OK;
}

static void evolution_take(const struct comparison *c, const struct task *k,
                           const struct cmp_at *at) {
  char detail[192];
  for (size_t m = 0; m < CMP_N_MEASURES; m++) {
    struct cmp_look look = {c, k->run, at, at->t, detail, sizeof detail, false, 0};
    if (cmp_measure_always(m))
      k->run->evolution.value[m][k->row] = cmp_measure_take(m, &look).value;
  }
}

/* One bad surface must not cost the report: it says why there is no number. `q` is NULL when the
 * reference's is bad, for the reason of the last failure. */
static void task_do(const struct comparison *c, struct cmp_geos *g, const struct task *k,
                    const struct cmp_outline *q) {
  struct cmp_at own = {.output = k->output,
                       .ref_output = k->ref_output,
                       .t = k->run->data.t[k->output],
                       .ref_t = c->ref.data.t[k->ref_output]};
  struct cmp_at *at = k->at ? k->at : &own;
  if (!q || surfaces_compare(c, g, k->run, k->step, k->at != NULL, q, at) != OK)
    unavailable(at, cmp_unknown("%.100s", status_message()));
  if (!k->at) evolution_take(c, k, at);
}

/* The tasks from `first` to before `end`, which share the reference's outline. */
static void group_do(const struct comparison *c, struct cmp_geos *g, const struct task *first,
                     const struct task *end) {
  struct cmp_outline *q = NULL;
  if (!g)
    status_raise(ERR_MEMORY, "no memory for GEOS");
  else if (outline_of(c, g, &c->ref.data, first->ref_output, first->step, &q) != OK)
    q = NULL;
  for (const struct task *k = first; k < end; k++) task_do(c, g, k, q);
  cmp_outline_destroy(q);
}

static enum status tasks_do(const struct comparison *c, const struct tasks *tasks) {
  size_t groups = 0, *first = malloc((tasks->n + 1) * sizeof *first);
  CHECK(first, ERR_MEMORY, "no memory for %zu pairs of surfaces", tasks->n);
  qsort(tasks->task, tasks->n, sizeof *tasks->task, by_outline);
  for (size_t i = 0; i < tasks->n; i++)
    if (i == 0 || by_outline(&tasks->task[i - 1], &tasks->task[i]) != 0) first[groups++] = i;
  first[groups] = tasks->n;
#pragma omp parallel
  {
    struct cmp_geos *g = cmp_geos_create();
#pragma omp for schedule(dynamic)
    for (size_t k = 0; k < groups; k++)
      group_do(c, g, tasks->task + first[k], tasks->task + first[k + 1]);
    cmp_geos_destroy(g);
  }
  free(first);
  return OK;
}

enum status cmp_surfaces_measure(struct comparison *c) {
  enum status status = OK;
  struct tasks tasks = {0};
  for (size_t r = 0; r < c->n_runs; r++) ATTEMPT(run_tasks(c, &c->run[r], &tasks));
  if (tasks.n) ATTEMPT(tasks_do(c, &tasks));
done:
  free(tasks.task);
  return status;
}

/* ---- how far the reference's own surface moves ---- */

/* From a few of its outputs. Motion below a tenth of its spacing is none that it is known to. */
static enum status motion_measure(struct comparison *c, struct cmp_geos *g) {
  enum { LOOKS = 32 };
  const struct cmp_data *d = &c->ref.data;
  enum status status = OK;
  struct cmp_outline *first = NULL, *now = NULL;
  double step = fmax(d->dx / 2, 1e-3), motion = NAN;
  ATTEMPT(outline_of(c, g, d, 0, step, &first));
  for (size_t k = 1; k <= LOOKS; k++) {
    struct cmp_distance distance;
    struct cmp_value mean, largest;
    ATTEMPT(outline_of(c, g, d, (d->n - 1) * k / LOOKS, step, &now));
    ATTEMPT(cmp_outline_distance(first, now, &distance, &mean, &largest));
    motion = fmax(motion, mean.value);
    cmp_outline_destroy(now);
    now = NULL;
  }
  c->motion = motion > 0.1 * d->dx ? cmp_number(motion)
                                   : cmp_unknown("the surface of %.60s does not move", d->label);
done:
  cmp_outline_destroy(first);
  cmp_outline_destroy(now);
  return status;
}

enum status cmp_surfaces_motion(struct comparison *c) {
  c->motion = cmp_unknown("%.60s has no two surfaces", c->ref.data.label);
  if (c->ref.data.n < 2) return OK;
  struct cmp_geos *g = cmp_geos_create();
  CHECK(g, ERR_MEMORY, "no memory for GEOS");
  enum status status = motion_measure(c, g);
  cmp_geos_destroy(g);
  if (status == ERR_MEMORY) return status;
  if (status != OK) c->motion = cmp_unknown("%.100s", status_message());
  return OK;
}
