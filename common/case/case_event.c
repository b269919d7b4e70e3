/* compare.events: what is published of an instant, which runs are held against. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "common/case/case_draft.h"

const char *const case_event_names[] = {
#define X(name, help) #name,
    CASE_EVENTS(X)
#undef X
};

const char *const case_event_parts[] = {"time", "x", "y"};

struct event_section {
  int event, runs;
  double time, x, y, within;
  char *source;
};
static const struct param time_rows[] = {
    NODE(struct event_section, event, NULL, "the name of an event"),
    REAL(struct event_section, time, QTY_TIME, 0, 1e9, "", "when it was; or x or y"),
    REAL(struct event_section, x, QTY_LENGTH, -1e6, 1e6, "", "where it was, along the tank"),
    REAL(struct event_section, y, QTY_LENGTH, -1e6, 1e6, "",
         "where it was, its height in the tank"),
    REAL(struct event_section, within, QTY_TIME, PARAM_ABOVE_0, 1e9, NULL,
         "the largest difference that passes: a time, or a length beside x or y"),
    TEXT(struct event_section, source, 1000, NULL, "citation"),
    NODE(struct event_section, runs, "", "a list of runs; default: all, and the reference"),
};
enum { WITHIN = 4 };

const struct case_table case_event_tables[] = {
    {"compare.events (a list)", time_rows, ROWS(time_rows)},
    {0},
};

static bool read_name(struct case_draft *d, int node, const char *path, int *event) {
  const char *text = case_doc_text(&d->doc, node);
  char found[64], key[CASE_PATH + 16];
  for (int i = 0; i < CASE_N_EVENTS; i++) {
    if (!text || strcmp(text, case_event_names[i]) != 0) continue;
    *event = i;
    return true;
  }
  snprintf(key, sizeof key, "%s.event", path);
  struct case_offer offer = case_offer("one of ", CASE_N_EVENTS, case_event_names, text);
  case_doc_found(&d->doc, node, found);
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), key, found, offer.allowed, offer.todo);
  return false;
}

/* Which of time, x and y is given, one alone. */
static bool find_part(struct case_draft *d, int node, const char *path, int *part) {
  int given = 0;
  for (int i = 0; i < CASE_N_EVENT_PARTS; i++)
    if (case_doc_member(&d->doc, node, case_event_parts[i])) {
      *part = i;
      given++;
    }
  if (given == 1) return true;
  case_doc_problem(&d->doc, case_doc_line(&d->doc, node), path,
                   given ? "more than one of time, x and y" : "nothing of it that is published",
                   "one of time, x and y", given ? "write an entry for each" : "add what is known");
  return false;
}

static enum status read_event(struct case_draft *d, int node, size_t i) {
  struct case_file *c = d->c;
  struct event_section s = {0};
  struct case_event *e = &c->compare.events[c->compare.n_events];
  struct param rows[ROWS(time_rows)];
  char path[CASE_PATH], key[CASE_PATH + 16];
  enum status status = OK;
  int part = 0, event = 0;
  snprintf(path, sizeof path, "compare.events[%zu]", i);
  if (case_doc_is_mapping(&d->doc, node) && !find_part(d, node, path, &part)) return OK;
  memcpy(rows, time_rows, sizeof rows);
  if (part != CASE_EVENT_time) rows[WITHIN].quantity = QTY_LENGTH;
  if (case_read_section(d, node, path, rows, ROWS(rows), &s) &&
      read_name(d, s.event, path, &event)) {
    const double value[] = {s.time, s.x, s.y};
    *e = (struct case_event){event, part, value[part], s.within, s.source, 0, NULL};
    c->compare.n_events++;
    s.source = NULL;
    snprintf(key, sizeof key, "%s.runs", path);
    if (s.runs) status = case_read_run_names(d, s.runs, key, true, &e->n_runs, &e->runs);
  }
  params_release(rows, ROWS(rows), &s);
  return status;
}

enum status case_read_events(struct case_draft *d, int node) {
  struct case_doc *doc = &d->doc;
  if (!case_doc_expect_list(doc, node, "compare.events", 0, CASE_MOST_ITEMS, "events")) return OK;
  const size_t n = case_doc_size(doc, node);
  TRY(array_create(&d->c->compare.events, n, "entries of the case"));
  for (size_t i = 0; i < n; i++) TRY(read_event(d, case_doc_item(doc, node, i), i));
  return OK;
}

/* Runs that are not compared have no report. */
void case_check_events(struct case_draft *d) {
  const int list = case_doc_member(&d->doc, d->at.compare, "events");
  if (!d->c->compare.n_events || d->c->n_runs != 1) return;
  case_doc_problem(&d->doc, case_doc_line(&d->doc, case_doc_item(&d->doc, list, 0)),
                   "compare.events", "an event in a case of one run",
                   "a reference and one more run", "add a run or remove the events");
}

void case_event_destroy(struct case_event *e) {
  free(e->source);
  free(e->runs);
}
