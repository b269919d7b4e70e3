/* Settings of a comparison in a file of their own: the section `compare` of a case, for results
 * that are there already. What it is checked against is what those results say of themselves, so
 * that results of other programs and versions can be compared too. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/base/text.h"
#include "common/case/case_draft.h"

enum { MOST_BYTES = 1 << 20 };

/* ---- names ---- */

struct name_list {
  size_t n, room;
  const char **name; /* [n]; borrowed */
};

static enum status list_add(struct name_list *l, const char *name) {
  for (size_t i = 0; i < l->n; i++)
    if (!strcmp(l->name[i], name)) return OK;
  TRY(array_grow(&l->name, &l->room, l->n + 1, "names"));
  l->name[l->n++] = name;
  return OK;
}

/* Those of a frame first, then what a list of the case has. A run without a name has its solver's.
 */
static enum status list_fill(struct case_doc *doc, const char *section,
                             const struct case_names *known, struct name_list *l) {
  const int list = case_doc_member(doc, case_doc_root(doc), section);
  for (size_t i = 0; i < known->n; i++) TRY(list_add(l, known->name[i]));
  for (size_t i = 0; i < case_doc_size(doc, list); i++) {
    const int item = case_doc_item(doc, list, i);
    const char *name = case_doc_text(doc, case_doc_member(doc, item, "name"));
    if (!name) name = case_doc_text(doc, case_doc_member(doc, item, "solver"));
    if (name) TRY(list_add(l, name));
  }
  return OK;
}

/* Copies the names to where `elements` of `size` bytes have theirs. */
static enum status names_put(const struct name_list *l, size_t size, size_t offset, void *elements,
                             size_t *n) {
  for (; *n < l->n; ++*n) {
    char *copy = strdup(l->name[*n]);
    CHECK(copy, ERR_MEMORY, "no memory for a name");
    memcpy((char *)elements + *n * size + offset, &copy, sizeof copy);
  }
  return OK;
}

#define TAKE_NAMES(list)                                                                           \
  do {                                                                                             \
    struct name_list names_ = {0};                                                                 \
    enum status took_ = list_fill(&d->doc, #list, &frame->list, &names_);                          \
    if (took_ == OK) took_ = array_create(&d->c->list, names_.n, "entries of the case");           \
    if (took_ == OK)                                                                               \
      took_ = names_put(&names_, sizeof *d->c->list,                                               \
                        (size_t)((char *)&d->c->list->name - (char *)d->c->list), d->c->list,      \
                        &d->c->n_##list);                                                          \
    free(names_.name);                                                                             \
    TRY(took_);                                                                                    \
  } while (0)

static enum status take_frame(struct case_draft *d, const struct case_frame *frame) {
  d->c->H = d->doc.scales.H = frame->H;
  d->c->gravity = d->c->g = d->doc.scales.g = frame->g;
  d->c->tank = frame->tank;
  TAKE_NAMES(runs);
  TAKE_NAMES(probes);
  TAKE_NAMES(gauges);
  TAKE_NAMES(points);
  return OK;
}

/* ---- a file of settings ---- */

/* What belongs to a case and not to results that are there already. */
static void check_absent(struct case_draft *d, const char *key, const char *why) {
  int node = case_doc_member(&d->doc, d->at.compare, key);
  char path[CASE_PATH];
  if (!node) return;
  snprintf(path, sizeof path, "compare.%s", key);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path, "a key of a case", why,
                   "remove it");
}

/* Puts a time to the output that it names; that of another one is a problem. */
static void check_time(struct case_draft *d, const struct case_frame *frame, int item, size_t i) {
  double *time = &d->c->compare.times[i], nearest = NAN;
  char path[CASE_PATH], found[64], words[64], todo[96];
  for (size_t k = 0; k < frame->n_times; k++)
    if (!(fabs(frame->times[k] - *time) >= fabs(nearest - *time))) nearest = frame->times[k];
  bool near = fabs(nearest - *time) <= 1e-6 * fmax(*time, fabs(nearest));
  if (near) *time = nearest;
  bool later = !i || *time > d->c->compare.times[i - 1];
  if (near && later) return;
  snprintf(path, sizeof path, "compare.times[%zu]", i);
  case_time_words(d, item, *time, found);
  case_time_words(d, item, nearest, words);
  snprintf(todo, sizeof todo, near ? "put them in order" : "the nearest is %s", words);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, item), path, found,
                   near ? "times that increase" : "an output time of the reference", todo);
}

/* The section without its name: one hint for all of its keys. */
static bool is_bare_section(struct case_draft *d, int root) {
  static const char *const keys[] = {"times",   "window",  "tolerances", "averages",
                                     "filters", "spectra", "events"};
  if (case_doc_member(&d->doc, root, "compare")) return false;
  for (size_t k = 0; k < sizeof keys / sizeof *keys; k++) {
    if (!case_doc_member(&d->doc, root, keys[k])) continue;
    case_doc_problem(&d->doc, case_doc_member_line(&d->doc, root, keys[k]), keys[k],
                     "a key of the section `compare`, outside of it", "compare",
                     "write `compare:` on a line above and indent what follows");
    return true;
  }
  return false;
}

static enum status read_settings(struct case_draft *d, const struct case_frame *frame) {
  static const struct param rows[] = {
      {.key = "compare",
       .type = PARAM_NODE,
       .offset = offsetof(struct case_draft, at.compare),
       .value = NULL,
       .help = "a mapping with times, window, tolerances, averages, filters, spectra, events"},
  };
  struct case_block block = {rows, ROWS(rows), d, NULL};
  int root = case_doc_root(&d->doc);
  if (is_bare_section(d, root)) return OK;
  case_doc_read(&d->doc, root, "", case_doc_line(&d->doc, root), 1, &block);
  if (!d->at.compare) return OK;
  TRY(case_read_compare(d));
  check_absent(d, "reference", "none, the reference is the first file");
  check_absent(d, "experiments", "none, they are in the reference's file");
  check_absent(d, "profiles", "none, they are in the reference's file");
  int list = case_doc_member(&d->doc, d->at.compare, "times");
  for (size_t i = 0; i < d->c->compare.n_times; i++)
    check_time(d, frame, case_doc_item(&d->doc, list, i), i);
  case_check_tolerances(d);
  if (frame->n_times) {
    const double end = frame->times[frame->n_times - 1];
    const char *what = "the reference's last output";
    case_check_averages(d, end, what);
    case_check_filters(d, 0, end, what);
    case_check_spectra(d, end, what);
  }
  case_check_window(d);
  return OK;
}

/* ---- the case of a result file ---- */

/* How the sides move, which pictures show. Motions that this version does not read are no problem
 * of the comparison: its walls are at rest then. */
static enum status take_motions(struct case_draft *d, const struct geo_lines *walls) {
  struct case_doc *doc = &d->doc;
  struct problems *kept = doc->problems, mine = {0};
  const size_t faults = doc->faults;
  const int node = case_doc_member(doc, d->at.tank, "motions");
  if (!node || !walls) return OK;
  TRY(geo_lines_copy(&d->c->walls, walls));
  doc->problems = &mine;
  enum status status = case_read_motions(d, node);
  d->good.tank = status == OK && doc->faults == faults;
  case_check_motions(d);
  if (doc->faults != faults) case_release_motions(d->c);
  kept->out_of_memory |= mine.out_of_memory;
  problems_destroy(&mine);
  doc->problems = kept;
  doc->faults = faults;
  return status;
}

/* The same from another case than that of the settings. */
static enum status take_motions_of(const char *text, const struct case_frame *frame,
                                   struct case_draft *d) {
  struct problems mine = {0};
  struct case_draft other = {.registry = d->registry, .c = d->c};
  enum status status = OK;
  if (case_doc_load(&other.doc, text, strlen(text), &mine)) {
    other.doc.scales = d->doc.scales;
    other.at.tank = case_doc_member(&other.doc, case_doc_root(&other.doc), "tank");
    if (other.at.tank) status = take_motions(&other, frame->walls);
  }
  case_doc_destroy(&other.doc);
  problems_destroy(&mine);
  return status;
}

/* Sections that are not the comparison's are nobody's business here. */
static enum status read_own(struct case_draft *d, const struct case_frame *frame) {
  const int root = case_doc_root(&d->doc);
  d->at.tank = case_doc_member(&d->doc, root, "tank");
  TRY(take_motions(d, frame->walls));
  d->at.time = case_doc_member(&d->doc, root, "time");
  d->at.compare = case_doc_member(&d->doc, root, "compare");
  if (d->at.time) case_read_time(d);
  TRY(case_read_compare(d));
  case_check_tolerances(d);
  if (!d->good.time) return OK;
  case_check_averages(d, d->c->end, "time.end");
  case_check_filters(d, d->c->sample, d->c->end, "time.end");
  case_check_spectra(d, d->c->end, "time.end");
  return OK;
}

/* ---- both ---- */

/* `own`: the text is a whole case. */
static enum status read_text(const char *text, size_t n, bool own, const struct case_frame *frame,
                             struct case_draft *d, struct problems *problems) {
  d->c = calloc(1, sizeof *d->c);
  CHECK(d->c, ERR_MEMORY, "no memory for settings");
  if (!(own ? case_doc_load(&d->doc, text, n, problems)
            : case_doc_load_other(&d->doc, text, n, "a mapping with the section compare",
                                  problems)))
    return OK;
  if (own && !case_sweep_expand(&d->doc)) return OK;
  TRY(take_frame(d, frame));
  if (own) return read_own(d, frame);
  if (frame->tank_text) TRY(take_motions_of(frame->tank_text, frame, d));
  return read_settings(d, frame);
}

/* Settings out of a draft that ends with them. */
static enum status conclude(enum status status, const char *name, struct case_draft *d,
                            struct problems *problems, struct case_file **out) {
  const size_t faults = problems->n + problems->unlisted;
  case_doc_destroy(&d->doc);
  problems_finish(problems, name, 0, NULL);
  if (status == OK && problems->out_of_memory)
    status = status_raise(ERR_MEMORY, "no memory to read %s", name);
  if (status == OK && faults)
    status = status_raise(ERR_INPUT, "%s has %zu problem%s", name, faults, faults == 1 ? "" : "s");
  if (status == OK)
    *out = d->c;
  else
    case_destroy(d->c);
  return status;
}

enum status case_load_settings(const char *path, const struct case_frame *frame,
                               const struct registry *registry, struct problems *problems,
                               struct case_file **out) {
  struct case_draft d = {.registry = registry};
  char *text;
  size_t n;
  *problems = (struct problems){0};
  *out = NULL;
  enum status status = text_read(path, MOST_BYTES, &text, &n);
  if (status == ERR_INPUT)
    return status_context(ERR_INPUT, "cannot read settings, YAML of at most 1 MB, from %s: found ",
                          path);
  TRY(status);
  status = read_text(text, n, false, frame, &d, problems);
  free(text);
  return conclude(status, path, &d, problems, out);
}

enum status case_parse_settings(const char *name, const char *text, const struct case_frame *frame,
                                const struct registry *registry, struct problems *problems,
                                struct case_file **out) {
  struct case_draft d = {.registry = registry};
  const char *given = *text ? text : "{}"; /* no case: nothing is asked */
  *problems = (struct problems){0};
  *out = NULL;
  return conclude(read_text(given, strlen(given), true, frame, &d, problems), name, &d, problems,
                  out);
}
