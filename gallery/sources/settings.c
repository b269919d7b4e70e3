#include "gallery/sources/settings.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SETTINGS = 32, MOST_TOPICS = 128 };

struct settings {
  char *words; /* owned: keys and values are parts of it */
  size_t n;
  struct theory_setting setting[MOST_SETTINGS];
};

static enum status settings_split(const char *set, struct settings *s) {
  char *rest = NULL;
  *s = (struct settings){.words = strdup(set ? set : "")};
  CHECK(s->words, ERR_MEMORY, "no memory for theory");
  for (char *word = strtok_r(s->words, " ", &rest); word; word = strtok_r(NULL, " ", &rest)) {
    char *value = strchr(word, '=');
    CHECK(value, ERR_INPUT, "found '%.60s'; allowed: KEY=VALUE", word);
    CHECK(s->n < MOST_SETTINGS, ERR_INPUT, "found more settings; allowed: %d", MOST_SETTINGS);
    *value = 0;
    s->setting[s->n++] = (struct theory_setting){word, value + 1};
  }
  return OK;
}

enum status gallery_theory(const char *name, const char *set, struct theory_result *result) {
  const struct theory_topic *topic = theory_topic_find(name);
  struct settings s;
  CHECK(topic, ERR_INPUT, "there is no topic '%s'", name);
  enum status status = settings_split(set, &s);
  if (status == OK) status = theory_evaluate(topic, s.n, s.setting, result);
  free(s.words);
  if (status == ERR_USAGE || status == ERR_INPUT)
    status = status_context(ERR_INPUT, "topic %s: ", name);
  return status;
}

/* ---- while an entry is read ---- */

/* A complaint that is there already. */
static void pass_on(struct gallery_reader *r, int node, const char *path) {
  r->doc.faults++;
  problems_add(r->doc.problems, case_doc_line(&r->doc, node), "%s: %s", path, status_message());
}

static bool keys_are_there(struct gallery_reader *r, int node, const char *path,
                           const struct theory_topic *t, const struct settings *s) {
  const char *names[t->n_params + 1];
  const size_t faults = r->doc.faults;
  for (size_t p = 0; p < t->n_params; p++) names[p] = t->params[p].key;
  for (size_t i = 0; i < s->n; i++) {
    size_t p = 0;
    char found[80];
    while (p < t->n_params && strcmp(names[p], s->setting[i].key) != 0) p++;
    for (size_t k = 0; k < i; k++)
      if (!strcmp(s->setting[k].key, s->setting[i].key)) {
        snprintf(found, sizeof found, "the parameter '%.40s' a second time", s->setting[i].key);
        gallery_complain(r, node, path, found, "each parameter once", "remove one");
      }
    if (p < t->n_params) continue;
    const struct case_offer offer = case_offer("one of ", t->n_params, names, s->setting[i].key);
    snprintf(found, sizeof found, "the parameter '%.40s'", s->setting[i].key);
    gallery_complain(r, node, path, found, offer.allowed, offer.todo);
  }
  return r->doc.faults == faults;
}

const struct theory_topic *gallery_theory_check(struct gallery_reader *r, int node,
                                                const char *path, const char *topic,
                                                const char *set, size_t *curves) {
  const struct theory_topic *t = topic ? theory_topic_find(topic) : NULL;
  const char *names[MOST_TOPICS];
  const int at = case_doc_member(&r->doc, node, "set");
  char full[CASE_PATH + 8];
  size_t n = 0;
  struct settings s;
  if (!topic) return NULL;
  for (; theory_topics[n] && n < MOST_TOPICS; n++) names[n] = theory_topics[n]->name;
  if (!t) gallery_complain_of_word(r, node, path, "topic", n, names);
  if (!t) return NULL;
  snprintf(full, sizeof full, "%s.set", path);
  const bool split = settings_split(set, &s) == OK;
  bool fine = split && keys_are_there(r, at, full, t, &s);
  if (!split || (fine && theory_check(t, s.n, s.setting, curves) != OK)) {
    pass_on(r, at, full);
    fine = false;
  }
  free(s.words);
  return fine ? t : NULL;
}
