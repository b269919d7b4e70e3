/* The runs of a case, each with its solver's own keys, and what is compared. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case_draft.h"

struct run_section {
  char *name;
  int solver, sweep;
  double resolution;
};
static const struct param run_rows[] = {
    TEXT(struct run_section, name, 64, "", "name of the run and its files; default: the solver's"),
    NODE(struct run_section, solver, NULL, "the name of a solver"),
    REAL(struct run_section, resolution, QTY_NUMBER, PARAM_ABOVE_0, 1e5, NULL,
         "particles (SPH) or surface nodes (BEM) per H; bem may have accuracy instead"),
    NODE(struct run_section, sweep, "", /* nothing is left of it when runs are read */
         "several runs in one: a mapping of keys with a list of values each, for all their "
         "combinations, or a list of mappings, for a run each"),
};

static const struct solver *find_solver(struct case_draft *d, int run, const char *path) {
  const struct registry *r = d->registry;
  const char *names[64];
  char found[64], full[CASE_PATH + 16];
  int node = case_doc_member(&d->doc, run, "solver");
  const char *text = case_doc_text(&d->doc, node);
  size_t n = r->n_solvers < 64 ? r->n_solvers : 64;
  for (size_t i = 0; i < n; i++) {
    names[i] = r->solvers[i]->name;
    if (text && !strcmp(text, names[i])) return r->solvers[i];
  }
  struct case_offer offer = case_offer("one of ", n, names, text);
  case_doc_found(&d->doc, node, found);
  snprintf(full, sizeof full, "%s.solver", path);
  case_doc_problem(&d->doc, case_doc_member_line(&d->doc, run, "solver"), full, found,
                   offer.allowed, node ? offer.todo : "add this key");
  return NULL;
}

static const char *key_name(const struct case_run *r, size_t i) {
  return i < ROWS(run_rows) ? run_rows[i].key : r->solver->params[i - ROWS(run_rows)].key;
}

static size_t n_keys(const struct case_run *r) {
  return ROWS(run_rows) + (r->solver ? r->solver->n_params : 0);
}

static enum status note_keys(struct case_draft *d, int node, struct case_run *run) {
  const size_t n = n_keys(run);
  TRY(array_create(&run->key_line, n, "entries of the case"));
  TRY(array_create(&run->key_given, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    run->key_line[i] = case_doc_member_line(&d->doc, node, key_name(run, i));
    run->key_given[i] = case_doc_member(&d->doc, node, key_name(run, i)) != 0;
  }
  return OK;
}

/* Where it is among the keys of a run; n_keys: it is none. */
static size_t find_key(const struct case_run *r, const char *key) {
  size_t i = 0;
  while (i < n_keys(r) && strcmp(key_name(r, i), key)) i++;
  return i;
}

int case_run_line(const struct case_run *r, const char *key) {
  const size_t i = find_key(r, key);
  return r->key_line && i < n_keys(r) ? r->key_line[i] : r->line;
}

bool case_run_gives(const struct case_run *r, const char *key) {
  const size_t i = find_key(r, key);
  return r->key_given && i < n_keys(r) && r->key_given[i];
}

/* The preset that the run's key `scheme` names; the table reports a name that is none. */
static const struct param_preset *find_preset(struct case_draft *d, int run,
                                              const struct solver *solver) {
  const char *text = case_doc_text(&d->doc, case_doc_member(&d->doc, run, "scheme"));
  for (size_t i = 0; solver && text && i < solver->n_presets; i++)
    if (!strcmp(solver->presets[i].name, text)) return &solver->presets[i];
  return NULL;
}

/* The solver finds it. */
static const struct param_preset without_resolution = {
    .values = (const struct param_value[]){{"resolution", ""}, {NULL, NULL}}};

static enum status read_run(struct case_draft *d, int node, size_t i, struct case_run *run) {
  char path[CASE_PATH];
  case_doc_item_path(&d->doc, "runs", node, i, path);
  /* without a mapping there is nothing to look a solver up in: the tables report that */
  const struct solver *solver =
      case_doc_is_mapping(&d->doc, node) ? find_solver(d, node, path) : NULL;
  if (!solver && case_doc_is_mapping(&d->doc, node)) { /* its keys cannot be judged */
    const char *name = case_doc_text(&d->doc, case_doc_member(&d->doc, node, "name"));
    run->name = name && case_name_fits(name) ? strdup(name) : NULL;
    return OK;
  }
  struct run_section section = {0};
  if (solver) run->options = array_memory(NULL, 1, solver->options_size, "options of a run");
  if (solver && !run->options) return ERR_MEMORY;
  const bool settled = solver && solver->settle && case_doc_member(&d->doc, node, "accuracy") != 0;
  struct case_block blocks[] = {
      {run_rows, ROWS(run_rows), &section, settled ? &without_resolution : NULL},
      {solver ? solver->params : NULL, solver ? solver->n_params : 0, run->options,
       find_preset(d, node, solver)},
  };
  case_doc_read(&d->doc, node, path, 0, 2, blocks);
  run->name = section.name;
  run->solver = solver;
  run->resolution = section.resolution;
  run->line = case_doc_line(&d->doc, node);
  TRY(note_keys(d, node, run));
  if (!run->name && solver) {
    run->name = strdup(solver->name);
    CHECK(run->name, ERR_MEMORY, "no memory for the name of a run");
  }
  return OK;
}

enum status case_read_runs(struct case_draft *d) {
  struct case_doc *doc = &d->doc;
  struct case_file *c = d->c;
  size_t faults = doc->faults, n = 0;
  if (d->at.runs && case_doc_expect_list(doc, d->at.runs, "runs", 1, CASE_MOST_ITEMS, "runs"))
    n = case_doc_size(doc, d->at.runs);
  TRY(array_create(&c->runs, n, "entries of the case"));
  for (size_t i = 0; i < n; i++)
    TRY(read_run(d, case_doc_item(doc, d->at.runs, i), i, &c->runs[c->n_runs++]));
  d->good.runs = n && doc->faults == faults;
  return OK;
}

/* ---- compare ---- */

struct compare_section {
  int reference, times, window, tolerances, averages, filters, spectra, experiments, profiles,
      events;
};
static const struct param compare_rows[] = {
    NODE(struct compare_section, reference, "", "the name of a run; default: the first"),
    NODE(struct compare_section, times, "", "a list of times; default: three, evenly spaced"),
    NODE(struct compare_section, window, "", "a list of 2 points, lower left and upper right"),
    NODE(struct compare_section, tolerances, "", "a list of tolerances"),
    NODE(struct compare_section, averages, "",
         "a list of averages; default: probes are compared as they are"),
    NODE(struct compare_section, filters, "",
         "a list of filters of probes, shown beside what is compared"),
    NODE(struct compare_section, spectra, "", "a list of spectra of series"),
    NODE(struct compare_section, experiments, "", "a list of experiments"),
    NODE(struct compare_section, profiles, "", "a list of measured surfaces at instants"),
    NODE(struct compare_section, events, "", "a list of published numbers of events"),
};

static const char *run_name(const struct case_file *c, size_t i) {
  return i < c->n_runs ? c->runs[i].name : NULL;
}

static const char *probe_name(const struct case_file *c, size_t i) {
  return i < c->n_probes ? c->probes[i].name : NULL;
}

/* Which of n things `node` names, or n with a problem added. Results may have more of them than a
 * case has; a message then offers the first. */
static size_t find_named(struct case_draft *d, int node, const char *path, const char *lead,
                         const char *(*name)(const struct case_file *, size_t), size_t n) {
  const char *text = case_doc_text(&d->doc, node), *names[CASE_MOST_ITEMS];
  char found[64];
  size_t offered = 0;
  for (size_t i = 0; i < n; i++) {
    const char *its = name(d->c, i);
    if (!its) continue;
    if (text && !strcmp(text, its)) return i;
    if (offered < CASE_MOST_ITEMS) names[offered++] = its;
  }
  struct case_offer offer = case_offer(lead, offered, names, text);
  case_doc_found(&d->doc, node, found);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, found, offer.allowed, offer.todo);
  return n;
}

size_t case_find_probe(struct case_draft *d, int node, const char *path) {
  const size_t n = d->c->n_probes;
  return find_named(d, node, path, n ? "one of the probes " : "none, there are no probes",
                    probe_name, n);
}

static size_t find_run(struct case_draft *d, int node, const char *path) {
  return find_named(d, node, path, "one of the runs ", run_name, d->c->n_runs);
}

/* The output times nearest to the thirds of the run; fewer where there are not three. */
static enum status default_times(struct case_file *c) {
  double outputs = floor(c->end / c->every * (1 + 1e-12));
  TRY(array_create(&c->compare.times, 3, "entries of the case"));
  for (int i = 1; i <= 3; i++) {
    double time = round(outputs * i / 3) * c->every;
    size_t n = c->compare.n_times;
    if (time > (n ? c->compare.times[n - 1] : 0)) c->compare.times[c->compare.n_times++] = time;
  }
  return OK;
}

static enum status read_times(struct case_draft *d, int node) {
  static const struct param row = {.type = PARAM_REAL, .quantity = QTY_TIME, .min = 0, .max = 1e9};
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.times", 1, CASE_MOST_ITEMS, "times")) return OK;
  size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.times, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    char path[CASE_PATH];
    snprintf(path, sizeof path, "compare.times[%zu]", i);
    case_doc_value(doc, case_doc_item(doc, node, i), path, &row, &d->c->compare.times[i]);
  }
  d->c->compare.n_times = n;
  return OK;
}

static void read_window(struct case_draft *d, int node) {
  struct geo_box *window = &d->c->compare.window;
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.window", 2, 2,
                            "points, lower left and upper right") ||
      !case_read_point(doc, case_doc_item(doc, node, 0), "compare.window[0]", window->min) ||
      !case_read_point(doc, case_doc_item(doc, node, 1), "compare.window[1]", window->max))
    return;
  if (!(window->max[0] > window->min[0] && window->max[1] > window->min[1])) {
    case_doc_problem(doc, case_doc_line(doc, node), "compare.window", "an empty window",
                     "the lower left, then the upper right corner", "exchange them");
  }
}

struct tolerance_section {
  int measure, runs;
  double at, max;
};
static const struct param tolerance_rows[] = {
    NODE(struct tolerance_section, measure, NULL, "the name of a measure"),
    REAL(struct tolerance_section, max, QTY_NUMBER, 0, 1e30, NULL,
         "largest value that passes, in the measure's units"),
    REAL(struct tolerance_section, at, QTY_TIME, 0, 1e9, "",
         "the comparison time that it holds for; default: all"),
    NODE(struct tolerance_section, runs, "", "a list of runs; default: all but the reference"),
};

static enum status read_measure(struct case_draft *d, int node, const char *path, char **out) {
  const struct registry *r = d->registry;
  const char *text = case_doc_text(&d->doc, node), *names[128];
  char found[64];
  size_t n = r->n_measures < 128 ? r->n_measures : 128;
  for (size_t i = 0; i < n; i++) {
    names[i] = r->measures[i].name;
    if (!text || strcmp(text, names[i]) != 0) continue;
    *out = strdup(text);
    CHECK(*out, ERR_MEMORY, "no memory for the name of a measure");
    return OK;
  }
  struct case_offer offer = case_offer("one of ", n, names, text);
  case_doc_found(&d->doc, node, found);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, found, offer.allowed, offer.todo);
  return OK;
}

enum status case_read_run_names(struct case_draft *d, int node, const char *path, bool reference,
                                size_t *n, size_t **runs) {
  struct case_doc *doc = &d->doc;
  char item[CASE_PATH + 48];
  if (!case_doc_expect_list(doc, node, path, 1, CASE_MOST_ITEMS, "runs")) return OK;
  const size_t all = case_doc_size(doc, node);
  TRY(array_create(runs, all, "entries of the case"));
  for (size_t i = 0; i < all; i++) {
    int name = case_doc_item(doc, node, i);
    snprintf(item, sizeof item, "%s[%zu]", path, i);
    size_t run = find_run(d, name, item);
    if (run == d->c->n_runs) continue;
    if (!reference && run == d->c->compare.reference)
      case_doc_problem(doc, case_doc_line(doc, name), item, "the reference itself",
                       "runs that are compared with it", "remove it");
    (*runs)[(*n)++] = run;
  }
  return OK;
}

static enum status read_tolerances(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.tolerances", 0, CASE_MOST_ITEMS, "tolerances"))
    return OK;
  size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.tolerances, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) {
    struct tolerance_section s = {.at = NAN};
    struct case_tolerance *t = &d->c->compare.tolerances[d->c->compare.n_tolerances++];
    char path[CASE_PATH], key[CASE_PATH + 16];
    int item = case_doc_item(doc, node, i);
    snprintf(path, sizeof path, "compare.tolerances[%zu]", i);
    if (!case_read_section(d, item, path, tolerance_rows, ROWS(tolerance_rows), &s)) continue;
    t->at = s.at;
    t->max = s.max;
    snprintf(key, sizeof key, "%s.measure", path);
    TRY(read_measure(d, s.measure, key, &t->measure));
    snprintf(key, sizeof key, "%s.runs", path);
    if (s.runs) TRY(case_read_run_names(d, s.runs, key, false, &t->n_runs, &t->runs));
  }
  return OK;
}

struct average_section {
  int probe;
  double over;
};
static const struct param average_rows[] = {
    NODE(struct average_section, probe, NULL, "the name of a probe"),
    REAL(struct average_section, over, QTY_TIME, 0, 1e9, NULL,
         "time over which its pressure, that of every run, of the reference and of experiments "
         "alike, is averaged before it is measured; 0 is none"),
};

static void read_average(struct case_draft *d, int node, size_t i) {
  struct case_file *c = d->c;
  struct case_average *a = &c->compare.averages[c->compare.n_averages++];
  struct average_section s = {0};
  char path[CASE_PATH], key[CASE_PATH + 16], found[96];
  a->probe = c->n_probes;
  snprintf(path, sizeof path, "compare.averages[%zu]", i);
  if (!case_read_section(d, node, path, average_rows, ROWS(average_rows), &s)) return;
  snprintf(key, sizeof key, "%s.probe", path);
  a->over = s.over;
  a->probe = case_find_probe(d, s.probe, key);
  for (size_t k = 0; k < i && a->probe < c->n_probes; k++) {
    if (c->compare.averages[k].probe != a->probe) continue;
    snprintf(found, sizeof found, "'%s' a second time", c->probes[a->probe].name);
    case_doc_problem(&d->doc, case_doc_line(&d->doc, s.probe), key, found,
                     "one average of each probe", "remove one");
    return;
  }
}

static enum status read_averages(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.averages", 0, CASE_MOST_ITEMS, "averages"))
    return OK;
  size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.averages, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) read_average(d, case_doc_item(doc, node, i), i);
  return OK;
}

struct experiment_section {
  char *file, *label, *source, *target;
};
static const struct param experiment_rows[] = {
    TEXT(struct experiment_section, file, 1000, NULL, "data file, relative to the case"),
    TEXT(struct experiment_section, target, 64, NULL, "name of a probe or gauge, or front"),
    TEXT(struct experiment_section, label, 200, "", "name in plots; default: the file's"),
    TEXT(struct experiment_section, source, 1000, "", "citation"),
};

static enum status read_experiment(struct case_draft *d, int node, size_t i) {
  struct case_doc *doc = &d->doc;
  struct experiment_section s = {0};
  struct case_experiment *e = &d->c->compare.experiments[d->c->compare.n_experiments];
  char path[CASE_PATH], key[CASE_PATH + 16];
  enum status status = OK;
  snprintf(path, sizeof path, "compare.experiments[%zu]", i);
  bool good = case_read_section(d, node, path, experiment_rows, ROWS(experiment_rows), &s);
  if (good) {
    const char *slash = strrchr(s.file, '/');
    *e = (struct case_experiment){
        .label = s.label ? s.label : strdup(slash ? slash + 1 : s.file),
        .source = s.source ? s.source : strdup(""),
        .target = s.target,
    };
    s.label = s.source = s.target = NULL;
    d->c->compare.n_experiments++;
    if (!e->label || !e->source) status = status_raise(ERR_MEMORY, "no memory for an experiment");
    snprintf(key, sizeof key, "%s.file", path);
    if (status == OK)
      status = case_read_experiment(d, e, s.file, case_doc_member_line(doc, node, "file"), key);
  }
  params_release(experiment_rows, ROWS(experiment_rows), &s);
  return status;
}

const struct case_table case_run_tables[] = {
    {"runs (a list; and the keys of the run's solver)", run_rows, ROWS(run_rows)},
    {"compare", compare_rows, ROWS(compare_rows)},
    {"compare.tolerances (a list)", tolerance_rows, ROWS(tolerance_rows)},
    {"compare.averages (a list)", average_rows, ROWS(average_rows)},
    {"compare.experiments (a list)", experiment_rows, ROWS(experiment_rows)},
    {0},
};

enum status case_read_compare(struct case_draft *d) {
  struct case_file *c = d->c;
  struct case_doc *doc = &d->doc;
  struct compare_section s = {0};
  c->compare.window = (struct geo_box){{-INFINITY, -INFINITY}, {INFINITY, INFINITY}};
  c->compare.reference = c->n_runs > 1 || d->at.compare ? 0 : c->n_runs;
  if (!case_read_section(d, d->at.compare, "compare", compare_rows, ROWS(compare_rows), &s))
    return OK;
  if (s.reference && c->n_runs)
    c->compare.reference = find_run(d, s.reference, "compare.reference");
  if (s.times)
    TRY(read_times(d, s.times));
  else if (d->good.time && c->every <= c->end)
    TRY(default_times(c));
  if (s.window) read_window(d, s.window);
  if (s.tolerances) TRY(read_tolerances(d, s.tolerances));
  if (s.averages) TRY(read_averages(d, s.averages));
  if (s.filters) TRY(case_read_filters(d, s.filters));
  if (s.spectra) TRY(case_read_spectra(d, s.spectra));
  if (s.events) TRY(case_read_events(d, s.events));
  if (s.profiles && d->read_data) TRY(case_read_profiles(d, s.profiles));
  if (!s.experiments || !d->read_data ||
      !case_doc_expect_list(doc, s.experiments, "compare.experiments", 0, CASE_MOST_ITEMS,
                            "experiments"))
    return OK;
  size_t n = case_doc_size(doc, s.experiments);
  TRY(array_create(&c->compare.experiments, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) TRY(read_experiment(d, case_doc_item(doc, s.experiments, i), i));
  return OK;
}
