#include "compare/convergence/groups.h"

#include <ctype.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "common/base/array.h"
#include "compare/chart.h"

struct candidate {
  size_t member;
  const struct cmp_data *data;
  char *settings; /* owned; NULL: no file says */
  bool told, taken;
};

/* ---- candidates ---- */

/* What files themselves say, else the case in them, which is mostly the same in all and is read
 * once then. `run` and `settings` [n] are for that. */
static enum status settings_take(size_t n, struct candidate *candidate, const char **run,
                                 char **settings) {
  for (size_t i = 0; i < n; i++) {
    const struct result_file *f = candidate[i].data->file;
    size_t same = 0;
    if (candidate[i].told) continue;
    for (size_t k = i; k < n; k++)
      if (!candidate[k].told && !strcmp(candidate[k].data->file->case_text, f->case_text))
        run[same++] = candidate[k].data->file->run;
    TRY(case_run_settings(f->case_text, same, run, settings));
    same = 0;
    for (size_t k = i; k < n; k++) {
      if (candidate[k].told || strcmp(candidate[k].data->file->case_text, f->case_text) != 0)
        continue;
      candidate[k].settings = settings[same++];
      candidate[k].told = true;
    }
  }
  return OK;
}

static enum status candidates_make(const struct comparison *c, struct candidate *candidate) {
  const size_t n = c->n_runs + 1;
  const char **run = NULL;
  char **settings = NULL;
  enum status status = OK;
  for (size_t i = 0; i < n; i++) {
    const size_t member = i < c->n_runs ? i : SIZE_MAX;
    const struct cmp_data *d = &cmp_run_or_ref(c, member)->data;
    const char *own = d->file->settings;
    candidate[i] = (struct candidate){.member = member, .data = d, .told = own && *own};
    if (!candidate[i].told) continue;
    candidate[i].settings = strdup(own);
    ATTEMPT(candidate[i].settings ? OK : status_raise(ERR_MEMORY, "no memory for settings"));
  }
  ATTEMPT(array_create(&run, n, "names of runs"));
  ATTEMPT(array_create(&settings, n, "settings of runs"));
  status = settings_take(n, candidate, run, settings);
done:
  free(run);
  free(settings);
  return status;
}

static bool same_text(const char *a, const char *b) {
  return (!a && !b) || (a && b && !strcmp(a, b));
}

static bool belong_together(const struct candidate *a, const struct candidate *b) {
  const struct result_file *f = a->data->file, *g = b->data->file;
  return !strcmp(f->solver, g->solver) && !strcmp(f->water_fingerprint, g->water_fingerprint) &&
         same_text(a->settings, b->settings);
}

/* Coarsest first; of one spacing in the order of the files, the reference before all. */
static int by_spacing(const void *a, const void *b) {
  const struct candidate *p = *(struct candidate *const *)a, *q = *(struct candidate *const *)b;
  const double h = p->data->dx, k = q->data->dx;
  if (fabs(h / k - 1) > 1e-9) return h > k ? -1 : 1;
  if (p->member == SIZE_MAX || q->member == SIZE_MAX) return p->member == SIZE_MAX ? -1 : 1;
  return (p->member > q->member) - (p->member < q->member);
}

/* ---- names ---- */

static bool separates(char c) {
  return c && strchr("-_. ", c);
}

static bool is_of_number(char c) {
  return isdigit((unsigned char)c) || (c && strchr(".eE+-", c));
}

/* Without a number at its end that a separator or nothing precedes, and separators. */
static size_t front_trim(const char *text, size_t n) {
  size_t number = n;
  while (number && is_of_number(text[number - 1])) number--;
  while (number < n && !isdigit((unsigned char)text[number])) number++;
  if (number < n && (!number || separates(text[number - 1])))
    n = number;
  else if (n && !separates(text[n - 1]))
    while (n && isdigit((unsigned char)text[n - 1])) n--;
  while (n && separates(text[n - 1])) n--;
  return n;
}

/* What the names of the members begin and end with, less what is of their resolution; nothing: the
 * solver. */
static void name_group(size_t n, struct candidate *const *member, char *out, size_t room) {
  const char *first = member[0]->data->label;
  const size_t whole = strlen(first);
  size_t front = whole, back = whole;
  for (size_t i = 1; i < n; i++) {
    const char *own = member[i]->data->label;
    const size_t length = strlen(own);
    size_t same = 0;
    while (same < front && own[same] == first[same]) same++;
    front = same;
    for (same = 0; same < back && same < length;) {
      if (own[length - 1 - same] != first[whole - 1 - same]) break;
      same++;
    }
    back = same;
  }
  front = front_trim(first, front);
  if (back > whole - front) back = whole - front;
  const char *end = first + whole - back;
  end += strcspn(end, "-_ "); /* digits before it are of the number */
  if (!front && *end) end++;
  snprintf(out, room, "%.*s%s", (int)front, first, end);
  if (!*out) snprintf(out, room, "%s", member[0]->data->file->solver);
}

static void names_make_unique(struct cmp_convergence *v) {
  for (size_t i = 0; i < v->n; i++) {
    unsigned copies = 1;
    for (size_t k = 0; k < i; k++) copies += !strcmp(v->group[k].name, v->group[i].name);
    if (copies == 1) continue;
    char name[sizeof v->group->name];
    snprintf(name, sizeof name, "%.70s (%u)", v->group[i].name, copies);
    memcpy(v->group[i].name, name, sizeof name);
  }
}

/* ---- groups ---- */

static enum status group_make(size_t n, struct candidate **member, struct cmp_group *g) {
  *g = (struct cmp_group){0};
  TRY(array_create(&g->member, n, "runs of a group"));
  TRY(array_create(&g->spacing, n, "spacings"));
  TRY(array_create(&g->left_out, n, "runs of a group"));
  for (size_t i = 0; i < n; i++) {
    const double h = member[i]->data->dx;
    const size_t before = g->n;
    if (before && fabs(g->spacing[before - 1] / h - 1) <= 1e-9) {
      struct cmp_left_out *l = &g->left_out[g->n_left_out++];
      l->run = member[i]->member;
      snprintf(l->why, sizeof l->why, "it has the spacing of %.96s", member[i - 1]->data->label);
      continue;
    }
    g->member[before] = member[i]->member;
    g->spacing[g->n++] = h;
  }
  name_group(n, member, g->name, sizeof g->name);
  if (member[0]->settings) {
    g->settings = strdup(member[0]->settings);
    CHECK(g->settings, ERR_MEMORY, "no memory for settings");
  }
  return OK;
}

static enum status group_add(struct cmp_convergence *v, size_t n, struct candidate **member) {
  qsort(member, n, sizeof(struct candidate *), by_spacing);
  if (fabs(member[0]->data->dx / member[n - 1]->data->dx - 1) <= 1e-9) return OK;
  v->n++;
  return group_make(n, member, &v->group[v->n - 1]);
}

enum status cmp_groups_find(const struct comparison *c, struct cmp_convergence *v) {
  struct candidate *candidate = NULL, **member = NULL;
  const size_t n = c->n_runs + 1;
  enum status status;
  *v = (struct cmp_convergence){0};
  ATTEMPT(array_create(&candidate, n, "runs"));
  ATTEMPT(array_create(&member, n, "runs"));
  ATTEMPT(array_create(&v->group, n / 2 + 1, "groups of runs"));
  ATTEMPT(candidates_make(c, candidate));
  for (size_t i = 0; i < n; i++) {
    size_t found = 0;
    if (candidate[i].taken) continue;
    for (size_t k = i; k < n; k++)
      if (!candidate[k].taken && belong_together(&candidate[i], &candidate[k])) {
        candidate[k].taken = true;
        member[found++] = &candidate[k];
      }
    if (found > 1) ATTEMPT(group_add(v, found, member));
  }
  names_make_unique(v);
done:
  for (size_t i = 0; candidate && i < n; i++) free(candidate[i].settings);
  free(candidate);
  free(member);
  return status;
}
