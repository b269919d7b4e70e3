#include "gallery/sources/settings.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SETTINGS = 32 };

static enum status evaluate(const struct theory_topic *topic, char *words,
                            struct theory_result *result) {
  struct theory_setting setting[MOST_SETTINGS];
  size_t n = 0;
  char *rest = NULL;
  for (char *word = strtok_r(words, " ", &rest); word; word = strtok_r(NULL, " ", &rest)) {
    char *value = strchr(word, '=');
    CHECK(value, ERR_INPUT, "topic %s: found '%s'; allowed: KEY=VALUE", topic->name, word);
    CHECK(n < MOST_SETTINGS, ERR_INPUT, "topic %s: more than %d settings", topic->name,
          MOST_SETTINGS);
    *value = 0;
    setting[n++] = (struct theory_setting){word, value + 1};
  }
  return theory_evaluate(topic, n, setting, result);
}

enum status gallery_theory(const char *name, const char *set, struct theory_result *result) {
  const struct theory_topic *topic = theory_topic_find(name);
  const char *near = topic ? NULL : theory_topic_nearest(name);
  CHECK(topic, ERR_INPUT, "there is no topic '%s'%s%s%s", name, near ? "; did you mean '" : "",
        near ? near : "", near ? "'?" : "");
  char *words = strdup(set ? set : "");
  CHECK(words, ERR_MEMORY, "no memory for theory");
  enum status status = evaluate(topic, words, result);
  free(words);
  if (status == ERR_USAGE) status = status_context(ERR_INPUT, "topic %s: ", name);
  return status;
}
