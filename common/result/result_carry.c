#include "common/result/result_carry.h"

#include <string.h>

#include "common/result/result_layout.h"

/* `n` numbers where another array has said how many. */
static enum status carry_same_elements(struct carrier *c, size_t n, void **array, size_t size) {
  size_t count = n;
  TRY(carry_elements(c, &count, array, size));
  CHECK(count == n, ERR_INPUT, "an array has %zu elements where %zu are needed", count, n);
  return OK;
}

#define carry_same(c, n, array)                                                                    \
  array_lend(array, carry_same_elements(c, n, &memory_, sizeof **(array)))

/* A text that must be there: whoever prints it later does not ask. */
static enum status carry_word(struct carrier *c, char **text) {
  TRY(carry_text(c, text));
  CHECK(*text, ERR_INPUT, "a text is missing");
  return OK;
}

static enum status carry_lines(struct carrier *c, void *element) {
  struct geo_lines *l = element;
  TRY(carry_array(c, &l->pieces, &l->closed));
  TRY(carry_array(c, &l->points, &l->p));
  size_t n = l->first ? l->pieces + 1 : 0; /* nothing has begun where there is no piece */
  TRY(carry_array(c, &n, &l->first));
  if (c->sending) return OK;
  l->piece_room = l->pieces;
  l->point_room = l->points;
  bool good = n == l->pieces + 1 || (n == 0 && l->pieces == 0);
  for (size_t k = 0; good && k < n; k++)
    good = k == 0 ? l->first[0] == 0 : l->first[k] >= l->first[k - 1];
  CHECK(good && l->first[n ? n - 1 : 0] == l->points, ERR_INPUT, "a line is inconsistent");
  return OK;
}

/* Error bars of n numbers, or none. */
static enum status carry_errors(struct carrier *c, size_t n, size_t *n_errors, double **error) {
  TRY(carry_array(c, n_errors, error));
  CHECK(*n_errors == 0 || *n_errors == n, ERR_INPUT, "%zu error bars are of %zu numbers", *n_errors,
        n);
  return OK;
}

static enum status carry_series(struct carrier *c, void *element) {
  struct result_series *s = element;
  TRY(carry_word(c, &s->name));
  TRY(carry_word(c, &s->units));
  TRY(carry_word(c, &s->help));
  TRY(carry_bytes(c, &s->x, sizeof s->x));
  TRY(carry_bytes(c, &s->y, sizeof s->y));
  TRY(carry_bytes(c, &s->size, sizeof s->size));
  TRY(carry_array(c, &s->n, &s->t));
  TRY(carry_same(c, s->n, &s->value));
  return carry_errors(c, s->n, &s->n_errors, &s->error);
}

static enum status carry_point(struct carrier *c, void *element) {
  struct result_point_read *p = element;
  TRY(carry_word(c, &p->name));
  TRY(carry_bytes(c, &p->x, sizeof p->x));
  TRY(carry_bytes(c, &p->y, sizeof p->y));
  TRY(carry_array(c, &p->n, &p->t));
  for (int k = 0; k < CASE_POINT_FIELDS; k++) TRY(carry_same(c, p->n, &p->value[k]));
  return OK;
}

static enum status carry_event(struct carrier *c, void *element) {
  struct result_event_read *e = element;
  TRY(carry_word(c, &e->name));
  TRY(carry_bytes(c, &e->time, sizeof e->time));
  TRY(carry_bytes(c, &e->x, sizeof e->x));
  TRY(carry_bytes(c, &e->y, sizeof e->y));
  return carry_bytes(c, e->error, sizeof e->error);
}

static enum status carry_experiment(struct carrier *c, void *element) {
  struct case_experiment *e = element;
  TRY(carry_word(c, &e->label));
  TRY(carry_word(c, &e->source));
  TRY(carry_word(c, &e->target));
  TRY(carry_array(c, &e->n, &e->t));
  return carry_same(c, e->n, &e->value);
}

static enum status carry_profile(struct carrier *c, void *element) {
  struct case_profile *p = element;
  TRY(carry_word(c, &p->label));
  TRY(carry_word(c, &p->source));
  TRY(carry_bytes(c, &p->time, sizeof p->time));
  TRY(carry_array(c, &p->n, &p->x));
  return carry_same(c, p->n, &p->y);
}

static enum status carry_statistic(struct carrier *c, void *element) {
  struct result_statistic_read *s = element;
  TRY(carry_word(c, &s->name));
  TRY(carry_word(c, &s->help));
  return carry_bytes(c, &s->value, sizeof s->value);
}

static enum status carry_term(struct carrier *c, void *element) {
  struct result_term_read *t = element;
  TRY(carry_word(c, &t->name));
  TRY(carry_word(c, &t->help));
  return carry_bytes(c, &t->outside, sizeof t->outside);
}

static enum status carry_field(struct carrier *c, void *element) {
  return carry_word(c, element);
}

static enum status carry_header(struct carrier *c, struct result_file *f) {
  char **text[] = {&f->solver,   &f->run,       &f->title,       &f->version,
                   &f->revision, &f->case_text, &f->fingerprint, &f->water_fingerprint,
                   &f->created,  &f->ended,     &f->imported,    &f->health,
                   &f->settings};
  for (size_t i = 0; i < sizeof text / sizeof *text; i++) TRY(carry_word(c, text[i]));
  size_t complete = f->complete, floats = f->floats;
  TRY(carry_number(c, &complete));
  TRY(carry_number(c, &floats));
  f->complete = complete == 1;
  f->floats = floats == 1;
  for (int i = 0; i < RESULT_SCALES; i++)
    TRY(carry_bytes(c, (char *)f + result_scales[i].offset, sizeof(double)));
  return carry_bytes(c, &f->c0, sizeof f->c0);
}

static enum status carry_tables(struct carrier *c, struct result_file *f) {
  TRY(carry_array(c, &f->n_energy, &f->energy));
  TRY(carry_array(c, &f->n_energy_errors, &f->energy_error));
  CHECK(f->n_energy_errors == 0 || f->n_energy_errors == f->n_energy, ERR_INPUT,
        "%zu error bars are of %zu energies", f->n_energy_errors, f->n_energy);
  TRY(carry_each(c, &f->n_terms, &f->terms, carry_term));
  CHECK(f->n_terms <= RESULT_TERMS, ERR_INPUT, "%s has %zu terms of energy", f->path, f->n_terms);
  TRY(carry_array(c, &f->n_steps, &f->steps));
  TRY(carry_each(c, &f->n_probes, &f->probes, carry_series));
  TRY(carry_each(c, &f->n_gauges, &f->gauges, carry_series));
  TRY(carry_each(c, &f->n_points, &f->points, carry_point));
  TRY(carry_each(c, &f->n_diagnostics, &f->diagnostics, carry_series));
  TRY(carry_each(c, &f->n_events, &f->events, carry_event));
  TRY(carry_each(c, &f->n_experiments, &f->experiments, carry_experiment));
  TRY(carry_each(c, &f->n_profiles, &f->profiles, carry_profile));
  return carry_each(c, &f->n_statistics, &f->statistics, carry_statistic);
}

enum status result_carry(struct carrier *c, void *file) {
  struct result_file *f = file;
  TRY(carry_header(c, f));
  TRY(carry_lines(c, &f->walls));
  TRY(carry_each(c, &f->n_surfaces, &f->surface, carry_lines));
  TRY(carry_same(c, f->n_surfaces, &f->surface_time));
  size_t points = 0;
  for (size_t k = 0; k < f->n_surfaces; k++) points += f->surface[k].points;
  TRY(carry_errors(c, points, &f->n_surface_errors, &f->surface_error));
  TRY(carry_bytes(c, &f->coarser, sizeof f->coarser));
  TRY(carry_tables(c, f));
  TRY(carry_array(c, &f->n_outputs, &f->output_time));
  TRY(carry_same(c, f->n_outputs, &f->output_points));
  return carry_each(c, &f->n_fields, &f->fields, carry_field);
}
