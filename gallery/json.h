/* What is known of an entry once it has been computed, as JSON (docs/gallery-entries.md). */
#pragma once
#include <jansson.h>

#include "gallery/verdict.h"

/* id, key, document, title, where, kind, corrected, setup, remarks, verdict, as_expected, checks with
 * their answers, runs. What figures add is theirs. ERR_MEMORY. */
enum status gallery_json_entry(const struct gallery_entry *e, const struct gallery_answer *answer,
                               json_t **out);

/* A text of an object; "": there is none. */
const char *gallery_text(const json_t *object, const char *key);
bool gallery_is_true(const json_t *object, const char *key);

/* Of an entry as it was left. */
enum gallery_verdict gallery_json_verdict(const json_t *entry);

/* Of an entry as it was left: how many of its checks were made, how many of them hold, and whether
 * one came out otherwise than it is known to. Of one that could not be made nothing counts. */
struct gallery_tally {
  size_t checks, hold;
  bool changed;
};
struct gallery_tally gallery_json_tally(const json_t *entry);
